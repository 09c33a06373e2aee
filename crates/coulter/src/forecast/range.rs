//! What is typed on the command line about a variable: `Z=0.02..0.4`, `soil.friction_angle="30 deg".."45 deg"`.

use super::setting::Setting;
use super::variable::{Variable, find, variables};
use crate::case::format::new_name;
use crate::case::keys::Kind;
use crate::case::quantity;

/// Why it cannot be read, and what would do.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Unreadable(String);

/// A variable and the values that it shall take.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// Which variable.
    pub variable: Variable,
    /// Whether it was given as Z = z/d.
    pub relative: bool,
    /// The values, in SI units.
    pub values: Vec<f64>,
}

impl Range {
    /// Reads `KEY=LOW..HIGH`: `count` values, evenly spaced, or in even ratios if `logarithmic`.
    ///
    /// # Errors
    /// [`Unreadable`] says what is wrong.
    pub fn read(text: &str, setting: &Setting, count: usize, logarithmic: bool) -> Result<Self, Unreadable> {
        let wrong = |why: &str| Unreadable(format!("--against {text}: {why}; write it such as Z=0.02..0.4"));
        let (key, ends) = text.split_once('=').ok_or_else(|| wrong("no `=`"))?;
        let key = key.trim();
        let variable = known(key, setting)?;
        let (low, high) = ends.split_once("..").ok_or_else(|| wrong("no `..` between two values"))?;
        let relative = key == "Z";
        let read = |end: &str| {
            if relative {
                let z = number(end).ok_or_else(|| wrong(&format!("`{end}` is no number")))?;
                return Ok(z * setting.towing.body.length());
            }
            value(end, &variable).map_err(|why| wrong(&why))
        };
        let (low, high) = (read(low)?, read(high)?);
        if low >= high {
            return Err(wrong("the second value must be above the first"));
        }
        if logarithmic && low <= 0.0 {
            return Err(wrong("with --log every value must be above 0"));
        }
        let last = count.max(2) - 1;
        let at = |n: usize| {
            let share = n as f64 / last as f64;
            if logarithmic { low * (high / low).powf(share) } else { low + share * (high - low) }
        };
        Ok(Self { variable, relative, values: (0..=last).map(at).collect() })
    }
}

/// The variable of that name.
pub(super) fn known(key: &str, setting: &Setting) -> Result<Variable, Unreadable> {
    if let Some(new) = new_name(key) {
        return Err(Unreadable(format!("`{key}` is now called `{new}`; write {new}")));
    }
    let Some(found) = find(key, &setting.bodies) else {
        let own = variables().iter().filter(|v| v.belongs(setting));
        let names = own.map(|v| v.dotted(setting)).collect::<Vec<_>>().join(", ");
        return Err(Unreadable(format!("the models have no `{key}` to change; possible: Z, {names}")));
    };
    if !found.belongs(setting) {
        let kind = setting.kind;
        return Err(Unreadable(format!("{key}: no model of a {kind} here asks for it")));
    }
    if found.has_effect(setting) {
        return Ok(found);
    }
    let cure = "give it some: terrain = \"LETE sand\" in [forecast], or another published soil";
    Err(Unreadable(format!("{key}: the case has no plate constants; {cure}")))
}

/// A value of the variable, in SI units.
pub(super) fn value(text: &str, variable: &Variable) -> Result<f64, String> {
    let text = text.trim().trim_matches(['"', '\'']).trim();
    match variable.kind {
        Kind::Quantity(measure) => quantity::parse(text, &measure).map_err(|e| e.to_string()),
        Kind::Modulus(offset) => quantity::parse_modulus(text, offset).map_err(|e| e.to_string()),
        _ => number(text).ok_or_else(|| format!("`{text}` is no number")),
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().trim_matches(['"', '\'']).trim().parse().ok().filter(|x: &f64| x.is_finite())
}
