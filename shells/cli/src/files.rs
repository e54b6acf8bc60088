//! Text in from files of bounded size, text out to the standard output.

use crate::error::{CliError, shown};
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

/// Reads a text file of at most `most` bytes.
pub(crate) fn read_text(path: &Path, most: u64) -> Result<String, CliError> {
    let refuse = |e| CliError::read(path, &e);
    let mut text = String::new();
    let file = File::open(path).map_err(refuse)?;
    file.take(most + 1).read_to_string(&mut text).map_err(refuse)?;
    if text.len() as u64 > most {
        let file = shown(path);
        return Err(CliError::Call(format!("{file}: more than {most} bytes are refused")));
    }
    Ok(text)
}

/// Writes to the standard output.
pub(crate) fn say(text: &str) -> Result<(), CliError> {
    let written = std::io::stdout().lock().write_all(text.as_bytes());
    written.map_err(|e| CliError::write("standard output".as_ref(), &e))
}

/// Writes a line of JSON to the standard output.
pub(crate) fn say_json(value: &impl serde::Serialize) -> Result<(), CliError> {
    say(&(serde_json::to_string(value).unwrap_or_default() + "\n"))
}
