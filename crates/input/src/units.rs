//! Unit symbols: their size in SI units and their dimension.

use super::names::nearest;

/// Exponents of length, mass, time and angle. The angle is a dimension of its own, so that a bare number is
/// not one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension(pub [i32; 4]);

impl std::fmt::Display for Dimension {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let factors: Vec<String> = ["m", "kg", "s", "rad"]
            .iter()
            .zip(self.0)
            .filter(|(_, exponent)| *exponent != 0)
            .map(
                |(symbol, exponent)| {
                    if exponent == 1 { (*symbol).into() } else { format!("{symbol}^{exponent}") }
                },
            )
            .collect();
        f.write_str(if factors.is_empty() { "no unit" } else { "" })?;
        f.write_str(&factors.join(" "))
    }
}

/// What is wrong with a quantity.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum QuantityError {
    /// There is no number at the start.
    #[error("`{text}` does not start with a number")]
    NoNumber {
        /// What was typed.
        text: String,
    },
    /// Infinite, or too large to be represented.
    #[error("`{text}` is not a finite number")]
    NotFinite {
        /// What was typed.
        text: String,
    },
    /// A number and nothing else.
    #[error("`{text}` has no unit")]
    NoUnit {
        /// What was typed.
        text: String,
    },
    /// A symbol that is not known.
    #[error("unknown unit `{unit}`{}", nearest.as_ref().map_or(String::new(), |n| format!("; did you mean `{n}`?")))]
    UnknownUnit {
        /// The symbol.
        unit: String,
        /// The nearest symbol that is known.
        nearest: Option<String>,
    },
    /// The unit does not follow the grammar.
    #[error("cannot read the unit `{unit}`: {why}")]
    Malformed {
        /// The text after the number.
        unit: String,
        /// What is wrong with the unit.
        why: &'static str,
    },
    /// A unit, but of something else.
    #[error("`{text}` is {found}, but {needed} is needed{}", meant.as_ref().map_or(String::new(), |n| format!("; did you mean `{n}`?")))]
    WrongDimension {
        /// What was typed.
        text: String,
        /// What the unit measures.
        found: String,
        /// What quantity is needed.
        needed: &'static str,
        /// The unit with kilonewtons for knots, where that is one of what is needed.
        meant: Option<String>,
    },
}

struct Unit {
    symbol: &'static str,
    factor: f64,
    dimension: [i32; 4],
    prefixes: bool,
}

const fn unit(symbol: &'static str, factor: f64, dimension: [i32; 4], prefixes: bool) -> Unit {
    Unit { symbol, factor, dimension, prefixes }
}

/// Standard gravity [m/s²] by definition (3rd General Conference on Weights and Measures, 1901), and the
/// avoirdupois pound [kg] (international agreement of 1959): what units of force and pressure of both kinds
/// are made of.
const STANDARD_GRAVITY: f64 = 9.80665;
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = POUND * STANDARD_GRAVITY;
const FOOT: f64 = 0.3048;
const INCH: f64 = 0.0254;
/// A nautical mile, 1852 m (International Hydrographic Conference, 1929), an hour.
const KNOT: f64 = 1852.0 / 3600.0;
const FORCE: [i32; 4] = [1, 1, -2, 0];
const PRESSURE: [i32; 4] = [-1, 1, -2, 0];
const TORQUE: [i32; 4] = [2, 1, -2, 0];

const UNITS: [Unit; 48] = [
    unit("m", 1.0, [1, 0, 0, 0], true),
    unit("in", INCH, [1, 0, 0, 0], false),
    unit("inch", INCH, [1, 0, 0, 0], false),
    unit("ft", FOOT, [1, 0, 0, 0], false),
    unit("yd", 3.0 * FOOT, [1, 0, 0, 0], false),
    unit("mi", 5280.0 * FOOT, [1, 0, 0, 0], false),
    unit("g", 1e-3, [0, 1, 0, 0], true),
    unit("lb", POUND, [0, 1, 0, 0], false),
    unit("s", 1.0, [0, 0, 1, 0], true),
    unit("sec", 1.0, [0, 0, 1, 0], false),
    unit("rad", 1.0, [0, 0, 0, 1], true),
    unit("N", 1.0, FORCE, true),
    unit("gf", 1e-3 * STANDARD_GRAVITY, FORCE, false),
    unit("kgf", STANDARD_GRAVITY, FORCE, false),
    unit("kp", STANDARD_GRAVITY, FORCE, false),
    unit("tf", 1e3 * STANDARD_GRAVITY, FORCE, false),
    unit("lbf", POUND_FORCE, FORCE, false),
    unit("kip", 1e3 * POUND_FORCE, FORCE, false),
    unit("Pa", 1.0, PRESSURE, true),
    unit("bar", 1e5, PRESSURE, true),
    unit("atm", 101_325.0, PRESSURE, false),
    unit("psi", POUND_FORCE / (INCH * INCH), PRESSURE, false),
    unit("ksi", 1e3 * POUND_FORCE / (INCH * INCH), PRESSURE, false),
    unit("psf", POUND_FORCE / (FOOT * FOOT), PRESSURE, false),
    unit("ksf", 1e3 * POUND_FORCE / (FOOT * FOOT), PRESSURE, false),
    unit("tsf", 2e3 * POUND_FORCE / (FOOT * FOOT), PRESSURE, false),
    unit("Nm", 1.0, TORQUE, true),
    unit("Ncm", 1e-2, TORQUE, false),
    unit("Nmm", 1e-3, TORQUE, false),
    unit("J", 1.0, [2, 1, -2, 0], true),
    unit("W", 1.0, [2, 1, -3, 0], true),
    unit("t", 1e3, [0, 1, 0, 0], false),
    unit("min", 60.0, [0, 0, 1, 0], false),
    unit("h", 3600.0, [0, 0, 1, 0], false),
    unit("hr", 3600.0, [0, 0, 1, 0], false),
    unit("mph", 5280.0 * FOOT / 3600.0, [1, 0, -1, 0], false),
    unit("kph", 1.0 / 3.6, [1, 0, -1, 0], false),
    unit("kn", KNOT, [1, 0, -1, 0], false),
    unit("knot", KNOT, [1, 0, -1, 0], false),
    unit("knots", KNOT, [1, 0, -1, 0], false),
    unit("deg", std::f64::consts::PI / 180.0, [0, 0, 0, 1], false),
    unit("°", std::f64::consts::PI / 180.0, [0, 0, 0, 1], false),
    unit("rev", std::f64::consts::TAU, [0, 0, 0, 1], false),
    unit("rpm", std::f64::consts::TAU / 60.0, [0, 0, -1, 1], false),
    unit("rps", std::f64::consts::TAU, [0, 0, -1, 1], false),
    unit("dps", std::f64::consts::PI / 180.0, [0, 0, -1, 1], false),
    unit("Hz", 1.0, [0, 0, -1, 0], true),
    unit("1", 1.0, [0, 0, 0, 0], false),
];

const PREFIXES: [(&str, f64); 11] = [
    ("n", 1e-9),
    ("µ", 1e-6), // U+00B5, the micro sign
    ("μ", 1e-6), // U+03BC, the Greek letter
    ("u", 1e-6),
    ("m", 1e-3),
    ("c", 1e-2),
    ("d", 1e-1),
    ("h", 1e2),
    ("k", 1e3),
    ("M", 1e6),
    ("G", 1e9),
];

/// Symbols that are suggested when an unknown one is similar.
const COMMON: [&str; 35] = [
    "m", "mm", "cm", "km", "µm", "in", "ft", "kg", "g", "t", "lb", "s", "ms", "min", "h", "rad", "deg", "N",
    "kN", "MN", "kgf", "lbf", "Pa", "kPa", "MPa", "GPa", "bar", "psi", "J", "kJ", "Nm", "rpm", "rev", "Hz",
    "mph",
];

/// The symbol most like an unknown one, of those of a dimension.
pub(super) fn nearest_of(symbol: &str, dimension: Dimension) -> Option<&'static str> {
    let fits = |known: &&str| parse(known).is_ok_and(|(_, of_known)| of_known == dimension);
    nearest(symbol, COMMON.into_iter().filter(fits))
}

/// Largest exponent that makes sense; a larger one is a typing error.
const EXPONENT_LIMIT: i32 = 9;

/// Reads a unit such as `kN/m^3`: its size in SI units and its dimension.
pub(super) fn parse(text: &str) -> Result<(f64, Dimension), QuantityError> {
    let malformed = |why| QuantityError::Malformed { unit: text.to_owned(), why };
    if text.starts_with(',') {
        return Err(malformed("write a decimal point, not a comma"));
    }
    let (mut factor, mut dimension) = (1.0, [0i32; 4]);
    let mut rest = text;
    let mut sign = 1;
    loop {
        let (symbol, exponent, remainder) = split_factor(rest).map_err(malformed)?;
        let (size, exponents) = look_up(symbol)?;
        factor *= size.powi(sign * exponent);
        for (sum, one) in dimension.iter_mut().zip(exponents) {
            *sum += sign * exponent * one;
        }
        rest = remainder.trim_start();
        let Some(separator) = rest.chars().next() else { return Ok((factor, Dimension(dimension))) };
        sign = if separator == '/' { -1 } else { 1 };
        if matches!(separator, '/' | '*' | '·') {
            rest = rest[separator.len_utf8()..].trim_start();
        } else if rest.len() == remainder.len() {
            return Err(malformed("join symbols with `*`, `/` or a space, and write powers as `^3`"));
        }
    }
}

/// The first symbol of `text`, its exponent, and what follows.
fn split_factor(text: &str) -> Result<(&str, i32, &str), &'static str> {
    let is_symbol = |c: char| c.is_alphabetic() || c == '°';
    let end = if text.starts_with('1') { 1 } else { text.find(|c| !is_symbol(c)).unwrap_or(text.len()) };
    let (symbol, behind) = text.split_at(end);
    if symbol.is_empty() {
        return Err("a symbol such as `m` or `kN` is missing (no parentheses)");
    }
    for (mark, exponent) in [('²', 2), ('³', 3)] {
        if let Some(rest) = behind.strip_prefix(mark) {
            return Ok((symbol, exponent, rest));
        }
    }
    let (powered, caret) = behind.strip_prefix('^').map_or((behind, false), |rest| (rest, true));
    let sign_end = usize::from(caret && powered.starts_with('-'));
    let digits = powered[sign_end..].find(|c: char| !c.is_ascii_digit()).unwrap_or(powered.len() - sign_end);
    if digits == 0 {
        return if caret { Err("a whole exponent must follow `^`") } else { Ok((symbol, 1, behind)) };
    }
    let (exponent, rest) = powered.split_at(sign_end + digits);
    match exponent.parse::<i32>() {
        Ok(exponent) if exponent.abs() <= EXPONENT_LIMIT => Ok((symbol, exponent, rest)),
        _ => Err("the exponent is too large"),
    }
}

/// Size and dimension of one symbol, with or without a prefix.
fn look_up(symbol: &str) -> Result<(f64, [i32; 4]), QuantityError> {
    if let Some(unit) = UNITS.iter().find(|u| u.symbol == symbol) {
        return Ok((unit.factor, unit.dimension));
    }
    for (prefix, size) in PREFIXES {
        let base = symbol.strip_prefix(prefix);
        if let Some(unit) = UNITS.iter().find(|u| u.prefixes && Some(u.symbol) == base) {
            return Ok((size * unit.factor, unit.dimension));
        }
    }
    Err(QuantityError::UnknownUnit {
        unit: symbol.to_owned(),
        nearest: nearest(symbol, COMMON.iter().copied()).map(str::to_owned),
    })
}
