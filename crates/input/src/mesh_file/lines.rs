//! Lines of a text, with their numbers. No line may be so long that it takes up memory.

use super::problem::{DAMAGED, MeshFileProblem, refuse};
use std::io::{BufRead, Read};

/// Longest line [bytes].
const LONGEST: u64 = 1 << 16;

/// The lines of a text.
pub(super) struct Lines<R> {
    reader: R,
    buffer: Vec<u8>,
    number: usize,
}

impl<R: BufRead> Lines<R> {
    pub(super) fn new(reader: R) -> Self {
        Self { reader, buffer: Vec::new(), number: 0 }
    }

    /// The next line, without spaces around it; `None` at the end.
    pub(super) fn next(&mut self) -> Result<Option<String>, MeshFileProblem> {
        self.buffer.clear();
        self.number += 1;
        let read = self.reader.by_ref().take(LONGEST).read_until(b'\n', &mut self.buffer);
        match read {
            Ok(0) => Ok(None),
            Ok(_) if self.buffer.len() as u64 == LONGEST && self.buffer.last() != Some(&b'\n') => {
                refuse(format!("line {} is longer than {LONGEST} bytes", self.number), DAMAGED)
            }
            // Names and comments may be in any encoding.
            Ok(_) => Ok(Some(String::from_utf8_lossy(&self.buffer).trim().to_owned())),
            Err(error) => refuse(format!("line {} cannot be read: {error}", self.number), DAMAGED),
        }
    }

    /// The refusal of the present line, which is not what the format has there.
    pub(super) fn wrong<T>(&self, message: impl std::fmt::Display) -> Result<T, MeshFileProblem> {
        self.refused(message, DAMAGED)
    }

    /// The refusal of the present line, with a cure of its own.
    pub(super) fn refused<T>(
        &self,
        message: impl std::fmt::Display,
        cure: &str,
    ) -> Result<T, MeshFileProblem> {
        refuse(format!("line {}: {message}", self.number), cure)
    }

    /// Number of the present line.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// What follows the lines that were read.
    pub(super) fn into_rest(self) -> R {
        self.reader
    }
}

/// A word shortened to what a message can hold.
pub(super) fn shown(word: &str) -> String {
    const LETTERS: usize = 30;
    let short: String = word.chars().take(LETTERS).collect();
    if short.len() < word.len() { format!("`{short}…`") } else { format!("`{short}`") }
}

/// Three finite coordinates from words; what is wrong otherwise.
pub(super) fn coordinates<'a>(mut words: impl Iterator<Item = &'a str>) -> Result<[f64; 3], String> {
    let mut coordinates = [0.0; 3];
    for (n, coordinate) in coordinates.iter_mut().enumerate() {
        let word = words.next().ok_or_else(|| format!("expected three coordinates, found {n}"))?;
        *coordinate = word
            .parse()
            .ok()
            .filter(|x: &f64| x.is_finite())
            .ok_or_else(|| format!("{} is not a finite number", shown(word)))?;
    }
    Ok(coordinates)
}
