//! PDF pages: sizes from the page boxes, pictures by hayro, every call of it guarded.

use crate::error::Fault;
use crate::fit::{check_shape, fit};
use crate::guard::guarded;
use crate::inspect::inspect;
use crate::limits::{MAX_PDF_BYTES, MAX_PDF_PAGES};
use crate::picture::Picture;
use crate::title;
use hayro::hayro_interpret::InterpreterSettings;
use hayro::hayro_interpret::util::TransformExt;
use hayro::hayro_syntax::page::Page;
use hayro::hayro_syntax::{LoadPdfError, Pdf};
use hayro::kurbo::Affine;
use hayro::vello_cpu::color::palette::css::WHITE;
use hayro::vello_cpu::{Pixmap, RasterizerSettings, RenderContext, Resources, TargetInit};
use hayro::{RenderCache, RenderSettings, render_into};
use std::fs::File;
use std::io::Read;
use std::sync::{Arc, PoisonError, RwLock};

/// Bytes at the end of a file in which its end mark must stand; readers look at the last 1024.
const TAIL_BYTES: usize = 4096;

/// What every encrypted PDF says in its trailer.
const ENCRYPTED: &[u8] = b"/Encrypt";

/// A PDF held in memory.
pub(crate) struct PdfBook {
    bytes: Arc<Vec<u8>>,
    parsed: RwLock<Arc<Pdf>>,
    sizes: Vec<(f32, f32)>,
    title: Option<String>,
}

impl PdfBook {
    pub(crate) fn open(file: &File) -> Result<Self, Fault> {
        let bytes = Arc::new(read(file)?);
        let pdf = parse(&bytes)?;
        let sizes = guarded(|| sizes(&pdf)).map_err(|_| damaged())?;
        check_count(sizes.len())?;
        if sizes.is_empty() && contains(&bytes, ENCRYPTED) {
            return Err(Fault::PasswordProtected);
        }
        // hayro mends what it can, but a file that was cut off has lost pages in silence.
        if !has_end_mark(&bytes) {
            return Err(cut_off());
        }
        let title = pdf.metadata().title.as_deref().and_then(title::from_pdf);
        Ok(Self { bytes, parsed: RwLock::new(Arc::new(pdf)), sizes, title })
    }

    pub(crate) fn count(&self) -> usize {
        self.sizes.len()
    }

    pub(crate) fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    pub(crate) fn page_size(&self, i: usize) -> Result<(f32, f32), String> {
        let size = self.sizes.get(i).copied().ok_or("no such page")?;
        check_shape(size).map(|()| size)
    }

    pub(crate) fn page(&self, i: usize, max: (u32, u32)) -> Result<Picture, String> {
        let target = fit(self.page_size(i)?, max, f64::INFINITY);
        let pdf = Arc::clone(&self.parsed.read().unwrap_or_else(PoisonError::into_inner));
        let drawn = guarded(|| draw(&pdf, i, target))
            .unwrap_or_else(|_| Err("its drawing instructions are damaged".into()));
        drawn.inspect_err(|_| self.parse_again())
    }

    /// A panic may have poisoned a lock inside the parsed file; the other pages need it whole.
    fn parse_again(&self) {
        if let Ok(fresh) = parse(&self.bytes) {
            *self.parsed.write().unwrap_or_else(PoisonError::into_inner) = Arc::new(fresh);
        }
    }
}

fn read(file: &File) -> Result<Vec<u8>, Fault> {
    let too_large = || Fault::TooLarge(format!("a pdf of over {} MiB", MAX_PDF_BYTES >> 20));
    if file.metadata()?.len() > MAX_PDF_BYTES {
        return Err(too_large());
    }
    let mut bytes = Vec::new();
    file.take(MAX_PDF_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_PDF_BYTES { Err(too_large()) } else { Ok(bytes) }
}

fn parse(bytes: &Arc<Vec<u8>>) -> Result<Pdf, Fault> {
    match guarded(|| Pdf::new(Arc::clone(bytes))) {
        Ok(Ok(pdf)) => Ok(pdf),
        Ok(Err(LoadPdfError::Decryption(_))) => Err(Fault::PasswordProtected),
        // When hayro has to mend a file it forgets that the reason was a lock.
        Ok(Err(LoadPdfError::Invalid)) if contains(bytes, ENCRYPTED) => {
            Err(Fault::PasswordProtected)
        }
        Ok(Err(LoadPdfError::Invalid)) if !has_end_mark(bytes) => Err(cut_off()),
        Ok(Err(LoadPdfError::Invalid)) | Err(_) => Err(damaged()),
    }
}

fn damaged() -> Fault {
    Fault::Broken("its pages cannot be found".into())
}

fn cut_off() -> Fault {
    Fault::Broken("the file ends early".into())
}

fn check_count(pages: usize) -> Result<(), Fault> {
    if pages > MAX_PDF_PAGES {
        let reason = format!("{pages} pages, at most {MAX_PDF_PAGES} are read");
        return Err(Fault::TooLarge(reason));
    }
    Ok(())
}

fn has_end_mark(bytes: &[u8]) -> bool {
    // Some servers pad with zeros.
    let end =
        bytes.iter().rposition(|b| !matches!(b, 0 | b'\n' | b'\r' | b' ')).map_or(0, |i| i + 1);
    contains(&bytes[end.saturating_sub(TAIL_BYTES)..end], b"%%EOF")
}

fn contains(bytes: &[u8], wanted: &[u8]) -> bool {
    bytes.windows(wanted.len()).any(|w| w == wanted)
}

fn sizes(pdf: &Pdf) -> Vec<(f32, f32)> {
    pdf.pages().iter().map(|page| page.render_dimensions()).collect()
}

fn draw(pdf: &Pdf, i: usize, (width, height): (u32, u32)) -> Result<Picture, String> {
    let page = pdf.pages().get(i).ok_or("no such page")?;
    if page.raw().contains_key("Contents") && page.page_stream().is_none() {
        return Err("its contents cannot be read".into());
    }
    inspect(page)?;
    let narrow = |side: u32| u16::try_from(side).map_err(|_| "it is drawn too large");
    let mut context = RenderContext::new(narrow(width)?, narrow(height)?);
    let cache = RenderCache::new();
    let settings = InterpreterSettings::default();
    let place = placement(page, width, height);
    render_into(page, &cache, &settings, &exact(), &mut context, place);
    Ok(rasterise(&mut context))
}

/// Hinting and hayro's glyph cache snap lines of print to whole pixels, up or down by chance. A
/// page seen in perspective must not have that in it, and exact places cost no more.
fn exact() -> RenderSettings {
    RenderSettings { hinting: false, glyph_caching: false, ..Default::default() }
}

/// From page coordinates to pixels: both sides are rounded, so the two scales differ by a hair.
fn placement(page: &Page<'_>, width: u32, height: u32) -> Affine {
    let (w, h) = page.render_dimensions();
    Affine::scale_non_uniform(f64::from(width) / f64::from(w), f64::from(height) / f64::from(h))
        * page.initial_transform(true).to_kurbo()
}

fn rasterise(context: &mut RenderContext) -> Picture {
    context.flush();
    let mut pixmap = Pixmap::new(context.width(), context.height());
    let paper = RasterizerSettings { target_init: TargetInit::Clear(WHITE), ..Default::default() };
    context.render_with(&mut pixmap, &mut Resources::default(), paper);
    let (width, height) = (u32::from(pixmap.width()), u32::from(pixmap.height()));
    Picture { width, height, rgba: opaque(&pixmap) }
}

/// Colours are premultiplied: what is missing from full cover is the paper's white.
fn opaque(pixmap: &Pixmap) -> Vec<u8> {
    let mut rgba = pixmap.data_as_u8_slice().to_vec();
    for pixel in rgba.chunks_exact_mut(4) {
        let bare = 255 - pixel[3];
        pixel.iter_mut().for_each(|c| *c = c.saturating_add(bare));
    }
    rgba
}
