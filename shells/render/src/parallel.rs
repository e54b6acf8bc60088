//! Work split over threads by bands of the output, so that the result never depends on how many.

use std::num::NonZeroUsize;
use std::sync::Mutex;

/// How many threads this machine gives us.
pub(crate) fn default_threads() -> usize {
    std::thread::available_parallelism().map_or(1, NonZeroUsize::get)
}

/// Calls `work(index, part)` once for every `part_len` items of `out`, on up to `threads` threads.
///
/// # Determinism
///
/// Each part is written by exactly one call that sees nothing of the others.
pub(crate) fn for_each_part<T, F>(threads: usize, out: &mut [T], part_len: usize, work: F)
where
    T: Send,
    F: Fn(usize, &mut [T]) + Sync,
{
    let parts = out.chunks_mut(part_len.max(1)).enumerate();
    if threads <= 1 {
        parts.for_each(|(i, part)| work(i, part));
        return;
    }
    let queue = Mutex::new(parts);
    let next = || queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner).next();
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((i, part)) = next() {
                    work(i, part);
                }
            });
        }
    });
}
