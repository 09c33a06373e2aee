//! Text with a unit → a number in SI units. The only module that uses units other than SI.
//!
//! Grammar: a number, then symbols joined by `*`, `·`, a space or `/` (which divides by the one symbol that
//! follows), each with an optional whole exponent: `16 kN/m^3`, `35 deg`, `2 N*m`, `9.81 m/s²`.

use super::units;
pub use super::units::{Dimension, QuantityError};

/// A measurable quantity: its name in messages, its dimension and an example.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measure {
    /// Name of the measure with the article: `a length`.
    pub name: &'static str,
    /// Dimension of the measure.
    pub dimension: Dimension,
    /// Unit in which the quantity is shown: that of the SI, degrees for an angle.
    pub unit: &'static str,
    /// A value as one would write it.
    pub example: &'static str,
}

const fn measure(
    name: &'static str,
    exponents: [i32; 4],
    unit: &'static str,
    example: &'static str,
) -> Measure {
    Measure { name, dimension: Dimension(exponents), unit, example }
}

/// A length [m].
pub const LENGTH: Measure = measure("a length", [1, 0, 0, 0], "m", "12.5 mm");
/// A mass [kg].
pub const MASS: Measure = measure("a mass", [0, 1, 0, 0], "kg", "4 kg");
/// A time [s].
pub const TIME: Measure = measure("a time", [0, 0, 1, 0], "s", "0.3 s");
/// An angle [rad].
pub const ANGLE: Measure = measure("an angle", [0, 0, 0, 1], "deg", "35 deg");
/// A frequency [Hz].
pub const FREQUENCY: Measure = measure("a frequency", [0, 0, -1, 0], "Hz", "10 Hz");
/// A speed [m/s].
pub const SPEED: Measure = measure("a speed", [1, 0, -1, 0], "m/s", "0.2 m/s");
/// An acceleration [m/s²].
pub const ACCELERATION: Measure = measure("an acceleration", [1, 0, -2, 0], "m/s^2", "9.81 m/s^2");
/// A rate of turning [rad/s].
pub const TURN_RATE: Measure = measure("a rate of turning", [0, 0, -1, 1], "rad/s", "3 rad/s");
/// A density [kg/m³].
pub const DENSITY: Measure = measure("a density", [-3, 1, 0, 0], "kg/m^3", "1600 kg/m^3");
/// A force [N].
pub const FORCE: Measure = measure("a force", [1, 1, -2, 0], "N", "40 N");
/// A torque [N m].
pub const TORQUE: Measure = measure("a torque", [2, 1, -2, 0], "N*m", "2 N*m");
/// A stress [Pa].
pub const STRESS: Measure = measure("a stress", [-1, 1, -2, 0], "Pa", "5 MPa");
/// A unit weight [N/m³].
pub const UNIT_WEIGHT: Measure = measure("a unit weight", [-2, 1, -2, 0], "N/m^3", "16 kN/m^3");
/// A growth of strength with depth [Pa/m].
pub const STRENGTH_GRADIENT: Measure =
    measure("a growth of strength with depth", [-2, 1, -2, 0], "Pa/m", "1.5 kPa/m");
/// A growth of relative density with depth [1/m].
pub const DENSITY_GRADIENT: Measure =
    measure("a growth of relative density with depth", [-1, 0, 0, 0], "1/m", "0.5 1/m");
/// A stiffness [N/m].
pub const STIFFNESS: Measure = measure("a stiffness", [0, 1, -2, 0], "N/m", "20 kN/m");
/// A damping coefficient [N s/m].
pub const DAMPING: Measure = measure("a damping coefficient", [0, 1, -1, 0], "N*s/m", "50 N*s/m");
/// A resistance per speed and area [N s/m³].
pub const RATE_RESISTANCE: Measure =
    measure("a resistance per speed and area", [-2, 1, -1, 0], "N*s/m^3", "200 kN*s/m^3");
/// A moment of inertia [kg m²].
pub const INERTIA: Measure = measure("a moment of inertia", [2, 1, 0, 0], "kg*m^2", "0.02 kg*m^2");

/// Every measure that has a name, to name a wrong one.
const NAMED: [Measure; 14] = [
    LENGTH,
    MASS,
    TIME,
    ANGLE,
    SPEED,
    ACCELERATION,
    TURN_RATE,
    DENSITY,
    FORCE,
    TORQUE,
    STRESS,
    UNIT_WEIGHT,
    INERTIA,
    FREQUENCY,
];

/// Reads `text` as `measure`; the value in SI units.
///
/// # Errors
/// [`QuantityError`] says what is wrong and, where possible, what was meant.
pub fn parse(text: &str, measure: &Measure) -> Result<f64, QuantityError> {
    let (value, dimension) = parse_any(text).map_err(|error| sensible(error, text, measure))?;
    if dimension == measure.dimension {
        return Ok(value);
    }
    let text = text.trim();
    let meant = split_number(text).1.trim().replace("kn", "kN");
    let meant = units::parse(&meant).is_ok_and(|(_, of)| of == measure.dimension).then_some(meant);
    let (text, found) = (text.to_owned(), describe(dimension));
    Err(QuantityError::WrongDimension { text, found, needed: measure.name, meant })
}

/// The error without a suggestion that leads astray: a unit that stands alone is like one of the same
/// measure, or like none.
fn sensible(error: QuantityError, text: &str, measure: &Measure) -> QuantityError {
    match error {
        QuantityError::UnknownUnit { unit, .. } if split_number(text.trim()).1.trim() == unit => {
            let nearest = units::nearest_of(&unit, measure.dimension).map(str::to_owned);
            QuantityError::UnknownUnit { unit, nearest }
        }
        other => other,
    }
}

/// How many SI units of a measure a unit is; what is wrong with it in words. A mass in place of a force, as
/// scales and old gauges show it, is named.
///
/// # Errors
/// In words, without a cure.
pub fn unit_size(unit: &str, measure: &Measure) -> Result<f64, String> {
    let text = format!("1 {unit}");
    let (size, dimension) = parse_any(&text).map_err(|error| sensible(error, &text, measure).to_string())?;
    if dimension == measure.dimension && size > 0.0 {
        return Ok(size);
    }
    let mut per_acceleration = measure.dimension;
    per_acceleration.0[0] -= 1;
    per_acceleration.0[2] += 2;
    let of_mass = dimension == per_acceleration;
    let hint = if of_mass {
        ": it has a mass where a force belongs; of forces write kgf, gf, tf or lbf"
    } else {
        ""
    };
    Err(format!("[{unit}] is not a unit of {}{hint}", measure.name))
}

/// Reads `text` as a quantity of any dimension; the value in SI units.
///
/// # Errors
/// [`QuantityError`] where the text is not a number with a known unit.
pub fn parse_any(text: &str) -> Result<(f64, Dimension), QuantityError> {
    let text = text.trim();
    let owned = || text.to_owned();
    let (number, unit) = split_number(text);
    let digits: String =
        number.chars().filter(|c| *c != '_').map(|c| if c == '−' { '-' } else { c }).collect();
    let value: f64 = digits.parse().map_err(|_| QuantityError::NoNumber { text: owned() })?;
    if unit.trim().is_empty() {
        return Err(QuantityError::NoUnit { text: owned() });
    }
    let (factor, dimension) = units::parse(unit.trim())?;
    let value = value * factor;
    if value.is_finite() { Ok((value, dimension)) } else { Err(QuantityError::NotFinite { text: owned() }) }
}

/// Reads one of Bekker's moduli, whose unit contains the sinkage exponent n: `102 kN/m^(n+1)`, or `102
/// kPa/m^(n-1)`. `offset` is i in N/m^(n+i); the value is in that unit, for any n.
///
/// # Errors
/// [`QuantityError`] says what is wrong.
pub fn parse_modulus(text: &str, offset: i32) -> Result<f64, QuantityError> {
    let (number, unit) = split_number(text.trim());
    if unit.trim().is_empty() {
        return parse_any(text).map(|(value, _)| value);
    }
    let malformed = |why| QuantityError::Malformed { unit: unit.trim().to_owned(), why };
    let whole = "the exponent must contain n, as in kN/m^(n+1)";
    let (load, power) = unit.split_once("/m^").ok_or_else(|| malformed(whole))?;
    let (value, dimension) = parse_any(&format!("{number} {load}"))?;
    // N/m² over m^(n+i-2) is N over m^(n+i).
    let folded = match dimension {
        _ if dimension == FORCE.dimension => 0,
        _ if dimension == STRESS.dimension => 2,
        _ => return Err(malformed("a force or a stress is needed before /m^")),
    };
    let power: String = power.chars().filter(|c| !c.is_whitespace() && !"()".contains(*c)).collect();
    let beyond_n = power.strip_prefix('n').ok_or_else(|| malformed(whole))?.replace('−', "-");
    let beyond_n: i32 =
        if beyond_n.is_empty() { 0 } else { beyond_n.parse().map_err(|_| malformed(whole))? };
    if beyond_n + folded == offset {
        Ok(value)
    } else {
        Err(malformed(if offset == 1 { "k_c is in N/m^(n+1)" } else { "k_φ is in N/m^(n+2)" }))
    }
}

/// Names a dimension: `a length`, or `a quantity in m^2 kg s^-1` where it has no name.
#[must_use]
pub fn describe(dimension: Dimension) -> String {
    match NAMED.iter().find(|m| m.dimension == dimension) {
        Some(measure) => measure.name.to_owned(),
        None => format!("a quantity in {dimension}"),
    }
}

/// Splits `12.5e-3 mm` after the number; an `e` belongs to it only when an exponent follows.
#[must_use]
pub fn split_number(text: &str) -> (&str, &str) {
    let bytes: Vec<(usize, char)> = text.char_indices().collect();
    let at = |n: usize| bytes.get(n).map(|(_, c)| *c);
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let is_sign = |c: Option<char>| matches!(c, Some('+' | '-' | '−'));
    let mut n = usize::from(is_sign(at(0)));
    while is_digit(at(n)) || matches!(at(n), Some('.' | '_')) {
        n += 1;
    }
    if matches!(at(n), Some('e' | 'E')) {
        let first_digit = n + 1 + usize::from(is_sign(at(n + 1)));
        if is_digit(at(first_digit)) {
            n = first_digit;
            while is_digit(at(n)) {
                n += 1;
            }
        }
    }
    text.split_at(bytes.get(n).map_or(text.len(), |(index, _)| *index))
}

/// A number for display, in seven digits and without rounding noise: `0.35`, not `0.35000000000000003`.
#[must_use]
pub fn plain(number: f64) -> String {
    format!("{number:.6e}").parse::<f64>().unwrap_or(number).to_string()
}

/// A number as people read it: up to four significant digits, without zeros that say nothing, `32` and not
/// `32.0000`; a dash where it is not finite.
#[must_use]
pub fn short(number: f64) -> String {
    if !number.is_finite() {
        return "–".to_owned();
    }
    let rounded: f64 = format!("{number:.3e}").parse().unwrap_or(number);
    let size = rounded.abs();
    // Adding zero turns a negative zero into a positive one.
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        format!("{rounded:e}")
    } else {
        format!("{}", rounded + 0.0)
    }
}

/// A stress [Pa] as people read it, in a unit that fits, with up to four significant digits.
#[must_use]
pub fn short_stress(stress: f64) -> String {
    let (size, unit) = match stress.abs() {
        1e9.. => (1e9, "GPa"),
        1e6.. => (1e6, "MPa"),
        1e3.. => (1e3, "kPa"),
        _ => (1.0, "Pa"),
    };
    format!("{} {unit}", short(stress / size))
}

/// A number in SI units for display, in the unit of its measure: `90 deg`.
#[must_use]
pub fn with_unit(number: f64, measure: &Measure) -> String {
    // The unit of every measure can be read: a test reads them all.
    let size = units::parse(measure.unit).map_or(1.0, |(size, _)| size);
    format!("{} {}", plain(number / size), measure.unit)
}

#[cfg(test)]
mod tests {
    #[test]
    fn numbers_have_the_digits_that_people_read() {
        let texts =
            [32.000_000_000_000_01, 0.123_456, -1e-9, -0.0, f64::NAN, 14_400.0, 2.0e7].map(super::short);
        assert_eq!(texts, ["32", "0.1235", "-1e-9", "0", "–", "14400", "2e7"]);
    }

    #[test]
    fn every_measure_is_shown_in_its_unit() {
        for measure in super::NAMED {
            let text = super::with_unit(0.5, &measure);
            let value = super::parse(&text, &measure).unwrap();
            assert!((value - 0.5).abs() < 1e-6, "{text}: {value}");
        }
        let right = std::f64::consts::FRAC_PI_2;
        assert_eq!(super::with_unit(right, &super::ANGLE), "90 deg");
    }

    #[test]
    fn displayed_numbers_have_no_rounding_noise() {
        let shown =
            [0.350_000_000_000_000_03, -0.1, 1e-9, 0.1 + 0.2, 1234.5, f64::INFINITY].map(super::plain);
        assert_eq!(shown, ["0.35", "-0.1", "0.000000001", "0.3", "1234.5", "inf"]);
    }

    use super::*;
    use proptest::prelude::*;

    fn close(text: &str, measure: &Measure, expected: f64) {
        let value = parse(text, measure).unwrap();
        assert!((value - expected).abs() <= 1e-12 * expected.abs(), "{text}: {value} ≠ {expected}");
    }

    #[test]
    fn reads_what_people_type() {
        close("16 kN/m^3", &UNIT_WEIGHT, 16e3);
        close("16 kN/m3", &UNIT_WEIGHT, 16e3);
        close("16kN/m³", &UNIT_WEIGHT, 16e3);
        close("35 deg", &ANGLE, 35f64.to_radians());
        close("35°", &ANGLE, 35f64.to_radians());
        close("0.2 m/s", &SPEED, 0.2);
        close("7.2 km/h", &SPEED, 2.0);
        close("12.5 mm", &LENGTH, 0.0125);
        close("12.5 µm", &LENGTH, 12.5e-6);
        close("12.5 um", &LENGTH, 12.5e-6);
        close("5 MPa", &STRESS, 5e6);
        close("5e6 N/m^2", &STRESS, 5e6);
        close("1.2e-3 GPa", &STRESS, 1.2e6);
        close("40 N", &FORCE, 40.0);
        close("4 kg", &MASS, 4.0);
        close("0.5 t", &MASS, 500.0);
        close("1600 kg/m^3", &DENSITY, 1600.0);
        close("3 rad/s", &TURN_RATE, 3.0);
        close("60 rpm", &TURN_RATE, std::f64::consts::TAU);
        close("2 N*m", &TORQUE, 2.0);
        close("2 N m", &TORQUE, 2.0);
        close("2 N·m", &TORQUE, 2.0);
        close("0.02 kg*m^2", &INERTIA, 0.02);
        close("-300 ms", &TIME, -0.3);
        close("−300 ms", &TIME, -0.3);
        close("2 min", &TIME, 120.0);
        close("9.81 m/s²", &ACCELERATION, 9.81);
        close("9.81 m s^-2", &ACCELERATION, 9.81);
        close("1000 mm", &LENGTH, 1.0);
        for (text, newtons) in [("1 lbf", 4.4482216152605), ("1 kgf", 9.80665), ("2 tf", 19613.3)] {
            close(text, &FORCE, newtons);
        }
        close("1 psi", &STRESS, 6894.757293168361);
        close("1 ksf", &STRESS, 47880.25898033584);
        close("1 kgf/cm^2", &STRESS, 98066.5);
        close("3 kN/m²", &STRESS, 3e3);
        close("3 N/mm²", &STRESS, 3e6);
        close("10 mph", &SPEED, 4.4704);
        close("4 kn", &SPEED, 4.0 * 1852.0 / 3600.0);
        close("1 knot", &SPEED, 1852.0 / 3600.0);
        close("2 kNm", &TORQUE, 2e3);
        close("0 deg", &ANGLE, 0.0);
    }

    #[test]
    fn reads_moduli_with_the_exponent_in_their_unit() {
        for (text, offset, expected) in [
            ("102 kN/m^(n+1)", 1, 102e3),
            ("5301 kN/m^(n+2)", 2, 5301e3),
            ("5301 kPa/m^n", 2, 5301e3),
            ("102 kPa/m^(n-1)", 1, 102e3),
            ("0.99kN/m^(n + 1)", 1, 990.0),
            ("8 MN/m^n+2", 2, 8e6),
        ] {
            let value = parse_modulus(text, offset).unwrap();
            assert!((value / expected - 1.0).abs() < 1e-12, "{text}: {value}");
        }
        for text in
            ["102 kN/m^(n+2)", "102 kN/m^2", "102 kN", "102", "kN/m^(n+1)", "102 m/m^(n+1)", "nan kN/m^(n+1)"]
        {
            assert!(parse_modulus(text, 1).is_err(), "{text}");
        }
    }

    #[test]
    fn says_what_is_wrong() {
        let complaint = |text: &str, measure: &Measure| parse(text, measure).unwrap_err().to_string();
        assert!(complaint("16 kN/mm", &UNIT_WEIGHT).contains("a unit weight is needed"));
        assert!(complaint("5 MPa", &LENGTH).contains("is a stress, but a length is needed"));
        assert!(complaint("5 m^7", &LENGTH).contains("a quantity in m^7"));
        assert!(complaint("5", &LENGTH).contains("no unit"));
        assert!(complaint("5 kPaa", &STRESS).contains("did you mean `kPa`?"));
        assert!(complaint("5 kn", &FORCE).contains("did you mean `kN`?"));
        assert!(complaint("16 kn/m^3", &UNIT_WEIGHT).contains("did you mean `kN/m^3`?"));
        assert!(complaint("5 kgff", &FORCE).contains("did you mean `kgf`?"));
        assert!(!complaint("5 kgg", &FORCE).contains("`kg`"));
        assert!(unit_size("kg/cm^2", &STRESS).unwrap_err().contains("a mass where a force belongs"));
        assert!(complaint("", &LENGTH).contains("number"));
        assert!(complaint("nan m", &LENGTH).contains("number"));
        assert!(complaint("inf m", &LENGTH).contains("number"));
        assert!(complaint("1e999 m", &LENGTH).contains("finite"));
        assert!(complaint("1e308 km", &LENGTH).contains("finite"));
        assert!(complaint("12,5 mm", &LENGTH).contains("decimal point"));
        assert!(complaint("5 m/", &LENGTH).contains("symbol"));
        assert!(complaint("5 m^99", &LENGTH).contains("exponent"));
        assert!(complaint("5 m^^2", &LENGTH).contains("exponent"));
    }

    proptest! {
        #[test]
        fn never_panics(text in "\\PC{0,24}") {
            let _ = parse_any(&text);
        }

        #[test]
        fn never_panics_near_the_grammar(text in "[-+−0-9._eE]{0,6} ?[a-zA-Zµ°/*^·² 0-9()-]{0,10}") {
            if let Ok((value, _)) = parse_any(&text) {
                prop_assert!(value.is_finite());
            }
        }

        #[test]
        fn reads_back_any_number(value in -1e30f64..1e30) {
            prop_assert_eq!(parse(&format!("{value:e} m"), &LENGTH), Ok(value));
            let thousand = parse(&format!("{value} kPa"), &STRESS).unwrap();
            prop_assert!((thousand - 1e3 * value).abs() <= 1e-9 * value.abs());
        }

        #[test]
        fn product_and_quotient_cancel(a in 0usize..8, b in 0usize..8) {
            let symbols = ["m", "kg", "s", "rad", "N", "kPa", "mm", "J"];
            let (a, b) = (symbols[a], symbols[b]);
            let (value, dimension) = parse_any(&format!("3 {a}*{b}/{b}")).unwrap();
            let (same, expected) = parse_any(&format!("3 {a}")).unwrap();
            prop_assert_eq!(dimension, expected);
            prop_assert!((value - same).abs() < 1e-12 * same.abs());
        }
    }
}
