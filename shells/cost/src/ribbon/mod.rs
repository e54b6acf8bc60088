//! Ribbons against the seed's own method: L-BFGS-B within an augmented Lagrangian, on the same objective, in one process.
//!
//! | file | question |
//! |---|---|
//! | `lbfgsb` | the least value of a function within bounds |
//! | `unknowns` | a ribbon's unknowns as the seed counts them: angles, differences of slopes, the start |
//! | `gradient` | the objective's gradient, no dearer than need be |
//! | `algorithm` | the seed's Algorithm 2 |
//! | `scenes` | the seed's experiments |
//! | `race` | work and time of both to the same gap |
//! | `claims` | the seed's Table 1 and Fig. 13 beside ours |

pub mod algorithm;
pub mod claims;
pub mod gradient;
pub mod lbfgsb;
pub mod race;
pub mod scenes;
pub mod unknowns;
