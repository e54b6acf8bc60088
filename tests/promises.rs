//! The promises about the book, in one program: the solver is generic, and every program compiles it anew.
//!
//! A file is a promise, and a module here; `cargo test --test promises turns::` plays one.

mod asleep;
mod bad_input;
mod bad_specs;
mod bounded_work;
mod derivatives;
mod finger;
mod gestures;
mod golden;
mod hard_cases;
mod interrupted;
mod kkt_dense;
mod lanes;
mod layers;
mod lone_leaf;
mod mesh_books;
mod mesh_gestures;
mod mesh_layout;
mod meshes;
mod mirror;
mod no_alloc;
mod only_what_is_asked;
mod reading;
mod recorded;
mod recording_refused;
mod replay;
mod seed_agrees;
mod self_test;
mod soak;
mod sweeps;
mod tally;
mod tent_and_pick;
mod turns;
mod units;
