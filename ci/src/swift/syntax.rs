//! Swift is parsed by tree-sitter's grammar: no compiler, but what it cannot read, Swift cannot either.

use std::path::{Path, PathBuf};

use tree_sitter::{Node, Parser, Tree};

/// Parses every file without a node of error; how many. A planted error in each must be found.
pub(crate) fn check(files: &[PathBuf]) -> Result<usize, String> {
    let mut faults = Vec::new();
    for path in files {
        let text = read(path)?;
        if let Some(line) = fault(&text)? {
            faults.push(format!("{}:{line}: not Swift", path.display()));
            continue;
        }
        let planted = format!("{text}\nfunc planted( {{ let = }}\n");
        if fault(&planted)?.is_none() {
            return Err(format!("{}: a planted error was not found", path.display()));
        }
    }
    if files.is_empty() {
        faults.push("no Swift files".to_owned());
    }
    if faults.is_empty() { Ok(files.len()) } else { Err(faults.join("\n")) }
}

pub(crate) fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}

pub(crate) fn tree(text: &str) -> Result<Tree, String> {
    let mut parser = Parser::new();
    parser.set_language(&tree_sitter_swift::LANGUAGE.into()).map_err(|e| e.to_string())?;
    parser.parse(text, None).ok_or_else(|| "the parser gave up".to_owned())
}

/// Line of the first thing that is not Swift.
fn fault(text: &str) -> Result<Option<usize>, String> {
    let tree = tree(text)?;
    let mut first = None;
    walk(tree.root_node(), &mut |node| {
        if first.is_none() && (node.is_error() || node.is_missing()) {
            first = Some(node.start_position().row + 1);
        }
    });
    Ok(first)
}

/// Every node, from the outside inwards.
pub(crate) fn walk<'t>(node: Node<'t>, see: &mut impl FnMut(Node<'t>)) {
    see(node);
    let mut cursor = node.walk();
    for child in node.children(&mut cursor) {
        walk(child, see);
    }
}

#[cfg(test)]
mod check {
    use super::fault;

    #[test]
    fn errors_have_a_line() {
        assert_eq!(fault("let a = 1\n"), Ok(None));
        assert_eq!(fault("let a = 1\nfunc f( { }\n"), Ok(Some(2)));
    }
}
