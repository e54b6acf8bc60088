//! Promise: bad input in the middle of a turn is refused by name and leaves the book as it was; what is only
//! just allowed turns, or stays a leaf, like anything else.

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::scene::{SpecError, Weights};
use dogleaf_tests::case::{Case, Ends, judge};
use dogleaf_tests::gesture::{Gesture, Scene, play};

/// A number in a scene.
type FieldOf = fn(&mut Scene) -> &mut f64;
/// A field of a scene that can be set to anything.
type Field = (&'static str, FieldOf);

const FIELDS: [Field; 14] = [
    ("book.width_m", |s| &mut s.book.width_m),
    ("book.height_m", |s| &mut s.book.height_m),
    ("paper.areal_mass_gsm", |s| &mut s.paper.areal_mass_gsm),
    ("paper.thickness_mm", |s| &mut s.paper.thickness_mm),
    ("paper.youngs_gpa", |s| &mut s.paper.youngs_gpa),
    ("paper.poisson", |s| &mut s.paper.poisson),
    ("world.gravity", |s| &mut s.world.gravity[0]),
    ("world.gravity", |s| &mut s.world.gravity[1]),
    ("world.gravity", |s| &mut s.world.gravity[2]),
    ("world.damping_per_s", |s| &mut s.world.damping_per_s),
    ("view", |s| &mut s.view.eye_m[0]),
    ("view", |s| &mut s.view.eye_m[1]),
    ("view", |s| &mut s.view.target_m[2]),
    ("view", |s| &mut s.view.fov_y_deg),
];

/// A weight of the seed's paper.
type Weight = (&'static str, fn(&mut Weights) -> &mut f64);

const WEIGHTS: [Weight; 5] = [
    ("paper.weights.bend_3d", |w| &mut w.bend_3d),
    ("paper.weights.bend_2d", |w| &mut w.bend_2d),
    ("paper.weights.glue", |w| &mut w.glue),
    ("paper.weights.iso_3d", |w| &mut w.iso_3d),
    ("paper.weights.position", |w| &mut w.position),
];

const NO_NUMBERS: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A book in the middle of a turn.
fn turning() -> Box<Book<f32, G11x8>> {
    let scene = Scene::default();
    let mut book = scene.open::<f32, G11x8>().expect("a sound scene");
    let samples = Gesture::corner_turn(&scene.eye(), 3);
    play(&mut book, &samples, 30, &mut |_, _| ());
    assert!(book.leaf().is_some(), "in the air");
    book
}

/// Opens `scene` over a book in the middle of a turn; answers the refusal, and sees that nothing came of it.
fn refusal(book: &mut Book<f32, G11x8>, scene: &Scene) -> Option<SpecError> {
    let (hash, now, spec) = (book.state_hash(), book.now_us(), *book.spec());
    let answer =
        book.open(&scene.book, &scene.paper, &scene.world, &scene.view, scene.fidelity).err();
    if answer.is_some() {
        assert_eq!((book.state_hash(), book.now_us()), (hash, now), "the book is as it was");
        assert_eq!(*book.spec(), spec, "the book is as it was");
    }
    answer
}

#[test]
fn what_is_no_number_is_refused() {
    let mut book = turning();
    for (name, field) in FIELDS {
        for value in NO_NUMBERS {
            let mut scene = Scene::default();
            *field(&mut scene) = value;
            let answer = refusal(&mut book, &scene);
            assert_eq!(answer, Some(SpecError::NotFinite(name)), "{name} = {value}");
        }
    }
    for (name, weight) in WEIGHTS {
        for value in NO_NUMBERS {
            let mut weights = Weights::default();
            *weight(&mut weights) = value;
            let mut scene = Scene::seed();
            scene.paper.weights = Some(weights);
            assert_eq!(
                refusal(&mut book, &scene),
                Some(SpecError::NotFinite(name)),
                "{name} = {value}"
            );
        }
    }
}

#[test]
fn a_view_that_sees_nothing_is_refused() {
    let mut book = turning();
    let hash = book.state_hash();
    for value in NO_NUMBERS {
        let mut view = Scene::default().view;
        view.target_m[1] = value;
        assert_eq!(book.look(&view), Err(SpecError::NotFinite("view")), "{value}");
    }
    assert_eq!(book.state_hash(), hash, "the book is as it was");
}

/// The ends of what is allowed, one field at a time.
#[test]
fn what_is_only_just_allowed_is_simulated() {
    let ends: [(&str, FieldOf, [f64; 2]); 6] = [
        ("g/m²", |s| &mut s.paper.areal_mass_gsm, [1.0, 10_000.0]),
        ("mm thick", |s| &mut s.paper.thickness_mm, [0.001, 10.0]),
        ("GPa", |s| &mut s.paper.youngs_gpa, [1e-6, 1000.0]),
        ("poisson", |s| &mut s.paper.poisson, [0.0, 0.49]),
        ("m/s² upwards", |s| &mut s.world.gravity[1], [-1000.0, 1000.0]),
        ("damping", |s| &mut s.world.damping_per_s, [0.0, 1000.0]),
    ];
    let mut cases = Vec::new();
    for (name, field, values) in ends {
        for value in values {
            let mut scene = Scene::default();
            *field(&mut scene) = value;
            // What is heavy, stiff or weightless need not turn: it must stay a leaf.
            let samples = Gesture::corner_turn(&scene.eye(), 7);
            let ends = if name == "mm thick" && value > 1.0 { Ends::Unlikely } else { Ends::Hangs };
            cases.push(Case::new(format!("{value} {name}"), &scene, samples, ends).within(20.0));
        }
    }
    for (name, weight) in WEIGHTS {
        for value in [1e-3, 1e6] {
            let mut weights = Weights::default();
            *weight(&mut weights) = value;
            let mut scene = Scene::seed();
            scene.paper.weights = Some(weights);
            let samples = Gesture::corner_turn(&scene.eye(), 7);
            let name = name.trim_start_matches("paper.weights.");
            let case = Case::new(format!("{name} {value:e}"), &scene, samples, Ends::Hangs);
            // Blocks without stiffness fold where they are glued.
            let folded = name == "bend_2d" && value < 1.0;
            cases.push(Case { folded, ..case.within(20.0) });
        }
    }
    let failed = judge(&cases);
    let names: Vec<_> = failed.iter().map(ToString::to_string).collect();
    assert!(failed.is_empty(), "failed:\n{}", names.join("\n"));
}

/// Samples are integers: the worst of them is far away, never no number.
#[test]
fn samples_at_the_ends_of_their_range() {
    let mut book = turning();
    for n in [i32::MIN, i32::MIN + 1, -1, 0, i32::MAX] {
        for phase in [Phase::Move, Phase::Down, Phase::Up, Phase::Cancel, Phase::Down] {
            for (x, y) in [(n, 0), (0, n), (n, n)] {
                let t_us = book.now_us();
                let sample = Sample { t_us, id: 0, phase, x, y, leaves: u16::MAX };
                book.input(sample).expect("in order");
                let _ = book.step();
                let leaf = book.leaf().is_none_or(|l| l.x.finite() && l.v.finite());
                assert!(leaf, "{phase:?} at {x}, {y}");
            }
        }
    }
}
