//! What a panel can do, and how long that takes.

/// How a panel brings a picture about.
///
/// | | from | to | drives | flashes |
/// |---|---|---|---|---|
/// | `A2` | black, white | black, white | what changes | no |
/// | `Du` | any grey | black, white | what changes | no |
/// | `Gl16` | any grey | any grey | all but what stays white | no |
/// | `Glr16` | any grey | any grey | every pixel of the rectangle | no |
/// | `Gc16` | any grey | any grey | every pixel of the rectangle | yes |
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Waveform {
    /// Fast, two tones, from two tones.
    A2,
    /// Direct update to two tones.
    Du,
    /// Sixteen greys on white.
    Gl16,
    /// Sixteen greys, white driven anew: what makers call Regal.
    Glr16,
    /// Sixteen greys, cleaned.
    Gc16,
}

impl Waveform {
    /// Every waveform with its name.
    pub const ALL: [(&'static str, Self); 5] = [
        ("A2", Self::A2),
        ("DU", Self::Du),
        ("GL16", Self::Gl16),
        ("GLR16", Self::Glr16),
        ("GC16", Self::Gc16),
    ];

    /// Its usual name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, w)| *w == self).map_or("", |(name, _)| name)
    }

    /// Shows black and white alone.
    #[must_use]
    pub fn is_two_tone(self) -> bool {
        matches!(self, Self::A2 | Self::Du)
    }
}

/// A panel: its size, and how long each waveform takes whatever the size of the rectangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Panel {
    /// Pixels across.
    pub width: u16,
    /// Pixels down.
    pub height: u16,
    /// Shows sixteen greys, not two tones.
    pub grey: bool,
    /// Microseconds of an `A2`; none if the panel has none.
    pub a2_us: Option<u32>,
    /// Microseconds of a `Du`.
    pub du_us: u32,
    /// Microseconds of a `Gl16`.
    pub gl16_us: u32,
    /// Microseconds of a `Glr16`; none if the panel has none.
    pub glr16_us: Option<u32>,
    /// Microseconds of a `Gc16`.
    pub gc16_us: u32,
}

/// Why a panel is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PanelError {
    /// Fewer than 64 or more than 2,048 pixels across or down.
    Size,
    /// A waveform of no time, or of more than ten seconds.
    Time,
}

impl core::fmt::Display for PanelError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Size => "a panel has 64 to 2,048 pixels across and down",
            Self::Time => "a panel's waveform takes a microsecond to ten seconds",
        })
    }
}

impl core::error::Error for PanelError {}

impl Panel {
    /// Six inches, 800x600, sixteen greys, as in readers and phones.
    pub const SIX_INCH: Self = Self {
        width: 800,
        height: 600,
        grey: true,
        a2_us: Some(120_000),
        du_us: 260_000,
        gl16_us: 450_000,
        glr16_us: Some(450_000),
        gc16_us: 450_000,
    };

    /// Seven and a half inches, 800x480, two tones, as on bare modules for microcontrollers.
    pub const MODULE: Self = Self {
        width: 800,
        height: 480,
        grey: false,
        a2_us: None,
        du_us: 300_000,
        gl16_us: 300_000,
        glr16_us: None,
        gc16_us: 2_000_000,
    };

    /// Refuses what is no panel.
    ///
    /// # Errors
    ///
    /// [`PanelError`].
    pub fn check(&self) -> Result<(), PanelError> {
        if [self.width, self.height].iter().any(|n| !(64..=2_048).contains(n)) {
            return Err(PanelError::Size);
        }
        let times = Waveform::ALL.map(|(_, w)| self.takes_us(w));
        let odd = times.iter().any(|t| !(1..=10_000_000).contains(t));
        if odd { Err(PanelError::Time) } else { Ok(()) }
    }

    /// How long a waveform takes, microseconds.
    #[must_use]
    pub fn takes_us(&self, waveform: Waveform) -> u32 {
        match waveform {
            Waveform::A2 => self.a2_us.unwrap_or(self.du_us),
            Waveform::Du => self.du_us,
            Waveform::Gl16 => self.gl16_us,
            Waveform::Glr16 => self.glr16_us.unwrap_or(self.gl16_us),
            Waveform::Gc16 => self.gc16_us,
        }
    }

    /// Microseconds of the fastest picture.
    #[must_use]
    pub fn frame_us(&self) -> u32 {
        self.takes_us(Waveform::A2)
    }

    /// All of it.
    #[must_use]
    pub fn whole(&self) -> crate::Rect {
        crate::Rect::new(0, 0, self.width, self.height)
    }
}
