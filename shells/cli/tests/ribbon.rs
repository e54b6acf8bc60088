//! Ribbons in a scene: what `run` tells of them, and that a scene without any is as it was.

mod common;

use common::{arg, fixture, folder, refused, run_lines, told};
use serde_json::Value;

fn points(rim: &Value) -> Vec<[f64; 3]> {
    let number = |v: &Value| v.as_f64().expect("a number");
    let point = |p: &Value| std::array::from_fn(|i| number(&p[i]));
    rim.as_array().expect("a list").iter().map(point).collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Middle of a ribbon's end.
fn end(ribbon: &Value) -> [f64; 3] {
    let [a, b] = ["rim_a", "rim_b"].map(|r| *points(&ribbon[r]).last().expect("points"));
    std::array::from_fn(|i| 0.5 * (a[i] + b[i]))
}

#[test]
fn both_borders_of_every_ribbon_are_told() {
    let here = folder("ribbon_two");
    let scene = arg(&here, "two.toml");
    let text = "[[ribbon]]\n[[ribbon]]\nsegments = 20\nat_m = [0.0, 0.0, 1.0]\nstart = 'ring'\n";
    std::fs::write(&scene, text).expect("a file");
    let obj = arg(&here, "obj");
    let lines = run_lines(&[&scene, "--frames", "3", "--obj", &obj]);
    assert_eq!(lines[0]["parts"], serde_json::json!(["ribbon"]), "{}", lines[0]);
    assert!(lines[0].get("grid").is_none(), "no leaf, no grid: {}", lines[0]);
    for frame in &lines[1..] {
        let ribbons = frame["ribbons"].as_array().expect("ribbons");
        assert_eq!(ribbons.len(), 2, "both");
        for (ribbon, n) in ribbons.iter().zip([51, 21]) {
            let (a, b) = (points(&ribbon["rim_a"]), points(&ribbon["rim_b"]));
            assert_eq!((a.len(), b.len()), (n, n), "one more than segments");
            assert!((distance(a[0], b[0]) - 0.05).abs() < 1e-6, "five centimetres wide");
            let most = ribbon["stretch"]["max"].as_f64().expect("a number");
            assert!(most < 1e-4, "stretch {most}");
        }
        for absent in ["leaf", "midline", "sheets"] {
            assert!(frame.get(absent).is_none(), "{absent} is not in the scene");
        }
        assert!(ribbons[0].get("gap").is_none(), "no loop");
        assert!(ribbons[1]["gap"].as_f64() < Some(1e-4), "a closed one");
    }
    let first = &lines[1]["ribbons"][0];
    assert_eq!(first["work"]["steps"], 0, "nothing has moved at first");
    let [x, y, z] = end(first);
    assert!((x - 1.0).abs() + y.abs() + z.abs() < 1e-3, "along X, level: {x} {y} {z}");
    let mesh = std::fs::read_to_string(here.join("obj/frame_00002.obj")).expect("a file");
    assert!(mesh.contains("\no Ribbon0\n") && mesh.contains("\no Ribbon1\n"), "both are in it");
    let count = |head: &str| mesh.lines().filter(|l| l.starts_with(head)).count();
    let face = mesh.lines().filter(|l| l.starts_with("f ")).flat_map(str::split_whitespace);
    let largest = face.filter_map(|c| c.split('/').next()?.parse::<usize>().ok()).max();
    assert_eq!(largest, Some(count("v ")), "faces count up to the last vertex");
}

#[test]
fn a_ribbon_beside_a_book_changes_nothing_of_it() {
    let here = folder("ribbon_book");
    let turn = std::fs::read_to_string(fixture("scenes/turn.toml")).expect("a scene");
    let gesture = fixture("gestures").replace('\\', "/");
    let turn = turn.replace("../gestures", &gesture);
    let [plain, with] = ["plain.toml", "with.toml"].map(|n| arg(&here, n));
    std::fs::write(&plain, &turn).expect("a file");
    let text = format!("{turn}\n[[ribbon]]\nlength_m = 0.3\nwidth_m = 0.006\nsegments = 20\n");
    std::fs::write(&with, text).expect("a file");
    let (plain, with) =
        (run_lines(&[&plain, "--frames", "40"]), run_lines(&[&with, "--frames", "40"]));
    assert_eq!(with[0]["parts"], serde_json::json!(["book", "ribbon"]), "both");
    for (a, b) in plain[1..].iter().zip(&with[1..]) {
        assert!(a.get("ribbons").is_none(), "none asked for, none told");
        for key in ["midline", "leaf", "events", "work"] {
            assert_eq!(a.get(key), b.get(key), "{key}");
        }
        assert_ne!(a["hash"], b["hash"], "the hash sees the ribbon");
    }
}

#[test]
fn a_clamped_ribbon_droops_as_the_heavy_elastica() {
    for real in ["f32", "f64"] {
        let lines = run_lines(&[&fixture("scenes/ribbon_droop_gamma_10.toml"), "--real", real]);
        let [x, y, _] = end(&lines.last().expect("frames")["ribbons"][0]);
        let ratio = -y / x;
        assert!((ratio / 1.066_802 - 1.0).abs() < 2e-3, "{real}: {ratio}");
    }
}

#[test]
fn the_end_follows_its_twist() {
    let lines = run_lines(&[
        &fixture("scenes/ribbon_torsion_wide.toml"),
        "--frames",
        "151",
        "--real",
        "f64",
    ]);
    // A turn in two seconds: after a second and a half the front, up at first, faces forward or back.
    let ribbon = &lines.last().expect("frames")["ribbons"][0];
    let [a, b] = ["rim_a", "rim_b"].map(|r| points(&ribbon[r]));
    let sub = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| a[i] - b[i]) };
    let (t, w) = (sub(a[50], a[49]), sub(b[50], a[50]));
    let n = [t[1] * w[2] - t[2] * w[1], t[2] * w[0] - t[0] * w[2], t[0] * w[1] - t[1] * w[0]];
    let norm = distance(n, [0.0; 3]);
    assert!(n[2] / norm < -0.99, "three quarters round: {:?}", n.map(|c| c / norm));
}

#[test]
fn a_moebius_band_has_its_energy() {
    let lines = run_lines(&[
        &fixture("scenes/ribbon_mobius_middle.toml"),
        "--frames",
        "1",
        "--real",
        "f64",
    ]);
    let ribbon = &lines[1]["ribbons"][0];
    let energy = ribbon["energy"]["potential"].as_f64().expect("a number");
    let (length, width, rigidity) = (0.6, 0.02, 2.7e-4);
    let pi = std::f64::consts::PI;
    let u = 2.0 * energy * length / (2.0 * pi * rigidity * width) / pi;
    assert!((u - 5.93).abs() < 0.01, "{u}");
    assert!(ribbon["gap"].as_f64().expect("a loop") < 1e-9, "closed");
}

#[test]
fn the_same_scene_gives_the_same_lines() {
    let args = ["run", &fixture("scenes/ribbon_helix_001.toml"), "--frames", "30", "--json", "-"];
    assert_eq!(told(&args), told(&args), "twice the same");
}

#[test]
fn what_cannot_be_is_refused_in_one_line() {
    let here = folder("ribbon_refused");
    let scene = arg(&here, "r.toml");
    for (text, wanted) in [
        (
            "[[ribbon]]\nlenght_m = 1",
            ":2: unknown key 'lenght_m' in [ribbon]; did you mean 'length_m'?",
        ),
        (
            "[[ribbon]]\nstart = 'helical'",
            ":2: unknown value 'helical' of ribbon.start; did you mean",
        ),
        ("[ribbon]\nlength_m = 1.0", "ribbon must be a list of tables: write [[ribbon]]"),
        ("[[ribbon]]\n[[ribbon]]\nsegments = 1", ":3: ribbon.segments is out of range"),
        ("[[ribbon]]\nsegments = 100000", ":2: ribbon.segments is out of range"),
        ("[[ribbon]]\nlength_m = nan", ":2: ribbon.length_m is not a finite number"),
        ("[[ribbon]]\nclamp_start = 1", ":2: ribbon.clamp_start must be true or false"),
        (
            "[[ribbon]]\nnormal = [1, 0, 0]",
            ":2: ribbon.normal and ribbon.along must be two directions",
        ),
        ("[[ribbon]]\nat_m = [inf, 0, 0]", ":2: ribbon.at_m is not a finite number"),
        (
            "[[ribbon]]\nspin_rad_per_s = [nan, 0, 0]",
            ":2: ribbon.spin_rad_per_s is not a finite number",
        ),
        (
            "[[ribbon]]\npulls = [{to_m = [0, nan, 0]}]",
            ":2: ribbon.pulls.to_m is not a finite number",
        ),
        ("[[ribbon]]\npulls = [{n_per_m = -1}]", ":2: ribbon.pulls.n_per_m is out of range"),
        ("[[ribbon]]\nfloor_n_per_m = 5.0", ":2: unknown key 'floor_n_per_m' in [ribbon]"),
        ("[[ribbon]]\n[hand]\nsamples=[{phase='down'}]", "[hand] needs a [book]"),
    ] {
        std::fs::write(&scene, text).expect("a file");
        let (error, code) = refused(&["run", &scene]);
        assert!(error.contains(wanted) && code == 2, "{error}\nshould say\n{wanted}");
    }
}

#[test]
fn what_falls_on_a_floor_stays_above_it() {
    let scene = fixture("scenes/ribbon_fall_150.toml");
    let lines = run_lines(&[&scene, "--frames", "45"]);
    let lowest = |frame: &Value| {
        let rims = ["rim_a", "rim_b"].map(|r| points(&frame["ribbons"][0][r]));
        rims.iter().flatten().map(|p| p[1]).fold(f64::INFINITY, f64::min)
    };
    assert!(lines[1..].iter().all(|l| lowest(l) > 0.0), "nothing is below the floor");
    let last = lines.last().expect("frames");
    assert!(lowest(last) < 2e-3, "it is down, as near as its cushion lets it");
    // Half a metre takes 0.32 s and ends at 3.1 m/s.
    let touches: Vec<(f64, &Value)> = lines[1..]
        .iter()
        .flat_map(|l| {
            let events = l["events"].as_array().expect("events");
            events.iter().map(|e| (l["time_s"].as_f64().expect("seconds"), e))
        })
        .filter(|(_, e)| e["event"] == "touched")
        .collect();
    let (time, first) = touches.first().expect("its fall is heard");
    let speed = first["m_per_s"].as_f64().expect("a speed");
    assert!((0.25..0.4).contains(time) && (2.0..4.0).contains(&speed), "{time} s: {first}");
    assert!(first["ribbon"] == 0 && first["vertices"].as_u64() > Some(0), "{first}");
}

#[test]
fn a_ribbon_that_is_pulled_by_nothing_is_not_heard() {
    let lines = run_lines(&[&fixture("scenes/ribbon_droop_gamma_10.toml"), "--frames", "5"]);
    let touched = |l: &Value| {
        l["events"].as_array().is_some_and(|e| e.iter().any(|e| e["event"] == "touched"))
    };
    assert!(!lines[1..].iter().any(touched), "nothing to touch");
}

#[test]
fn chains_stay_closed_and_lose_energy() {
    for (name, links) in [("ribbon_mobius_chain", 9), ("ribbon_double_chain", 18)] {
        let scene = fixture(&format!("scenes/{name}.toml"));
        let lines = run_lines(&[&scene, "--frames", "4", "--real", "f64"]);
        let total = |l: &Value| {
            let part = |k: &str| l["energy"][k].as_f64().expect("joules");
            part("kinetic") + part("potential")
        };
        for pair in lines[1..].windows(2) {
            assert!(total(&pair[1]) < total(&pair[0]), "{name}: energy from nowhere");
        }
        for frame in &lines[1..] {
            let ribbons = frame["ribbons"].as_array().expect("ribbons");
            assert_eq!(ribbons.len(), links, "{name}");
            assert!(ribbons.iter().all(|r| r["gap"].as_f64() < Some(1e-5)), "{name} is closed");
        }
    }
}
