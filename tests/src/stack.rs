//! Room for big arrays: the workspaces of the largest grids do not fit a test thread's stack.

use std::panic::resume_unwind;
use std::thread;

/// Runs `job` on a stack of 64 MB.
pub fn roomy<T: Send>(job: impl FnOnce() -> T + Send) -> T {
    let done = thread::scope(|scope| {
        let worker = thread::Builder::new().stack_size(64 << 20).spawn_scoped(scope, job);
        worker.expect("a thread can be started").join()
    });
    done.unwrap_or_else(|panic| resume_unwind(panic))
}
