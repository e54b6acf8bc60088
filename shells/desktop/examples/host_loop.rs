//! The whole of what a reader's app does: samples and time in, one mesh and what happened out. Paste it, and put
//! your own window, textures and page numbers where the comments are.

use dogleaf_core::Reading;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::mesh::Vertex;
use dogleaf_core::reading::{Face, Notice, Shape};
use dogleaf_core::record::{RecordError, Setup};
use dogleaf_core::scene::BookSpec;

type Paper = Reading<f32, G11x8>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut paper = Box::new(Paper::EMPTY);
    open(&mut paper)?;
    let mut indices = vec![0_u16; Shape::<G11x8>::INDICES];
    Paper::indices(&mut indices)?; // Once: upload them.
    let mut vertices = vec![Vertex::default(); Shape::<G11x8>::VERTICES];

    // Your platform's pointer events, in its own clock, in 1/256 pixel of the view.
    let at = |phase, x: i32| Sample { t_us: 0, id: 0, phase, x: x * 256, y: 500 * 256, leaves: 0 };
    let mut finger = (0..=60).map(|n| match n {
        0 => at(Phase::Down, 780),
        60 => at(Phase::Up, 180),
        n => at(Phase::Move, 780 - 10 * n),
    });
    let (mut now_us, mut frames) = (0, 0);
    loop {
        now_us += 16_667;
        if let Some(sample) = finger.next() {
            paper.pointer(Sample { t_us: now_us, ..sample }, &mut ())?;
        }
        if paper.step(now_us, &mut ()).draw {
            for piece in paper.vertices(&mut vertices)?.iter().filter(|p| p.visible) {
                if let Face::Page(_page) = piece.face {
                    // Bind that page's texture; then draw `piece.indices` of the one mesh.
                }
            }
            frames += 1;
        }
        while let Some(notice) = paper.take_notice() {
            match notice {
                Notice::Committed { page } => println!("the book is open at {page}: keep it"),
                Notice::Cancelled => println!("the leaf was put back"),
                _ => {}
            }
        }
        if !paper.needs_frame() {
            break; // Asleep: wait for the next input, and draw nothing until then.
        }
    }
    println!("{frames} pictures of {} vertices", vertices.len());
    Ok(())
}

fn open(paper: &mut Paper) -> Result<(), RecordError> {
    paper.open(&Setup::fingers(BookSpec { pages: 24, open_at: 8, ..BookSpec::default() }, 960, 720))
}
