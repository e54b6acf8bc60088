//! Contact inside the step: a ribbon against the ground, against other ribbons, against itself.
//!
//! What is near is found once a step. A barrier pushes vertices from faces and edges from edges, as rank-one terms of the
//! segment they belong to, so a solve stays linear in the segments. And no trial of the line search may go further than
//! the first contact on its way: what did not cross before a step does not cross after it, however few the iterations.
//!
//! | file | question |
//! |---|---|
//! | `touch` | what a solver asks of contact |
//! | `push` | the barrier of one distance |
//! | `distance` | how near two segments are |
//! | `advance` | how far may vertices go |
//! | `surface` | grounds: half-spaces, fields of heights |
//! | `near` | what is near a ribbon |
//! | `press` | energy, forces and limits of what is near |
//! | `crowd` | many ribbons, one after the other |
//! | `post` | the seed's way: vertices corrected after the step |
//!
//! Source: Ribbon Sec. 5.2 corrects positions after the step instead, as `post` does; barrier and limits after Li et al., "Incremental
//! Potential Contact" (2020) and "Codimensional Incremental Potential Contact" (2021).

pub mod touch;
pub mod push;
pub mod distance;
pub mod advance;
pub mod surface;
pub mod near;
pub mod press;
pub mod crowd;
pub mod post;

pub use crowd::{Summary, step_all, step_each};
pub use near::{Counts, Near};
pub use post::{Post, PostReport};
pub use push::Cushion;
pub use surface::{Field, HalfSpace, Surface};
pub use touch::Touch;
