//! One page turn, by three books in step: the seed's form, and ours in both scalars.

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::Sample;
use dogleaf_core::seed::{Factor, Matrix, SeedBook, SeedGrid, SeedSettings};
use dogleaf_tests::gesture::{FRAME_US, Gesture, Scene};

use crate::matrices::Matrices;

/// Which corner is carried how over the spine.
const GESTURE: u64 = 0;
/// Poses that are kept: the drag of a second, and what follows of the fall.
const POSES: usize = 80;
/// Pictures after which a turn that gave too few poses is given up.
const PATIENCE: usize = 300;

/// The seed's matrix in its own storage.
pub(crate) type Kkt = Matrix<f64, G11x8>;

/// The same moments of one turn as everyone wants them.
#[derive(Debug)]
pub(crate) struct Turn {
    /// The book, its paper, its world.
    pub(crate) scene: Scene,
    /// The seed's full KKT, for other solvers.
    pub(crate) set: Matrices,
    /// The same for the seed form's own factor.
    pub(crate) kkt: Vec<Box<Kkt>>,
    /// That factor, its slots found.
    pub(crate) factor: Box<Factor<f64, G11x8>>,
    /// Our book before the step from each pose, its input handed over.
    pub(crate) single: Vec<Box<Book<f32, G11x8>>>,
    /// The same in `f64`.
    pub(crate) double: Vec<Box<Book<f64, G11x8>>>,
}

/// Three books on one table.
struct Table {
    seed: Box<SeedBook<f64, G11x8>>,
    single: Box<Book<f32, G11x8>>,
    double: Box<Book<f64, G11x8>>,
}

/// Plays a corner turn and keeps [`POSES`] moments at which all three books have a leaf in the air.
///
/// The weights are the seed's, so that it is its book. Its Hessian is cut to the semidefinite part: with
/// the exact one its line search stalls and the turn takes long; the pattern is the same.
///
/// # Errors
///
/// A book refused the scene or a sample, or the turn ended early.
pub(crate) fn corner_turn() -> Result<Turn, String> {
    let scene = Scene::seed();
    let samples = Gesture::corner_turn(&scene.eye(), GESTURE);
    let mut table = Table::open(&scene)?;
    let mut turn = Turn::empty(scene);
    let mut next = samples.iter().copied().peekable();
    for _ in 0..PATIENCE {
        let until = table.double.now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            table.input(sample)?;
        }
        if table.in_air() {
            turn.keep(&mut table)?;
        }
        if turn.double.len() == POSES {
            turn.factor = Box::new(table.seed.solver().factor().clone());
            return Ok(turn);
        }
        table.advance();
    }
    Err(format!("the turn gave {} poses, not {POSES}", turn.double.len()))
}

impl Table {
    fn open(scene: &Scene) -> Result<Self, String> {
        let s = scene;
        let settings = SeedSettings { exact: false, ..SeedSettings::default() };
        let mut seed = Box::new(SeedBook::EMPTY);
        seed.open(&s.book, &s.paper, &s.world, &s.view, s.fidelity, settings)
            .map_err(|e| e.to_string())?;
        let single = scene.open().map_err(|e| e.to_string())?;
        let double = scene.open().map_err(|e| e.to_string())?;
        Ok(Self { seed, single, double })
    }

    fn input(&mut self, sample: Sample) -> Result<(), String> {
        let all = [
            self.seed.book_mut().input(sample),
            self.single.input(sample),
            self.double.input(sample),
        ];
        all.into_iter().collect::<Result<(), _>>().map_err(|e| e.to_string())
    }

    fn in_air(&self) -> bool {
        self.seed.book().leaf().is_some()
            && self.single.leaf().is_some()
            && self.double.leaf().is_some()
    }

    fn advance(&mut self) {
        self.seed.advance(FRAME_US);
        self.single.advance(FRAME_US);
        self.double.advance(FRAME_US);
    }
}

impl Turn {
    fn empty(scene: Scene) -> Self {
        let n = G11x8::N;
        let set = Matrices {
            name: "seed's full KKT, one corner turn, 11x8",
            n,
            starts: vec![0; n + 1],
            rows: vec![0; SeedBook::<f64, G11x8>::entries(false)],
            values: Vec::new(),
            rhs: Vec::new(),
        };
        let (single, double) = (Vec::new(), Vec::new());
        Self { scene, set, kkt: Vec::new(), factor: Box::new(Factor::ZERO), single, double }
    }

    fn keep(&mut self, table: &mut Table) -> Result<(), String> {
        let set = &mut self.set;
        let (values, rhs) = (set.values.len(), set.rhs.len());
        set.values.resize(values + set.rows.len(), 0.0);
        set.rhs.resize(rhs + set.n, 0.0);
        // Eq. 3 as it stands: without rows that hold the spine.
        table.seed.settings_mut().lock_spine = false;
        let told = table.seed.export(
            &mut set.starts,
            &mut set.rows,
            &mut set.values[values..],
            &mut set.rhs[rhs..],
        );
        table.seed.settings_mut().lock_spine = true;
        if told != Some(set.rows.len()) {
            return Err(format!("the seed's form exports {told:?} entries"));
        }
        self.kkt.push(Box::new(table.seed.solver().matrix().clone()));
        self.single.push(table.single.clone());
        self.double.push(table.double.clone());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{POSES, corner_turn};

    #[test]
    fn the_turn_goes_over_the_spine_and_its_matrices_are_symmetric() {
        let turn = corner_turn().expect("a sound scene");
        let set = &turn.set;
        assert_eq!(set.count(), POSES, "{set:?}");
        let across = |n: usize| turn.double[n].leaf().map(|l| l.x.at(10, 4).0[0]);
        let (first, last) = (across(0), across(POSES - 1));
        assert!(first > Some(5.0) && last < Some(-5.0), "{first:?} {last:?}");
        let values = &set.values[(POSES / 2) * set.entries()..][..set.entries()];
        let at = |row: i32, col: usize| {
            let range = set.starts[col] as usize..set.starts[col + 1] as usize;
            let found = set.rows[range.clone()].binary_search(&row).expect("a place");
            values[range.start + found]
        };
        for col in 0..set.n {
            for place in set.starts[col]..set.starts[col + 1] {
                let row = set.rows[place as usize];
                assert_eq!(at(row, col), at(col as i32, row as usize), "({row}, {col})");
            }
        }
    }
}
