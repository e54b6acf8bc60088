#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]

pub mod real;
pub mod grid;
pub mod scene;
pub mod state;
pub mod potential;
pub mod constraint;
pub mod kkt;
pub mod step;
pub mod collision;
pub mod hand;
pub mod event;
pub mod book;
pub mod selftest;
#[cfg(feature = "seed")]
pub mod seed;
pub mod mesh;
pub mod record;
pub mod reading;
pub mod effect;

pub use book::{Book, LoneLeaf};
pub use reading::Reading;
