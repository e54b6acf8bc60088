//! Opt-in effects: each a cargo feature, a spec, a workspace the caller places, and a step. None knows another.

#[cfg(feature = "ribbon")]
pub mod ribbon;
