//! Whether what the shell asks of the bindings exists there.
//!
//! Not a type check: a value is known by its name. Whatever is called `book` is taken for a `Book`, `frame` for a
//! `FrameInfo`, and so on; the cases of a `switch` over such a value must all be there, each of them once.

use std::collections::BTreeSet;
use std::path::PathBuf;

use tree_sitter::Node;

use super::names::{Names, said};
use super::syntax::{read, tree, walk};

const GENERATED: &str = "shells/ios/Sources/Dogleaf/Generated.swift";

/// Names of values, and the types they have wherever they occur.
const VALUES: [(&str, &str); 17] = [
    ("book", "Book"),
    ("Book", "Book"),
    ("frame", "FrameInfo"),
    ("stage", "Stage"),
    ("piece", "Piece"),
    ("sample", "PointerSample"),
    ("PointerSample", "PointerSample"),
    ("options", "BookOptions"),
    ("motion", "Motion"),
    ("Motion", "Motion"),
    ("meshView", "MeshView"),
    ("indexView", "IndexView"),
    ("notice", "Notice"),
    ("tick", "Tick"),
    ("face", "PieceFace"),
    ("surface", "Surface"),
    ("DogleafError", "DogleafError"),
];

/// Looks every use up; how many there are. The same sources with one wrong name in them must be refused.
pub(crate) fn check(files: &[PathBuf]) -> Result<usize, String> {
    let mut names = Names::default();
    names.add(&read(GENERATED.as_ref())?)?;
    for file in files {
        names.add(&read(file)?)?;
    }
    let (mut count, mut step, mut wrong) = (0, 0, Vec::new());
    for file in files {
        let text = read(file)?;
        let uses = uses(&text)?;
        count += uses.len();
        let found = faults(&uses, &names);
        wrong.extend(found.into_iter().map(|f| format!("{}:{f}", file.display())));
        let planted = text.replace("book.step(nowUs:", "book.step(now:");
        if planted != text {
            step += 1;
            if faults(&self::uses(&planted)?, &names).is_empty() {
                return Err(format!("{}: a planted wrong label was not found", file.display()));
            }
        }
    }
    if step == 0 {
        wrong.push("nothing steps a book: no control".to_owned());
    }
    if wrong.is_empty() { Ok(count) } else { Err(wrong.join("\n")) }
}

/// One use of a member of the bindings' types.
#[derive(Debug, PartialEq, Eq)]
enum Use {
    Member {
        line: usize,
        owner: &'static str,
        name: String,
    },
    /// The cases of a `switch`; `open` if it has a default.
    Switch {
        line: usize,
        owner: &'static str,
        cases: BTreeSet<String>,
        open: bool,
    },
}

fn faults(uses: &[Use], names: &Names) -> Vec<String> {
    uses.iter().filter_map(|u| fault(u, names)).collect()
}

fn fault(one: &Use, names: &Names) -> Option<String> {
    match one {
        Use::Member { line, owner, name } => {
            (!names.has(owner, name)).then(|| format!("{line}: {owner} has no {name}"))
        }
        Use::Switch { line, owner, cases, open } => {
            let there = names.0.get(*owner)?;
            let wrong = cases.iter().find(|c| !there.contains(*c));
            let missed = there.iter().find(|c| {
                !open && !c.contains('(') && !cases.contains(*c) && *c != "errorDescription"
            });
            let wrong = wrong.map(|c| format!("{line}: {owner} has no case {c}"));
            wrong.or_else(|| {
                missed.map(|c| format!("{line}: the case {c} of {owner} is not handled"))
            })
        }
    }
}

fn uses(text: &str) -> Result<Vec<Use>, String> {
    let tree = tree(text)?;
    let mut found = Vec::new();
    walk(tree.root_node(), &mut |node| {
        found.extend(match node.kind() {
            "navigation_expression" => navigation(node, text),
            "call_expression" => construction(node, text),
            "switch_statement" => switch(node, text),
            _ => None,
        });
    });
    Ok(found)
}

fn owner(of: Node<'_>, text: &str) -> Option<&'static str> {
    let whole = text.get(of.byte_range())?;
    let last = whole.rsplit('.').next()?.trim_end_matches(['?', '!', ' ']);
    VALUES.iter().find(|(value, _)| *value == last).map(|(_, owner)| *owner)
}

/// `book.step(nowUs: now)`, `frame.draw`, `Book.open(options: options)`.
fn navigation(node: Node<'_>, text: &str) -> Option<Use> {
    let owner = owner(node.child_by_field_name("target")?, text)?;
    let suffix = said(node, "suffix", text)?.trim_start_matches('.').trim();
    let call = node.parent().filter(|p| p.kind() == "call_expression");
    let name = match call.and_then(|c| labels(c, text)) {
        Some(labels) if owner != "DogleafError" => format!("{suffix}({labels})"),
        _ => suffix.to_owned(),
    };
    if ["self", "init", "Type"].contains(&suffix) {
        return None;
    }
    Some(Use::Member { line: node.start_position().row + 1, owner, name })
}

/// `PointerSample(timeUs: ..)`.
fn construction(node: Node<'_>, text: &str) -> Option<Use> {
    let name = text.get(node.child(0)?.byte_range())?;
    let owner = VALUES.iter().find(|(v, owner)| *v == name && v == owner)?.1;
    let name = format!("init({})", labels(node, text)?);
    Some(Use::Member { line: node.start_position().row + 1, owner, name })
}

fn labels(call: Node<'_>, text: &str) -> Option<String> {
    let mut cursor = call.walk();
    let suffix = call.children(&mut cursor).find(|c| c.kind() == "call_suffix")?;
    let mut cursor = suffix.walk();
    let arguments = suffix.children(&mut cursor).find(|c| c.kind() == "value_arguments")?;
    // `a[0]` is no call.
    arguments.child(0).filter(|c| c.kind() == "(")?;
    let mut cursor = arguments.walk();
    let one = arguments.children(&mut cursor).filter(|c| c.kind() == "value_argument");
    Some(one.map(|a| format!("{}:", said(a, "name", text).unwrap_or("_"))).collect())
}

fn switch(node: Node<'_>, text: &str) -> Option<Use> {
    let owner = owner(node.child_by_field_name("expr")?, text)?;
    let (mut cases, mut open) = (BTreeSet::new(), false);
    let mut cursor = node.walk();
    for entry in node.children(&mut cursor).filter(|c| c.kind() == "switch_entry") {
        let mut cursor = entry.walk();
        for part in entry.children(&mut cursor) {
            let said = text.get(part.byte_range()).unwrap_or_default();
            match part.kind() {
                "default_keyword" => open = true,
                "switch_pattern" => {
                    let plain = said.trim_start_matches("let ").trim_start_matches('.');
                    let end = plain.find(|c: char| !c.is_alphanumeric()).unwrap_or(plain.len());
                    cases.insert(plain[..end].to_owned());
                }
                _ => {}
            }
        }
    }
    Some(Use::Switch { line: node.start_position().row + 1, owner, cases, open })
}

#[cfg(test)]
mod check {
    use super::{faults, uses};
    use crate::swift::names::Names;

    const BINDINGS: &str = "open class Book { open func step(nowUs: UInt64) {}\n open func page() {} }\n\
        struct FrameInfo { var draw: Bool }\nenum Notice { case asleep\n case committed(page: UInt32) }\n";

    fn said(text: &str) -> Vec<String> {
        let mut names = Names::default();
        assert_eq!(names.add(BINDINGS), Ok(()));
        faults(&uses(text).unwrap_or_default(), &names)
    }

    #[test]
    fn what_is_there_passes_and_is_seen() {
        let text =
            "func f() { let frame = try self.book.step(nowUs: 1); if frame.draw { book?.page() } }";
        assert_eq!(uses(text).map(|u| u.len()), Ok(3));
        assert_eq!(said(text), Vec::<String>::new());
    }

    #[test]
    fn wrong_names_labels_and_fields_are_found() {
        assert_eq!(said("func f() { book.stop() }"), ["1: Book has no stop()"]);
        assert_eq!(said("func f() { book.step(now: 1) }"), ["1: Book has no step(now:)"]);
        assert_eq!(said("func f() { if frame.drawn { } }"), ["1: FrameInfo has no drawn"]);
    }

    #[test]
    fn a_switch_handles_every_case() {
        let text =
            |case: &str| format!("func f() {{ switch notice {{ case .asleep: a()\n {case} }} }}");
        assert_eq!(said(&text("case .committed(let page): b(page)")), Vec::<String>::new());
        assert_eq!(said(&text("default: b()")), Vec::<String>::new());
        assert_eq!(said(&text("")), ["1: the case committed of Notice is not handled"]);
        assert_eq!(said(&text("case .done: b()\n default: c()")), ["1: Notice has no case done"]);
    }
}
