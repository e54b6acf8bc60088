//! Levels from the command line: `--newton 1,2,tol`.

use super::{AXES, Form, GridName, Levels, RealName};
use crate::CostError;

impl Levels {
    /// Sets the levels of one axis from a comma-separated list.
    ///
    /// # Errors
    ///
    /// The first level that is none of this axis.
    pub fn set(&mut self, axis: &'static str, text: &str) -> Result<(), CostError> {
        let words = || text.split(',').map(str::trim).filter(|w| !w.is_empty());
        let bad = |word: &str| CostError::Level { axis, word: word.to_owned() };
        macro_rules! levels {
            ($field:ident, $of:expr) => {{
                let of = $of;
                self.$field =
                    words().map(|w| of(w).ok_or_else(|| bad(w))).collect::<Result<_, _>>()?;
                if self.$field.is_empty() {
                    return Err(bad(text));
                }
            }};
        }
        match axis {
            "grid" => {
                levels!(grid, GridName::of);
            }
            "newton" => {
                levels!(newton, newton);
            }
            "step" => {
                levels!(rate, rate);
            }
            "real" => {
                levels!(real, real);
            }
            "form" => {
                levels!(form, form);
            }
            "search" => {
                levels!(search, switch);
            }
            "passes" => levels!(passes, |w: &str| w.parse().ok().filter(|n| *n <= 3)),
            "delta" => {
                levels!(delta, |w: &str| w.parse().ok().filter(|d| (1e-12..=1.0).contains(d)));
            }
            "mesh" => {
                levels!(mesh, switch);
            }
            other => return Err(CostError::Axis(other.to_owned())),
        }
        Ok(())
    }

    /// Refuses names that are no axes.
    ///
    /// # Errors
    ///
    /// The first one.
    pub fn check_names(axes: &[String]) -> Result<(), CostError> {
        let unknown = axes.iter().find(|a| !AXES.contains(&a.as_str()));
        unknown.map_or(Ok(()), |a| Err(CostError::Axis(a.clone())))
    }
}

fn newton(word: &str) -> Option<Option<u32>> {
    if word == "tol" {
        Some(None)
    } else {
        word.parse().ok().filter(|n| (1..=20).contains(n)).map(Some)
    }
}

/// Steps a second: such that a thirtieth of a second is a whole number of them.
fn rate(word: &str) -> Option<u32> {
    let word = word.strip_prefix("1/").unwrap_or(word);
    word.parse()
        .ok()
        .filter(|n: &u32| *n == 30 || (n.is_multiple_of(60) && (60..=3840).contains(n)))
}

fn real(word: &str) -> Option<(RealName, u32)> {
    match word {
        "f32" => Some((RealName::F32, 0)),
        "f32+1" => Some((RealName::F32, 1)),
        "f64" => Some((RealName::F64, 0)),
        "f64+1" => Some((RealName::F64, 1)),
        _ => None,
    }
}

fn form(word: &str) -> Option<Form> {
    match word {
        "ours" => Some(Form::Ours),
        "seed" => Some(Form::Seed { hessian: false }),
        "seed+hessian" => Some(Form::Seed { hessian: true }),
        _ => None,
    }
}

fn switch(word: &str) -> Option<bool> {
    match word {
        "on" => Some(true),
        "off" => Some(false),
        _ => None,
    }
}
