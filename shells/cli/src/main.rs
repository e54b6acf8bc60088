//! The program `dogleaf`.
fn main() {}
