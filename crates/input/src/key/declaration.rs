//! A key of a case file and a section of keys.

use super::allowed_range::AllowedRange;
use super::default_value::DefaultValue;
use super::usual_range::UsualRange;
use crate::problem::Problems;
use crate::quantity::{Measure, parse, plain, with_unit};
use crate::typed::Section;

/// What a value may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Any text.
    Text,
    /// The version of the case-file format.
    Format,
    /// A number with a unit, as text.
    Quantity(Measure),
    /// A number without a unit.
    Number,
    /// Three numbers without a unit, along x, y and z.
    Ratios,
    /// Low and high end: two numbers without a unit.
    Interval,
    /// A whole number, 0 or more.
    Count,
    /// `true` or `false`.
    Flag,
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// Low and high end: two quantities.
    Range(Measure),
    /// Two or three quantities.
    Vector(Measure),
    /// Bekker's modulus in N/m^(n+i), whose unit contains the sinkage exponent n; the number is i.
    Modulus(i32),
    /// A number, or the word `rough`.
    Friction,
    /// A number, or a word such as `loose`.
    RelativeDensity,
    /// The names of two bodies.
    NamePair,
    /// Words from a list, each at most once.
    Choices(&'static [&'static str]),
    /// Names, any number of them.
    Names,
    /// A list of values, each as its key wants it.
    Values,
    /// A table of keys of a case and what to set them to.
    Assignments,
    /// The boundary conditions at the low and at the high end.
    WallPair,
    /// What the grid follows: a table with a body and axes.
    Follow,
    /// What ends a stage: a table with a body and the value of a quantity that it reaches.
    Until,
    /// How a degree of freedom moves: a word, or a table with a speed or a load.
    Motion {
        /// The word for no motion.
        still: &'static str,
        /// What `displacement` measures.
        way: Measure,
        /// What `speed` measures.
        speed: Measure,
        /// What `load` measures.
        load: Measure,
    },
}

impl Kind {
    /// Whether the value is how a degree of freedom moves.
    #[must_use]
    pub fn is_motion(&self) -> bool {
        matches!(self, Self::Motion { .. })
    }
}

/// One key.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Name of the key in its section.
    pub name: &'static str,
    /// What the value of the key may be.
    pub kind: Kind,
    /// What applies if the key is left out.
    pub default: DefaultValue,
    /// Which numbers the key allows; `None` for any, and where its values are no numbers.
    pub range: Option<AllowedRange>,
    /// Which numbers are usual for the key; `None` where any is.
    pub usual: Option<UsualRange>,
    /// What the key means.
    pub meaning: &'static str,
}

impl Key {
    /// The key with the range of the numbers that it allows.
    #[must_use]
    pub const fn within(self, range: AllowedRange) -> Self {
        Self { range: Some(range), ..self }
    }

    /// The key with the range of the numbers that are usual.
    #[must_use]
    pub const fn usually(self, usual: UsualRange) -> Self {
        Self { usual: Some(usual), ..self }
    }

    /// A number of this key as one would write it, with its unit.
    #[must_use]
    pub fn shown(&self, number: f64) -> String {
        match self.kind {
            Kind::Quantity(measure) | Kind::Range(measure) | Kind::Vector(measure) => {
                with_unit(number, &measure)
            }
            Kind::Modulus(offset) => format!("{} N/m^(n+{offset})", plain(number)),
            _ => plain(number),
        }
    }

    /// The ends of the usual range of the key, in SI units.
    #[must_use]
    pub fn usual_ends(&self) -> Option<[f64; 2]> {
        let usual = self.usual?;
        let read = |end: &str| match self.kind {
            Kind::Quantity(measure) => parse(end, &measure).ok(),
            _ => end.parse().ok(),
        };
        Some([read(usual.low)?, read(usual.high)?])
    }

    /// Usual range of the key in words: `50 kPa to 1 GPa (from mud to soft rock)`.
    #[must_use]
    pub fn usual_text(&self) -> Option<String> {
        self.usual.map(|usual| format!("{} to {} ({})", usual.low, usual.high, usual.source))
    }

    /// Allowed range of the key in words, if it has one.
    #[must_use]
    pub fn range_text(&self) -> Option<String> {
        self.range.map(|range| range.text(|number| self.shown(number)))
    }
}

impl Key {
    /// Whether a number at a path is finite and in the range of the key; reported if not.
    pub fn admits(&self, path: &str, number: f64, problems: &mut Problems) -> bool {
        let is_right = number.is_finite() && self.range.is_none_or(|range| range.contains(number));
        if !is_right {
            self.refuse(path, number, problems);
        }
        is_right
    }

    /// Reports a number at a path that is out of range.
    pub fn refuse(&self, path: &str, number: f64, problems: &mut Problems) {
        let allowed = self.range_text().unwrap_or_else(|| "a finite number".to_owned());
        let message = format!("{path} = {} is out of range", self.shown(number));
        problems.add(path, message, format!("it must be {allowed}"));
    }

    /// A value for the key as one would write it.
    pub fn example(&self) -> String {
        match self.kind {
            Kind::Quantity(measure) => format!("\"{}\"", measure.example),
            Kind::Choice(words) => format!("\"{}\"", words.first().unwrap_or(&"")),
            Kind::Range(measure) => format!("[\"-{0}\", \"{0}\"]", measure.example),
            Kind::Vector(measure) => format!("[\"{0}\", \"{0}\", \"{0}\"]", measure.example),
            Kind::Modulus(offset) => format!("\"102 kN/m^(n+{offset})\""),
            Kind::NamePair => "[\"frame\", \"disc\"]".into(),
            Kind::Ratios => "[3, 3, 1]".into(),
            Kind::Interval => "[0.3, 0.5]".into(),
            Kind::Count => "24".into(),
            Kind::Flag => "true".into(),
            _ => "0.3".into(),
        }
    }

    /// Reports that the key is missing in a section.
    pub fn missing(&self, section: &Section, problems: &mut Problems) {
        let path = section.at(self.name);
        let cure = format!("add  {} = {}  to [{}]", self.name, self.example(), section.path);
        problems.add(&path, format!("`{path}` is missing"), cure);
    }
}

/// The keys of one section.
#[derive(Clone, Copy, Debug)]
pub struct KeyTable {
    /// Name of the section; empty for the top of the file, `body` for `[body.NAME]`.
    pub name: &'static str,
    /// What the section is about.
    pub meaning: &'static str,
    /// Keys of the section.
    pub keys: &'static [Key],
}

impl KeyTable {
    /// The key of that name.
    #[must_use]
    pub fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

/// A key without a range.
#[must_use]
pub const fn key(name: &'static str, kind: Kind, default: DefaultValue, meaning: &'static str) -> Key {
    Key { name, kind, default, range: None, usual: None, meaning }
}

/// A section.
#[must_use]
pub const fn section(name: &'static str, meaning: &'static str, keys: &'static [Key]) -> KeyTable {
    KeyTable { name, meaning, keys }
}
