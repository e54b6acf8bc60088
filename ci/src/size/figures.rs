//! What an image says about itself when it runs: lines of a name and a number.

/// The figures of one run.
#[derive(Debug, Clone, Default)]
pub(crate) struct Figures(Vec<(String, u64)>);

impl Figures {
    /// From the image's output.
    pub(crate) fn read(text: &str) -> Self {
        let line = |l: &str| {
            let (name, number) = l.trim().rsplit_once(char::is_whitespace)?;
            Some((name.trim().to_owned(), number.parse().ok()?))
        };
        Self(text.lines().filter_map(line).collect())
    }

    /// One of them.
    pub(crate) fn get(&self, name: &str) -> Result<u64, String> {
        let found = self.0.iter().find(|(n, _)| n == name);
        found.map(|(_, number)| *number).ok_or_else(|| format!("the image did not say `{name}`"))
    }
}

#[cfg(test)]
mod check {
    use super::Figures;

    #[test]
    fn names_may_have_spaces() {
        let f = Figures::read("self test  passed\ninstructions median   1434382\n");
        assert_eq!(f.get("instructions median"), Ok(1_434_382));
        assert!(f.get("self test").is_err(), "that is no number");
    }
}
