//! Scenarios 21-26: a hand that asks the impossible.

use super::harness::{Rules, Seen, at as with, play};
use super::{At, Found};
use crate::gesture::{Eye, Gesture, Rng, Scene, TOUCH_US};
use dogleaf_core::event::Event;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;

fn press(eye: &Eye) -> Gesture {
    Gesture::press(eye.page(0.9, 0.8))
}

/// Plays each gesture on a scene of its own; answers the runs, with their faults named.
fn each<R: Real>(
    at: At,
    rules: &Rules,
    gestures: impl IntoIterator<Item = (&'static str, Vec<Sample>)>,
    figure: impl Fn(&Seen<R>) -> f64,
) -> Found {
    let scene = with(&Scene::default(), at);
    let mut found = Found::default();
    for (name, samples) in gestures {
        let seen = play::<R>(&scene, &samples, rules);
        found.figure = found.figure.max(figure(&seen));
        let [lifted, committed, cancelled] = seen.watch.turns();
        let once = lifted == committed + cancelled && lifted <= 1;
        found.expect(once, || format!("{name}: {lifted} = {committed} + {cancelled}"));
        found.faults.extend(seen.faults.into_iter().map(|f| format!("{name}: {f}")));
    }
    found
}

fn worst<R: Real>(seen: &Seen<R>) -> f64 {
    seen.watch.air.worst
}

/// 21: a press that does not move; a drag into the binding, which cannot be reached and must not be divided by.
pub fn at_home<R: Real>(at: At) -> Found {
    let eye = Scene::default().eye();
    let into = |along: f64| press(&eye).to(eye.page(0.0, along), 600_000).hold(400_000).up();
    let gestures = [
        ("held where it lies", press(&eye).hold(1_000_000).up()),
        ("to the binding", into(0.8)),
        ("to the binding's middle", into(0.0)),
        ("beside the binding", press(&eye).to(eye.page(0.02, 0.8), 600_000).hold(400_000).up()),
        ("pressed near the binding", Gesture::press(eye.page(0.05, 0.0)).hold(500_000).up()),
    ];
    each::<R>(at, &Rules::GENTLE, gestures, worst)
}

/// 22: beyond every screen; the leaf bears it and comes to rest.
pub fn far<R: Real>(at: At) -> Found {
    let eye = Scene::default().eye();
    let away = [[1e6, 0.0], [-1e6, 0.0], [0.0, 1e6], [0.0, -1e6], [1e6, 1e6]];
    let gestures =
        away.map(|place| ("a thousand widths", press(&eye).to(place, 200_000).hold(800_000).up()));
    each::<R>(at, &Rules::WILD, gestures, worst)
}

/// 23: from corner to corner, another every sample.
pub fn teleports<R: Real>(at: At) -> Found {
    let eye = Scene::default().eye();
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(|(x, z)| eye.page(x, z));
    let gestures = (0..at.count(8, 2)).map(|seed| {
        let mut rng = Rng::new(seed.into());
        let jump = |g: Gesture, _| g.to(corners[(rng.bits() % 4) as usize], TOUCH_US);
        ("teleports", (0..240).fold(press(&eye), jump).up())
    });
    each::<R>(at, &Rules::WILD, gestures, worst)
}

/// 24: a circle over the spine, twenty times a second. What energy there is came from the hand: speeds stay those of
/// a leaf that is led, and all of it is gone four seconds after.
pub fn scribble<R: Real>(at: At) -> Found {
    let eye = Scene::default().eye();
    let (a, b) = (eye.above(-0.6, 0.4, 0.8), eye.above(0.6, 0.4, 0.8));
    let seconds = f64::from(at.count(60, 6));
    let round = |t: f64| {
        let angle = core::f64::consts::TAU * 20.0 * seconds * t;
        let middle = [0, 1].map(|c: usize| 0.5 * (a[c] + b[c]));
        let radius = 0.5 * (b[0] - a[0]);
        [middle[0] + radius * angle.cosine(), middle[1] + radius * angle.sine()]
    };
    let led = press(&eye).to(round(0.0), 200_000).along((seconds * 1e6) as u64, round);
    each::<R>(at, &Rules::WILD, [("scribble", led.up())], |seen| seen.fastest)
}

/// 25: where there is no room for a leaf. I4 is in the rules.
pub fn under<R: Real>(at: At) -> Found {
    let eye = Scene::default().eye();
    let through = eye.above(-0.5, -0.6, 0.8);
    let gestures = [
        ("through the other block", press(&eye).to(through, 800_000).up()),
        ("below its own block", press(&eye).to(eye.above(0.7, -0.8, 0.8), 500_000).up()),
        ("behind the spine", press(&eye).to(eye.above(0.0, 0.2, -3.0), 800_000).hold(300_000).up()),
        (
            "round the fore-edge",
            press(&eye).to(eye.above(1.5, -0.5, 0.8), 400_000).to(through, 600_000).up(),
        ),
    ];
    // In leaves: one of office paper is 0.0096 units thick.
    let leaf = 0.104e-3 / 0.13;
    each::<R>(at, &Rules::WILD, gestures, |seen| seen.watch.sunk / leaf)
}

/// 26: upright over the spine, and let go at rest: it decides for a side, the same everywhere.
pub fn dead_centre<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let eye = scene.eye();
    let led = press(&eye).to(eye.above(0.0, 0.7, 0.8), 700_000).hold(1_500_000);
    let seen = play::<R>(&scene, &led.up(), &Rules::GENTLE);
    let turned = seen.watch.events.iter().any(|e| matches!(e, Event::Committed { .. }));
    let ends = seen.watch.turns();
    let figure = if turned { seen.rested() } else { -seen.rested() };
    let mut found = Found { figure, faults: seen.faults };
    found.expect(ends[1] + ends[2] == 1, || format!("{ends:?}"));
    found
}
