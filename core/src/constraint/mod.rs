//! The rows of C, Eq. 5: residual and Jacobian together, one file each.

pub mod binding;
pub mod dog;
pub mod fix;
pub mod length;
