//! Animations read back by another decoder.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use dogleaf_render::AnimError;
use dogleaf_render::anim::Writer;
use image::{AnimationDecoder, Frame};

const WIDTH: usize = 50;
const HEIGHT: usize = 38;

/// A place for a test's file, unique to it.
fn place(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("dogleaf_{}_{name}", std::process::id()))
}

/// Paper with a dark square that wanders; frame 4 is as frame 3.
fn frame(i: usize) -> Vec<u8> {
    let i = if i == 4 { 3 } else { i };
    let mut bytes = Vec::new();
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let inside = (i * 4..i * 4 + 10).contains(&x) && (8..20).contains(&y);
            let shade = 190 + (x / 4 + y / 4) as u8;
            bytes.extend(if inside { [40, 30, 30] } else { [shade, shade, shade - 12] });
        }
    }
    bytes
}

fn write(path: &Path, fps: u32, frames: usize) {
    let mut writer = Writer::create(path, WIDTH as u32, HEIGHT as u32, fps).expect("a sound start");
    for i in 0..frames {
        writer.push(&frame(i)).expect("a sound frame");
    }
    assert_eq!(writer.frames(), frames as u64, "all are counted");
    writer.finish().expect("a sound end");
}

fn read(path: &Path) -> Vec<Frame> {
    let file = BufReader::new(File::open(path).expect("the file is there"));
    let frames = match path.extension().and_then(|e| e.to_str()) {
        Some("webp") => image::codecs::webp::WebPDecoder::new(file).expect("WebP").into_frames(),
        Some("gif") => image::codecs::gif::GifDecoder::new(file).expect("GIF").into_frames(),
        _ => image::codecs::png::PngDecoder::new(file)
            .expect("PNG")
            .apng()
            .expect("animated")
            .into_frames(),
    };
    frames.collect_frames().expect("every frame decodes")
}

fn milliseconds(frame: &Frame) -> u32 {
    let (numerator, denominator) = frame.delay().numer_denom_ms();
    numerator / denominator
}

/// Mean difference of the channels, levels.
fn apart(found: &Frame, expected: &[u8]) -> f32 {
    let pairs = found.buffer().pixels().zip(expected.chunks_exact(3));
    let sum: u32 = pairs.flat_map(|(a, b)| (0..3).map(|c| u32::from(a.0[c].abs_diff(b[c])))).sum();
    sum as f32 / expected.len() as f32
}

fn round_trip(name: &str, tolerance: f32) {
    let path = place(name);
    write(&path, 20, 7);
    let frames = read(&path);
    assert_eq!(frames.len(), 6, "the frame that repeats only lasts longer");
    let lengths: Vec<u32> = frames.iter().map(milliseconds).collect();
    assert_eq!(lengths, [50, 50, 50, 100, 50, 50], "each lasts its time");
    for (found, expected) in frames.iter().zip([0, 1, 2, 3, 5, 6]) {
        assert_eq!(found.buffer().dimensions(), (WIDTH as u32, HEIGHT as u32), "whole pictures");
        let apart = apart(found, &frame(expected));
        assert!(apart <= tolerance, "frame {expected} is {apart} levels off");
    }
    std::fs::remove_file(path).ok();
}

#[test]
fn webp_reads_back() {
    round_trip("a.webp", 2.5);
}

#[test]
fn gif_reads_back() {
    round_trip("a.gif", 3.5);
}

#[test]
fn png_reads_back_exactly() {
    round_trip("a.png", 0.0);
}

#[test]
fn a_folder_holds_every_frame() {
    let path = place("frames");
    write(&path, 20, 5);
    for i in 0..5 {
        let picture = image::open(path.join(format!("frame_{i:04}.png")))
            .expect("the picture is there")
            .to_rgb8();
        assert_eq!(picture.into_raw(), frame(i), "frame {i}");
    }
    // Into the same folder once more: the pictures are replaced.
    write(&path, 20, 2);
    assert_eq!(std::fs::read_dir(&path).expect("the folder is there").count(), 5, "none was lost");
    std::fs::remove_dir_all(path).ok();
}

#[test]
fn a_gif_too_fast_for_players_leaves_frames_out_but_not_the_last() {
    let path = place("fast.gif");
    write(&path, 100, 8);
    let frames = read(&path);
    assert!(frames.len() < 8, "some are left out");
    assert!(
        frames.iter().rev().skip(1).all(|f| milliseconds(f) >= 20),
        "the others last two hundredths"
    );
    let last = apart(&frames[frames.len() - 1], &frame(7));
    assert!(last < 3.5, "the last frame is the last one pushed: {last} levels off");
    std::fs::remove_file(path).ok();
}

#[test]
fn sixty_frames_make_one_second() {
    for name in ["second.webp", "second.gif", "second.png"] {
        let path = place(name);
        let mut writer = Writer::create(&path, 16, 16, 60).expect("a sound start");
        for i in 0..60_u8 {
            writer.push(&[4 * i; 16 * 16 * 3]).expect("a sound frame");
        }
        writer.finish().expect("a sound end");
        let total: u32 = read(&path).iter().map(milliseconds).sum();
        // A GIF may hold its last frame but one a little longer to show the last one, too.
        assert!((1000..=1020).contains(&total), "{name}: {total} ms");
        std::fs::remove_file(path).ok();
    }
}

#[test]
fn odd_sizes_read_back() {
    for (width, height) in [(1, 1), (2, 3), (17, 31), (33, 16)] {
        for name in ["odd.webp", "odd.gif", "odd.png"] {
            let path = place(name);
            let mut writer = Writer::create(&path, width, height, 10).expect("a sound start");
            for shade in [20, 220] {
                writer.push(&vec![shade; (width * height * 3) as usize]).expect("a sound frame");
            }
            writer.finish().expect("a sound end");
            let frames = read(&path);
            assert_eq!(frames.len(), 2, "{name} {width}x{height}");
            let off = apart(&frames[1], &vec![220; (width * height * 3) as usize]);
            assert!(off < 5.0, "{name} {width}x{height}: {off} levels off");
            std::fs::remove_file(path).ok();
        }
    }
}

#[test]
fn a_run_that_fails_leaves_nothing_behind() {
    let folder = place("half");
    std::fs::create_dir_all(&folder).expect("a folder");
    for name in ["half.webp", "half.gif", "half.png", "half"] {
        let mut writer = Writer::create(&folder.join(name), WIDTH as u32, HEIGHT as u32, 20)
            .expect("a sound start");
        writer.push(&frame(0)).expect("a sound frame");
        writer.push(&frame(1)).expect("a sound frame");
        assert!(!folder.join(name).exists(), "{name} has no name before it is complete");
        drop(writer);
    }
    let empty = Writer::create(&folder.join("none.webp"), 8, 8, 20).expect("a sound start");
    assert!(matches!(empty.finish(), Err(AnimError::Empty)), "no frame, no file");
    assert_eq!(
        std::fs::read_dir(&folder).expect("the folder is there").count(),
        0,
        "no half files"
    );
    std::fs::remove_dir_all(folder).ok();
}

#[test]
fn unsound_calls_are_refused() {
    let create = |name: &str, width, fps| Writer::create(&place(name), width, 10, fps);
    assert!(
        matches!(create("a.bmp", 10, 20), Err(AnimError::Format(_))),
        "an ending we do not know"
    );
    assert!(matches!(create("b.webp", 0, 20), Err(AnimError::Shape { .. })), "no picture");
    assert!(
        matches!(create("b.webp", 20_000, 20), Err(AnimError::Shape { .. })),
        "wider than a frame can be"
    );
    assert!(matches!(create("b.webp", 10, 0), Err(AnimError::Shape { .. })), "no time");
    let nowhere = Path::new("/no/such/folder/a.webp");
    assert!(matches!(Writer::create(nowhere, 10, 10, 20), Err(AnimError::Io { .. })), "no folder");
    let path = place("c.webp");
    let mut writer = Writer::create(&path, 10, 10, 20).expect("a sound start");
    let wrong = writer.push(&[0; 299]);
    assert!(matches!(wrong, Err(AnimError::Frame { needed: 300, got: 299 })), "a byte is missing");
}
