//! `eink`: the firmware that reads a built-in book, on every emulated board: its pictures are the host's to the bit, nothing is
//! drawn at rest, memory and instructions stay within their bounds.

use crate::boards::{M0, M4F, M7, Processor};
use crate::shell::{cargo, run};
use crate::size::{Figures, Image};
use crate::tally::Tally;
use crate::words::{Result, Stop, flag};

/// The lines of the session, made by the host's test.
const GOLDEN: &str = "fixtures/golden/eink.txt";
/// Pages that are built in: the book, the first one (counted from 0), how many, and the file.
const PAGES: [&str; 4] =
    ["fixtures/books/old-verses.pdf", "13", "4", "fixtures/books/old-verses.dlp"];

/// A processor, and what it may take: thousands of instructions of the dearest key frame's pixels, and bytes of stack.
/// What we have, with a fiftieth for another compiler.
const BOUNDS: [(Processor, u64, u64); 3] =
    [(M7, 127_000, 5_220), (M4F, 124_000, 5_520), (M0, 225_000, 6_900)];
/// Core, bands and stack together, bytes: the goal.
const RAM: u64 = 160 * 1024;
/// Instructions in ten seconds of rest, of a processor that does a thousand million and more in that time.
const REST: u64 = 1_000_000;

/// Parts of the memory, as the firmware names them.
const MEMORY: [&str; 8] = [
    "book and its solver",
    "band of pixels",
    "leaf as it is seen",
    "key frames that wait",
    "core and bands",
    "stack high water",
    "simulated panel",
    "built-in pages",
];

/// What one board did.
struct Session {
    processor: Processor,
    pictures: Vec<String>,
    /// Thousands of instructions of physics and of pixels, a picture each.
    costs: Vec<[u64; 2]>,
    figures: Figures,
    /// Functions that only a panic or an allocator needs.
    forbidden: Vec<String>,
    well: bool,
}

/// `cargo ci eink [--bless]`.
pub(crate) fn eink(args: &[String]) -> Result {
    let bless = flag(args, "--bless")?;
    for (processor, ..) in BOUNDS {
        processor.ready().map_err(Stop::Skipped)?;
    }
    if bless {
        renew()?;
    }
    let golden = std::fs::read_to_string(GOLDEN).map_err(|e| format!("{GOLDEN}: {e}"))?;
    let golden: Vec<&str> = golden.lines().collect();
    let mut faults = Vec::new();
    let mut sessions = Vec::new();
    for (processor, pixels, stack) in BOUNDS {
        let session = Session::play(processor)?;
        faults.extend(session.faults(&golden, pixels, stack)?);
        sessions.push(session);
    }
    costs(&golden, &sessions);
    memory(&sessions)?;
    faults.iter().for_each(|fault| eprintln!("  {fault}"));
    if faults.is_empty() {
        Ok(Tally { passed: sessions.len() as u64, ..Tally::default() })
    } else {
        Err(format!("{} promises of the reading firmware do not hold", faults.len()).into())
    }
}

/// Prints the built-in pages, then plays the session on the host: its lines become golden. That they are today's is a
/// test of the reader's, run with all others.
fn renew() -> std::result::Result<(), String> {
    let package = ["--profile", "swift", "-p", "dogleaf-eink-reader"];
    run(cargo(["run"]).args(package).args(["--example", "print", "--"]).args(PAGES))?;
    run(cargo(["test"]).args(package).args(["--test", "golden"]).env("DOGLEAF_BLESS", "1"))
}

impl Session {
    fn play(processor: Processor) -> std::result::Result<Self, String> {
        let image = processor.build("read", "reader")?;
        let (well, said) = processor.run(&image)?;
        let looked = Image::read(&image)?;
        let forbidden = [looked.panics, looked.allocators].concat();
        let after = |key: &str| -> Vec<String> {
            said.lines().filter_map(|l| l.strip_prefix(key)).map(str::to_owned).collect()
        };
        let costs = after("cost ").iter().filter_map(|l| pair(l)).collect();
        let (pictures, figures) = (after("picture "), Figures::read(&said));
        Ok(Self { processor, pictures, costs, figures, forbidden, well })
    }

    /// What does not hold.
    fn faults(
        &self,
        golden: &[&str],
        pixels: u64,
        stack: u64,
    ) -> std::result::Result<Vec<String>, String> {
        let get = |name| self.figures.get(name);
        let ram = get("core and bands")? + get("stack high water")?;
        let dearest = self.costs.iter().map(|c| c[1]).max().unwrap_or(u64::MAX);
        let mut faults = Vec::new();
        let mut hold = |holds: bool, why: String| {
            if !holds {
                faults.push(format!("{}: {why}", self.processor.name));
            }
        };
        hold(self.well, "the session ended badly".into());
        hold(self.forbidden.is_empty(), format!("in the image: {}", self.forbidden.join(", ")));
        let first = self.pictures.iter().map(String::as_str).zip(golden).position(|(a, b)| a != *b);
        hold(
            self.pictures.len() == golden.len() && first.is_none(),
            format!(
                "picture {} is not the host's",
                first.unwrap_or(self.pictures.len().min(golden.len()))
            ),
        );
        hold(get("redraws at rest")? == 0, "something is drawn at rest".into());
        hold(get("instructions at rest")? <= REST, "it does not sleep at rest".into());
        hold(ram <= RAM, format!("core, bands and stack take {ram} bytes, more than {RAM}"));
        hold(get("stack high water")? <= stack, format!("more than {stack} bytes of stack"));
        hold(
            dearest <= pixels,
            format!("{dearest} thousand instructions for a picture, more than {pixels}"),
        );
        Ok(faults)
    }
}

fn pair(line: &str) -> Option<[u64; 2]> {
    let (a, b) = line.split_once(' ')?;
    Some([a.trim().parse().ok()?, b.trim().parse().ok()?])
}

/// Every picture with what it cost on each board.
fn costs(golden: &[&str], sessions: &[Session]) {
    let names: Vec<&str> = sessions.iter().map(|s| s.processor.name).collect();
    println!("thousands of instructions, physics + pixels");
    println!("| picture | {} |\n|---|{}", names.join(" | "), "---|".repeat(names.len()));
    for (n, line) in golden.iter().enumerate() {
        let cost =
            |s: &Session| s.costs.get(n).map_or_else(|| "-".into(), |[p, r]| format!("{p} + {r}"));
        let cells: Vec<String> = sessions.iter().map(cost).collect();
        println!("| `{}` | {} |", line.trim(), cells.join(" | "));
    }
}

/// Whose the memory is, and what rest costs.
fn memory(sessions: &[Session]) -> std::result::Result<(), String> {
    let names: Vec<&str> = sessions.iter().map(|s| s.processor.name).collect();
    println!("| | {} |\n|---|{}", names.join(" | "), "---|".repeat(names.len()));
    for what in MEMORY.into_iter().chain(["redraws at rest", "instructions at rest"]) {
        let of = |s: &Session| s.figures.get(what).map(|n| n.to_string());
        let cells: std::result::Result<Vec<String>, String> = sessions.iter().map(of).collect();
        println!("| {what} | {} |", cells?.join(" | "));
    }
    Ok(())
}

#[cfg(test)]
mod check {
    use super::{BOUNDS, Session, pair};
    use crate::size::Figures;

    const FIGURES: &str = "core and bands 152264\nstack high water 5120\nredraws at rest 0\ninstructions at rest 67883\n";

    fn session(said: &str, pictures: &[&str]) -> Session {
        Session {
            processor: BOUNDS[0].0,
            pictures: pictures.iter().map(ToString::to_string).collect(),
            costs: vec![[0, 10]],
            figures: Figures::read(said),
            forbidden: Vec::new(),
            well: true,
        }
    }

    fn count(said: &str, pictures: &[&str]) -> usize {
        let faults = session(said, pictures).faults(&["a", "b"], 10, 5_120);
        faults.expect("every figure is there").len()
    }

    #[test]
    fn a_good_session_has_no_fault() {
        assert_eq!(count(FIGURES, &["a", "b"]), 0);
    }

    #[test]
    fn every_fault_is_found() {
        assert_eq!(count(FIGURES, &["a", "c"]), 1, "another picture");
        assert_eq!(count(FIGURES, &["a"]), 1, "one is missing");
        assert_eq!(count(FIGURES, &["a", "b", "c"]), 1, "one too many");
        assert_eq!(count(&FIGURES.replace("rest 0", "rest 1"), &["a", "b"]), 1, "drawn at rest");
        assert_eq!(count(&FIGURES.replace("67883", "2000000"), &["a", "b"]), 1, "awake at rest");
        assert_eq!(count(&FIGURES.replace("152264", "160000"), &["a", "b"]), 1, "memory");
        assert_eq!(count(&FIGURES.replace("5120", "5121"), &["a", "b"]), 1, "stack");
        let dear = Session { costs: vec![[0, 11]], ..session(FIGURES, &["a", "b"]) };
        assert_eq!(dear.faults(&["a", "b"], 10, 5_120).expect("figures").len(), 1, "pixels");
        let panics = Session { forbidden: vec!["f".into()], ..session(FIGURES, &["a", "b"]) };
        assert_eq!(panics.faults(&["a", "b"], 10, 5_120).expect("figures").len(), 1, "a panic");
        assert!(session("", &[]).faults(&[], 10, 10).is_err(), "a session that said nothing");
    }

    #[test]
    fn costs_are_pairs() {
        assert_eq!(pair("12 345"), Some([12, 345]));
        assert_eq!(pair("12"), None);
    }
}
