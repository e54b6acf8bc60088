//! Help with examples for every word, and exit codes.

mod common;

use common::{dogleaf, fixture, folder, refused, told};

#[test]
fn every_word_has_help_with_examples() {
    for word in ["turn", "run", "replay", "bench", "cost", "eink"] {
        let text = told(&[word, "--help"]);
        assert!(text.contains(&format!("Usage: dogleaf {word}")), "{word}: {text}");
        assert!(text.contains("Examples:"), "{word}: {text}");
        let example = format!("\n  dogleaf {word}");
        assert!(text.contains(&example), "{word} shows itself: {text}");
    }
    let text = told(&["--help"]);
    assert!(text.contains("Exit code 0: done; 1: a check failed; 2: bad input."), "{text}");
    assert!(told(&["--version"]).starts_with("dogleaf "), "version");
}

#[test]
fn bad_input_is_one_line_and_2() {
    let book = fixture("books/old-verses.pdf");
    let scene = fixture("scenes/lone_leaf.toml");
    let here = folder("help_bad");
    let out = common::arg(&here, "x.webp");
    for (args, wanted) in [
        (vec!["run", "no_such.toml"], "no_such.toml: cannot be read"),
        (vec!["run"], "<SCENE>"),
        (vec!["fly"], "unrecognized subcommand 'fly'"),
        (vec!["run", &scene, "--fidelty", "fine"], "--fidelity"),
        (vec!["run", &scene, "--fidelity", "best"], "possible values: draft, standard"),
        (vec!["run", &scene, "--real", "f16"], "possible values: f32, f64"),
        (vec!["run", &scene, "--wav", "x.wav"], "no sound in this scene"),
        (vec!["run", &scene, "--record", "x.dlr"], "a recording is of a book"),
        (vec!["run", &scene, "--frames", "-3"], "-3"),
        (vec!["replay", &scene], "not a dogleaf recording"),
        (vec!["replay", "no_such.dlr"], "cannot be read"),
        (vec!["turn", "no_such.pdf"], "no_such.pdf does not exist"),
        (vec!["turn", &scene], "is not a book"),
        (vec!["turn", &book, "-o", &out, "--page", "999"], "has no page 999"),
        (vec!["turn", &book, "-o", &out, "--page", "24"], "there is no leaf to turn"),
        (vec!["turn", &book, "-o", &out, "--size", "10"], "write it as 960x720"),
        (vec!["turn", &book, "-o", "x.mp4"], "unknown animation format"),
        (vec!["turn", &book, "-o", &out, "--gesture", &scene], "lone_leaf.toml:1: "),
    ] {
        let (error, code) = refused(&args);
        assert!(error.contains(wanted), "{args:?}: {error} should say {wanted}");
        assert_eq!(code, 2, "{args:?}: {error}");
    }
}

#[test]
fn nothing_asked_is_help_and_2() {
    let output = dogleaf(&[]);
    assert_eq!(output.status.code(), Some(2), "no word");
    assert!(String::from_utf8_lossy(&output.stderr).contains("Usage: dogleaf"), "help");
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let scene = fixture("scenes/lone_leaf.toml");
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_dogleaf"))
        .args(["run", &scene, "--frames", "2000", "--json", "-"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("it starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}
