//! Promise: SI goes in, model units run, SI comes out: nothing is lost on the way, and the numbers mean
//! what a plate of paper means.

use dogleaf_core::LoneLeaf;
use dogleaf_core::grid::{G6x5, G11x8, G12x9, G16x12, Grid};
use dogleaf_core::potential::{bending, gravity};
use dogleaf_core::real::V3;
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::scene::{Fidelity, LeafSpec, PaperSpec, Preset, Units, WorldSpec};
use dogleaf_core::state::{Field, Sheet};
use dogleaf_tests::posed::seed_paper;
use dogleaf_tests::random::Pcg;

/// Book of the size of a hand.
const SIZE_M: [f64; 2] = [0.13, 0.20];

fn close(found: f64, expected: f64, share: f64) {
    assert!(found.is_finite() && expected != 0.0, "{found} and {expected} can be compared");
    assert!((found / expected - 1.0).abs() < share, "{found} is not {expected}");
}

fn there_and_back(units: &Units, value: f64) {
    close(units.to_metres(units.length(value)), value, 1e-14);
    close(units.to_joules(units.energy(value)), value, 1e-14);
    close(units.to_kilograms(units.mass(value)), value, 1e-14);
    close(units.length(units.to_metres(value)), value, 1e-14);
    close(units.energy(units.to_joules(value)), value, 1e-14);
    close(units.mass(units.to_kilograms(value)), value, 1e-14);
}

#[test]
fn what_goes_in_comes_out() {
    let mut random = Pcg::new(60);
    for _ in 0..1000 {
        let (width, height) = (random.within(0.001, 10.0), random.within(0.001, 10.0));
        let units = Units::of_leaf(width, height, random.within(1.0, 10_000.0));
        let size = 10.0_f64.powf(random.within(-9.0, 9.0));
        there_and_back(&units, size);
        there_and_back(&units, -size);
    }
}

#[test]
fn a_leaf_is_twelve_wide_and_weighs_one() {
    let units = Units::of_leaf(0.15, 0.20, 80.0);
    close(units.length(0.15), WIDTH, 1e-15);
    close(units.mass(0.080 * 0.15 * 0.20), 1.0, 1e-15);
}

#[test]
fn a_joule_is_a_kilogram_metre_squared_per_second_squared() {
    let units = Units::of_leaf(0.15, 0.20, 80.0);
    let (mass, speed) = (units.mass(0.003), units.length(2.5));
    close(units.to_joules(0.5 * mass * speed * speed), 0.5 * 0.003 * 2.5 * 2.5, 1e-14);
}

#[test]
fn office_paper_has_the_rigidity_its_modulus_gives_it() {
    // 4.5 GPa · (0.104 mm)³ / 12 (1 - 0.2²), worked out by hand.
    close(PaperSpec::from(Preset::Office).rigidity_nm(), 4.394e-4, 1e-4);
}

fn sheet<G: Grid>(paper: &PaperSpec, units: &Units) -> Sheet<f64, G> {
    let mut sheet = Sheet::ZERO;
    sheet.fill(WIDTH, units.length(SIZE_M[1]), paper, units, 1.0);
    sheet
}

/// Which way a cylinder is rolled, from across (0) over askew to along (1).
fn height(askew: f64, kappa: f64, s: f64, z: f64) -> f64 {
    let (sin, cos) = (askew * core::f64::consts::FRAC_PI_2).sin_cos();
    let along = cos * s + sin * z;
    0.5 * kappa * along * along
}

/// Bending energy of all differences of a sheet over a height field, and the area they stand for.
fn bent<G: Grid>(sheet: &Sheet<f64, G>, y: impl Fn(f64, f64) -> f64) -> [f64; 4] {
    let [lx, lz] = sheet.spacing;
    let at = |i: usize, k: usize| {
        let (s, z) = (lx * (i as f64 - 4.0), lz * (k as f64 - 3.0));
        V3([s, y(s, z), z])
    };
    let mut sums = [0.0; 4];
    for (i, k) in Field::<f64, G>::nodes() {
        let (a, b, c) = (sheet.across.at(i, k), sheet.along.at(i, k), sheet.twist.at(i, k));
        if a > 0.0 {
            sums[0] += bending::second(at(i, k), at(i + 1, k), at(i - 1, k), a).norm_sq();
        }
        if b > 0.0 {
            sums[1] += bending::second(at(i, k), at(i, k + 1), at(i, k - 1), b).norm_sq();
        }
        if c > 0.0 {
            let corners = [at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)];
            sums[2] += bending::mixed(corners, c).norm_sq();
        }
    }
    sums[3] = lx * lz;
    sums
}

/// Cells each kind of difference stands for: columns inside, rows inside, all cells.
fn cells<G: Grid>() -> [f64; 3] {
    let (x, z) = ((G::NX - 1) as f64, (G::NZ - 1) as f64);
    // Along, the held spine column stores nothing, and the fore-edge half a cell.
    [(x - 1.0) * z, (z - 1.0) * (x - 0.5), x * z]
}

/// Joules per square metre of a sheet bent to `kappa_per_m` in the direction `askew`.
fn stored<G: Grid>(paper: &PaperSpec, kappa_per_m: f64, askew: f64) -> f64 {
    let units = Units::of_leaf(SIZE_M[0], SIZE_M[1], paper.areal_mass_gsm);
    let kappa = kappa_per_m * units.metres;
    let [x, z, twist, cell] = bent(&sheet::<G>(paper, &units), |s, z| height(askew, kappa, s, z));
    let [nx, nz, nt] = cells::<G>();
    let per_area = (x / nx + z / nz + twist / nt) / cell;
    units.to_joules(per_area) / (units.metres * units.metres)
}

fn cylinders<G: Grid>() {
    for (name, preset) in Preset::ALL {
        let paper = PaperSpec::from(preset);
        for askew in [0.0, 0.3, 0.5, 1.0] {
            let expected = 0.5 * paper.rigidity_nm() * 0.4 * 0.4;
            let found = stored::<G>(&paper, 0.4, askew);
            assert!((found / expected - 1.0).abs() < 1e-3, "{name} at {askew}: {found}");
        }
    }
}

#[test]
fn a_cylinder_stores_half_its_rigidity_times_curvature_squared_whichever_way_it_is_rolled() {
    cylinders::<G6x5>();
    cylinders::<G11x8>();
    cylinders::<G12x9>();
    cylinders::<G16x12>();
}

#[test]
fn a_saddle_costs_as_much_as_its_two_cylinders() {
    let paper = PaperSpec::default();
    let units = Units::of_leaf(SIZE_M[0], SIZE_M[1], paper.areal_mass_gsm);
    let [x, z, _, _] = bent(&sheet::<G11x8>(&paper, &units), |s, z| 1e-3 * (s * s - z * z));
    let [nx, nz, _] = cells::<G11x8>();
    close(x / nx, z / nz, 1e-9);
    assert!(x > 0.0);
}

#[test]
fn the_clamp_bends_half_a_cell() {
    let paper = PaperSpec::default();
    let units = Units::of_leaf(SIZE_M[0], SIZE_M[1], paper.areal_mass_gsm);
    let s = sheet::<G11x8>(&paper, &units);
    // The first edge turns by half of what an inner node turns, over half the length.
    let half = s.hinge * s.hinge * 0.25;
    close(half, 0.5 * s.across.at(1, 1) * s.across.at(1, 1), 1e-14);
}

#[test]
fn the_seeds_weights_are_taken_as_they_are() {
    let paper = seed_paper();
    let s = sheet::<G11x8>(&paper, &Units::of_leaf(SIZE_M[0], SIZE_M[1], 80.0));
    close(s.across.at(1, 1) * s.spacing[0], 120.0_f64.sqrt(), 1e-14);
    close(s.along.at(1, 1) * s.spacing[1], 120.0_f64.sqrt(), 1e-14);
    assert_eq!((s.cross, s.twist.at(1, 1), s.position), (1.0, 0.0, 400.0));
}

fn total<G: Grid>(paper: &PaperSpec) -> f64 {
    let s = sheet::<G>(paper, &Units::of_leaf(SIZE_M[0], SIZE_M[1], paper.areal_mass_gsm));
    Field::<f64, G>::nodes().map(|(i, k)| s.mass.at(i, k)).sum()
}

#[test]
fn the_masses_of_all_nodes_sum_to_one_leaf() {
    for paper in [PaperSpec::default(), seed_paper()] {
        close(total::<G6x5>(&paper), 1.0, 1e-14);
        close(total::<G11x8>(&paper), 1.0, 1e-14);
        close(total::<G16x12>(&paper), 1.0, 1e-14);
    }
}

fn lone(paper: &PaperSpec) -> Box<LoneLeaf<f64, G11x8>> {
    let mut leaf = Box::new(LoneLeaf::EMPTY);
    let (spec, world) = (LeafSpec::default(), WorldSpec::default());
    leaf.open(&spec, paper, &world, Fidelity::default()).expect("the defaults are sound");
    leaf
}

#[test]
fn a_leaf_weighs_its_area_times_its_areal_mass_in_newtons() {
    for (_, preset) in Preset::ALL {
        let paper = PaperSpec::from(preset);
        let leaf = lone(&paper);
        let (units, sheet) = (leaf.units(), leaf.sheet());
        let fall = V3([0.0, -units.length(9.81), 0.0]);
        let pull = |(i, k)| gravity::gradient(sheet.mass.at(i, k), fall).0[1];
        let weight: f64 = Field::<f64, G11x8>::nodes().map(pull).sum();
        // A force is an energy per length.
        let newtons = units.to_joules(weight) / units.to_metres(1.0);
        close(newtons, paper.areal_mass_gsm * 1e-3 * 0.15 * 0.20 * 9.81, 1e-12);
    }
}

#[test]
fn a_leaf_lies_where_its_size_in_metres_says() {
    let leaf = lone(&PaperSpec::default());
    let metres = |i, k| leaf.leaf().x.at(i, k).0.map(|c| leaf.units().to_metres(c));
    let [tail, head] = [metres(10, 0), metres(10, 7)];
    close(tail[0], 0.15, 1e-12);
    close(tail[2], 0.10, 1e-12);
    close(head[2], -0.10, 1e-12);
}

#[test]
fn a_wrong_conversion_is_caught() {
    let paper = PaperSpec::default();
    let mut units = Units::of_leaf(SIZE_M[0], SIZE_M[1], paper.areal_mass_gsm);
    units.kilograms *= 1.01;
    let [x, _, _, cell] = bent(&sheet::<G11x8>(&paper, &units), |s, z| height(0.0, 0.01, s, z));
    let right = Units::of_leaf(SIZE_M[0], SIZE_M[1], paper.areal_mass_gsm);
    let found = right.to_joules(x / cells::<G11x8>()[0] / cell);
    let expected = 0.5 * paper.rigidity_nm() * 0.01 * 0.01;
    assert!((found / expected - 1.0).abs() > 1e-3);
}
