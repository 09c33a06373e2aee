//! What applies where a key is left out. A default stands here and nowhere else: `resolve`, the documentation
//! and the JSON schema read it from the tables.

/// What applies where a key is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DefaultValue {
    /// Nothing: the key must be given.
    Required,
    /// Nothing: the key must be given with a soil law of this word.
    RequiredFor(&'static str),
    /// A number without a unit.
    Number(f64),
    /// Three numbers without a unit.
    Ratios([f64; 3]),
    /// A quantity as one would write it: `10 min`.
    Quantity(&'static str),
    /// A word.
    Word(&'static str),
    /// `true` or `false`.
    Flag(bool),
    /// The boundary conditions at the low and at the high end.
    Walls([&'static str; 2]),
    /// A fraction of the duration of the run: the duration over this number.
    DurationOver(f64),
    /// A number that depends on the yield law.
    ByLaw {
        /// The number for most laws.
        usual: f64,
        /// The other laws.
        laws: &'static [&'static str],
        /// The number for the other laws.
        instead: f64,
    },
    /// Derived where possible, otherwise a quantity as one would write it.
    Otherwise {
        /// How the default is derived.
        derived: &'static str,
        /// The quantity.
        quantity: &'static str,
    },
    /// Derived from other keys, or required by some of them only: how.
    Derived(&'static str),
}

impl DefaultValue {
    /// Whether the key must be given, at least where its law applies.
    #[must_use]
    pub const fn is_required(&self) -> bool {
        matches!(self, Self::Required | Self::RequiredFor(_))
    }

    /// The default in words, for the documentation.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Required => "required".to_owned(),
            Self::RequiredFor(law) => format!("required for {law}"),
            Self::Number(number) => number.to_string(),
            Self::Ratios([x, y, z]) => format!("[{x}, {y}, {z}]"),
            Self::Quantity(text) | Self::Derived(text) => (*text).to_owned(),
            Self::Word(word) => format!("\"{word}\""),
            Self::Flag(flag) => flag.to_string(),
            Self::Walls([low, high]) => format!("[\"{low}\", \"{high}\"]"),
            Self::DurationOver(number) => format!("duration / {number}"),
            Self::ByLaw { usual, laws, instead } => format!("{usual}; {} {instead}", laws.join(" and ")),
            Self::Otherwise { derived, quantity } => format!("{derived}; otherwise {quantity}"),
        }
    }

    /// The number for a yield law, where it depends on the law.
    #[must_use]
    pub fn for_law(&self, law: &str) -> Option<f64> {
        match *self {
            Self::ByLaw { laws, instead, .. } if laws.contains(&law) => Some(instead),
            Self::ByLaw { usual, .. } => Some(usual),
            _ => None,
        }
    }

    /// The time for a run of this duration [s], where it is a fraction of it.
    #[must_use]
    pub fn of_duration(&self, duration: f64) -> Option<f64> {
        match *self {
            Self::DurationOver(number) => Some(duration / number),
            _ => None,
        }
    }
}
