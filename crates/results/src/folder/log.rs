//! `run.log`: events with their times.

use crate::files::{Inside, LOG, Named, OutputError};
use input::printed::plain;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// An open log.
#[derive(Debug)]
pub struct Log {
    path: PathBuf,
    file: File,
}

impl Log {
    /// Creates the log of a results folder.
    ///
    /// # Errors
    /// When the file cannot be created.
    pub fn create(dir: &Path) -> Result<Self, OutputError> {
        let log = Inside::of(dir, LOG);
        Ok(Self { path: log.path(), file: log.create().named("create", &log.path())? })
    }

    /// Continues a log.
    ///
    /// # Errors
    /// When the file cannot be opened.
    pub fn append(dir: &Path) -> Result<Self, OutputError> {
        let log = Inside::of(dir, LOG);
        let open = || log.open_or_create().and_then(|mut file| file.seek(SeekFrom::End(0)).map(|_| file));
        Ok(Self { path: log.path(), file: open().named("open", &log.path())? })
    }

    /// Writes a line with a time stamp (UTC).
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn line(&mut self, text: &str) -> Result<(), OutputError> {
        let line = format!("{}  {}\n", stamp(SystemTime::now()), plain(text));
        self.file.write_all(line.as_bytes()).named("write", &self.path)?;
        self.file.flush().named("write", &self.path)
    }
}

/// A time as `2026-01-31T12:00:00Z`.
#[must_use]
pub(super) fn stamp(time: SystemTime) -> String {
    let seconds = time.duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    let (mut day, second) = (seconds / 86_400, seconds % 86_400);
    let mut year = 1970;
    while day >= days_of_year(year) {
        day -= days_of_year(year);
        year += 1;
    }
    let february = days_of_year(year) - 337;
    let mut month = 0;
    for days in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        month += 1;
        if day < days {
            break;
        }
        day -= days;
    }
    format!(
        "{year:04}-{month:02}-{:02}T{:02}:{:02}:{:02}Z",
        day + 1,
        second / 3600,
        second / 60 % 60,
        second % 60
    )
}

fn days_of_year(year: u64) -> u64 {
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    if leap { 366 } else { 365 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn stamps_follow_the_calendar() {
        let at = |seconds| stamp(UNIX_EPOCH + Duration::from_secs(seconds));
        assert_eq!(at(0), "1970-01-01T00:00:00Z");
        assert_eq!(at(951_782_400), "2000-02-29T00:00:00Z");
        assert_eq!(at(1_767_225_599), "2025-12-31T23:59:59Z");
    }
}
