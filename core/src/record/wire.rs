//! Bytes and fields: one list of fields serves writing, reading and measuring.
//!
//! A list of fields is a function over [`Wire`] that hands it each field in turn. A writer copies the
//! field out, a reader fills it in, a ruler only counts: the three cannot disagree on the layout.

use super::code::Coded;
use super::crc::Crc;
use super::error::RecordError;
use super::write::Sink;

/// What a wire answers.
pub(crate) type Done = Result<(), RecordError>;

/// A direction in which fields travel.
pub(crate) trait Wire {
    /// The bytes of one field.
    fn bytes<const N: usize>(&mut self, field: &mut [u8; N]) -> Done;

    /// One byte.
    fn u8(&mut self, field: &mut u8) -> Done {
        let mut bytes = [*field];
        self.bytes(&mut bytes)?;
        [*field] = bytes;
        Ok(())
    }
    /// Two bytes.
    fn u16(&mut self, field: &mut u16) -> Done {
        let mut bytes = field.to_le_bytes();
        self.bytes(&mut bytes)?;
        *field = u16::from_le_bytes(bytes);
        Ok(())
    }
    /// Four bytes.
    fn u32(&mut self, field: &mut u32) -> Done {
        let mut bytes = field.to_le_bytes();
        self.bytes(&mut bytes)?;
        *field = u32::from_le_bytes(bytes);
        Ok(())
    }
    /// Eight bytes.
    fn u64(&mut self, field: &mut u64) -> Done {
        let mut bytes = field.to_le_bytes();
        self.bytes(&mut bytes)?;
        *field = u64::from_le_bytes(bytes);
        Ok(())
    }
    /// Four bytes, two's complement.
    fn i32(&mut self, field: &mut i32) -> Done {
        let mut bytes = field.to_le_bytes();
        self.bytes(&mut bytes)?;
        *field = i32::from_le_bytes(bytes);
        Ok(())
    }
    /// The eight bytes of a binary64.
    fn f64(&mut self, field: &mut f64) -> Done {
        let mut bits = field.to_bits();
        self.u64(&mut bits)?;
        *field = f64::from_bits(bits);
        Ok(())
    }
    /// Three of them.
    fn point(&mut self, field: &mut [f64; 3]) -> Done {
        field.iter_mut().try_for_each(|c| self.f64(c))
    }
    /// One of a few named values.
    fn code<T: Coded>(&mut self, field: &mut T) -> Done {
        let mut code = field.code();
        self.u8(&mut code)?;
        let known = T::ALL.iter().copied().find(|value| value.code() == code);
        *field = known.ok_or(RecordError::Unknown(T::NAME))?;
        Ok(())
    }
}

/// Out into a sink, counted and summed.
#[derive(Debug)]
pub(crate) struct Out<S> {
    pub(crate) sink: S,
    pub(crate) crc: Crc,
    pub(crate) written: usize,
}

impl<S: Sink> Wire for Out<S> {
    fn bytes<const N: usize>(&mut self, field: &mut [u8; N]) -> Done {
        self.sink.put(field)?;
        self.crc.take(field);
        self.written = self.written.saturating_add(N);
        Ok(())
    }
}

/// In from bytes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct In<'a>(pub(crate) &'a [u8]);

impl Wire for In<'_> {
    fn bytes<const N: usize>(&mut self, field: &mut [u8; N]) -> Done {
        let (head, rest) = self.0.split_first_chunk().ok_or(RecordError::Truncated)?;
        *field = *head;
        self.0 = rest;
        Ok(())
    }
}

/// Nowhere: how long would it be?
#[derive(Debug, Default)]
pub(crate) struct Ruler(pub(crate) usize);

impl Wire for Ruler {
    fn bytes<const N: usize>(&mut self, _: &mut [u8; N]) -> Done {
        self.0 = self.0.saturating_add(N);
        Ok(())
    }
}
