//! The potentials V of Eq. 9: value, gradient and Hessian together, one file each.
//!
//! Each is written over [`Num`](crate::real::Num), so the same lines serve one node and eight rows.

pub mod bending;
pub mod contact;
pub mod glue;
pub mod gravity;
pub mod isometry;
pub mod position;
