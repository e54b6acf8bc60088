//! A scene: TOML in, the core's specs out.
//!
//! Every key has a default, so the empty file is a scene: a book nobody touches. A key nobody knows
//! is an error that names its line and what may have been meant.

mod error;
mod hint;
mod parts;
mod section;

pub(crate) use error::{Fault, SceneError};

use crate::error::{CliError, shown};
use crate::files::read_text;
use crate::gesture;
use crate::grid::GridName;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::scene::{BookSpec, LeafSpec, PaperSpec, WorldSpec};
use section::{Section, Source};
use std::path::Path;
use toml::de::DeTable;

/// Tables a scene may have.
const TABLES: [&str; 9] =
    ["world", "paper", "leaf", "book", "hand", "view", "ribbon", "sheet", "sound"];
/// Effects of other versions: known, and refused.
const EFFECTS: [&str; 3] = ["ribbon", "sheet", "sound"];
/// Largest scene read, bytes: inline samples of an hour.
const LARGEST: u64 = 32 << 20;
/// Picture a scene is seen in unless it says otherwise.
pub(crate) const PICTURE: [u32; 2] = [960, 720];

/// What lies there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Body {
    Book(BookSpec),
    Leaf(LeafSpec),
}

impl Body {
    /// The name of its table.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Book(_) => "book",
            Self::Leaf(_) => "leaf",
        }
    }

    /// Width and height of its leaf, metres.
    pub(crate) fn size_m(&self) -> [f64; 2] {
        match self {
            Self::Book(b) => [b.width_m, b.height_m],
            Self::Leaf(l) => [l.width_m, l.height_m],
        }
    }
}

/// A scene, checked by the core's own rules.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scene {
    pub(crate) world: WorldSpec,
    /// Time of one frame, microseconds.
    pub(crate) frame_us: u32,
    pub(crate) paper: PaperSpec,
    pub(crate) body: Body,
    pub(crate) grid: GridName,
    pub(crate) view: View,
    /// What the hand does.
    pub(crate) samples: Vec<Sample>,
}

impl Scene {
    /// Reads a scene from a file; a gesture it names is looked for beside it.
    pub(crate) fn load(path: &Path) -> Result<Self, CliError> {
        let text = read_text(path, LARGEST)?;
        Self::parse(&text, &shown(path), path.parent().unwrap_or(Path::new("")))
    }

    /// Reads a scene from text; `beside` is the folder gesture files are looked for in.
    pub(crate) fn parse(text: &str, file: &str, beside: &Path) -> Result<Self, CliError> {
        let source = Source { file, text };
        let table = DeTable::parse(text).map_err(|e| {
            source.fault(e.span(), Fault::Syntax(crate::error::one_line(e.message())))
        })?;
        let root = Section::root(source, table.get_ref(), &TABLES)?;
        if let Some(effect) = EFFECTS.into_iter().find(|e| root.has(e)) {
            return Err(root.fault(effect, Fault::NotBuilt(effect)).into());
        }
        let (world, frame_us) = parts::world(&root)?;
        let (body, grid) = parts::body(&root)?;
        let scene = Self {
            world,
            frame_us,
            paper: parts::paper(&root)?,
            body,
            grid,
            view: parts::view(&root, &body)?,
            samples: Self::hand(&root, beside)?,
        };
        if !scene.samples.is_empty() && matches!(body, Body::Leaf(_)) {
            let fault = Fault::Conflict("[hand] needs a [book]: a lone leaf cannot be held");
            return Err(root.fault("hand", fault).into());
        }
        Ok(scene)
    }

    fn hand(root: &Section<'_>, beside: &Path) -> Result<Vec<Sample>, CliError> {
        match parts::hand(root)? {
            parts::Hand::File(name) => gesture::load(&beside.join(name)),
            parts::Hand::Samples(samples) => Ok(samples),
        }
    }
}

#[cfg(test)]
mod tests;
