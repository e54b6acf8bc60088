//! A progress bar on a terminal, nothing elsewhere.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar of so many steps on the standard error, if that is a terminal; else one that shows nothing.
pub(crate) fn bar(steps: u64, what: &'static str) -> ProgressBar {
    use std::io::IsTerminal;
    let shown = std::io::stderr().is_terminal();
    let target = if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(steps), target);
    if let Ok(style) = ProgressStyle::with_template("{msg:12} {bar:40} {pos}/{len} {eta}") {
        bar.set_style(style);
    }
    bar.with_message(what)
}
