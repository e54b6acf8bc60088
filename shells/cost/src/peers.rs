//! Peers on the same sheet, measured elsewhere (`cargo ci peers`) and read from a file.

use crate::CostError;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A file is at most this big, bytes.
const MOST: u64 = 1 << 20;

/// What a peer did.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Peer {
    /// Its name and version.
    pub name: String,
    /// Its dials.
    pub config: String,
    /// `Γ` of the sheet that came to rest.
    pub gamma: f64,
    /// Drop over reach at rest; nothing where it did not come to rest.
    pub ratio: Option<f64>,
    /// The same of the heavy elastica.
    pub elastica: f64,
    /// Median microseconds of a step.
    pub step_us: f64,
    /// Steps a second.
    pub rate: f64,
    /// Drop of the free edge a quarter of a second after it was let go, metres.
    pub fall_m: Option<f64>,
}

/// All of them.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Peers {
    /// Runs.
    pub rows: Vec<Peer>,
    /// Linear algebra on the seed's matrix: name, median microseconds of factor and solve.
    pub linear: Vec<(String, f64)>,
    /// What could not be had.
    pub omissions: Vec<String>,
}

impl Peers {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// Where there is none, or it is no report of peers.
    pub fn read(path: &Path) -> Result<Self, CostError> {
        use std::io::Read;
        let file = path.display().to_string();
        let bad = |reason: String| CostError::Peers { file: file.clone(), reason };
        let mut text = String::new();
        let open = std::fs::File::open(path).map_err(|e| bad(e.to_string()))?;
        open.take(MOST).read_to_string(&mut text).map_err(|e| bad(e.to_string()))?;
        serde_json::from_str(&text).map_err(|e| bad(e.to_string()))
    }
}
