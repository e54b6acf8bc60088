//! How large a page is on paper, metres.

use crate::book::Book;
use crate::kind::BookKind;

/// Width of a page nobody knows the size of, metres.
const WIDTH_M: f64 = 0.130;
/// Sizes of a page that a PDF is believed, metres.
const SANE_M: std::ops::RangeInclusive<f64> = 0.060..=0.300;
/// Metres in a point of a PDF.
const POINT_M: f64 = 0.0254 / 72.0;
/// Pages a PDF is asked for one of the typical shape.
const ASKED: usize = 64;

impl Book {
    /// Width and height of a page, metres: a PDF's own, if they are a book's; else 130 mm wide.
    ///
    /// # Cost
    ///
    /// As [`aspect`](Self::aspect).
    #[must_use]
    pub fn size_m(&self) -> [f64; 2] {
        let aspect = f64::from(self.aspect()).clamp(0.2, 5.0);
        let own = match self.kind() {
            BookKind::Pdf => self.own_size_m(aspect),
            _ => None,
        };
        own.unwrap_or([WIDTH_M, WIDTH_M / aspect])
    }

    /// The size of the first page that has the typical shape.
    fn own_size_m(&self, aspect: f64) -> Option<[f64; 2]> {
        let sizes = (0..self.page_count().min(ASKED)).filter_map(|i| self.page_size(i).ok());
        let points = |(w, h): (f32, f32)| [f64::from(w), f64::from(h)];
        let mut typical = sizes.map(points).filter(|[w, h]| (w / h / aspect - 1.0).abs() < 0.01);
        let size = typical.next()?.map(|side| side * POINT_M);
        size.iter().all(|side| SANE_M.contains(side)).then_some(size)
    }
}
