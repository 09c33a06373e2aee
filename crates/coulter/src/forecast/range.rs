//! Variables and their values as typed on the command line: `Z=0.02..0.4`, `soil.friction_angle="30 deg".."45
//! deg"`.

use super::model_input::ModelInput;
use super::variable::{Variable, find, variables};
use case::keys::Kind;
use input::quantity;

/// Why a range cannot be read, and what to write instead.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Unreadable(String);

/// A variable and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The variable.
    pub variable: Variable,
    /// Whether the range was given as Z = z/d.
    pub relative: bool,
    /// The values, in SI units.
    pub values: Vec<f64>,
}

impl Range {
    /// Reads `KEY=LOW..HIGH`: `count` values, evenly spaced, or in even ratios if `logarithmic`.
    ///
    /// # Errors
    /// [`Unreadable`] says what is wrong.
    pub fn read(text: &str, input: &ModelInput, count: usize, logarithmic: bool) -> Result<Self, Unreadable> {
        let wrong = |why: &str| Unreadable(format!("--against {text}: {why}; write it such as Z=0.02..0.4"));
        let (key, ends) = text.split_once('=').ok_or_else(|| wrong("no `=`"))?;
        let key = key.trim();
        let variable = known(key, input)?;
        let (low, high) = ends.split_once("..").ok_or_else(|| wrong("no `..` between two values"))?;
        let relative = key == "Z";
        let read = |end: &str| {
            if relative {
                let z = number(end).ok_or_else(|| wrong(&format!("`{end}` is not a number")))?;
                return Ok(z * input.towing.reference_lengths()[0]);
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
            let fraction = n as f64 / last as f64;
            if logarithmic { low * (high / low).powf(fraction) } else { low + fraction * (high - low) }
        };
        Ok(Self { variable, relative, values: (0..=last).map(at).collect() })
    }
}

/// The variable of that name.
pub(super) fn known(key: &str, input: &ModelInput) -> Result<Variable, Unreadable> {
    let Some(found) = find(key, &input.bodies) else {
        let own = variables().iter().filter(|v| v.belongs(input));
        let names = own.map(|v| v.dotted(input)).collect::<Vec<_>>().join(", ");
        return Err(Unreadable(format!("`{key}` is not a variable of the models; possible: Z, {names}")));
    };
    if !found.belongs(input) {
        let kind = input.kind;
        return Err(Unreadable(format!("{key}: no model of a {kind} uses it")));
    }
    if found.has_effect(input) {
        return Ok(found);
    }
    let cure = "add  terrain = \"LETE sand\"  or another published soil to [forecast]";
    Err(Unreadable(format!("{key}: the case has no plate constants; {cure}")))
}

/// A value of the variable, in SI units.
pub(super) fn value(text: &str, variable: &Variable) -> Result<f64, String> {
    let text = text.trim().trim_matches(['"', '\'']).trim();
    match variable.kind {
        Kind::Quantity(measure) => quantity::parse(text, &measure).map_err(|e| e.to_string()),
        Kind::Modulus(offset) => quantity::parse_modulus(text, offset).map_err(|e| e.to_string()),
        _ => number(text).ok_or_else(|| format!("`{text}` is not a number")),
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().trim_matches(['"', '\'']).trim().parse().ok().filter(|x: &f64| x.is_finite())
}
