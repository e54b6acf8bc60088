//! `cargo ci <word>`.
fn main() {}
