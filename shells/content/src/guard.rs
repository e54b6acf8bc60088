//! Turns a panic of somebody else's parser into a plain failure, without a word on stderr.
//!
//! The panic hook is one per process, so it cannot be swapped around a call: another thread's
//! panic would vanish meanwhile. Instead a hook is put in once, in front of the one it finds. It is
//! silent only on a thread that is inside [`guarded`], and passes everything else on.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    static DEPTH: Cell<u32> = const { Cell::new(0) };
}

static HOOK: Once = Once::new();

/// What is left of a panic.
#[derive(Debug)]
pub(crate) struct Panicked;

/// Runs `work`; a panic in it becomes [`Panicked`].
///
/// Whatever `work` borrowed may be left half changed: the caller throws it away.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Panicked> {
    quieten_hook();
    DEPTH.set(DEPTH.get() + 1);
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    DEPTH.set(DEPTH.get() - 1);
    outcome.map_err(|_| Panicked)
}

fn quieten_hook() {
    // Setting a hook while this thread unwinds would itself panic.
    if std::thread::panicking() {
        return;
    }
    HOOK.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if DEPTH.try_with(Cell::get).unwrap_or(0) == 0 {
                before(info);
            }
        }));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_an_error_and_the_thread_goes_on() {
        assert!(guarded(|| panic!("odd file")).is_err(), "the panic was lost");
        assert_eq!(guarded(|| 7).ok(), Some(7), "the next call must work");
        assert_eq!(DEPTH.get(), 0, "the thread is no longer silent");
    }
}
