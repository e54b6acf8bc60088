//! A scene: TOML in, the core's specs out.
//!
//! Every key has a default, so the empty file is a scene: a book nobody touches. A key nobody knows
//! is an error that names its line and what may have been meant.

mod error;
mod hint;
mod parts;
mod ribbon;
mod section;

pub(crate) use error::{Fault, SceneError};
pub(crate) use ribbon::{Fabric, MOST_SEGMENTS, RibbonPart, Start, Twist};

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
const EFFECTS: [&str; 2] = ["sheet", "sound"];
/// Largest scene read, bytes: inline samples of an hour.
const LARGEST: u64 = 32 << 20;
/// Picture a scene is seen in unless it says otherwise.
pub(crate) const PICTURE: [u32; 2] = [960, 720];

/// What lies there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Body {
    Book(BookSpec),
    Leaf(LeafSpec),
    /// Neither: the scene is its ribbons.
    Nothing,
}

impl Body {
    /// The name of its table.
    pub(crate) fn name(&self) -> Option<&'static str> {
        match self {
            Self::Book(_) => Some("book"),
            Self::Leaf(_) => Some("leaf"),
            Self::Nothing => None,
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
    pub(crate) ribbons: Vec<RibbonPart>,
}

impl Scene {
    /// The names of what is simulated.
    pub(crate) fn parts(&self) -> Vec<&'static str> {
        let ribbon = (!self.ribbons.is_empty()).then_some("ribbon");
        self.body.name().into_iter().chain(ribbon).collect()
    }

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
        let ribbons = ribbon::ribbons(&root, &world)?;
        let scene = Self {
            world,
            frame_us,
            paper: parts::paper(&root)?,
            body,
            grid,
            view: parts::view(&root, &body, &ribbons)?,
            samples: Self::hand(&root, beside)?,
            ribbons,
        };
        if !scene.samples.is_empty() && !matches!(body, Body::Book(_)) {
            let fault = Fault::Conflict("[hand] needs a [book]: nothing else can be held");
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
