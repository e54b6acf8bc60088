//! Promise: figures move only when somebody says so. Three tables, printed anew and compared whole.

use dogleaf_core::event::Event;
use dogleaf_core::grid::{G6x5, G8x6, G11x8, G12x9, G16x12, G22x16, Grid};
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::{BookSpec, Cover, Fidelity, LeafSpec, PaperSpec, Preset, WorldSpec};
use dogleaf_core::state::{Fnv, Leaf, Sheet};
use dogleaf_core::step::{Solver, StepReport};
use dogleaf_core::{Book, LoneLeaf};
use dogleaf_tests::elastica::droop;
use dogleaf_tests::gesture::{Gesture, Scene, play};
use dogleaf_tests::golden::{beside, compare};
use dogleaf_tests::watch::Watch;
use std::fmt::Write;

fn check(name: &str, table: &str) {
    if let Err(difference) = compare(name, table) {
        panic!("{difference}");
    }
}

/// A line of a table.
macro_rules! line {
    ($table:expr, $($part:tt)*) => { writeln!($table, $($part)*).expect("a text takes every line") };
}

/// Scenes of the table of turns, and how many leaves are turned.
fn scenes() -> Vec<(&'static str, Scene, u16)> {
    let newsprint = Scene { paper: Preset::Newsprint.into(), ..Scene::default() };
    let soft = Scene::of(BookSpec { cover: Cover::Soft, ..BookSpec::default() });
    vec![
        ("paper", Scene::default(), 1),
        ("seed", Scene::seed(), 1),
        ("newsprint", newsprint, 1),
        ("soft cover", soft, 1),
        ("first leaf", Scene::open_at(320, 0), 1),
        ("last leaf", Scene::open_at(320, 318), 1),
        ("stack of 20", Scene::open_at(160, 60), 20),
    ]
}

fn turn<R: Real>(table: &mut String, name: &str, scene: &Scene, leaves: u16) {
    let mut book = scene.open::<R, G11x8>().expect("a sound scene");
    let samples: Vec<_> = Gesture::corner_turn(&scene.eye(), 2024)
        .into_iter()
        .map(|s| Sample { leaves, ..s })
        .collect();
    let (mut seen, mut way) = (Watch::default(), Fnv::default());
    play(&mut book, &samples, 300, &mut |b, r| {
        seen.see(b, r);
        way.word(b.state_hash());
    });
    let page = seen.page().map_or_else(|| "-".into(), |p| p.to_string());
    let fidelity = Fidelity::ALL.iter().find(|f| f.1 == scene.fidelity).map_or("", |f| f.0);
    let (w, asleep) = (&seen.work, seen.events.contains(&Event::Asleep));
    line!(
        table,
        "{name:11}  {fidelity:9}  {}  {page:>4}  {:>6}  {:5}  {:7.3}  {:7.3}  {:6}  {:5}  {:6}  {:016x}",
        R::NAME,
        if asleep { "asleep" } else { "awake" },
        w.steps,
        100.0 * seen.air.worst,
        100.0 * seen.air.rms(),
        w.newton_steps,
        w.cuts,
        w.passes,
        way.value(),
    );
}

#[test]
fn turns() {
    let mut table = String::from(
        "One-second corner turn, gesture 2024, 300 pictures.\n\
         scene        fidelity   real  page     end  steps    max %    rms %  newton   cuts  passes  hash of the way\n",
    );
    for (name, mut scene, leaves) in scenes() {
        for (_, fidelity) in Fidelity::ALL {
            scene.fidelity = fidelity;
            // The reference is for one scene: it costs as much as all the others.
            if fidelity == Fidelity::Reference && name != "paper" {
                continue;
            }
            turn::<f32>(&mut table, name, &scene, leaves);
            turn::<f64>(&mut table, name, &scene, leaves);
        }
    }
    check("turn.txt", &table);
}

/// Drop over reach of a clamped leaf at rest, mean over its free edge.
fn rest<R: Real, G: Grid>(gamma: f64) -> f64 {
    let (leaf, mut paper) = (LeafSpec::default(), PaperSpec::default());
    let w = leaf.width_m;
    let rigidity = paper.areal_mass_gsm * 1e-3 * 9.81 * w * w * w / gamma;
    paper.youngs_gpa *= rigidity / paper.rigidity_nm();
    // Damping has no part in where a leaf rests.
    let world = WorldSpec { damping_per_s: 5.0, ..WorldSpec::default() };
    let mut lone = Box::new(LoneLeaf::<R, G>::EMPTY);
    lone.open(&leaf, &paper, &world, Fidelity::Standard).expect("a sound leaf");
    for _ in 0..600 {
        let _ = lone.step();
    }
    let tips = (0..G::NZ).map(|k| lone.leaf().x.at(G::NX - 1, k).0.map(Real::wide));
    let [x, y] = tips.fold([0.0; 2], |sum, tip| [sum[0] + tip[0], sum[1] - tip[1]]);
    y / x
}

/// A row of the droop table, its bound asserted.
fn droops<R: Real, G: Grid>(table: &mut String, bounded: bool) {
    for (gamma, bound) in [(1.0, 0.03), (3.0, 0.03), (10.0, 0.03), (30.0, 0.05)] {
        let ([drop, reach], found) = (droop(gamma), rest::<R, G>(gamma));
        let reference = drop / reach;
        let error = found / reference - 1.0;
        let grid = format!("{}x{}", G::NX, G::NZ);
        let name = R::NAME;
        line!(
            table,
            "{grid:6}  {name}  {gamma:5}  {found:8.5}  {reference:8.5}  {:7.2}",
            100.0 * error
        );
        let text = format!("{grid} {name}, gamma {gamma}: {:.2} %", 100.0 * error);
        assert!(!bounded || error.abs() <= bound, "{text}");
    }
}

#[test]
fn droop_of_a_clamped_leaf() {
    let mut table = String::from(
        "Drop over reach of a leaf clamped level at its spine; reference: the heavy elastica.\n\
         grid    real  gamma       H/W  reference  error %\n",
    );
    droops::<f32, G11x8>(&mut table, true);
    droops::<f64, G11x8>(&mut table, true);
    droops::<f32, G6x5>(&mut table, false);
    droops::<f32, G8x6>(&mut table, false);
    droops::<f32, G12x9>(&mut table, true);
    droops::<f32, G16x12>(&mut table, true);
    droops::<f32, G22x16>(&mut table, true);
    check("droop.txt", &table);
}

/// The oracle itself, against values of an independent solution.
#[test]
fn the_elastica_is_the_elastica() {
    let known = [
        (0.1, 0.012_50, 0.999_91),
        (1.0, 0.123_47, 0.991_25),
        (3.0, 0.339_65, 0.931_51),
        (10.0, 0.700_20, 0.656_35),
        (30.0, 0.873_09, 0.342_76),
        (100.0, 0.937_52, 0.159_22),
    ];
    for (gamma, drop, reach) in known {
        let [h, w] = droop(gamma);
        assert!((h - drop).abs() < 1e-5 && (w - reach).abs() < 1e-5, "gamma {gamma}: {h} {w}");
    }
}

fn sizes_of<R: Real, G: Grid>(table: &mut String) {
    let sizes = [
        ("Book", size_of::<Book<R, G>>()),
        ("LoneLeaf", size_of::<LoneLeaf<R, G>>()),
        ("Solver", size_of::<Solver<R, G>>()),
        ("Leaf", size_of::<Leaf<R, G>>()),
        ("Sheet", size_of::<Sheet<R, G>>()),
    ];
    let grid = format!("{}x{}", G::NX, G::NZ);
    for (name, bytes) in sizes {
        line!(table, "{name:10}  {}  {grid:6}  {bytes:8}", R::NAME);
    }
}

#[cfg(target_pointer_width = "64")]
#[test]
fn sizes() {
    let mut table = String::from("Bytes, 64-bit host.\ntype        real  grid       bytes\n");
    sizes_of::<f32, G6x5>(&mut table);
    sizes_of::<f32, G8x6>(&mut table);
    sizes_of::<f32, G11x8>(&mut table);
    sizes_of::<f64, G11x8>(&mut table);
    sizes_of::<f32, G12x9>(&mut table);
    sizes_of::<f32, G16x12>(&mut table);
    sizes_of::<f32, G22x16>(&mut table);
    let others = [
        ("StepReport", size_of::<StepReport>()),
        ("Sample", size_of::<Sample>()),
        ("Event", size_of::<Event>()),
    ];
    for (name, bytes) in others {
        line!(table, "{name:10}  -    -       {bytes:8}");
    }
    check("sizes.txt", &table);
}

/// What the comparison is worth: another figure, a line more and a line less are seen and shown.
#[test]
fn the_check_can_fail() {
    assert_eq!(beside("a 1\nb 2\n", "a 1\nb 2\n"), None);
    let both = beside("a 1\nb 2\n", "a 1\nb 3\nc 4\n").expect("they differ");
    assert!(both.contains("         | a 1\nexpected | b 2\nfound    | b 3\n"), "{both}");
    assert!(both.contains("expected | (nothing)\nfound    | c 4\n"), "{both}");
    assert!(beside("a 1\nb 2\n", "a 1\n").is_some(), "a line less");
    assert!(beside("", "a 1\n").is_some(), "a file that is not there");
}
