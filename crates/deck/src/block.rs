//! A keyword block: a line that begins with an asterisk, its parameters, and the lines of data below it.

use std::cell::Cell;

/// Where something stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Number of the file: 0 is the deck, others are included.
    pub file: usize,
    /// Line in it, counted from 1.
    pub line: usize,
}

/// A file of the deck.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// Its name, as the deck gives it.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// A parameter of a keyword, `NAME=VALUE` or `NAME`.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name in capitals, blanks made one.
    pub name: String,
    /// Value as it stands, without quotes.
    pub value: Option<String>,
    seen: Cell<bool>,
}

impl Parameter {
    /// A parameter that nobody has asked for yet.
    pub(super) fn new(name: String, value: Option<String>) -> Self {
        Self { name, value, seen: Cell::new(false) }
    }
}

/// A line of data.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where it stands.
    pub place: Place,
    /// Its text, without the end of the line.
    pub text: String,
}

impl Row {
    /// The fields between its commas; an empty one at the end is none.
    pub fn fields(&self) -> Vec<&str> {
        let mut fields: Vec<&str> = self.text.split(',').map(str::trim).collect();
        while fields.last().is_some_and(|last| last.is_empty()) {
            fields.pop();
        }
        fields
    }

    /// A field, counted from 0; empty where the line has fewer.
    pub fn field(&self, number: usize) -> &str {
        self.text.split(',').nth(number).map_or("", str::trim)
    }

    /// All fields as numbers, an empty one as 0.
    ///
    /// # Errors
    /// The field that is no number.
    pub fn numbers(&self) -> Result<Vec<f64>, Wrong> {
        self.fields()
            .into_iter()
            .map(|field| if field.is_empty() { Ok(0.0) } else { self.as_number(field) })
            .collect()
    }

    /// A field as a number; `None` where it is empty.
    ///
    /// # Errors
    /// It is no number.
    pub fn number(&self, number: usize) -> Result<Option<f64>, Wrong> {
        let field = self.field(number);
        if field.is_empty() { Ok(None) } else { self.as_number(field).map(Some) }
    }

    /// A field as the label of a node or an element.
    ///
    /// # Errors
    /// It is no whole number above 0.
    pub fn label(&self, number: usize) -> Result<u32, Wrong> {
        let field = self.field(number);
        label(field)
            .ok_or_else(|| Wrong::at(self.place, format!("{field:?} is no label of a node or element")))
    }

    fn as_number(&self, field: &str) -> Result<f64, Wrong> {
        number(field).ok_or_else(|| Wrong::at(self.place, format!("{field:?} is no number")))
    }
}

/// A number as Fortran and C write it: `1.`, `.5`, `2.5E6`, `1.d-3`; finite.
pub fn number(text: &str) -> Option<f64> {
    let plain = text.replace(['d', 'D'], "e");
    let is_number = plain.chars().all(|letter| letter.is_ascii_digit() || "+-.eE".contains(letter));
    plain.parse().ok().filter(|value: &f64| is_number && value.is_finite())
}

/// A label: a whole number above 0.
pub fn label(text: &str) -> Option<u32> {
    text.parse().ok().filter(|label| *label > 0)
}

/// What is wrong with a block, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Wrong {
    /// Where it stands; `None`: where the keyword does.
    pub place: Option<Place>,
    /// What is wrong, and what was expected.
    pub message: String,
}

impl Wrong {
    /// What is wrong at a place.
    pub fn at(place: Place, message: impl Into<String>) -> Self {
        Self { place: Some(place), message: message.into() }
    }
}

impl<T: Into<String>> From<T> for Wrong {
    fn from(message: T) -> Self {
        Self { place: None, message: message.into() }
    }
}

/// A keyword with what belongs to it.
#[derive(Clone, Debug)]
pub struct Block {
    /// Keyword in capitals, without the asterisk, blanks made one: `RIGID BODY`.
    pub keyword: String,
    /// Its parameters, in their order.
    pub parameters: Vec<Parameter>,
    /// Its lines of data.
    pub rows: Vec<Row>,
    /// Where the keyword stands.
    pub place: Place,
}

impl Block {
    /// Whether a parameter is there, with or without a value.
    pub fn has(&self, name: &str) -> bool {
        self.parameter(name).is_some()
    }

    /// Value of a parameter, as it stands.
    pub fn value(&self, name: &str) -> Option<&str> {
        self.parameter(name)?.value.as_deref()
    }

    /// Value of a parameter in capitals: names are the same in any case.
    pub fn word(&self, name: &str) -> Option<String> {
        self.value(name).map(str::to_uppercase)
    }

    /// A value that must be there, in capitals.
    ///
    /// # Errors
    /// It is not.
    pub fn required(&self, name: &str) -> Result<String, Wrong> {
        self.word(name).filter(|word| !word.is_empty()).ok_or_else(|| format!("{name}= is missing").into())
    }

    /// The parameters that nobody has asked for: what they say is lost.
    pub fn unseen(&self) -> impl Iterator<Item = &Parameter> {
        self.parameters.iter().filter(|parameter| !parameter.seen.get())
    }

    /// Marks all parameters as seen: of a block that is ignored or refused as a whole.
    pub fn see_all(&self) {
        self.parameters.iter().for_each(|parameter| parameter.seen.set(true));
    }

    fn parameter(&self, name: &str) -> Option<&Parameter> {
        let found = self.parameters.iter().find(|parameter| parameter.name == name)?;
        found.seen.set(true);
        Some(found)
    }
}
