//! The order a reader means: numbers by value, letters without case, folders apart.

use std::cmp::Ordering;
use std::iter::Peekable;
use std::str::Chars;

/// Compares two names; equal only if they are the same text.
pub(crate) fn compare(a: &str, b: &str) -> Ordering {
    let mut left = a.split(['/', '\\']);
    let mut right = b.split(['/', '\\']);
    loop {
        let order = match (left.next(), right.next()) {
            (None, None) => return a.cmp(b),
            (None, Some(_)) => Ordering::Less,
            (Some(_), None) => Ordering::Greater,
            (Some(l), Some(r)) => compare_part(l, r),
        };
        if order.is_ne() {
            return order;
        }
    }
}

fn compare_part(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a.chars().peekable(), b.chars().peekable());
    loop {
        let order = match (left.peek().copied(), right.peek().copied()) {
            (None, None) => return Ordering::Equal,
            (None, Some(_)) => Ordering::Less,
            (Some(_), None) => Ordering::Greater,
            (Some(l), Some(r)) if l.is_ascii_digit() && r.is_ascii_digit() => {
                compare_numbers(&digits(&mut left), &digits(&mut right))
            }
            (Some(l), Some(r)) => {
                left.next();
                right.next();
                l.to_lowercase().cmp(r.to_lowercase())
            }
        };
        if order.is_ne() {
            return order;
        }
    }
}

/// Numbers of any length: without leading zeros the longer is the larger.
fn compare_numbers(a: &str, b: &str) -> Ordering {
    let (a, b) = (a.trim_start_matches('0'), b.trim_start_matches('0'));
    a.len().cmp(&b.len()).then_with(|| a.cmp(b))
}

fn digits(chars: &mut Peekable<Chars<'_>>) -> String {
    std::iter::from_fn(|| chars.next_if(char::is_ascii_digit)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readers_order() {
        let wanted = [
            "1.png",
            "2.png",
            "010.png",
            "10.png",
            "10a.png",
            "184467440737095516160.png",
            "a/1.png",
            "A/2.png",
            "a/10.png",
            "a b/1.png",
            "Cover.png",
            "cover2.png",
        ];
        let mut found = wanted;
        found.reverse();
        found.sort_by(|a, b| compare(a, b));
        assert_eq!(found, wanted, "not the order a reader means");
    }
}
