//! What the generated bindings declare: types, and the names of their members.

use std::collections::{BTreeMap, BTreeSet};

use tree_sitter::Node;

use super::syntax::{tree, walk};

/// Types and their members: fields and cases by name, methods as Swift writes them, `step(nowUs:)`.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Names(pub(crate) BTreeMap<String, BTreeSet<String>>);

impl Names {
    /// Adds what a file declares, in types and in extensions.
    pub(crate) fn add(&mut self, text: &str) -> Result<(), String> {
        let tree = tree(text)?;
        walk(tree.root_node(), &mut |node| {
            if let Some((owner, names)) = member(node, text) {
                self.0.entry(owner).or_default().extend(names);
            }
        });
        Ok(())
    }

    pub(crate) fn has(&self, owner: &str, name: &str) -> bool {
        self.0.get(owner).is_some_and(|members| members.contains(name))
    }
}

/// The type and the names of what a node declares in it: a method may be called without what has a default.
fn member(node: Node<'_>, text: &str) -> Option<(String, Vec<String>)> {
    let kind = node.kind();
    let names = match kind {
        "function_declaration" | "protocol_function_declaration" | "init_declaration" => {
            let plain = if kind == "init_declaration" { "init" } else { said(node, "name", text)? };
            let plain = plain.trim_matches('`');
            [false, true].map(|all| format!("{plain}({})", labels(node, text, all))).to_vec()
        }
        "property_declaration" => {
            let plain = said(node, "name", text)?.split(':').next().unwrap_or_default();
            vec![plain.trim().to_owned()]
        }
        "enum_entry" => vec![said(node, "name", text)?.to_owned()],
        _ => return None,
    };
    let owner = node.parent()?.parent()?;
    let owner = (owner.kind() == "class_declaration").then(|| said(owner, "name", text))??;
    Some((owner.to_owned(), names))
}

fn labels(node: Node<'_>, text: &str, all: bool) -> String {
    let mut cursor = node.walk();
    let parameters = node.children(&mut cursor).filter(|c| c.kind() == "parameter");
    let wanted = parameters.filter(|p| all || p.next_sibling().is_none_or(|n| n.kind() != "="));
    let label = |p: Node<'_>| {
        let outer = said(p, "external_name", text).or_else(|| said(p, "name", text));
        format!("{}:", outer.unwrap_or("_"))
    };
    wanted.map(label).collect()
}

/// The text of a node's field.
pub(crate) fn said<'t>(node: Node<'_>, field: &str, text: &'t str) -> Option<&'t str> {
    text.get(node.child_by_field_name(field)?.byte_range())
}

#[cfg(test)]
mod check {
    use super::Names;

    #[test]
    fn members_of_classes_structs_and_enums() {
        let text = "open class Book { open func step(nowUs: UInt64) throws -> Frame { f() }\n\
            static func `open`(_ a: Int, at b: Int = 0) {} }\n\
            struct Frame { var draw: Bool\n init(draw: Bool) { self.draw = draw } }\n\
            enum Notice { case asleep\n case committed(page: UInt32) }\nextension Book { var more: Int { 1 } }\n";
        let mut names = Names::default();
        assert_eq!(names.add(text), Ok(()));
        for (owner, name) in [
            ("Book", "step(nowUs:)"),
            ("Book", "open(_:at:)"),
            ("Book", "open(_:)"),
            ("Book", "more"),
            ("Frame", "draw"),
            ("Frame", "init(draw:)"),
            ("Notice", "committed"),
        ] {
            assert!(names.has(owner, name), "{owner}.{name} in {names:?}");
        }
        assert!(!names.has("Book", "step(now:)"), "another label is another method");
    }
}
