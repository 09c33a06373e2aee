//! Words of a text, one after the other over all its lines, as formats have them that end lines where they
//! like.

use super::lines::{Field, Separator};
use super::number::{self, Numbers};
use super::placed::line_of;
use crate::data_file::FileProblem;

/// The words of a text, and the numbers among them.
#[derive(Clone, Debug)]
pub(crate) struct Words<'a> {
    text: &'a str,
    at: usize,
    numbers: Numbers,
}

impl<'a> Words<'a> {
    /// The words of a text; `absent` says what is to be done about a word that is no number.
    pub(crate) fn new(text: &'a str, absent: &'static str) -> Self {
        Self { text, at: 0, numbers: Numbers::new(Separator::Blanks, absent) }
    }

    /// The number that a word is.
    pub(crate) fn number(&mut self, word: &Field<'_>) -> Result<f64, FileProblem> {
        self.numbers.read(word).map_err(|(at, problem)| FileProblem {
            message: format!("line {}: {}", line_of(self.text, at.start), problem.message),
            cure: problem.cure,
        })
    }

    /// Whether a word is a number.
    pub(crate) fn is_number(&self, word: &Field<'_>) -> bool {
        number::is_number(word, Separator::Blanks)
    }

    /// A remark on how the numbers were read.
    pub(crate) fn remark(&self) -> Option<String> {
        self.numbers.remark()
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = Field<'a>;

    fn next(&mut self) -> Option<Field<'a>> {
        let rest = &self.text[self.at..];
        let start = self.at + rest.find(|c: char| !c.is_whitespace())?;
        let word = self.text[start..].split_whitespace().next()?;
        self.at = start + word.len();
        Some(Field { text: word, at: start..self.at, is_quoted: false })
    }
}
