//! The house rule: who may import whom, and what every file owes its reader.
//!
//! Works on paths and texts, so that a test can plant what must be caught.

use std::fs;
use std::io;
use std::path::Path;

/// Lines a hand-written file may have.
pub const LONGEST: usize = 400;
/// Where the core lies.
const CORE: &str = "core/src/";
/// How a file may say what it is for: a crate's root lends its README.
const HEADERS: [&str; 2] = ["//!", "#![doc = include_str!("];
/// The room whose members never know one another.
const EFFECTS: &str = "effect";

/// A file: its path from the root of the repository, and its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// With `/` between folders.
    pub path: String,
    /// What stands in it.
    pub text: String,
}

impl Source {
    /// A file that need not exist.
    pub fn new(path: &str, text: &str) -> Self {
        Self { path: path.into(), text: text.into() }
    }
    /// A generator wrote it.
    fn generated(&self) -> bool {
        self.text.starts_with("//! GENERATED")
    }
}

/// All Rust files below `folders` of the repository.
///
/// # Errors
///
/// A folder or file that cannot be read.
pub fn sources(root: &Path, folders: &[&str]) -> io::Result<Vec<Source>> {
    let mut found = Vec::new();
    folders.iter().try_for_each(|folder| gather(root, folder, &mut found))?;
    found.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(found)
}

fn gather(root: &Path, folder: &str, found: &mut Vec<Source>) -> io::Result<()> {
    for entry in fs::read_dir(root.join(folder))? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{folder}/{name}");
        if entry.file_type()?.is_dir() {
            if name != "target" && !name.starts_with('.') {
                gather(root, &path, found)?;
            }
        } else if name.ends_with(".rs") {
            found.push(Source { text: fs::read_to_string(root.join(&path))?, path });
        }
    }
    Ok(())
}

/// The rooms of the core in data-flow order, and what its root lends from them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rooms {
    names: Vec<String>,
    /// A name at the root and the room it comes from.
    lent: Vec<(String, String)>,
}

impl Rooms {
    /// As `lib.rs` lists them.
    pub fn of(lib: &str) -> Self {
        let mut rooms = Self { names: Vec::new(), lent: Vec::new() };
        for line in lib.lines().map(str::trim) {
            let room =
                ["pub mod ", "pub(crate) mod ", "mod "].iter().find_map(|m| line.strip_prefix(m));
            if let Some(name) = room {
                rooms.names.push(name.trim_end_matches(';').into());
            } else if let Some((room, names)) =
                line.strip_prefix("pub use ").and_then(|use_| use_.split_once("::"))
            {
                let lent = words(names).map(|name| (name.to_owned(), room.to_owned()));
                rooms.lent.extend(lent);
            }
        }
        rooms
    }
    /// Their names, in order.
    pub fn names(&self) -> &[String] {
        &self.names
    }
    fn place(&self, name: &str) -> Option<usize> {
        let lent = self.lent.iter().find(|(lent, _)| lent == name);
        let room = lent.map_or(name, |(_, room)| room);
        self.names.iter().position(|n| n == room)
    }
}

/// All that is wrong, one line each.
pub fn complaints(files: &[Source], rooms: &Rooms) -> Vec<String> {
    files.iter().flat_map(|file| manners(file).into_iter().chain(imports(file, rooms))).collect()
}

/// A header, and no more lines than one can keep in mind.
fn manners(file: &Source) -> Vec<String> {
    let mut found = Vec::new();
    if !HEADERS.iter().any(|header| file.text.starts_with(header)) {
        found.push(format!("{}: does not start with //!", file.path));
    }
    let lines = file.text.lines().count();
    if lines > LONGEST && !file.generated() {
        found.push(format!("{}: {lines} lines, more than {LONGEST}", file.path));
    }
    found
}

/// Imports from a room further down, from no room, or from another effect.
fn imports(file: &Source, rooms: &Rooms) -> Vec<String> {
    let Some((own, modules)) = home(&file.path, rooms) else { return Vec::new() };
    let complaint = |path: &str| {
        let (room, rest) = path.split_once("::").unwrap_or((path, ""));
        match rooms.place(room) {
            None => Some(format!("{room} is no room")),
            Some(place) if place > own => Some(format!("imports {room} from below")),
            Some(_) if room == EFFECTS => other_effect(&modules, rest),
            Some(_) => None,
        }
    };
    let all = named(&code(&file.text), modules.len()).into_iter();
    let found = all.filter_map(|(line, path)| Some((line, complaint(&path)?)));
    found.map(|(line, what)| format!("{}:{line}: {what}", file.path)).collect()
}

/// The complaint about a file among `modules` that names `path` below the effects.
fn other_effect(modules: &[&str], path: &str) -> Option<String> {
    let [EFFECTS, own, ..] = modules else { return None };
    let named = words(path).next()?;
    (named != *own).then(|| format!("one effect imports another, {named}"))
}

/// Place of the room a file of the core lies in, and its path of modules.
fn home<'a>(path: &'a str, rooms: &Rooms) -> Option<(usize, Vec<&'a str>)> {
    let inside = path.strip_prefix(CORE)?.strip_suffix(".rs")?;
    let modules: Vec<&str> = inside.split('/').filter(|m| *m != "mod").collect();
    let own = rooms.place(modules.first()?)?;
    Some((own, modules))
}

/// The text without comments, line by line; what stands in strings stays.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// Paths from the core's root that code at this depth names, each with its line.
fn named(code: &str, depth: usize) -> Vec<(usize, String)> {
    let up = "super::".repeat(depth);
    let starts = ["crate::".to_owned(), up];
    let mut found = Vec::new();
    for start in starts.iter().filter(|s| !s.is_empty()) {
        for (at, _) in code.match_indices(start.as_str()) {
            let before = code[..at].chars().next_back();
            let longer = code[..at].ends_with("super::");
            if longer || before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
                continue;
            }
            let line = code[..at].matches('\n').count() + 1;
            let rest = &code[at + start.len()..];
            found.extend(targets(rest).into_iter().map(|path| (line, path)));
        }
    }
    found
}

/// What a path goes on with: one name and its next, or each name of a group.
fn targets(rest: &str) -> Vec<String> {
    let Some(group) = rest.strip_prefix('{') else {
        let path: String =
            rest.chars().take_while(|c| c.is_alphanumeric() || "_:".contains(*c)).collect();
        return vec![path];
    };
    let mut depth = 0;
    let mut names = vec![String::new()];
    for c in group.chars() {
        match c {
            '}' if depth == 0 => break,
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(String::new()),
            _ => {}
        }
        if depth == 0 && (c.is_alphanumeric() || "_:".contains(c)) {
            names.last_mut().into_iter().for_each(|name| name.push(c));
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}
