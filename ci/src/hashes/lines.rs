//! Lines that a runner prints, and what it means that two lists of them differ.

/// The hash of one probe.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Line {
    /// `scene` or `operation`.
    pub(crate) kind: String,
    /// The numbers it ran on.
    pub(crate) tier: String,
    /// Which.
    pub(crate) name: String,
    /// Sixteen hexadecimal digits.
    pub(crate) hash: String,
}

/// Reads `kind tier name hash` lines; all others say nothing.
pub(crate) fn read(text: &str) -> Vec<Line> {
    text.lines().filter_map(line).collect()
}

fn line(text: &str) -> Option<Line> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let [kind, tier, name, hash] = words[..] else { return None };
    let known = ["scene", "operation"].contains(&kind) && hash.len() == 16;
    let of = str::to_owned;
    known.then(|| Line { kind: of(kind), tier: of(tier), name: of(name), hash: of(hash) })
}

/// As a file.
pub(crate) fn write(lines: &[Line]) -> String {
    lines.iter().map(|l| format!("{} {} {} {}\n", l.kind, l.tier, l.name, l.hash)).collect()
}

/// The first line of `golden`, in its order, that `found` lacks or has otherwise; operations stand first,
/// so it is the operation that differs, not the scene in which one sees it.
pub(crate) fn difference(golden: &[Line], found: &[Line], tiers: &[&str]) -> Option<String> {
    let wanted = golden.iter().filter(|l| tiers.contains(&l.tier.as_str()));
    let same = |a: &Line, b: &Line| (&a.kind, &a.tier, &a.name) == (&b.kind, &b.tier, &b.name);
    for want in wanted.clone() {
        let title = format!("{} {} {}", want.kind, want.tier, want.name);
        match found.iter().find(|f| same(want, f)) {
            None => return Some(format!("{title} did not run")),
            Some(f) if f.hash != want.hash => {
                return Some(format!("{title} is {}, golden {}", f.hash, want.hash));
            }
            Some(_) => {}
        }
    }
    let new = found.iter().find(|f| !golden.iter().any(|g| same(g, f)));
    new.map(|f| format!("{} {} {} is not in the golden file", f.kind, f.tier, f.name))
}

#[cfg(test)]
mod check {
    use super::{difference, read, write};

    const GOLDEN: &str = "operation f32 root 0000000000000001\nscene f32 turn 0000000000000002\noperation f64 root 0000000000000003\n";

    #[test]
    fn reads_what_it_writes_and_nothing_else() {
        let lines = read(GOLDEN);
        assert_eq!(write(&lines), GOLDEN);
        assert!(read("panicked\nscene f32 turn 12\n").is_empty(), "no such lines");
    }

    #[test]
    fn the_cause_is_named_before_the_scene() {
        let golden = read(GOLDEN);
        let broken = GOLDEN.replace("01\n", "09\n").replace("02\n", "08\n");
        let said = difference(&golden, &read(&broken), &["f32"]);
        assert!(said.is_some_and(|s| s.starts_with("operation f32 root")), "the operation first");
    }

    #[test]
    fn what_is_missing_or_new_differs() {
        let golden = read(GOLDEN);
        assert_eq!(difference(&golden, &golden, &["f32", "f64"]), None);
        assert_eq!(difference(&golden, &golden[..2], &["f32"]), None, "a board without f64");
        assert!(difference(&golden, &golden[..2], &["f32", "f64"]).is_some(), "f64 was promised");
        assert!(difference(&golden[..1], &golden[..2], &["f32"]).is_some(), "one is new");
    }
}
