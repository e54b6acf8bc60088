//! One table of a scene, read key by key; what is not known is an error with its line.

use super::error::{Fault, SceneError};
use super::hint::hint;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The text of a scene and where it came from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) file: &'a str,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// An error at a place of the text.
    pub(crate) fn fault(&self, span: Option<Range<usize>>, fault: Fault) -> SceneError {
        let before = self.text.as_bytes().get(..span.map_or(0, |s| s.start)).unwrap_or_default();
        let line = 1 + before.iter().filter(|&&b| b == b'\n').count();
        SceneError { file: self.file.to_owned(), line, fault }
    }
}

/// A table of the scene; an absent one gives defaults.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Section<'a> {
    source: Source<'a>,
    name: &'a str,
    table: Option<&'a DeTable<'a>>,
}

type Value<'a> = Spanned<DeValue<'a>>;

impl<'a> Section<'a> {
    /// The scene itself, whose keys are tables.
    pub(crate) fn root(
        source: Source<'a>,
        table: &'a DeTable<'a>,
        known: &[&str],
    ) -> Result<Self, SceneError> {
        let root = Self { source, name: "", table: Some(table) };
        root.all_known(known)?;
        Ok(root)
    }

    /// A table inside this one, all of whose keys must be known.
    pub(crate) fn section(&self, name: &'a str, known: &[&str]) -> Result<Self, SceneError> {
        let bare = name.rsplit('.').next().unwrap_or(name);
        let table = match self.get(bare) {
            None => None,
            Some(value) => match value.get_ref() {
                DeValue::Table(table) => Some(table),
                _ => return Err(self.wrong(bare, value, format!("a table: write [{name}]"))),
            },
        };
        let section = Self { source: self.source, name, table };
        section.all_known(known)?;
        Ok(section)
    }

    fn all_known(&self, known: &[&str]) -> Result<(), SceneError> {
        let keys = self.table.into_iter().flat_map(|t| t.keys());
        let unknown = keys.filter(|key| !known.contains(&key.get_ref().as_ref()));
        let Some(key) = unknown.min_by_key(|key| key.span().start) else { return Ok(()) };
        let (what, place) = if self.name.is_empty() {
            ("table", String::new())
        } else {
            ("key", format!(" in [{}]", self.name))
        };
        let given = crate::error::one_line(key.get_ref());
        let hint = hint(&given, known);
        Err(self.source.fault(Some(key.span()), Fault::Unknown { what, given, place, hint }))
    }

    /// Whether the scene names it.
    pub(crate) fn is_there(&self) -> bool {
        self.table.is_some()
    }
    /// Whether the scene names this key of it.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    pub(crate) fn get(&self, key: &str) -> Option<&'a Value<'a>> {
        self.table.and_then(|t| t.get(key))
    }

    /// An error at a key of this table.
    pub(crate) fn fault(&self, key: &str, fault: Fault) -> SceneError {
        let at = self.table.and_then(|t| t.get_key_value(key)).map(|(k, _)| k.span());
        self.source.fault(at, fault)
    }

    fn wrong(&self, key: &str, value: &Value<'_>, wanted: impl Into<String>) -> SceneError {
        let dot = if self.name.is_empty() { "" } else { "." };
        let key = format!("{}{dot}{key}", self.name);
        self.source.fault(Some(value.span()), Fault::Kind { key, wanted: wanted.into() })
    }

    /// A key read by `read`, or its default.
    fn read<T>(
        &self,
        key: &str,
        default: T,
        wanted: &str,
        read: impl Fn(&DeValue<'_>) -> Option<T>,
    ) -> Result<T, SceneError> {
        let Some(value) = self.get(key) else { return Ok(default) };
        read(value.get_ref()).ok_or_else(|| self.wrong(key, value, wanted))
    }

    pub(crate) fn number(&self, key: &str, default: f64) -> Result<f64, SceneError> {
        self.read(key, default, "a number", number)
    }

    pub(crate) fn whole<T: TryFrom<i64>>(&self, key: &str, default: T) -> Result<T, SceneError> {
        self.read(key, default, "a whole number that is not negative and not too large", |v| {
            whole(v).and_then(|n| T::try_from(n).ok())
        })
    }

    pub(crate) fn flag(&self, key: &str, default: bool) -> Result<bool, SceneError> {
        self.read(key, default, "true or false", |v| v.as_bool())
    }

    pub(crate) fn numbers<const N: usize>(
        &self,
        key: &str,
        default: [f64; N],
    ) -> Result<[f64; N], SceneError> {
        self.read(key, default, &format!("{N} numbers in brackets"), |v| {
            let all: Option<Vec<f64>> = v.as_array()?.iter().map(|n| number(n.get_ref())).collect();
            all?.try_into().ok()
        })
    }

    pub(crate) fn text(&self, key: &str) -> Result<Option<String>, SceneError> {
        self.read(key, None, "text in quotes", |v| v.as_str().map(|s| Some(s.to_owned())))
    }

    /// One of several words.
    pub(crate) fn choice<T: Copy>(
        &self,
        key: &str,
        default: T,
        words: &[(&str, T)],
    ) -> Result<T, SceneError> {
        let Some(given) = self.text(key)? else { return Ok(default) };
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == given) {
            return Ok(*value);
        }
        let known: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let hint = hint(&given, &known);
        let place = format!(" of {}.{key}", self.name);
        let given = crate::error::one_line(&given);
        Err(self.fault(key, Fault::Unknown { what: "value", given, place, hint }))
    }

    /// The tables of an array, each a section of its own.
    pub(crate) fn array(
        &self,
        key: &str,
        name: &'a str,
        known: &[&str],
    ) -> Result<Vec<Section<'a>>, SceneError> {
        let Some(value) = self.get(key) else { return Ok(Vec::new()) };
        let wrong = || {
            self.wrong(
                key,
                value,
                format!("a list of tables: write [[{name}]] or [{{..}}, {{..}}]"),
            )
        };
        let list = value.get_ref().as_array().ok_or_else(wrong)?;
        let mut sections = Vec::with_capacity(list.len());
        for item in list {
            let table = Some(item.get_ref().as_table().ok_or_else(wrong)?);
            let section = Section { source: self.source, name, table };
            section.all_known(known)?;
            sections.push(section);
        }
        Ok(sections)
    }
}

fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(f) => f.as_str().parse().ok(),
        _ => whole(value).map(|n| n as f64),
    }
}

fn whole(value: &DeValue<'_>) -> Option<i64> {
    let n = value.as_integer()?;
    i64::from_str_radix(n.as_str(), n.radix()).ok()
}
