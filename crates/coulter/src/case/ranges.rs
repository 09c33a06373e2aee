//! Ranges of allowed numbers, and the messages about numbers outside them.

use super::keys::{self, Kind};
use super::problem::Problems;
use super::typed::Section;
use solver::cpu::threads::MAX_WORKERS;

/// Which values a key allows.
pub(super) struct Allowed {
    test: fn(f64) -> bool,
    words: &'static str,
}

pub(super) const POSITIVE: Allowed = Allowed { test: |x| x > 0.0, words: "above 0" };
pub(super) const NOT_NEGATIVE: Allowed = Allowed { test: |x| x >= 0.0, words: "0 or more" };
pub(super) const BELOW_HALF: Allowed = Allowed {
    test: |x| (0.0..0.5).contains(&x),
    words: "0 or more and below 0.5 (0.5 would be incompressible)",
};
pub(super) const ACUTE: Allowed = Allowed {
    test: |x| (0.0..std::f64::consts::FRAC_PI_2).contains(&x),
    words: "0 deg or more and below 90 deg",
};
pub(super) const POSITIVE_FRACTION: Allowed =
    Allowed { test: |x| x > 0.0 && x <= 1.0, words: "above 0 and at most 1" };
pub(super) const FRACTION: Allowed = Allowed { test: |x| (0.0..=1.0).contains(&x), words: "from 0 to 1" };
pub(super) const GROWTH: Allowed = Allowed { test: |x| (1.0..=1.5).contains(&x), words: "from 1 to 1.5" };
pub(super) const SPACING: Allowed = Allowed { test: |x| (0.05..=4.0).contains(&x), words: "from 0.05 to 4" };
pub(super) const ECCENTRICITY: Allowed =
    Allowed { test: |x| x > 0.5 && x <= 1.0, words: "above 0.5 and at most 1" };
pub(super) const EXPONENT: Allowed =
    Allowed { test: |x| (0.05..=2.5).contains(&x), words: "from 0.05 to 2.5" };
pub(super) const BACKFILL: Allowed = Allowed {
    test: |x| (-10.000_001..=25.000_001).contains(&x.to_degrees()),
    words: "from -10 deg to 25 deg",
};
/// The largest number of threads is `solver::cpu::threads::MAX_WORKERS`.
pub(super) const THREADS: Allowed =
    Allowed { test: |x| x >= 0.0 && x <= MAX_WORKERS as f64, words: "from 0 to 64" };
pub(super) const ANY: Allowed = Allowed { test: |_| true, words: "any number" };

/// The number of the key, if it is given and allowed.
pub(super) fn given(section: &Section, key: &str, allowed: &Allowed, problems: &mut Problems) -> Option<f64> {
    let typed = section.number(key)?;
    if (allowed.test)(typed.value) {
        return Some(typed.value);
    }
    let message = format!("{} = {} is out of range", dotted(section, key), problems.typed(&typed.location));
    problems.add(&typed.location, message, format!("it must be {}", allowed.words));
    None
}

/// As [`given`], with a default for a key that is left out.
pub(super) fn or(
    section: &Section,
    key: &str,
    default: f64,
    allowed: &Allowed,
    problems: &mut Problems,
) -> Option<f64> {
    if section.has(key) { given(section, key, allowed, problems) } else { Some(default) }
}

/// As [`given`], for a required key.
pub(super) fn required(
    section: &Section,
    key: &str,
    allowed: &Allowed,
    problems: &mut Problems,
) -> Option<f64> {
    if !section.has(key) {
        missing(section, key, problems);
    }
    given(section, key, allowed, problems)
}

/// Reports a required key that is missing.
pub(super) fn missing(section: &Section, key: &str, problems: &mut Problems) {
    let cure = format!("add  {key} = {}  to [{}]", example(section, key), section.path);
    problems.add(&section.location, format!("`{}` is missing", dotted(section, key)), cure);
}

/// `soil.cohesion`, or `gravity` at the top.
pub(super) fn dotted(section: &Section, key: &str) -> String {
    if section.path.is_empty() { key.to_owned() } else { format!("{}.{key}", section.path) }
}

/// A low and a high end; reported if they are swapped, or missing without a default.
pub(super) fn range(
    section: &Section,
    key: &str,
    default: Option<[f64; 2]>,
    problems: &mut Problems,
) -> Option<[f64; 2]> {
    if !section.has(key) {
        if default.is_none() {
            missing(section, key, problems);
        }
        return default;
    }
    let typed = section.list(key)?;
    let (low, high) = (typed.value.first()?.value, typed.value.last()?.value);
    if low < high {
        return Some([low, high]);
    }
    let message = format!("{} is empty: its low end is not below its high end", dotted(section, key));
    problems.add(&typed.location, message, "write the lower value first");
    None
}

/// A value for the key as one would write it.
fn example(section: &Section, key: &str) -> String {
    let kind = section.path.split('.').next().unwrap_or_default();
    let known = keys::find(kind).and_then(|s| s.keys.iter().find(|k| k.name == key));
    match known.map(|k| k.kind) {
        Some(Kind::Quantity(measure)) => format!("\"{}\"", measure.example),
        Some(Kind::Choice(words)) => format!("\"{}\"", words.first().unwrap_or(&"")),
        Some(Kind::Range(measure)) => format!("[\"-{0}\", \"{0}\"]", measure.example),
        Some(Kind::Vector(measure)) => format!("[\"{0}\", \"{0}\", \"{0}\"]", measure.example),
        Some(Kind::Modulus(offset)) => format!("\"102 kN/m^(n+{offset})\""),
        Some(Kind::Flag) => "true".into(),
        _ => "0.3".into(),
    }
}
