//! A recorded finger: pointer samples, a JSON object a line, as in `fixtures/gestures`.

use dogleaf_core::hand::{Phase, Sample};

/// Samples in the order they were recorded.
#[derive(Debug, Clone)]
pub struct Touches<'a> {
    lines: core::str::Lines<'a>,
    next: Option<Sample>,
}

impl<'a> Touches<'a> {
    /// Of a file's text. What is no sample is passed over.
    #[must_use]
    pub fn of(text: &'a str) -> Self {
        let mut touches = Self { lines: text.lines(), next: None };
        touches.read();
        touches
    }

    /// When the next sample is due, microseconds; none if there is none.
    #[must_use]
    pub fn due_us(&self) -> Option<u64> {
        self.next.map(|s| s.t_us)
    }

    /// The next sample, if it is due.
    pub fn take(&mut self, now_us: u64) -> Option<Sample> {
        let sample = self.next.filter(|s| s.t_us <= now_us)?;
        self.read();
        Some(sample)
    }

    fn read(&mut self) {
        self.next = self.lines.find_map(sample);
    }
}

fn sample(line: &str) -> Option<Sample> {
    let phase = match after(line, "\"phase\":\"")?.bytes().next()? {
        b'd' => Phase::Down,
        b'm' => Phase::Move,
        b'u' => Phase::Up,
        b'c' => Phase::Cancel,
        _ => return None,
    };
    let [t_us, id] = [number(line, "\"t_us\":")?, number(line, "\"id\":")?];
    let [x, y] = [number(line, "\"x\":")?, number(line, "\"y\":")?];
    let leaves = number(line, "\"leaves\":").unwrap_or(0);
    Some(Sample {
        t_us: u64::try_from(t_us).ok()?,
        id: u8::try_from(id).ok()?,
        phase,
        x: i32::try_from(x).ok()?,
        y: i32::try_from(y).ok()?,
        leaves: u16::try_from(leaves).ok()?,
    })
}

fn after<'t>(line: &'t str, key: &str) -> Option<&'t str> {
    line.split_once(key).map(|(_, rest)| rest)
}

/// The whole number that stands after a key.
fn number(line: &str, key: &str) -> Option<i64> {
    let rest = after(line, key)?.trim_start();
    let end = rest.find([',', '}']).unwrap_or(rest.len());
    rest.get(..end)?.trim_end().parse().ok()
}
