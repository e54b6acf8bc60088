//! The promises about ribbons, in one program, as `promises` is for the book.

mod ribbon_bookmark;
mod ribbon_chains;
mod ribbon_contact;
mod ribbon_derivatives;
mod ribbon_draped;
mod ribbon_event;
mod ribbon_fidelity;
mod ribbon_golden;
mod ribbon_hard_cases;
mod ribbon_loops;
mod ribbon_momentum;
mod ribbon_newton;
mod ribbon_numbers;
mod ribbon_parts;
mod ribbon_post;
mod ribbon_record;
mod ribbon_soak;
mod ribbon_statics;
mod ribbon_traps;
mod tally;
