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

/// CRC-32 of zip files, bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |s, _| (s >> 1) ^ (0xedb8_8320 & (s & 1).wrapping_neg()))
    })
}
