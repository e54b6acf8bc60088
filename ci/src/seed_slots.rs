//! `cargo ci slots`, second table: writes `core/src/seed/slots.rs`, the order in which the seed's full KKT
//! matrix is factored, by AMD, and the sizes that follow from it.
//!
//! Numbering and couplings are those of `core/src/seed/number.rs` and `core/src/seed/assemble.rs`; a test in
//! `tests/seed_agrees.rs` builds the matrix from both and compares the counts.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

/// Grids the oracle exists for: nodes across and along.
const GRIDS: [(usize, usize); 5] = [(6, 5), (8, 6), (11, 8), (12, 9), (16, 12)];
/// Nodes of a block, the innermost being an end of the binding.
const BLOCK: usize = 7;
const FILE: &str = "core/src/seed/slots.rs";

/// A node's first unknown and how many it has.
type Node = (usize, usize);

/// The seed's unknowns and multipliers on one grid, and which meet.
struct System {
    nx: usize,
    nz: usize,
    /// Columns of the upper triangle: the rows that each one touches, diagonal included.
    columns: Vec<BTreeSet<usize>>,
}

impl System {
    fn new(nx: usize, nz: usize, curved: bool) -> Self {
        let n = multipliers(nx, nz) + 3 * (nx - 2) * (nz - 2) + 2 * (BLOCK - 1) + 3 + 2 * nz + 4;
        let mut system = Self { nx, nz, columns: (0..n).map(|i| BTreeSet::from([i])).collect() };
        system.leaf();
        system.midline(curved);
        system.stars(curved);
        system
    }

    fn node(&self, i: usize, k: usize) -> Node {
        match i {
            0 => (2 * k, 2),
            _ => (2 * self.nz + 3 * ((i - 1) * self.nz + k), 3),
        }
    }
    /// Node `j` of a block, from the binding outwards.
    fn block(&self, side: usize, j: usize) -> Node {
        (leaf_unknowns(self.nx, self.nz) + 2 * (BLOCK * side + j), 2)
    }
    fn centre(&self) -> Node {
        (leaf_unknowns(self.nx, self.nz) + 4 * BLOCK, 2)
    }
    fn board(&self, side: usize) -> Node {
        (leaf_unknowns(self.nx, self.nz) + 4 * BLOCK + 2 + 2 * side, 2)
    }

    fn meet(&mut self, a: usize, b: usize) {
        if let Some(column) = self.columns.get_mut(a.max(b)) {
            column.insert(a.min(b));
        }
    }
    /// Every coordinate of every node meets every other.
    fn full(&mut self, nodes: &[Node]) {
        let all: Vec<usize> = nodes.iter().flat_map(|&(at, dims)| at..at + dims).collect();
        for &a in &all {
            all.iter().for_each(|&b| self.meet(a, b));
        }
    }
    /// X meets X, Y meets Y, Z meets Z.
    fn alike(&mut self, nodes: &[Node]) {
        for &(a, na) in nodes {
            for &(b, nb) in nodes {
                (0..na.min(nb)).for_each(|c| self.meet(a + c, b + c));
            }
        }
    }
    /// A row of C names nodes.
    fn row(&mut self, row: usize, nodes: &[Node]) {
        for &(at, dims) in nodes {
            (at..at + dims).for_each(|a| self.meet(row, a));
        }
    }

    /// Bending, twist and isometry.
    fn leaf(&mut self) {
        let (nx, nz) = (self.nx, self.nz);
        for i in 0..nx {
            for k in 0..nz {
                let at = |i, k| self.node(i, k);
                let (mut bent, mut edges, mut cell) = (vec![at(i, k)], vec![], vec![]);
                if i > 0 && i + 1 < nx {
                    bent.extend([at(i + 1, k), at(i - 1, k)]);
                }
                if i > 0 && k > 0 && k + 1 < nz {
                    bent.extend([at(i, k + 1), at(i, k - 1)]);
                }
                if i + 1 < nx {
                    edges.push([at(i, k), at(i + 1, k)]);
                }
                if i > 0 && k + 1 < nz {
                    edges.push([at(i, k), at(i, k + 1)]);
                }
                if i + 1 < nx && k + 1 < nz {
                    cell = vec![at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)];
                }
                self.alike(&bent);
                self.alike(&cell);
                edges.iter().for_each(|e| self.full(e));
            }
        }
    }

    /// Three rows a star, each by three arms and the centre.
    fn stars(&mut self, curved: bool) {
        let mut row = multipliers(self.nx, self.nz);
        for i in 1..self.nx - 1 {
            for k in 1..self.nz - 1 {
                let arms = [(i + 1, k), (i, k + 1), (i - 1, k), (i, k - 1)];
                let [f, h, s, t] = arms.map(|(i, k)| self.node(i, k));
                let centre = self.node(i, k);
                for named in [[f, h, s], [h, s, t], [s, t, f]] {
                    let [a, b, c] = named;
                    self.row(row, &[a, b, c, centre]);
                    row += 1;
                }
                if curved {
                    self.full(&[f, h, s, t, centre]);
                }
            }
        }
    }

    /// Blocks, binding and boards: bending, glue, lengths, binding and fix.
    fn midline(&mut self, curved: bool) {
        let [b1, b2] = [self.block(0, 0), self.block(1, 0)];
        let mut row = multipliers(self.nx, self.nz) + 3 * (self.nx - 2) * (self.nz - 2);
        let mut lengths = Vec::new();
        for side in 0..2 {
            for j in 1..BLOCK - 1 {
                let three = [j - 1, j, j + 1].map(|j| self.block(side, j));
                self.alike(&three);
            }
            self.full(&[self.block(side, 1), b1, b2]);
            lengths.extend((1..BLOCK).map(|j| [self.block(side, j - 1), self.block(side, j)]));
        }
        lengths.push([b1, b2]);
        lengths.extend((0..2).map(|side| [self.block(side, 0), self.board(side)]));
        for edge in lengths {
            self.row(row, &edge);
            if curved {
                self.alike(&edge);
            }
            row += 1;
        }
        let bound: Vec<Node> =
            (0..self.nz).map(|k| self.node(0, k)).chain([self.centre()]).collect();
        for node in bound {
            for c in 0..2 {
                self.row(row, &[(node.0 + c, 1), (b1.0 + c, 1), (b2.0 + c, 1)]);
                row += 1;
            }
        }
        for c in 0..2 {
            self.row(row, &[(b1.0 + c, 1), (b2.0 + c, 1)]);
            row += 1;
        }
    }

    fn entries(&self) -> usize {
        self.columns.iter().map(BTreeSet::len).sum()
    }

    /// AMD on both triangles.
    fn order(&self) -> Result<Vec<usize>, String> {
        let n = self.columns.len();
        let mut both = self.columns.clone();
        for (c, rows) in self.columns.iter().enumerate() {
            for &r in rows {
                both[r].insert(c);
            }
        }
        let mut starts = vec![0];
        let mut rows = Vec::new();
        for column in &both {
            rows.extend(column.iter().map(|&r| r as i64));
            starts.push(rows.len() as i64);
        }
        let (order, _, _) = amd::order(n as i64, &starts, &rows, &amd::Control::default())
            .map_err(|status| format!("amd: {status:?}"))?;
        Ok(order.into_iter().map(|i| i as usize).collect())
    }

    /// Entries of `L` below the diagonal when eliminated in this order.
    fn fill(&self, order: &[usize]) -> usize {
        let n = order.len();
        let mut place = vec![0; n];
        order.iter().enumerate().for_each(|(at, &i)| place[i] = at);
        let mut upper = vec![BTreeSet::new(); n];
        for (c, rows) in self.columns.iter().enumerate() {
            for &r in rows.iter().filter(|&&r| r != c) {
                let (a, b) = (place[r], place[c]);
                upper[a.min(b)].insert(a.max(b));
            }
        }
        let mut count = 0;
        for k in 0..n {
            let below: Vec<usize> = upper[k].iter().copied().collect();
            count += below.len();
            if let Some((&parent, rest)) = below.split_first() {
                upper[parent].extend(rest);
            }
        }
        count
    }
}

fn leaf_unknowns(nx: usize, nz: usize) -> usize {
    3 * nx * nz - nz
}

/// Where the multipliers begin: after leaf, two blocks, centre and two boards.
fn multipliers(nx: usize, nz: usize) -> usize {
    leaf_unknowns(nx, nz) + 4 * BLOCK + 2 + 4
}

fn grid(out: &mut String, nx: usize, nz: usize) -> Result<(), String> {
    let systems = [System::new(nx, nz, false), System::new(nx, nz, true)];
    let [plain, curved] = &systems;
    let n = plain.columns.len();
    let order = plain.order()?;
    let entries = [plain.entries(), curved.entries()];
    let fill = [plain.fill(&order), curved.fill(&order)];
    let most = |pair: [usize; 2]| pair[0].max(pair[1]);
    let _ = writeln!(out, "\nimpl SeedGrid for G{nx}x{nz} {{");
    let _ = writeln!(out, "    const N: usize = {n};");
    let _ = writeln!(out, "    const ENTRIES: [usize; 2] = {entries:?};");
    let _ = writeln!(out, "    const FILL: [usize; 2] = {fill:?};");
    let _ = writeln!(out, "    const ORDER: &'static [u16] = &[");
    for line in order.chunks(20) {
        let numbers: Vec<String> = line.iter().map(ToString::to_string).collect();
        let _ = writeln!(out, "        {},", numbers.join(", "));
    }
    let _ = writeln!(out, "    ];");
    for (name, len) in
        [("Numbers", n), ("Starts", n + 1), ("Entries", most(entries)), ("Fill", most(fill))]
    {
        let _ = writeln!(out, "    type {name}<T: Cell> = [T; {len}];");
    }
    let _ = writeln!(out, "}}");
    Ok(())
}

fn generate() -> Result<String, String> {
    let mut out = String::from(
        "//! GENERATED by `cargo ci slots`; do not edit. Elimination orders and sizes of the seed's full KKT matrix.\n\n\
         use super::grid::{Cell, SeedGrid};\nuse crate::grid::{",
    );
    let names: Vec<String> = GRIDS.iter().map(|(nx, nz)| format!("G{nx}x{nz}")).collect();
    let _ = writeln!(out, "{}}};", names.join(", "));
    for (nx, nz) in GRIDS {
        grid(&mut out, nx, nz)?;
    }
    Ok(out)
}

/// Writes the table, or with `check` compares it with the committed one.
///
/// # Errors
///
/// The file cannot be read or written, or differs from what would be generated.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let want = generate()?;
    let path = Path::new(FILE);
    if !check {
        return std::fs::write(path, want).map_err(|e| format!("{FILE}: {e}"));
    }
    let have = std::fs::read_to_string(path).map_err(|e| format!("{FILE}: {e}"))?;
    if have == want { Ok(()) } else { Err(format!("{FILE} is stale: run `cargo ci slots`")) }
}
