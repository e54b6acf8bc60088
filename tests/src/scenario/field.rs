//! Scenarios 36 and 37: anything at all where something is expected.

use super::harness::{Pages, Rules, at as with, play};
use super::stream::half_way;
use super::{At, Found};
use crate::crc::crc32;
use crate::gesture::{Gesture, Scene};
use crate::soak::{Case, draw::World, kept};
use crate::watch::fault;
use dogleaf_core::grid::G11x8;
use dogleaf_core::real::Real;
use dogleaf_core::record::{Reader, replay_with};
use dogleaf_core::scene::Weights;
use std::ops::ControlFlow;

type Set = fn(&mut Scene, f64);

/// Every field of a scene that is a number.
const FIELDS: [(&str, Set); 24] = [
    ("book.width_m", |s, v| s.book.width_m = v),
    ("book.height_m", |s, v| s.book.height_m = v),
    ("book.pages", |s, v| s.book.pages = v as u32),
    ("book.open_at", |s, v| s.book.open_at = v as u32),
    ("paper.areal_mass_gsm", |s, v| s.paper.areal_mass_gsm = v),
    ("paper.thickness_mm", |s, v| s.paper.thickness_mm = v),
    ("paper.youngs_gpa", |s, v| s.paper.youngs_gpa = v),
    ("paper.poisson", |s, v| s.paper.poisson = v),
    ("bend_3d", |s, v| s.paper.weights = Some(Weights { bend_3d: v, ..Weights::default() })),
    ("bend_2d", |s, v| s.paper.weights = Some(Weights { bend_2d: v, ..Weights::default() })),
    ("glue", |s, v| s.paper.weights = Some(Weights { glue: v, ..Weights::default() })),
    ("iso_3d", |s, v| s.paper.weights = Some(Weights { iso_3d: v, ..Weights::default() })),
    ("position", |s, v| s.paper.weights = Some(Weights { position: v, ..Weights::default() })),
    ("gravity x", |s, v| s.world.gravity[0] = v),
    ("gravity y", |s, v| s.world.gravity[1] = v),
    ("gravity z", |s, v| s.world.gravity[2] = v),
    ("damping_per_s", |s, v| s.world.damping_per_s = v),
    ("step_us", |s, v| s.world.step_us = v as u32),
    ("eye x", |s, v| s.view.eye_m[0] = v),
    ("eye y", |s, v| s.view.eye_m[1] = v),
    ("target z", |s, v| s.view.target_m[2] = v),
    ("fov", |s, v| s.view.fov_y_deg = v),
    ("width_px", |s, v| s.view.width_px = v as u32),
    ("height_px", |s, v| s.view.height_px = v as u32),
];

const VALUES: [f64; 14] = [
    0.0,
    -0.0,
    -1.0,
    1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MIN_POSITIVE,
    5e-324,
    f64::MAX,
    f64::MIN,
    f64::EPSILON,
    1e9,
    4_294_967_295.0,
];

/// 36: refused, and the book is as it was; or taken, and it is a book.
pub fn fields<R: Real>(at: At) -> Found {
    let usual = with(&Scene::default(), at);
    let (turning, _) = half_way::<R>(&usual);
    let (hash, mut book) = (turning.book.state_hash(), turning.book.clone());
    let mut found = Found::default();
    for (name, set) in FIELDS {
        for value in VALUES {
            let mut scene = usual;
            set(&mut scene, value);
            let s = &scene;
            if book.open(&s.book, &s.paper, &s.world, &s.view, s.fidelity).is_err() {
                found.figure += 1.0;
                let same = book.state_hash() == hash;
                found.expect(same, || format!("{name} = {value}: refused, but the book changed"));
                continue;
            }
            book = turning.book.clone();
            if value == 1.0 {
                let samples = Gesture::corner_turn(&scene.eye(), 7);
                let seen = play::<R>(&scene, &samples, &Rules::NUMBERS);
                let named = |f| format!("{name} = {value}: {f}");
                found.faults.extend(seen.faults.into_iter().map(named));
            }
        }
    }
    found
}

/// 37: a recording is the one picture of a state there is. Every bit flipped is refused; with a checksum made
/// to fit it is refused or replays as a book.
pub fn flips<R: Real>(at: At) -> Found {
    let mut case = (0..).map(|n| Case::new(7, n)).find(|c| c.world == World::Readers);
    let mut found = Found::default();
    let Some(case) = &mut case else { return found };
    case.scene.fidelity = at.fidelity;
    let Ok(bytes) = kept::record::<R>(case) else { return found };
    found.expect(Reader::open(&bytes).is_ok(), || "a recording is refused".into());
    let length = bytes.len().min(4096);
    let mut book = Box::new(Pages::<R>::EMPTY);
    for bit in (0..8 * length).step_by(at.count(1, 29) as usize) {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        if Reader::open(&flipped).is_ok() {
            found.faults.push(format!("bit {bit} flipped, and believed"));
        }
        let body = flipped.len() - 4;
        let crc = crc32(&flipped[..body]);
        flipped[body..].copy_from_slice(&crc.to_le_bytes());
        let Ok(reader) = Reader::open(&flipped) else { continue };
        found.figure += 1.0;
        // Most flips are of hashes and places: a few steps of one in a hundred are enough.
        if bit % 101 == 0 {
            let complaint = replayed::<R>(&reader, &mut book);
            found.faults.extend(complaint.map(|what| format!("bit {bit}: {what}")));
        }
    }
    found
}

fn replayed<R: Real>(reader: &Reader<'_>, book: &mut Pages<R>) -> Option<String> {
    let mut complaint = None;
    let _ = replay_with::<R, G11x8>(reader, book, |seen| {
        complaint = fault(seen.book);
        let stop = complaint.is_some() || seen.step > 40;
        if stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    complaint
}
