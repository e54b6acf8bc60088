//! Arbitrary bytes to what a book can be asked.

use arbitrary::{Result, Unstructured};
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::scene::{BookSpec, Cover, Direction, Fidelity, PaperSpec, Weights, WorldSpec};

/// A number: any bits at all, or one that is likely to be taken.
pub fn number(u: &mut Unstructured<'_>, least: f64, most: f64) -> Result<f64> {
    if u.ratio(1u8, 16u8)? {
        return u.arbitrary();
    }
    let share = f64::from(u.arbitrary::<u16>()?) / f64::from(u16::MAX);
    Ok((least.ln() + (most.ln() - least.ln()) * share).exp())
}

/// One of a few.
pub fn one_of<T: Copy>(u: &mut Unstructured<'_>, all: &[T]) -> Result<T> {
    u.choose(all).copied()
}

/// A sample so much later than `now_us`, on the screen or anywhere.
pub fn sample(u: &mut Unstructured<'_>, now_us: u64) -> Result<Sample> {
    let phases = [Phase::Down, Phase::Move, Phase::Move, Phase::Move, Phase::Up, Phase::Cancel];
    let t_us = match u.arbitrary::<u8>()? {
        0 => u.arbitrary()?,
        1 => now_us.saturating_sub(u64::from(u.arbitrary::<u16>()?)),
        later => now_us + 300 * u64::from(later),
    };
    let near = !u.ratio(1u8, 16u8)?;
    let mut place = |side: i32| {
        if near { u.int_in_range(0..=256 * side) } else { u.arbitrary() }
    };
    let (x, y) = (place(960)?, place(720)?);
    Ok(Sample {
        t_us,
        id: one_of(u, &[0, 0, 0, 1, 255])?,
        phase: one_of(u, &phases)?,
        x,
        y,
        leaves: one_of(u, &[0, 1, 1, 3, u16::MAX])?,
    })
}

/// A view, mostly of the default book.
pub fn view(u: &mut Unstructured<'_>) -> Result<View> {
    let [width_px, height_px] = [u.arbitrary::<u16>()?, u.arbitrary::<u16>()?].map(u32::from);
    let mut view = View::reading(0.13, 0.2, width_px, height_px);
    for c in view.eye_m.iter_mut().chain(&mut view.target_m) {
        if u.ratio(1u8, 4u8)? {
            *c = number(u, 1e-3, 1e3)?;
        }
    }
    if u.ratio(1u8, 4u8)? {
        view.fov_y_deg = number(u, 1.0, 150.0)?;
    }
    Ok(view)
}

/// A book.
pub fn book(u: &mut Unstructured<'_>) -> Result<BookSpec> {
    let width_m = number(u, 1e-3, 10.0)?;
    let pages = number(u, 1.0, 20_000.0)? as u32;
    Ok(BookSpec {
        width_m,
        height_m: width_m * number(u, 0.2, 5.0)?,
        pages,
        open_at: if u.arbitrary()? { pages / 2 } else { u.arbitrary::<u16>()?.into() },
        cover: one_of(u, &[Cover::Hard, Cover::Soft])?,
        direction: one_of(u, &[Direction::Ltr, Direction::Rtl])?,
    })
}

/// Paper, in physical units or as weights.
pub fn paper(u: &mut Unstructured<'_>) -> Result<PaperSpec> {
    let mut paper = PaperSpec {
        areal_mass_gsm: number(u, 1.0, 1e4)?,
        thickness_mm: number(u, 1e-3, 10.0)?,
        youngs_gpa: number(u, 1e-6, 1e3)?,
        poisson: number(u, 1e-3, 0.49)?,
        weights: None,
    };
    if u.arbitrary()? {
        let mut weight = || number(u, 1e-3, 1e6);
        paper.weights = Some(Weights {
            bend_3d: weight()?,
            bend_2d: weight()?,
            glue: weight()?,
            iso_3d: weight()?,
            position: weight()?,
        });
    }
    Ok(paper)
}

/// A world.
pub fn world(u: &mut Unstructured<'_>) -> Result<WorldSpec> {
    let mut gravity = [0.0; 3];
    for g in &mut gravity {
        let sign = one_of(u, &[-1.0, 0.0, 1.0])?;
        *g = sign * number(u, 1e-3, 1e3)?;
    }
    Ok(WorldSpec {
        gravity,
        damping_per_s: number(u, 1e-3, 1e3)?,
        step_us: number(u, 100.0, 1e5)? as u32,
        seed: 1,
    })
}

/// A fidelity that is not the slowest.
pub fn fidelity(u: &mut Unstructured<'_>) -> Result<Fidelity> {
    one_of(u, &[Fidelity::Draft, Fidelity::Standard, Fidelity::Fine])
}
