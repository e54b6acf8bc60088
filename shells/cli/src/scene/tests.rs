//! What a scene may say, and what is said of one that says something else.

use super::{Body, Scene};
use dogleaf_core::scene::{BookSpec, Cover, Direction, PaperSpec, Preset, WorldSpec};
use std::path::Path;

fn parse(text: &str) -> Result<Scene, String> {
    Scene::parse(text, "s.toml", Path::new("")).map_err(|e| e.to_string())
}

fn refused(text: &str) -> String {
    parse(text).expect_err("refused")
}

#[test]
fn the_empty_scene_is_a_default_book() {
    let scene = parse("").expect("sound");
    assert_eq!(scene.body, Body::Book(BookSpec::default()), "the default book");
    assert_eq!(scene.world, WorldSpec::default(), "the default world");
    assert_eq!(scene.paper, PaperSpec::default(), "office paper");
    assert_eq!(scene.frame_us, 16_667, "sixty frames a second");
    assert_eq!(scene.grid.size(), [11, 8], "the default grid");
    assert!(scene.samples.is_empty(), "nobody touches it");
}

#[test]
fn every_name_of_the_contract_is_known() {
    let book = "[world]\ngravity=[0.0,-9.81,0.0]\ndamping_per_s=1.2\nstep_us=16667\nseed=1\nframe_us=8333\n\
        [paper]\npreset='coated'\nareal_mass_gsm=80.0\nthickness_mm=0.1\nyoungs_gpa=4\npoisson=0.3\n\
        [book]\nwidth_m=0.13\nheight_m=0.20\npages=320\nopen_at=120\ncover='soft'\ndirection='rtl'\n\
        [view]\neye_m=[0,0.5,0.3]\ntarget_m=[0,0,0]\nfov_y_deg=30\nwidth_px=640\nheight_px=480\n\
        [hand]\nsamples=[{t_us=5,id=1,phase='down',x=1,y=-2,leaves=3},{t_us=6,phase='up',x=0,y=0}]";
    let scene = parse(book).expect("sound");
    let Body::Book(spec) = scene.body else { panic!("a book") };
    assert_eq!((spec.cover, spec.direction), (Cover::Soft, Direction::Rtl), "words");
    assert_eq!((scene.samples.len(), scene.samples[0].leaves), (2, 3), "samples");
    assert_eq!((scene.view.width_px, scene.frame_us), (640, 8333), "numbers");
    assert_eq!(scene.paper.youngs_gpa, 4.0, "a whole number is a number");
    let leaf = "[leaf]\nwidth_m=0.15\nheight_m=0.20\ngrid=[32,24]\nclamp='spine'\n\
        clamp_angle_deg=10.0\ncurl_per_m=-1.0";
    let scene = parse(leaf).expect("sound");
    assert_eq!((scene.grid.size(), scene.body.name()), ([32, 24], Some("leaf")), "a leaf");
}

#[test]
fn a_preset_is_changed_number_by_number() {
    let scene = parse("[paper]\npreset = 'card'").expect_err("no such paper");
    assert!(scene.contains("did you mean 'cardboard'?") || scene.contains("known are"), "{scene}");
    let paper = parse("[paper]\npreset = 'cardboard'\npoisson = 0.1").expect("sound").paper;
    let wanted = PaperSpec { poisson: 0.1, ..Preset::Cardboard.into() };
    assert_eq!(paper, wanted, "the rest is the preset's");
    let weights = parse("[paper.weights]\nglue = 7").expect("sound").paper.weights;
    assert_eq!(weights.map(|w| (w.glue, w.bend_3d)), Some((7.0, 120.0)), "the seed's for the rest");
}

#[test]
fn a_short_book_is_open_inside_itself() {
    let scene = parse("[book]\npages = 4").expect("sound");
    assert!(matches!(scene.body, Body::Book(b) if b.open_at <= 4), "{:?}", scene.body);
}

#[test]
fn unknown_words_are_named_with_their_line() {
    for (text, wanted) in [
        (
            "\n[book]\nwidht_m = 1",
            "s.toml:3: unknown key 'widht_m' in [book]; did you mean 'width_m'?",
        ),
        ("[bok]", "s.toml:1: unknown table 'bok'; did you mean 'book'?"),
        (
            "[book]\ncover = 'hart'",
            "s.toml:2: unknown value 'hart' of book.cover; did you mean 'hard'?",
        ),
        (
            "[paper.weights]\nbend = 1",
            "s.toml:2: unknown key 'bend' in [paper.weights]; known are bend_3d",
        ),
        ("[hand]\nsamples = [{phase='fly'}]", "unknown value 'fly' of hand.samples.phase"),
        ("[leaf]\nclamp = 'none'", "unknown value 'none' of leaf.clamp"),
    ] {
        let error = refused(text);
        assert!(error.contains(wanted), "{error}\nshould say\n{wanted}");
    }
}

#[test]
fn bad_values_are_named_with_their_line() {
    for (text, wanted) in [
        ("[book]\n\nwidth_m = 'wide'", "s.toml:3: book.width_m must be a number"),
        ("[book]\nwidth_m = inf", "s.toml:2: book.width_m is not a finite number"),
        ("[book]\nwidth_m = nan", "s.toml:2: book.width_m is not a finite number"),
        ("[book]\npages = -1", "s.toml:2: book.pages must be a whole number"),
        ("[book]\npages = 0", "s.toml:2: book.pages is out of range"),
        ("[world]\nstep_us = 99999999999", "s.toml:2: world.step_us must be a whole number"),
        ("[world]\ngravity = [1, 2]", "s.toml:2: world.gravity must be 3 numbers in brackets"),
        ("[world]\nframe_us = 1", "s.toml:2: world.frame_us is out of range"),
        ("[leaf]\ngrid = [10, 8]", "s.toml:2: grid must be one of [6, 5], [8, 6], [11, 8]"),
        ("[leaf]\nwidth_m = 1.0\nheight_m = 0.1", "height_m over leaf.width_m is out of range"),
        ("[paper.weights]\nglue = -1.0", "s.toml:2: paper.weights.glue is out of range"),
        ("book = 3", "s.toml:1: book must be a table: write [book]"),
        ("[book\n", "s.toml:1: unclosed table"),
        ("[leaf]\n[book]", "a scene has a [book] or a [leaf], not both"),
        ("[leaf]\n[hand]\nsamples=[{phase='down'}]", "s.toml:2: [hand] needs a [book]"),
        ("[hand]\nsamples=[{t_us=2},{t_us=1}]", "s.toml:2: hand.samples must be in the order"),
        ("[hand]\ngesture='g'\nsamples=[]", "s.toml:3: [hand] has a gesture file or samples"),
    ] {
        let error = refused(text);
        assert!(error.contains(wanted), "{error}\nshould say\n{wanted}");
    }
}

#[test]
fn effects_of_other_versions_are_refused_in_one_line() {
    for (text, name) in [("[[sheet]]\nx = 1", "sheet"), ("[sound]", "sound")] {
        let wanted = format!("s.toml:1: the effect '{name}' is not built into this dogleaf");
        assert_eq!(refused(text), wanted, "{name}");
    }
    let span = refused("[world]\nseed = 1\n\n[[sheet]]\n[[sheet]]\n");
    assert!(span.starts_with("s.toml:4: "), "the first of two: {span}");
}

#[test]
fn every_fixture_is_a_scene() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scenes");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).expect("the fixtures") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|e| e == "toml") {
            Scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
            seen += 1;
        }
    }
    assert!(seen >= 7, "{seen} scenes");
}
