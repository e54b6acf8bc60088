//! A recorded finger: pointer samples, a JSON object a line, as in `fixtures/gestures`.

use dogleaf_core::hand::{Phase, Sample};

/// Samples in the order they were recorded.
#[derive(Debug, Clone)]
pub struct Touches<'a> {
    rest: &'a [u8],
    next: Option<Sample>,
}

impl<'a> Touches<'a> {
    /// Of a file's text. What is no sample is passed over.
    #[must_use]
    pub fn of(text: &'a str) -> Self {
        let mut touches = Self { rest: text.as_bytes(), next: None };
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

    /// Lines are cut by hand, here and below: the searches of `str` would bring panics into the firmware.
    fn read(&mut self) {
        self.next = None;
        while self.next.is_none() && !self.rest.is_empty() {
            let end = self.rest.iter().position(|b| *b == b'\n').unwrap_or(self.rest.len());
            let (line, rest) = self.rest.split_at_checked(end).unwrap_or_default();
            self.rest = rest.get(1..).unwrap_or_default();
            self.next = sample(line);
        }
    }
}

fn sample(line: &[u8]) -> Option<Sample> {
    let phase = match after(line, b"\"phase\":\"")?.first()? {
        b'd' => Phase::Down,
        b'm' => Phase::Move,
        b'u' => Phase::Up,
        b'c' => Phase::Cancel,
        _ => return None,
    };
    let [t_us, id] = [number(line, b"\"t_us\":")?, number(line, b"\"id\":")?];
    let [x, y] = [number(line, b"\"x\":")?, number(line, b"\"y\":")?];
    let leaves = number(line, b"\"leaves\":").unwrap_or(0);
    Some(Sample {
        t_us: u64::try_from(t_us).ok()?,
        id: u8::try_from(id).ok()?,
        phase,
        x: i32::try_from(x).ok()?,
        y: i32::try_from(y).ok()?,
        leaves: u16::try_from(leaves).ok()?,
    })
}

/// What stands after a key.
fn after<'t>(line: &'t [u8], key: &[u8]) -> Option<&'t [u8]> {
    (0..line.len()).find_map(|at| line.get(at..)?.strip_prefix(key))
}

/// The whole number that stands after a key.
fn number(line: &[u8], key: &[u8]) -> Option<i64> {
    let rest = after(line, key)?.trim_ascii_start();
    let (negative, digits) = rest.strip_prefix(b"-").map_or((false, rest), |rest| (true, rest));
    let mut sum: Option<i64> = None;
    for digit in digits.iter().take_while(|b| b.is_ascii_digit()) {
        let more = i64::from(digit & 15);
        sum = Some(sum.unwrap_or(0).checked_mul(10)?.checked_add(more)?);
    }
    sum.map(|n| if negative { -n } else { n })
}
