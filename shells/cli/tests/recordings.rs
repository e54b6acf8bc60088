//! What is recorded replays to the last bit, and what was changed is found.

mod common;

use common::{arg, dogleaf, fixture, folder, refused, told};

fn recorded(name: &str, more: &[&str]) -> String {
    let file = arg(&folder(name), "turn.dlr");
    let scene = fixture("scenes/turn.toml");
    told(&[&["run", &scene, "--record", &file], more].concat());
    file
}

#[test]
fn a_recording_replays() {
    for (name, more) in
        [("rec_f32", vec![]), ("rec_f64", vec!["--real", "f64", "--fidelity", "fine"])]
    {
        let file = recorded(name, &more);
        let text = told(&["replay", &file]);
        assert!(text.contains(" steps, ") && text.contains("hash "), "{text}");
        let found: serde_json::Value =
            serde_json::from_str(&told(&["replay", &file, "--json"])).expect("JSON");
        assert!(found["diverged"].is_null(), "{found}");
        assert_eq!(found["same_build"], true, "{found}");
        assert!(found["steps"].as_u64() > Some(60), "{found}");
    }
}

#[test]
fn the_first_step_that_diverges_is_named_and_1() {
    let file = recorded("rec_diverges", &[]);
    let mut bytes = std::fs::read(&file).expect("a file");
    // The hash of a step in the middle, and the checksum made good again.
    let at = bytes.len() / 2;
    let step = (at..bytes.len() - 16).find(|&i| bytes[i] == 3 && bytes[i + 9] == 3).expect("steps");
    bytes[step + 4] ^= 1;
    let body = bytes.len() - 4;
    let sum = crc32(&bytes[..body]).to_le_bytes();
    bytes[body..].copy_from_slice(&sum);
    std::fs::write(&file, &bytes).expect("written");
    let (error, code) = refused(&["replay", &file]);
    assert_eq!(code, 1, "a failed check: {error}");
    assert!(error.contains("step ") && error.contains(" diverges: recorded "), "{error}");
    let output = dogleaf(&["replay", &file, "--json"]);
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(found["diverged"]["step"].as_u64().is_some(), "{found}");
}

#[test]
fn a_damaged_recording_is_bad_input() {
    let file = recorded("rec_damaged", &[]);
    let bytes = std::fs::read(&file).expect("a file");
    std::fs::write(&file, &bytes[..bytes.len() - 9]).expect("written");
    let (error, code) = refused(&["replay", &file]);
    assert_eq!(code, 2, "{error}");
    assert!(error.contains("checksum"), "{error}");
}

/// A recording of a scene with ribbons, some frames of it.
fn recorded_ribbons(name: &str, scene: &str, more: &[&str]) -> String {
    let file = arg(&folder(name), "ribbons.dlr");
    told(&[&["run", scene, "--record", &file, "--frames"], more].concat());
    file
}

#[test]
fn ribbons_replay() {
    for (name, frames, real) in [
        ("ribbon_torsion", "20", "f32"),
        ("ribbon_fall_150", "40", "f32"),
        ("ribbon_drag", "10", "f64"),
        ("ribbon_mobius_chain", "3", "f64"),
    ] {
        let scene = fixture(&format!("scenes/{name}.toml"));
        let file = recorded_ribbons(&format!("rec_{name}"), &scene, &[frames, "--real", real]);
        let found: serde_json::Value =
            serde_json::from_str(&told(&["replay", &file, "--json"])).expect("JSON");
        let ribbons = found["ribbons"].as_array().expect("ribbons");
        assert!(!ribbons.is_empty() && found.get("book").is_none(), "{found}");
        for ribbon in ribbons {
            assert!(ribbon["diverged"].is_null(), "{name}: {found}");
            assert_eq!((&ribbon["same_build"], &ribbon["real"]), (&true.into(), &real.into()));
            assert!(ribbon["steps"].as_u64() > Some(1), "{found}");
        }
        assert!(told(&["replay", &file]).contains("ribbon 0: "), "{name}: and in words");
    }
}

#[test]
fn a_book_with_a_ribbon_replays_both() {
    let here = folder("rec_both");
    let turn = std::fs::read_to_string(fixture("scenes/turn.toml")).expect("a scene");
    let gesture = fixture("gestures").replace('\\', "/");
    let text = turn.replace("../gestures", &gesture) + "\n[[ribbon]]\nsegments = 20\n";
    let scene = arg(&here, "both.toml");
    std::fs::write(&scene, text).expect("a file");
    let file = recorded_ribbons("rec_both_dlr", &scene, &["30"]);
    let found: serde_json::Value =
        serde_json::from_str(&told(&["replay", &file, "--json"])).expect("JSON");
    assert!(found["book"]["diverged"].is_null() && found["book"]["steps"].as_u64() > Some(10));
    assert!(found["ribbons"][0]["diverged"].is_null(), "{found}");
}

#[test]
fn a_damaged_recording_of_ribbons_is_found_out() {
    let scene = fixture("scenes/ribbon_fall_150.toml");
    let file = recorded_ribbons("rec_ribbons_bad", &scene, &["40"]);
    let sound = std::fs::read(&file).expect("a file");
    let refused_as = |bytes: &[u8], wanted: &str, code: i32| {
        std::fs::write(&file, bytes).expect("written");
        let (error, found) = refused(&["replay", &file]);
        assert!(error.contains(wanted) && found == code, "{error}\nshould say\n{wanted}");
    };
    refused_as(&sound[..sound.len() - 9], "checksum", 2);
    refused_as(&sound[..9], "the recording ends too early", 2);
    let flipped = |at: usize| {
        let mut bytes = sound.clone();
        bytes[at] ^= 1;
        let body = bytes.len() - 4;
        let sum = crc32(&bytes[..body]).to_le_bytes();
        bytes[body..].copy_from_slice(&sum);
        bytes
    };
    let mut unsealed = sound.clone();
    unsealed[sound.len() / 2] ^= 1;
    refused_as(&unsealed, "checksum", 2);
    // The envelope sealed again, what is in it is still not.
    refused_as(&flipped(sound.len() / 2), "checksum", 2);
    refused_as(&flipped(4), "version", 2);
    // Another floor is another fall: magic, version, step, no book, one ribbon, its flags, then the height.
    let height = 4 + 2 + 4 + 4 + 2 + 2;
    refused_as(&flipped(height + 6), "ribbon 0: step ", 1);
}

/// CRC-32 of zip files, bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |s, _| (s >> 1) ^ (0xedb8_8320 & (s & 1).wrapping_neg()))
    })
}
