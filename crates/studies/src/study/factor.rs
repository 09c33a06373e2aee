//! A factor: what is varied, its levels and its range.

use coulter::case::form::Value;
use coulter::case::quantity::{self, Dimension};

/// A level of a factor.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// The value as TOML: `"30 deg"` with its quotes, `0.3`, `true`.
    pub toml: String,
    /// The number in the unit of the factor; `None` for a word.
    pub number: Option<f64>,
    /// The value as it is shown: `30 deg`.
    pub shown: String,
}

/// The unit of the numbers of a factor.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// The unit as typed: `deg`; `-` for plain numbers.
    pub symbol: String,
    /// Size of the unit in SI units, and what it measures; `None` for a unit that depends on another key,
    /// such as kN/m^(n+1).
    pub size: Option<(f64, Dimension)>,
}

impl Unit {
    /// The unit of plain numbers.
    #[must_use]
    pub fn none() -> Self {
        Self { symbol: "-".to_owned(), size: Some((1.0, Dimension([0; 4]))) }
    }

    /// Whether numbers are written without the unit.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.symbol == "-"
    }

    fn of(symbol: &str) -> Self {
        Self { symbol: symbol.to_owned(), size: quantity::parse_any(&format!("1 {symbol}")).ok() }
    }
}

/// A factor.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// Name of the factor, that of its column.
    pub name: String,
    /// The key of the case; `None` for one that is used in formulas only.
    pub key: Option<String>,
    /// Name of the factor in charts.
    pub label: String,
    /// Unit of the numbers of the factor; `None` for words.
    pub unit: Option<Unit>,
    /// Levels of the factor.
    pub levels: Vec<Level>,
    /// Range of the factor in its unit; `None` for words.
    pub range: Option<[f64; 2]>,
    /// Whether levels and points are spread over the range by their logarithms.
    pub logarithmic: bool,
}

/// A value as TOML.
#[must_use]
pub(super) fn toml_of(value: &Value) -> String {
    match value {
        Value::Text(text) => toml::Value::String(text.clone()).to_string(),
        Value::Integer(number) => number.to_string(),
        Value::Number(number) => toml::Value::Float(*number).to_string(),
        Value::Flag(flag) => flag.to_string(),
        Value::List(items) => format!("[{}]", items.iter().map(toml_of).collect::<Vec<_>>().join(", ")),
        Value::Table(entries) => {
            let one = |e: &coulter::case::form::Entry| {
                let key = toml::Value::String(e.key.clone());
                format!("{key} = {}", toml_of(&e.value))
            };
            format!("{{ {} }}", entries.iter().map(one).collect::<Vec<_>>().join(", "))
        }
        Value::Other(_) => String::new(),
    }
}

/// A value as it is shown.
#[must_use]
pub(super) fn shown(value: &Value) -> String {
    if let Value::Text(text) = value { text.clone() } else { toml_of(value) }
}

/// The number of a value and its unit; `None` for a word.
fn number_of(value: &Value) -> Option<(f64, Unit)> {
    match value {
        Value::Integer(number) => Some((*number as f64, Unit::none())),
        Value::Number(number) => Some((*number, Unit::none())),
        Value::Text(text) => {
            let (number, unit) = quantity::split_number(text.trim());
            let digits: String =
                number.chars().filter(|c| *c != '_').map(|c| if c == '−' { '-' } else { c }).collect();
            let number = digits.parse().ok()?;
            let unit = unit.trim();
            (!unit.is_empty()).then(|| (number, Unit::of(unit)))
        }
        _ => None,
    }
}

/// The unit of the first of some values, and all of them in it; `None` where one is a word, or of another
/// dimension.
#[must_use]
pub(super) fn numbers_of(values: &[Value]) -> Option<(Unit, Vec<f64>)> {
    let read: Vec<(f64, Unit)> = values.iter().map(number_of).collect::<Option<_>>()?;
    let unit = read.first()?.1.clone();
    let converted = read.iter().map(|(number, own)| match (own.size, unit.size) {
        _ if own.symbol == unit.symbol => Some(*number),
        (Some((own_size, own_dimension)), Some((size, dimension))) if own_dimension == dimension => {
            Some(number * own_size / size)
        }
        _ => None,
    });
    let numbers = converted.collect::<Option<Vec<f64>>>()?;
    numbers.iter().all(|number| number.is_finite()).then_some((unit, numbers))
}

impl Factor {
    /// The level of a number in the unit of the factor.
    #[must_use]
    pub fn level(&self, number: f64) -> Level {
        let unit = self.unit.as_ref().filter(|unit| !unit.is_none());
        match unit {
            Some(unit) => {
                let shown = format!("{number} {}", unit.symbol);
                Level { toml: format!("\"{shown}\""), number: Some(number), shown }
            }
            None => Level { toml: number.to_string(), number: Some(number), shown: number.to_string() },
        }
    }

    /// The level of a value as typed.
    #[must_use]
    pub fn level_of(value: &Value, number: Option<f64>) -> Level {
        Level { toml: toml_of(value), number, shown: shown(value) }
    }

    /// The number at a fraction of the range, 0 to 1; `None` for words.
    #[must_use]
    pub fn at(&self, fraction: f64) -> Option<f64> {
        let [low, high] = self.range?;
        let number = if self.logarithmic {
            (low.ln() + fraction * (high.ln() - low.ln())).exp()
        } else {
            low + fraction * (high - low)
        };
        Some(number.clamp(low.min(high), low.max(high)))
    }

    /// Level of the factor at a value of its key; of another unit or dimension than its own there is none.
    pub(super) fn own_level(&self, value: &Value) -> Option<Level> {
        let Some(unit) = self.unit.as_ref() else { return Some(Self::level_of(value, None)) };
        let (own, numbers) = numbers_of(std::slice::from_ref(value))?;
        let number = match (own.size, unit.size) {
            _ if own.symbol == unit.symbol => numbers[0],
            (Some((a, x)), Some((b, y))) if x == y => numbers[0] * a / b,
            _ => return None,
        };
        Some(Self::level_of(value, Some(number)))
    }
}
