//! The JSON lines of `run`: what tools and tests rely on.

mod common;

use common::{arg, fixture, folder, run_lines, told};
use serde_json::Value;

fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> =
        value.as_object().expect("an object").keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|n| n.as_f64().expect("a number")).collect()
}

#[test]
fn a_lone_leaf_has_a_leaf_and_no_midline() {
    let lines = run_lines(&[&fixture("scenes/lone_leaf.toml"), "--frames", "3"]);
    assert_eq!(lines.len(), 4, "a header and three frames");
    let header = &lines[0];
    assert_eq!(header["dogleaf"], env!("CARGO_PKG_VERSION"), "version");
    assert_eq!((&header["real"], &header["units"]), (&"f32".into(), &"SI".into()), "{header}");
    let wanted =
        ["energy", "events", "frame", "hash", "leaf", "status", "stretch", "time_s", "work"];
    for (n, frame) in lines[1..].iter().enumerate() {
        assert_eq!(keys(frame), wanted, "frame {n}");
        assert_eq!(frame["frame"], n, "its number");
        let hash = frame["hash"].as_str().expect("text");
        assert!(hash.len() == 16 && u64::from_str_radix(hash, 16).is_ok(), "{hash}");
        assert_eq!(keys(&frame["stretch"]), ["max", "rms"], "stretch");
        assert_eq!(keys(&frame["energy"]), ["kinetic", "potential"], "energy");
    }
    assert_eq!(lines[1]["time_s"], 0.0, "the first frame is the start");
    assert_eq!(lines[2]["status"], "converged", "a status by name");
    assert_eq!(lines[2]["work"]["newton_steps"], 1, "counts");
}

#[test]
fn nodes_go_from_the_spine_out_and_from_tail_to_head() {
    let lines = run_lines(&[&fixture("scenes/lone_leaf.toml"), "--frames", "1"]);
    let leaf = &lines[1]["leaf"];
    assert_eq!((&leaf["nx"], &leaf["nz"]), (&11.into(), &8.into()), "the grid");
    let nodes: Vec<Vec<f64>> =
        leaf["nodes"].as_array().expect("a list").iter().map(numbers).collect();
    assert_eq!(nodes.len(), 88, "all of them");
    let near = |a: &[f64], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-7);
    assert!(near(&nodes[0], [0.0, 0.0, 0.1]), "spine, tail: {:?}", nodes[0]);
    assert!(near(&nodes[7], [0.0, 0.0, -0.1]), "spine, head: {:?}", nodes[7]);
    assert!(near(&nodes[80], [0.15, 0.0, 0.1]), "fore-edge, tail: {:?}", nodes[80]);
}

#[test]
fn a_book_has_a_midline_of_fifteen_and_a_leaf_while_it_is_in_the_air() {
    let lines = run_lines(&[&fixture("scenes/turn.toml")]);
    let frames = &lines[1..];
    for frame in frames {
        let midline: Vec<Vec<f64>> =
            frame["midline"].as_array().expect("a list").iter().map(numbers).collect();
        assert_eq!(midline.len(), 15, "fifteen nodes");
        assert_eq!(midline[7], [0.0, 0.0], "the fixed centre");
        assert!(midline.windows(2).all(|w| w[0][0] < w[1][0]), "left to right: {midline:?}");
        assert!(midline[0][0] < -0.11 && midline[14][0] > 0.11, "metres: {midline:?}");
        for absent in ["ribbons", "sheets"] {
            assert!(frame.get(absent).is_none(), "{absent} is not in the scene");
        }
    }
    assert!(frames[0].get("leaf").is_none(), "nothing in the air at first");
    assert!(frames.iter().any(|f| f.get("leaf").is_some()), "then a leaf");
    let events: Vec<&Value> =
        frames.iter().flat_map(|f| f["events"].as_array().expect("a list")).collect();
    let names: Vec<&str> = events.iter().map(|e| e["event"].as_str().expect("a name")).collect();
    assert_eq!(names, ["lifted", "committed", "asleep"], "its story");
    assert_eq!(events[1]["page"], 10, "two pages on");
    let last = frames.last().expect("frames");
    assert!(last.get("leaf").is_none() && last["energy"]["kinetic"] == 0.0, "at rest: {last}");
}

#[test]
fn the_same_scene_gives_the_same_lines() {
    let args = ["run", &fixture("scenes/turn.toml"), "--json", "-"];
    assert_eq!(told(&args), told(&args), "twice the same");
}

#[test]
fn outputs_go_where_they_are_sent() {
    let here = folder("run_outputs");
    let (json, obj) = (arg(&here, "frames.jsonl"), arg(&here, "obj"));
    let scene = fixture("scenes/turn.toml");
    let text = told(&["run", &scene, "--frames", "20", "--json", &json, "--obj", &obj]);
    assert!(text.contains("frames     20"), "a summary: {text}");
    assert_eq!(std::fs::read_to_string(json).expect("a file").lines().count(), 21, "lines");
    let mesh = std::fs::read_to_string(here.join("obj/frame_00019.obj")).expect("a file");
    for wanted in ["\no net\n", "\no LeafUp\n", "\no RightTop\n", "\nf "] {
        assert!(mesh.contains(wanted), "{wanted:?}");
    }
}

#[test]
fn every_grid_and_scalar_runs() {
    let here = folder("run_grids");
    for grid in ["6, 5", "8, 6", "11, 8", "12, 9", "16, 12", "22, 16", "32, 24"] {
        let scene = here.join("leaf.toml");
        std::fs::write(&scene, format!("[leaf]\ngrid = [{grid}]\n")).expect("a file");
        for real in ["f32", "f64"] {
            let path = scene.to_str().expect("a path");
            let lines = run_lines(&[path, "--frames", "3", "--real", real]);
            assert_eq!(lines[0]["real"], real, "{grid}");
            assert_eq!(lines[3]["status"], "converged", "{grid} {real}");
        }
    }
}
