//! Promise: what is drawn is right to the pixel: a leaf that lies is its page, triangles meet without gap or overlap, parts
//! drawn one after another are the whole, and what does not change does not flicker.

mod support;

use dogleaf_core::scene::BookSpec;
use dogleaf_eink::pose::{ACROSS, ALONG, UNIT};
use dogleaf_eink::{
    Band, Canvas, Depth, Faces, Layout, Panel, Pose, Print, Rect, Scene, Sheet, Stage,
};
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Size};
use embedded_graphics_core::pixelcolor::BinaryColor;
use support::board::Lines;

const WIDTH: usize = 800;
const HEIGHT: usize = 600;

fn stage() -> Stage {
    Stage::new(&BookSpec::default(), &Panel::SIX_INCH, Layout::Spread).expect("a page fits")
}

/// A leaf that rises along a curve: `bend` of 256 of a right angle at the fore-edge, lying where that is nothing.
fn leaf(bend: i32, stage: &Stage) -> Pose {
    let mut pose = Pose::ZERO;
    let [w, h] = stage.page().map(f64::from);
    let half = f64::from(UNIT) * h / w / 2.0;
    let total = f64::from(bend) / 256.0 * std::f64::consts::FRAC_PI_2;
    for i in 0..ACROSS {
        let s = i as f64 / (ACROSS - 1) as f64;
        let (mut x, mut y) = (s, 0.0);
        if total > 0.0 {
            x = (total * s).sin() / total;
            y = (1.0 - (total * s).cos()) / total;
        }
        for k in 0..ALONG {
            let z = half * (1.0 - 2.0 * k as f64 / (ALONG - 1) as f64);
            let unit = f64::from(UNIT);
            pose.nodes[i][k] = [x * unit, y * unit, z].map(|c| c.round() as i16);
        }
    }
    pose
}

fn paint(scene: Scene<'_>, print: &impl Print, rects: &[Rect]) -> Vec<u8> {
    let stage = stage();
    let faces = Faces { left: Some(3), right: Some(6), up: Some(4), down: Some(5) };
    let canvas = Canvas { stage: &stage, faces, scene, print, hard: false };
    let mut band = Box::new(Band::<{ WIDTH * 17 }>::EMPTY);
    let mut out = vec![0; WIDTH * HEIGHT];
    for rect in rects {
        let rows = Band::<{ WIDTH * 17 }>::rows(rect.width());
        for top in (rect.y0..rect.y1).step_by(usize::from(rows)) {
            let part = Rect { y0: top, y1: (top + rows).min(rect.y1), ..*rect };
            let mut pixels = band.draw(part, &canvas);
            for y in part.y0..part.y1 {
                for x in part.x0..part.x1 {
                    out[usize::from(y) * WIDTH + usize::from(x)] = pixels.next().expect("all");
                }
            }
        }
    }
    out
}

const WHOLE: [Rect; 1] = [Rect { x0: 0, y0: 0, x1: 800, y1: 600 }];

#[test]
fn a_leaf_that_lies_is_its_page() {
    let stage = stage();
    let mut sheet = Box::new(Sheet::EMPTY);
    sheet.look(&leaf(0, &stage), &stage);
    let drawn = paint(Scene::Leaf(&sheet), &Lines, &WHOLE);
    let page = stage.pages()[1];
    let mut off = 0;
    for y in page.y0 + 3..page.y1 - 3 {
        for x in page.x0 + 3..page.x1 - 3 {
            let found = drawn[usize::from(y) * WIDTH + usize::from(x)];
            let wanted = Lines.luma(4, x - page.x0, y - page.y0);
            off += usize::from(found.abs_diff(wanted) > 2);
        }
    }
    assert!(off * 1_000 < page.area() as usize, "{off} pixels of {} are another's", page.area());
}

/// A print that counts how often it is asked: each pixel of the leaf once, if no triangles overlap or leave a gap.
#[derive(Debug)]
struct White;

impl Print for White {
    fn luma(&self, page: u32, _: u16, _: u16) -> u8 {
        if page == 4 || page == 5 { 255 } else { 0 }
    }
}

#[test]
fn no_hole_in_a_leaf() {
    let stage = stage();
    let mut sheet = Box::new(Sheet::EMPTY);
    for bend in [0, 20, 60, 120, 180, 240] {
        sheet.look(&leaf(bend, &stage), &stage);
        let drawn = paint(Scene::Leaf(&sheet), &White, &WHOLE);
        // Along each row the leaf is one run of light pixels but for its outline; beyond the page is light, too.
        let end = usize::from(stage.pages()[1].x1);
        for y in 40..HEIGHT - 40 {
            let row = &drawn[y * WIDTH..(y + 1) * WIDTH];
            let light = |x: &usize| row[*x] > 60 && *x > 400;
            let (Some(first), Some(last)) =
                ((401..end).find(|x| light(x)), (401..end).rfind(|x| light(x)))
            else {
                continue;
            };
            let dark: Vec<_> = (first..last).filter(|x| !light(x)).map(|x| (x, row[x])).collect();
            assert!(dark.len() <= 1, "bend {bend}, row {y}, {first}..{last}: {dark:?}");
        }
    }
}

#[test]
fn parts_are_the_whole() {
    let stage = stage();
    let mut sheet = Box::new(Sheet::EMPTY);
    sheet.look(&leaf(150, &stage), &stage);
    let whole = paint(Scene::Leaf(&sheet), &Lines, &WHOLE);
    let parts = [
        Rect::new(0, 0, 248, 600),
        Rect::new(248, 0, 800, 201),
        Rect::new(248, 201, 800, 202),
        Rect::new(248, 202, 800, 600),
    ];
    let pieces = paint(Scene::Leaf(&sheet), &Lines, &parts);
    // A vertical seam has no neighbour to draw an outline against.
    let wrong =
        whole.iter().zip(&pieces).enumerate().filter(|(n, (a, b))| a != b && n % WIDTH != 248);
    assert_eq!(wrong.count(), 0, "pixels differ");
}

/// Where the brightness is the same in two pictures, so are the dots.
#[test]
fn dots_do_not_crawl() {
    let stage = stage();
    let mut sheet = Box::new(Sheet::EMPTY);
    let pictures = [140, 150].map(|bend| {
        sheet.look(&leaf(bend, &stage), &stage);
        paint(Scene::Leaf(&sheet), &Lines, &WHOLE)
    });
    let mut still = 0;
    for (n, (a, b)) in pictures[0].iter().zip(&pictures[1]).enumerate() {
        let (x, y) = ((n % WIDTH) as u16, (n / WIDTH) as u16);
        let dot = |luma| Depth::TwoTone.level(luma, x, y);
        if a == b {
            still += 1;
            assert_eq!(dot(*a), dot(*b), "pixel {x},{y}");
        } else if a.abs_diff(*b) == 1 {
            // A brightness off by one may turn a dot, no more often than one in 255.
            still += usize::from(dot(*a) == dot(*b));
        }
    }
    assert!(still > WIDTH * HEIGHT / 2, "{still} pixels stayed");
}

/// A display of one bit a pixel, as drivers have it.
struct Bits(Vec<bool>);

impl OriginDimensions for Bits {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl DrawTarget for Bits {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        for Pixel(at, colour) in pixels {
            self.0[at.y as usize * WIDTH + at.x as usize] = colour.is_on();
        }
        Ok(())
    }
}

#[test]
fn any_target_of_two_tones_gets_the_same_dots() {
    let stage = stage();
    let mut sheet = Box::new(Sheet::EMPTY);
    sheet.look(&leaf(120, &stage), &stage);
    let scene = Scene::Leaf(&sheet);
    let wanted = paint(scene, &Lines, &WHOLE);
    let faces = Faces { left: Some(3), right: Some(6), up: Some(4), down: Some(5) };
    let canvas = Canvas { stage: &stage, faces, scene, print: &Lines, hard: false };
    let mut bits = Bits(vec![false; WIDTH * HEIGHT]);
    let mut band = Box::new(Band::<{ WIDTH * 9 }>::EMPTY);
    let Ok(()) = dogleaf_eink::draw(WHOLE[0], &canvas, Depth::TwoTone, &mut band, &mut bits);
    let dot =
        |n: usize| Depth::TwoTone.level(wanted[n], (n % WIDTH) as u16, (n / WIDTH) as u16) > 7;
    let wrong = (0..WIDTH * HEIGHT).filter(|&n| bits.0[n] != dot(n)).count();
    assert_eq!(wrong, 0, "dots");
}

#[test]
fn a_pose_is_written_and_read() {
    let pose = leaf(100, &stage());
    assert_eq!(Pose::from_bytes(&pose.to_bytes()), Some(pose), "the same");
    assert_eq!(Pose::from_bytes(&pose.to_bytes()[1..]), None, "cut short");
}

#[test]
fn progress_goes_from_nothing_to_all() {
    let mut pose = leaf(0, &stage());
    assert_eq!(pose.progress(), 0, "lying");
    let mut last = 0;
    for degrees in 0..=180 {
        let angle = f64::from(degrees).to_radians();
        for i in 0..ACROSS {
            let s = f64::from(UNIT) * i as f64 / 10.0;
            for node in &mut pose.nodes[i] {
                node[0] = (s * angle.cos()).round() as i16;
                node[1] = (s * angle.sin()).round() as i16;
            }
        }
        let now = pose.progress();
        assert!(now >= last, "{degrees}: {now} after {last}");
        last = now;
    }
    assert_eq!(last, 1_024, "over");
}

#[test]
fn what_is_no_panel_or_page_is_refused() {
    let book = BookSpec::default();
    for (width, height) in [(0, 600), (63, 600), (800, 2_049)] {
        let panel = Panel { width, height, ..Panel::SIX_INCH };
        assert!(Stage::new(&book, &panel, Layout::Spread).is_err(), "{width}x{height}");
    }
    let slow = Panel { du_us: 0, ..Panel::SIX_INCH };
    assert!(slow.check().is_err(), "a waveform of no time");
    let narrow = BookSpec { width_m: 0.001, height_m: 10.0, ..book };
    let panel = Panel::SIX_INCH;
    assert!(Stage::new(&narrow, &panel, Layout::Spread).is_err(), "a page of no pixels");
}
