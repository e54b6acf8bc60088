//! Scenes in TOML and gestures as lines of JSON: the program's own parsers, taken in by their files.
//!
//! The program is no library; what its parsers need of other crates stands here as empty types, so that this
//! target builds without a PDF reader.
#![no_main]
#![allow(
    dead_code,
    unused_imports,
    unreachable_pub,
    reason = "the program's files, of which only a share is used"
)]

extern crate self as dogleaf_content;
extern crate self as dogleaf_cost;
extern crate self as dogleaf_render;

#[path = "../../../shells/cli/src/error.rs"]
mod error;
#[path = "../../../shells/cli/src/files.rs"]
mod files;
#[path = "../../../shells/cli/src/gesture/mod.rs"]
mod gesture;
#[path = "../../../shells/cli/src/grid.rs"]
mod grid;
#[path = "../../../shells/cli/src/scene/mod.rs"]
mod scene;

use libfuzzer_sys::{Corpus, fuzz_target};
use std::path::Path;

/// An error that cannot be.
macro_rules! never {
    ($($name:ident)+) => {$(
        /// Never made here.
        #[derive(Debug, thiserror::Error)]
        #[error("never")]
        pub enum $name {}
    )+};
}
never!(ContentError CostError RenderError AnimError);

fuzz_target!(|data: &[u8]| -> Corpus {
    let Ok(text) = std::str::from_utf8(data) else { return Corpus::Reject };
    // A scene may name a file of gestures: no file of this machine is any of our business.
    if text.contains("gesture") {
        return Corpus::Reject;
    }
    match scene::Scene::parse(text, "fuzz.toml", Path::new("nowhere")) {
        Ok(scene) => {
            assert_eq!(scene.world.check(), Ok(()), "a world was believed");
            assert_eq!(scene.paper.check(), Ok(()), "a paper was believed");
            assert_eq!(scene.view.check(), Ok(()), "a view was believed");
            let ordered = scene.samples.windows(2).all(|w| w[0].t_us <= w[1].t_us);
            assert!(ordered, "samples out of order were believed");
        }
        Err(why) => {
            let line = error::one_line(&why.to_string());
            assert!(line.starts_with("fuzz.toml:"), "an error names its file: {line}");
        }
    }
    Corpus::Keep
});
