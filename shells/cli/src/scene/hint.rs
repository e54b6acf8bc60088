//! Did you mean: the known word nearest to one that is not known.

/// The end of a message about an unknown word: the nearest known one, else all of them.
pub(crate) fn hint(given: &str, known: &[&str]) -> String {
    let nearest = known.iter().map(|word| (distance(given, word), word)).min();
    match nearest {
        Some((d, word)) if d <= 1 + given.chars().count() / 3 => {
            format!("did you mean '{word}'?")
        }
        _ => format!("known are {}", known.join(", ")),
    }
}

/// Letters to insert, remove, replace, or swap with their neighbour.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_edits() {
        assert_eq!(distance("width_m", "widht_m"), 1, "a swap");
        assert_eq!(distance("", "abc"), 3, "insertions");
        assert_eq!(distance("kitten", "sitting"), 3, "the textbook's");
    }

    #[test]
    fn names_the_nearest_or_all() {
        assert_eq!(hint("widht", &["width", "height"]), "did you mean 'width'?", "near");
        assert_eq!(hint("zzz", &["width", "height"]), "known are width, height", "far");
    }
}
