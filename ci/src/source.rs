//! Rust source without what is not code: comments, strings and tests become blanks, lines stay lines.

/// Blanks comments, string and character literals, and items under `#[cfg(test)]`.
pub(crate) fn code_only(text: &str) -> String {
    blank_tests(blank_literals(text))
}

fn blank_literals(text: &str) -> Vec<char> {
    let mut rest: Vec<char> = text.chars().collect();
    let mut at = 0;
    while at < rest.len() {
        let before = at.checked_sub(1).map(|i| rest[i]);
        let end = at + literal(&rest[at..], before);
        for c in rest.iter_mut().take(end).skip(at).filter(|c| **c != '\n') {
            *c = ' ';
        }
        at = end.max(at + 1);
    }
    rest
}

/// The length of the comment or literal that starts here; 0 if none does.
fn literal(s: &[char], before: Option<char>) -> usize {
    let in_word = before.is_some_and(|c| c.is_alphanumeric() || c == '_');
    match s {
        ['/', '/', ..] => until(s, 2, |rest| rest.first() == Some(&'\n')),
        ['/', '*', ..] => nested(s),
        ['"', ..] => quoted(s, '"'),
        ['r', '"' | '#', ..] if !in_word => raw(s),
        ['\'', '\\', ..] => quoted(s, '\''),
        // A lifetime has no closing quote after one character.
        ['\'', _, '\'', ..] => 3,
        _ => 0,
    }
}

fn until(s: &[char], from: usize, end: impl Fn(&[char]) -> bool) -> usize {
    (from..s.len()).find(|&i| end(&s[i..])).unwrap_or(s.len())
}

fn nested(s: &[char]) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < s.len() {
        match s[at..] {
            ['/', '*', ..] => (depth, at) = (depth + 1, at + 2),
            ['*', '/', ..] => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            break;
        }
    }
    at
}

fn quoted(s: &[char], close: char) -> usize {
    let mut at = 1;
    while at < s.len() && s[at] != close {
        at += if s[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(s.len())
}

fn raw(s: &[char]) -> usize {
    let hashes = s[1..].iter().take_while(|c| **c == '#').count();
    if s.get(1 + hashes) != Some(&'"') {
        return 0; // r#name
    }
    let closes = |rest: &[char]| {
        rest[0] == '"' && rest[1..].iter().take_while(|c| **c == '#').count() >= hashes
    };
    (until(s, 2 + hashes, closes) + 1 + hashes).min(s.len())
}

const TEST: &str = "#[cfg(test)]";

fn blank_tests(mut code: Vec<char>) -> String {
    let mark: Vec<char> = TEST.chars().collect();
    let mut at = 0;
    while at + mark.len() <= code.len() {
        if code[at..].starts_with(&mark) {
            let end = at + item(&code[at + mark.len()..]) + mark.len();
            for c in code.iter_mut().take(end).skip(at).filter(|c| **c != '\n') {
                *c = ' ';
            }
            at = end;
        } else {
            at += 1;
        }
    }
    code.into_iter().collect()
}

/// The length of the item that starts here: to its `;`, or to the end of its braces.
fn item(s: &[char]) -> usize {
    let mut depth = 0_usize;
    for (i, c) in s.iter().enumerate() {
        match c {
            ';' if depth == 0 => return i + 1,
            '{' => depth += 1,
            '}' if depth <= 1 => return i + 1,
            '}' => depth -= 1,
            _ => {}
        }
    }
    s.len()
}

#[cfg(test)]
mod check {
    use super::code_only;

    #[test]
    fn comments_and_strings_go_code_and_lines_stay() {
        let text = "let a = \"x.unwrap()\"; // y.unwrap()\n/* z /* w */ v */ b.c();\nlet r = r#\"p\"q\"#; d();\n";
        let code = code_only(text);
        assert_eq!(code.lines().count(), text.lines().count());
        assert!(!code.contains("unwrap") && !code.contains('v') && !code.contains('q'), "{code}");
        assert!(code.contains("b.c();") && code.contains("d();"), "{code}");
    }

    #[test]
    fn lifetimes_are_not_characters() {
        let code = code_only("fn f<'a>(x: &'a str) { let q = '\"'; let n = '\\''; g(x) } // end");
        assert!(code.contains("g(x)") && code.contains("&'a str"), "{code}");
    }

    #[test]
    fn tests_go_what_follows_stays() {
        let code = code_only(
            "a();\n#[cfg(test)]\nmod t {\n fn x() { y.unwrap() }\n}\n#[cfg(test)]\nmod u;\nb();\n",
        );
        assert!(code.contains("a();") && code.contains("b();"), "{code}");
        assert!(!code.contains("unwrap") && !code.contains('u'), "{code}");
    }
}
