//! A reader that gives out only so many bytes.
//!
//! The zip crate believes the archive about how many entries it has. This puts a bound on what
//! it can be made to read, and so to keep, while it looks for them.

use std::io::{self, ErrorKind, Read, Seek, SeekFrom};

/// Passes reads on until the budget is spent; then fails with `QuotaExceeded`.
#[derive(Debug)]
pub(crate) struct Budget<R> {
    inner: R,
    left: u64,
}

impl<R> Budget<R> {
    pub(crate) fn new(inner: R, bytes: u64) -> Self {
        Self { inner, left: bytes }
    }

    /// The reader itself, from now on without a bound.
    pub(crate) fn into_inner(self) -> R {
        self.inner
    }
}

impl<R: Read> Read for Budget<R> {
    fn read(&mut self, buf: &mut [u8]) -> io::Result<usize> {
        let got = self.inner.read(buf)?;
        self.left = self.left.checked_sub(got as u64).ok_or(ErrorKind::QuotaExceeded)?;
        Ok(got)
    }
}

impl<R: Seek> Seek for Budget<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.inner.seek(to)
    }
}
