//! `bench --json`: every part has its figures, and a step allocates nothing.

mod common;

use common::told;
use serde_json::Value;

#[test]
fn parts_bytes_and_no_allocation() {
    let text = told(&["bench", "--turns", "1", "--json"]);
    let report: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(report["allocations"], 0, "a step allocates nothing");
    assert_eq!(report["grid"], serde_json::json!([11, 8]), "the grid");
    for key in ["cpu", "level", "flags", "rustc", "date", "target"] {
        assert!(report[key].is_string(), "{key}");
    }
    for real in ["f32", "f64"] {
        let side = &report[real];
        let names: Vec<&str> = side["parts"]
            .as_array()
            .expect("parts")
            .iter()
            .map(|p| p["name"].as_str().expect("a name"))
            .collect();
        let wanted = ["midline", "assemble", "factor", "solve", "merit", "collisions", "other"];
        assert_eq!(names, wanted, "{real}");
        for figure in ["median", "p95", "p99"] {
            assert!(side["step_us"][figure].as_f64() > Some(0.0), "{real} {figure}");
        }
        assert!(side["bytes"]["book"].as_u64() > side["bytes"]["solver"].as_u64(), "{real}");
        assert_eq!(side["trail"].as_str().map(str::len), Some(16), "{real}");
    }
    let ribbons = &report["ribbons"];
    let scenes = ribbons["scenes"].as_array().expect("scenes");
    let names: Vec<&str> = scenes.iter().map(|s| s["scene"].as_str().expect("a name")).collect();
    assert_eq!(names, ["helix h=0.01", "helix h=0.05", "fall n=150", "torsion 4 pi"], "in order");
    for scene in scenes {
        assert_eq!(scene["allocations"], 0, "a ribbon's step allocates nothing: {scene}");
        // A step has several minima: once at most is the seed's method's the lower one.
        let count = |name: &str| scene[name].as_u64().expect("a count");
        assert!(count("newton_arrives") + 1 >= count("steps"), "{scene}");
        assert!(scene["step_us"]["median"].as_f64() > Some(0.0), "{scene}");
    }
    assert!(ribbons["bytes"][1][0].as_u64() < Some(100_000), "{ribbons}");
}
