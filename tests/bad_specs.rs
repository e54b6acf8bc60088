//! Promise: a spec that asks for the impossible is refused by the name of its field, and nothing was
//! changed; a spec at its limits is taken, and stays finite.

use dogleaf_core::grid::G6x5;
use dogleaf_core::hand::View;
use dogleaf_core::scene::{
    BookSpec, Fidelity, LeafSpec, PaperSpec, SpecError, Units, Weights, WorldSpec,
};
use dogleaf_core::step::StepStatus;
use dogleaf_core::{Book, LoneLeaf};

/// All that can be asked for.
#[derive(Debug, Clone, Copy)]
struct Asked {
    book: BookSpec,
    leaf: LeafSpec,
    paper: PaperSpec,
    world: WorldSpec,
    view: View,
}

impl Default for Asked {
    fn default() -> Self {
        Self {
            book: BookSpec::default(),
            leaf: LeafSpec::default(),
            paper: PaperSpec::default(),
            world: WorldSpec::default(),
            view: View::reading(0.13, 0.20, 960, 720),
        }
    }
}

/// What a field belongs to decides who refuses it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Owner {
    Book,
    Leaf,
    Both,
}

use Owner::{Book as OfBook, Both, Leaf as OfLeaf};

/// A field: who has it, its name in an error, its limits, and how to set it.
type Row = (Owner, &'static str, f64, f64, fn(&mut Asked, f64));

/// A side that fits any other within the limits.
fn beside(side: f64) -> f64 {
    if side.is_finite() { side.clamp(0.002, 5.0) } else { 0.13 }
}

fn weights(a: &mut Asked) -> &mut Weights {
    a.paper.weights.get_or_insert_default()
}

const NUMBERS: [Row; 21] = [
    (OfBook, "book.width_m", 0.001, 10.0, |a, v| {
        (a.book.width_m, a.book.height_m) = (v, beside(v));
    }),
    (OfBook, "book.height_m", 0.001, 10.0, |a, v| {
        (a.book.width_m, a.book.height_m) = (beside(v), v);
    }),
    (OfLeaf, "leaf.width_m", 0.001, 10.0, |a, v| {
        (a.leaf.width_m, a.leaf.height_m) = (v, beside(v));
    }),
    (OfLeaf, "leaf.height_m", 0.001, 10.0, |a, v| {
        (a.leaf.width_m, a.leaf.height_m) = (beside(v), v);
    }),
    (OfLeaf, "leaf.clamp_angle_deg", -180.0, 180.0, |a, v| a.leaf.clamp_angle_deg = v),
    (OfLeaf, "leaf.curl_per_m times leaf.width_m", -6.0, 6.0, |a, v| {
        (a.leaf.width_m, a.leaf.curl_per_m) = (0.125, 8.0 * v);
    }),
    (Both, "paper.areal_mass_gsm", 1.0, 10_000.0, |a, v| a.paper.areal_mass_gsm = v),
    (Both, "paper.thickness_mm", 0.001, 10.0, |a, v| a.paper.thickness_mm = v),
    (Both, "paper.youngs_gpa", 1e-6, 1000.0, |a, v| a.paper.youngs_gpa = v),
    (Both, "paper.poisson", 0.0, 0.49, |a, v| a.paper.poisson = v),
    (Both, "paper.weights.bend_3d", 1e-3, 1e6, |a, v| weights(a).bend_3d = v),
    (Both, "paper.weights.bend_2d", 1e-3, 1e6, |a, v| weights(a).bend_2d = v),
    (Both, "paper.weights.glue", 1e-3, 1e6, |a, v| weights(a).glue = v),
    (Both, "paper.weights.iso_3d", 1e-3, 1e6, |a, v| weights(a).iso_3d = v),
    (Both, "paper.weights.position", 1e-3, 1e6, |a, v| weights(a).position = v),
    (Both, "world.gravity", -1000.0, 1000.0, |a, v| a.world.gravity[0] = v),
    (Both, "world.gravity", -1000.0, 1000.0, |a, v| a.world.gravity[1] = v),
    (Both, "world.gravity", -1000.0, 1000.0, |a, v| a.world.gravity[2] = v),
    (Both, "world.damping_per_s", 0.0, 1000.0, |a, v| a.world.damping_per_s = v),
    (OfBook, "book.height_m over book.width_m", 0.2, 5.0, |a, v| {
        (a.book.width_m, a.book.height_m) = (0.125, 0.125 * v);
    }),
    (OfLeaf, "leaf.height_m over leaf.width_m", 0.2, 5.0, |a, v| {
        (a.leaf.width_m, a.leaf.height_m) = (0.125, 0.125 * v);
    }),
];

const COUNTS: [Row; 3] = [
    (OfBook, "book.pages", 1.0, 20_000.0, |a, v| {
        (a.book.pages, a.book.open_at) = (v as u32, 0);
    }),
    (OfBook, "book.open_at", 0.0, 321.0, |a, v| a.book.open_at = v as u32),
    (Both, "world.step_us", 100.0, 100_000.0, |a, v| a.world.step_us = v as u32),
];

/// The view names no field of its own.
const VIEWS: [Row; 9] = [
    (OfBook, "view", 1.0, 150.0, |a, v| a.view.fov_y_deg = v),
    (OfBook, "view", 1.0, 16_384.0, |a, v| a.view.width_px = v as u32),
    (OfBook, "view", 1.0, 16_384.0, |a, v| a.view.height_px = v as u32),
    (OfBook, "view", -10.0, 10.0, |a, v| a.view.eye_m[0] = v),
    (OfBook, "view", -10.0, 10.0, |a, v| a.view.eye_m[1] = v),
    (OfBook, "view", -10.0, 10.0, |a, v| a.view.eye_m[2] = v),
    (OfBook, "view", -10.0, 10.0, |a, v| a.view.target_m[0] = v),
    (OfBook, "view", -10.0, 10.0, |a, v| a.view.target_m[1] = v),
    (OfBook, "view", -10.0, 10.0, |a, v| a.view.target_m[2] = v),
];

fn with(row: &Row, value: f64) -> Asked {
    let mut asked = Asked::default();
    (row.4)(&mut asked, value);
    asked
}

fn field(error: SpecError) -> &'static str {
    match error {
        SpecError::NotFinite(field) | SpecError::OutOfRange(field) => field,
    }
}

type Small = Book<f32, G6x5>;
type Lone = LoneLeaf<f32, G6x5>;

fn open(book: &mut Small, a: &Asked) -> Result<(), SpecError> {
    book.open(&a.book, &a.paper, &a.world, &a.view, Fidelity::default())
}

fn lay(leaf: &mut Lone, a: &Asked) -> Result<(), SpecError> {
    leaf.open(&a.leaf, &a.paper, &a.world, Fidelity::default())
}

/// Something else than the default, so that a default taken over would show.
fn other() -> Asked {
    let mut asked = Asked { paper: dogleaf_tests::posed::seed_paper(), ..Asked::default() };
    (asked.book.width_m, asked.book.pages, asked.leaf.clamp_angle_deg) = (0.14, 300, 10.0);
    (asked.world.step_us, asked.world.damping_per_s) = (10_000, 0.5);
    asked
}

/// A book with a leaf in the air, and a lone leaf that falls.
fn busy() -> (Box<Small>, Box<Lone>) {
    let (mut book, mut leaf) = (Box::new(Small::EMPTY), Box::new(Lone::EMPTY));
    open(&mut book, &other()).expect("it is sound");
    lay(&mut leaf, &other()).expect("it is sound");
    assert!(book.take_up(true, 1), "there is a leaf");
    for _ in 0..5 {
        let _ = (book.step(), leaf.step());
    }
    (book, leaf)
}

/// Runs a check on busy ones that must go on afterwards as if nothing had been asked.
fn untouched(check: impl Fn(&mut (Box<Small>, Box<Lone>))) {
    let (mut asked, mut spared) = (busy(), busy());
    check(&mut asked);
    for _ in 0..5 {
        let reports = [&mut asked, &mut spared].map(|(book, leaf)| (book.step(), leaf.step()));
        assert_eq!(reports[0], reports[1], "it goes on as if nothing had been asked");
    }
    let hashes = [&asked, &spared].map(|(book, leaf)| (book.state_hash(), leaf.state_hash()));
    assert_eq!(hashes[0], hashes[1], "it goes on as if nothing had been asked");
}

/// Demands that a value is refused, by name, by all who own the field, and leaves no trace.
fn refused(row: &Row, value: f64, (book, leaf): &mut (Box<Small>, Box<Lone>)) -> SpecError {
    let (asked, what) = (with(row, value), format!("{} of {value}", row.1));
    let mut errors = Vec::new();
    if row.0 != OfLeaf {
        let before = (book.state_hash(), book.now_us(), *book.spec());
        errors.push(open(book, &asked).expect_err(&what));
        assert_eq!((book.state_hash(), book.now_us(), *book.spec()), before, "{what}");
    }
    if row.0 != OfBook {
        let before = (leaf.state_hash(), leaf.now_us(), *leaf.spec());
        errors.push(lay(leaf, &asked).expect_err(&what));
        assert_eq!((leaf.state_hash(), leaf.now_us(), *leaf.spec()), before, "{what}");
    }
    assert!(errors.iter().all(|e| field(*e) == row.1 && *e == errors[0]), "{what}: {errors:?}");
    errors[0]
}

/// Values no field takes, and those that this one does not.
fn bad(row: &Row) -> Vec<f64> {
    let outside = |v: &f64| !(row.2..=row.3).contains(v);
    [-1e300, -1.0, -1e-300, 0.0, 1e300, row.2.next_down(), row.3.next_up()]
        .into_iter()
        .filter(outside)
        .collect()
}

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

#[test]
fn a_number_that_is_not_finite_is_refused_by_the_name_of_its_field() {
    untouched(|busy| {
        for row in &NUMBERS[..19] {
            for value in NOT_FINITE {
                assert_eq!(refused(row, value, busy), SpecError::NotFinite(row.1), "{value}");
            }
        }
    });
}

#[test]
fn a_number_out_of_its_limits_is_refused_by_the_name_of_its_field() {
    untouched(|busy| {
        for row in &NUMBERS[..19] {
            for value in bad(row) {
                assert_eq!(refused(row, value, busy), SpecError::OutOfRange(row.1), "{value}");
            }
        }
    });
}

#[test]
fn a_page_too_long_or_too_wide_is_refused() {
    untouched(|busy| {
        for row in &NUMBERS[19..] {
            for value in [row.2.next_down(), row.3.next_up(), 0.05, 50.0] {
                assert_eq!(refused(row, value, busy), SpecError::OutOfRange(row.1), "{value}");
            }
        }
    });
}

#[test]
fn a_count_out_of_its_limits_is_refused_by_the_name_of_its_field() {
    untouched(|busy| {
        for row in &COUNTS {
            let outside = [row.2 - 1.0, row.3 + 1.0, 1e300].into_iter().filter(|v| *v >= 0.0);
            for value in outside {
                assert_eq!(refused(row, value, busy), SpecError::OutOfRange(row.1), "{value}");
            }
        }
    });
}

#[test]
fn a_view_that_is_not_finite_or_sees_nothing_is_refused() {
    untouched(|busy| {
        for (n, row) in VIEWS.iter().enumerate() {
            let whole = (1..3).contains(&n);
            for value in NOT_FINITE.into_iter().filter(|_| !whole) {
                assert_eq!(refused(row, value, busy), SpecError::NotFinite("view"), "{value}");
            }
            for value in [0.0, 16_385.0, -1e300, 1e300].into_iter().skip(if n < 3 { 0 } else { 2 })
            {
                assert_eq!(refused(row, value, busy), SpecError::OutOfRange("view"), "{value}");
            }
            assert_eq!(busy.0.look(&with(row, 1e300).view), Err(SpecError::OutOfRange("view")));
        }
    });
}

#[test]
fn a_view_is_refused_or_its_camera_is_finite_in_the_narrowest_scalar() {
    let units = Units::of_leaf(0.13, 0.20, 80.0);
    for row in &VIEWS[3..] {
        for power in -320..=308 {
            let view = with(row, format!("1e{power}").parse().expect("a number")).view;
            if view.check().is_err() {
                continue;
            }
            let ray = view.camera::<f32>(&units).ray(0, 0);
            let numbers = ray.from.0.into_iter().chain(ray.along.0);
            let sizes = [ray.from.norm_sq(), ray.along.norm_sq()];
            assert!(numbers.chain(sizes).all(f32::is_finite), "1e{power}: {ray:?}");
        }
    }
}

/// Opens both, lets the leaf fall a little, and demands numbers.
fn lives(asked: &Asked, what: &str) {
    let (mut book, mut leaf) = (Box::new(Small::EMPTY), Box::new(Lone::EMPTY));
    assert_eq!((open(&mut book, asked), lay(&mut leaf, asked)), (Ok(()), Ok(())), "{what}");
    let lifted = book.take_up(true, 1) || book.take_up(false, 1);
    assert!(lifted, "{what}: there is a leaf");
    for _ in 0..10 {
        for status in [book.step().status, leaf.step().status] {
            assert_ne!(status, StepStatus::Held, "{what}: a number that is none");
        }
    }
    let landed_or_finite = book.leaf().is_none_or(|leaf| leaf.x.finite());
    assert!(landed_or_finite && leaf.leaf().x.finite(), "{what}");
    assert!(book.blocks().iter().flat_map(|b| b.x).all(|p| p.norm().is_finite()), "{what}");
}

#[test]
fn what_is_at_its_limits_is_taken_and_stays_finite() {
    lives(&Asked::default(), "the default");
    for row in NUMBERS.iter().chain(&COUNTS).chain(&VIEWS) {
        for value in [row.2, row.3] {
            lives(&with(row, value), &format!("{} of {value}", row.1));
        }
    }
}

#[test]
fn any_seed_is_taken() {
    for seed in [0, 1, u64::MAX] {
        let world = WorldSpec { seed, ..WorldSpec::default() };
        assert_eq!(world.check(), Ok(()), "{seed}");
    }
}

#[test]
fn a_refusal_is_one_clear_line() {
    let mut asked = Asked::default();
    asked.book.width_m = f64::NAN;
    let error = asked.book.check().expect_err("NaN");
    assert_eq!(error.to_string(), "book.width_m is not a finite number");
    asked.book.width_m = 11.0;
    let error = asked.book.check().expect_err("too wide");
    assert_eq!(error.to_string(), "book.width_m is out of range");
}

#[test]
fn a_book_that_opens_after_all_does_change() {
    let (mut book, mut leaf) = busy();
    let before = (book.state_hash(), leaf.state_hash());
    let asked = Asked::default();
    assert_eq!((open(&mut book, &asked), lay(&mut leaf, &asked)), (Ok(()), Ok(())));
    assert_ne!(book.state_hash(), before.0, "the hash sees what was opened");
    assert_ne!(leaf.state_hash(), before.1, "the hash sees what was opened");
}
