//! Books, papers and worlds at random: such as readers have, and such as nobody has.

use crate::gesture::{Rng, Scene};
use dogleaf_core::hand::View;
use dogleaf_core::real::Real;
use dogleaf_core::scene::{
    BookSpec, Cover, Direction, Fidelity, PaperSpec, Preset, Weights, WorldSpec,
};

/// A draw from a list.
pub fn one_of<T: Copy>(rng: &mut Rng, all: &[T]) -> T {
    all[(rng.bits() % all.len() as u64) as usize]
}
/// A draw between two numbers, evenly over their logarithms.
pub fn log_within(rng: &mut Rng, least: f64, most: f64) -> f64 {
    (least.max(1e-300) * (rng.within(0.0, 1.0) * log(most / least)).exponential())
        .clamp(least, most)
}
/// The natural logarithm, from the core's own exponential: the system's differs between systems, and so would a case.
fn log(v: f64) -> f64 {
    (0..64).fold(0.0, |y: f64, _| {
        let e = y.exponential();
        y + 2.0 * (v - e) / (v + e)
    })
}
/// True in so many of a hundred draws.
pub fn percent(rng: &mut Rng, share: u64) -> bool {
    rng.bits() % 100 < share
}

/// What kind of world a case is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum World {
    /// A reader's book on a table.
    #[default]
    Readers,
    /// The default book with the seed's raw weights.
    Seeds,
    /// Anything that is not refused.
    Wild,
}

impl World {
    /// Each with its name in the figures.
    pub const ALL: [(&'static str, Self); 3] = [
        ("readers' worlds", Self::Readers),
        ("the seed's weights", Self::Seeds),
        ("wild worlds", Self::Wild),
    ];

    /// Of twenty cases two are wild and three the seed's.
    pub fn draw(rng: &mut Rng) -> Self {
        match rng.bits() % 20 {
            0 | 1 => Self::Wild,
            2..=4 => Self::Seeds,
            _ => Self::Readers,
        }
    }
    /// A scene of this kind.
    pub fn scene(self, rng: &mut Rng) -> Scene {
        match self {
            Self::Readers => sound(rng, false),
            Self::Seeds => sound(rng, true),
            Self::Wild => wild(rng),
        }
    }
}

fn sound(rng: &mut Rng, seeds: bool) -> Scene {
    let mut scene = if seeds { Scene::seed() } else { Scene::of(book(rng)) };
    if !seeds {
        scene.paper = paper(rng);
        scene.world.gravity = gravity(rng);
        scene.world.damping_per_s = log_within(rng, 0.3, 5.0);
        // No thicker than a telephone book: two thirds as thick as wide.
        let most = 2.0 * 0.67 * scene.book.width_m / (scene.paper.thickness_mm * 1e-3);
        scene.book.pages = scene.book.pages.min(most as u32).max(1);
        scene.book.open_at = (rng.within(0.0, 1.0) * f64::from(scene.book.pages + 1)) as u32;
    }
    scene.world.step_us = one_of(rng, &[16_667, 16_667, 16_667, 33_333, 8_333, 4_167]);
    scene.fidelity =
        one_of(rng, &[Fidelity::Standard, Fidelity::Standard, Fidelity::Draft, Fidelity::Fine]);
    scene
}

fn book(rng: &mut Rng) -> BookSpec {
    let width_m = log_within(rng, 0.08, 0.3);
    BookSpec {
        width_m,
        height_m: width_m * rng.within(0.8, 1.8),
        pages: log_within(rng, 1.0, 1200.0) as u32,
        open_at: 0,
        cover: one_of(rng, &[Cover::Hard, Cover::Soft]),
        direction: one_of(rng, &[Direction::Ltr, Direction::Rtl]),
    }
}

fn paper(rng: &mut Rng) -> PaperSpec {
    let (_, preset) = one_of(rng, &Preset::ALL);
    let mut paper = PaperSpec::from(preset);
    if percent(rng, 30) {
        paper.areal_mass_gsm *= rng.within(0.7, 1.4);
        paper.youngs_gpa *= log_within(rng, 0.5, 2.0);
        paper.thickness_mm *= rng.within(0.8, 1.25);
    }
    paper
}

/// The Earth's, mostly; at times another planet's, or a table that leans by up to twenty degrees.
fn gravity(rng: &mut Rng) -> [f64; 3] {
    let g = if percent(rng, 80) { 9.81 } else { rng.within(5.0, 15.0) };
    if percent(rng, 80) {
        return [0.0, -g, 0.0];
    }
    let (lean, way) = (rng.within(0.0, 0.35), rng.within(0.0, core::f64::consts::TAU));
    [g * lean.sine() * way.cosine(), -g * lean.cosine(), g * lean.sine() * way.sine()]
}

fn wild(rng: &mut Rng) -> Scene {
    let width_m = log_within(rng, 0.001, 10.0);
    let height_m = (width_m * log_within(rng, 0.2, 5.0)).clamp(0.001, 10.0);
    let pages = log_within(rng, 1.0, 20_000.0) as u32;
    let open_at = (rng.within(0.0, 1.0) * f64::from(pages + 1)) as u32;
    let size = BookSpec { width_m, height_m, pages, open_at, ..book(rng) };
    let mut scene = Scene::of(size);
    scene.paper = PaperSpec {
        areal_mass_gsm: log_within(rng, 1.0, 10_000.0),
        thickness_mm: log_within(rng, 0.001, 10.0),
        youngs_gpa: log_within(rng, 1e-6, 1000.0),
        poisson: rng.within(0.0, 0.49),
        weights: percent(rng, 40).then(|| weights(rng)),
    };
    let strength = log_within(rng, 1e-3, 1000.0);
    let [x, y, z] = [0; 3].map(|_| rng.within(-1.0, 1.0));
    let still = percent(rng, 10);
    scene.world = WorldSpec {
        gravity: if still { [0.0; 3] } else { [x * strength, y * strength, z * strength] },
        damping_per_s: if percent(rng, 20) { 0.0 } else { log_within(rng, 0.01, 1000.0) },
        step_us: log_within(rng, 1000.0, 100_000.0) as u32,
        seed: rng.bits(),
    };
    scene.fidelity = one_of(rng, &Fidelity::ALL[..3]).1;
    scene
}

fn weights(rng: &mut Rng) -> Weights {
    let mut draw = || log_within(rng, 1e-3, 1e6);
    Weights { bend_3d: draw(), bend_2d: draw(), glue: draw(), iso_3d: draw(), position: draw() }
}

/// The same book from elsewhere.
pub fn view(rng: &mut Rng, scene: &Scene) -> View {
    let [width, height] = [0; 2].map(|_| rng.within(200.0, 2000.0) as u32);
    let mut view = View::reading(scene.book.width_m, scene.book.height_m, width, height);
    let side = scene.book.width_m;
    view.eye_m.iter_mut().for_each(|c| *c += side * rng.within(-0.8, 0.8));
    view
}
