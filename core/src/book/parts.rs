//! The book's state opened up for another solve than the product's: the oracle's. Feature `seed`.

use super::{Binding, Book};
use crate::grid::Grid;
use crate::real::{Real, V3};
use crate::scene::{Cover, PaperSpec};
use crate::state::strip::{BLOCK, BOARD, Fibre, Strip};
use crate::state::{Field, Grab, Leaf, Sheet};
use crate::step::StepReport;

/// What one substep reads and what it moves.
#[derive(Debug)]
pub(crate) struct Parts<'a, R: Real, G: Grid> {
    pub(crate) h: R,
    pub(crate) keep: R,
    pub(crate) gravity: V3<R>,
    pub(crate) grab: Option<Grab<R>>,
    pub(crate) passes: u32,
    pub(crate) active: bool,
    pub(crate) cover: Cover,
    pub(crate) paper: &'a PaperSpec,
    pub(crate) binding: &'a Binding<R>,
    pub(crate) fibre: &'a Fibre<R>,
    pub(crate) board: &'a Fibre<R>,
    pub(crate) sheet: &'a Sheet<R, G>,
    pub(crate) blocks: &'a mut [Strip<R, BLOCK>; 2],
    pub(crate) boards: &'a mut [Strip<R, BOARD>; 2],
    pub(crate) leaf: &'a mut Leaf<R, G>,
    pub(crate) before: &'a mut Field<R, G>,
    pub(crate) scratch: &'a mut Field<R, G>,
}

impl<R: Real, G: Grid> Book<R, G> {
    pub(crate) fn parts(&mut self) -> Parts<'_, R, G> {
        Parts {
            h: self.h,
            keep: self.keep,
            gravity: self.gravity,
            grab: self.grab,
            passes: self.settings.passes,
            active: self.active,
            cover: self.spec.cover,
            paper: &self.paper,
            binding: &self.binding,
            fibre: &self.fibre,
            board: &self.board,
            sheet: &self.sheet,
            blocks: &mut self.blocks,
            boards: &mut self.boards,
            leaf: &mut self.leaf,
            before: &mut self.before,
            scratch: &mut self.scratch,
        }
    }

    /// Moves the hand's target by one substep, and sees whether the leaf has landed. What the product then
    /// does to lay it flat is the product's own.
    pub(crate) fn lead(&mut self, report: &mut StepReport) {
        self.hold(report);
        if self.active {
            let _ = self.lay_down();
        }
    }
}
