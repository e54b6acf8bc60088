//! A page as pixels.

/// One page: opaque 8-bit sRGB with alpha, rows from the head down, left to right, no padding.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// `4 * width * height` bytes; every fourth is 255.
    pub rgba: Vec<u8>,
}

impl Picture {
    /// Makes a sheet of bare white paper, for a page that cannot be drawn.
    ///
    /// # Errors
    ///
    /// None: a size beyond the [`limits`](crate::limits) is made smaller, its shape kept.
    #[must_use]
    pub fn blank(width: u32, height: u32) -> Self {
        let shape = (width.max(1) as f32, height.max(1) as f32);
        let (width, height) = crate::fit::fit(shape, (width, height), 1.0);
        Self { width, height, rgba: vec![255; 4 * width as usize * height as usize] }
    }

    /// Reads one pixel, `None` outside.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        if x >= self.width {
            return None;
        }
        let at = 4 * (y as usize * self.width as usize + x as usize);
        self.rgba.get(at..at + 4)?.try_into().ok()
    }
}

impl std::fmt::Debug for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Picture({} x {})", self.width, self.height)
    }
}
