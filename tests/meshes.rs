//! What the tests of the mesh share: a book that is turned at random, and what a good mesh is.
#![allow(dead_code, missing_docs, unreachable_pub)]

use dogleaf_core::Book;
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::mesh::{Counts, Layout, Surface, Vertex, indices, vertices};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{BookSpec, Cover, Direction, Fidelity, PaperSpec, Preset, WorldSpec};
use std::collections::HashMap;

pub type Eleven = Book<f32, G11x8>;

/// A small generator: the tests need the same gestures everywhere.
pub struct Rng(pub u64);

impl Rng {
    /// One for the `n`-th gesture.
    pub fn new(n: u64) -> Self {
        let mut rng = Self(n.wrapping_mul(7919) + 12345);
        (0..5).for_each(|_| {
            rng.next();
        });
        rng
    }
    /// 0..1.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as f64) / ((1u64 << 31) as f64)
    }
    /// `from..to`.
    pub fn in_range(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[((self.next() * of.len() as f64) as usize).min(of.len() - 1)]
    }
}

/// What is opened and how it is turned.
#[derive(Debug, Clone)]
pub struct Case {
    pub spec: BookSpec,
    pub paper: Preset,
    pub stack: u16,
    pub forward: bool,
    pub frames: usize,
    pub fate: Phase,
    from: [f64; 2],
    to: [f64; 2],
    bow: f64,
    ease: f64,
}

impl Case {
    /// Everything at random; thin and thick, first and last page, single leaves and stacks.
    pub fn random(n: u64) -> Self {
        let mut r = Rng::new(n);
        let pages = r.pick(&[4, 4, 12, 80, 320, 320, 700, 1000]);
        let mut open_at = (f64::from(pages) * r.pick(&[0.0, 0.1, 0.4, 0.5, 0.9, 1.0])) as u32;
        let aspect = r.pick(&[0.5, 0.8, 1.3, 1.54, 1.54, 2.0]);
        let rtl = r.next() < 0.25;
        if pages == 4 && r.next() < 0.6 {
            open_at = 2;
        }
        let spec = BookSpec {
            pages,
            open_at,
            width_m: r.pick(&[0.1, 0.13, 0.21]),
            cover: if r.next() < 0.3 { Cover::Soft } else { Cover::Hard },
            direction: if rtl { Direction::Rtl } else { Direction::Ltr },
            ..BookSpec::default()
        };
        let spec = BookSpec { height_m: spec.width_m * aspect, ..spec };
        let most = f64::from(spec.leaves().min(45));
        let stack = if r.next() < 0.6 { 1 } else { 1 + (r.next() * most) as u16 };
        let paper = r.pick(&[
            Preset::Office,
            Preset::Office,
            Preset::Book,
            Preset::Newsprint,
            Preset::Glossy,
        ]);
        let side = if r.next() < 0.5 { 1.0 } else { -1.0 };
        let z0 = side * r.in_range(0.1, 0.98);
        let most_x = if r.next() < 0.3 { 11.0 } else { -6.0 };
        Self {
            spec,
            paper,
            stack,
            forward: r.next() < 0.6,
            frames: r.pick(&[12, 30, 60, 60]),
            fate: r.pick(&[Phase::Up, Phase::Up, Phase::Cancel]),
            from: [r.in_range(4.0, 11.8), z0],
            to: [r.in_range(-11.8, most_x), (z0 + r.in_range(-0.6, 0.6)).clamp(-1.0, 1.0)],
            bow: r.in_range(-60.0, 100.0),
            ease: r.next(),
        }
    }

    pub fn view(&self) -> View {
        View::reading(self.spec.width_m, self.spec.height_m, 960, 720)
    }

    pub fn open<R: Real, G: Grid>(&self, book: &mut Book<R, G>) {
        let paper = PaperSpec::from(self.paper);
        book.open(&self.spec, &paper, &WorldSpec::default(), &self.view(), Fidelity::Standard)
            .expect("a good spec");
    }

    /// Opens the book, turns, and shows every frame until it rests or `after` frames have passed.
    pub fn play<R: Real, G: Grid>(
        &self,
        book: &mut Book<R, G>,
        after: usize,
        mut look: impl FnMut(usize, &Book<R, G>),
    ) {
        self.open(book);
        let camera = self.view().camera::<f64>(book.units());
        let half_height = book.units().length(self.spec.height_m) * 0.5;
        let sign = if self.forward { 1.0 } else { -1.0 };
        let [left, right] = book.binding().thickness();
        let tops = if self.forward { [right, left] } else { [left, right] };
        let half = book.binding().half().wide();
        let place = |[x, z]: [f64; 2], top: R| {
            let out = x + if x > 0.0 { half } else { -half };
            camera.project(V3([out * sign, top.wide(), z * half_height])).unwrap_or([480.0, 360.0])
        };
        let (a, b) = (place(self.from, tops[0]), place(self.to, tops[1]));
        let sample = |t: f64, phase, t_us| {
            let e = self.ease * (t * t * (3.0 - 2.0 * t)) + (1.0 - self.ease) * t;
            let x = a[0] + (b[0] - a[0]) * e;
            let y = a[1] + (b[1] - a[1]) * e - self.bow * (4.0 * t * (1.0 - t));
            let [x, y] = [x, y].map(|c| (c * 256.0) as i32);
            Sample { t_us, id: 0, phase, x, y, leaves: self.stack }
        };
        let mut us = 20_000;
        book.input(sample(0.0, Phase::Down, us)).expect("room for a sample");
        for frame in 0..self.frames + after {
            for half in 0..if frame < self.frames { 2 } else { 0 } {
                us += 8333;
                let t = (frame as f64 + 0.5 * f64::from(half + 1)) / self.frames as f64;
                let last = frame + 1 == self.frames && half == 1;
                let phase = if last { self.fate } else { Phase::Move };
                book.input(sample(t, phase, us)).expect("room for a sample");
            }
            book.advance(16_667);
            look(frame, book);
            if frame > self.frames && !book.needs_frame() {
                break;
            }
        }
    }
}

/// Buffers a caller would own.
pub struct Mesh {
    pub vertices: Vec<Vertex>,
    pub indices: Vec<u16>,
    pub counts: Counts,
}

impl Mesh {
    pub fn new<G: Grid>() -> Self {
        let mut mesh = Self {
            vertices: vec![Vertex::default(); Layout::<G>::VERTICES],
            indices: vec![0; Layout::<G>::INDICES],
            counts: Layout::<G>::counts(),
        };
        indices::<G>(&mut mesh.indices).expect("room for the indices");
        mesh
    }
    pub fn draw<R: Real, G: Grid>(&mut self, book: &Book<R, G>) {
        self.counts = vertices(book, &mut self.vertices).expect("room for the vertices");
    }
    pub fn visible(&self, surface: Surface) -> bool {
        self.counts.part(surface).is_some_and(|p| p.visible)
    }
    pub fn of(&self, surface: Surface) -> &[Vertex] {
        &self.vertices
            [self.counts.part(surface).expect("every surface has a part").vertices.clone()]
    }
    pub fn triangles(&self, surface: Surface) -> impl Iterator<Item = [Vertex; 3]> + '_ {
        let part = self.counts.part(surface).expect("every surface has a part");
        self.indices[part.indices.clone()]
            .as_chunks::<3>()
            .0
            .iter()
            .map(|t| t.map(|i| self.vertices[usize::from(i)]))
    }
}

/// Bodies that have to be closed.
pub const BODIES: [&[Surface]; 6] = [
    &[Surface::LeafUp, Surface::LeafDown, Surface::LeafRim],
    &[Surface::LeftTop, Surface::LeftSides, Surface::LeftBottom],
    &[Surface::RightTop, Surface::RightSides, Surface::RightBottom],
    &[Surface::LeftBoard],
    &[Surface::RightBoard],
    &[Surface::Spine],
];

fn v3(p: [f32; 3]) -> [f64; 3] {
    p.map(f64::from)
}
fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
pub fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
    let d = sub(v3(a), v3(b));
    dot(d, d).sqrt()
}

/// Twice the area, as a vector.
pub fn area(t: [Vertex; 3]) -> [f64; 3] {
    let [a, b, c] = t.map(|v| v3(v.position));
    cross(sub(b, a), sub(c, a))
}

/// Every number finite, every normal a unit vector, every texture place in 0..1.
pub fn sound(mesh: &Mesh) -> Result<(), String> {
    for part in mesh.counts.parts.iter().filter(|p| p.visible) {
        for (i, v) in mesh.of(part.surface).iter().enumerate() {
            let all = v.position.iter().chain(&v.normal).chain(&v.uv);
            if !all.clone().all(|c| c.is_finite()) {
                return Err(format!("{:?} vertex {i} is not finite", part.surface));
            }
            let n = v3(v.normal);
            if (dot(n, n) - 1.0).abs() > 1e-4 {
                return Err(format!("{:?} normal {i} is {:?}", part.surface, v.normal));
            }
            if v.uv.iter().any(|c| !(0.0..=1.0).contains(c)) {
                return Err(format!("{:?} uv {i} is {:?}", part.surface, v.uv));
            }
        }
    }
    Ok(())
}

/// No triangle without area, none turned against its normals. On the rim only the area counts: on a stack
/// folded over sharply its strips may turn over.
pub fn upright(mesh: &Mesh) -> Result<(), String> {
    for part in mesh.counts.parts.iter().filter(|p| p.visible) {
        for (i, t) in mesh.triangles(part.surface).enumerate() {
            let n = area(t);
            if dot(n, n) <= 0.0 {
                return Err(format!("{:?} triangle {i} has no area", part.surface));
            }
            let rim = part.surface == Surface::LeafRim;
            if !rim && t.iter().any(|v| dot(n, v3(v.normal)) <= 0.0) {
                return Err(format!("{:?} triangle {i} is inverted: {t:?}", part.surface));
            }
        }
    }
    Ok(())
}

/// Every edge of every body has two triangles, one each way round, and the inside is inside.
pub fn closed(mesh: &Mesh) -> Result<(), String> {
    for body in BODIES.iter().filter(|b| mesh.visible(b[0])) {
        let mut edges = HashMap::new();
        let mut volume = 0.0;
        for &surface in *body {
            for t in mesh.triangles(surface) {
                let key = t.map(|v| v.position.map(|c| (c + 0.0).to_bits()));
                for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                    if key[a] == key[b] {
                        return Err(format!("{surface:?} has an edge without length"));
                    }
                    *edges.entry((key[a], key[b])).or_insert(0) += 1;
                }
                volume += dot(v3(t[0].position), area(t)) / 6.0;
            }
        }
        for (&(a, b), &count) in &edges {
            if count != 1 || edges.get(&(b, a)) != Some(&1) {
                return Err(format!("{:?}: an edge at {a:?} is open", body[0]));
            }
        }
        if volume <= 0.0 {
            return Err(format!("{:?} has its inside outside: {volume}", body[0]));
        }
    }
    Ok(())
}

/// The worst relative error of the drawn width of any row of leaf and blocks.
pub fn width_error<G: Grid>(mesh: &Mesh, width: f64) -> f64 {
    let (columns, rows) = (Layout::<G>::COLUMNS, Layout::<G>::ROWS);
    let mut worst = 0.0f64;
    let mut take = |surface, rows: usize, offset: usize| {
        if mesh.visible(surface) {
            let net = &mesh.of(surface)[offset..];
            for row in 0..rows {
                let line: Vec<_> = net[row..].iter().step_by(rows).take(columns).collect();
                let length: f64 =
                    line.windows(2).map(|w| distance(w[0].position, w[1].position)).sum();
                worst = worst.max((length / width - 1.0).abs());
            }
        }
    };
    for surface in [Surface::LeafUp, Surface::LeafDown] {
        take(surface, rows, 0);
    }
    use Surface::{LeftBottom, LeftSides, LeftTop, RightBottom, RightSides, RightTop};
    for surface in [LeftTop, LeftBottom, RightTop, RightBottom] {
        take(surface, 2, 0);
    }
    for surface in [LeftSides, RightSides] {
        if mesh.visible(surface) {
            let levels = mesh.of(surface).len() / (2 * columns + 4);
            take(surface, levels, 0);
            take(surface, levels, columns * levels);
        }
    }
    worst
}

/// Everything at once.
pub fn check<G: Grid>(mesh: &Mesh, width: f64) -> Result<(), String> {
    sound(mesh)?;
    upright(mesh)?;
    closed(mesh)?;
    let error = width_error::<G>(mesh, width);
    if error > 1e-4 { Err(format!("a row is {error} too long or short")) } else { Ok(()) }
}
