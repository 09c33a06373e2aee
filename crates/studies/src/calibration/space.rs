//! The unknowns of a calibration: parameters with their priors, and links, keys that follow from them.

use super::prior::Prior;
use crate::expression::{self, Dimensional, Expression};
use coulter::case::{CaseError, Problem, nearest};
use std::ops::Range;

/// An unknown: a key of the case, or a free name that links use.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// Name of the unknown: `soil.friction_angle`, or a free one such as `e_max`.
    pub name: String,
    /// Unit of the unknown, as typed; empty for a plain number.
    pub unit: String,
    /// Prior of the unknown.
    pub prior: Prior,
}

impl Unknown {
    /// Whether the unknown is a key of the case.
    #[must_use]
    pub fn is_key(&self) -> bool {
        self.name.contains('.')
    }
}

/// A key that follows from the unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The key.
    pub key: String,
    /// Unit of the key; empty for a plain number.
    pub unit: String,
    /// Value of the key in that unit.
    pub expression: Expression,
    /// The expression as typed.
    pub text: String,
}

/// The unknowns and the links.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Space {
    /// The unknowns, in the order in which they were typed.
    pub unknowns: Vec<Unknown>,
    /// The links.
    pub links: Vec<Link>,
}

/// Largest number of unknowns.
const MOST_UNKNOWNS: usize = 12;
/// Digits to which values are written into cases: what is printed is what was run.
const DIGITS: usize = 6;

/// A number as it is written into a case: rounded to six digits.
#[must_use]
pub fn rounded(value: f64) -> f64 {
    format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
}

impl Space {
    /// Reads the unknowns, `KEY=PRIOR`, and the links, `KEY=EXPRESSION [UNIT]`.
    ///
    /// # Errors
    /// [`CaseError`] says what is wrong, where in the text, and what to write instead.
    pub fn read(parameters: &[String], links: &[String]) -> Result<Self, CaseError> {
        let mut space = Self::default();
        for text in parameters {
            let unknown = unknown(text).map_err(|problem| error("--parameter", text, problem))?;
            if space.unknowns.iter().any(|other| other.name == unknown.name) {
                let cure = ["it is given twice".to_owned(), "leave one of the two out".to_owned()];
                return Err(error("--parameter", text, (0..unknown.name.len(), cure)));
            }
            space.unknowns.push(unknown);
        }
        if space.unknowns.is_empty() || space.unknowns.len() > MOST_UNKNOWNS {
            let cure =
                "name what is to be found, such as --parameter soil.friction_angle=\"28 deg\"..\"45 deg\"";
            let message = format!("{} parameters; 1 to {MOST_UNKNOWNS} can be found", space.unknowns.len());
            return Err(CaseError::unreadable("--parameter", message, cure));
        }
        for text in links {
            let link = link(text, &space).map_err(|problem| error("--link", text, problem))?;
            space.links.push(link);
        }
        space.refuse_loose()?;
        Ok(space)
    }

    /// Refuses a free name that no link uses.
    fn refuse_loose(&self) -> Result<(), CaseError> {
        let used: Vec<&str> = self.links.iter().flat_map(|link| link.expression.names()).collect();
        let loose = self.unknowns.iter().find(|u| !u.is_key() && !used.contains(&u.name.as_str()));
        loose.map_or(Ok(()), |unknown| {
            let name = &unknown.name;
            let message = format!("`{name}` is neither a key of the case nor used by a link");
            let cure = format!(
                "write the key with its section, such as soil.{name}, or add --link KEY=\"EXPRESSION OF {name} [UNIT]\""
            );
            Err(CaseError::in_text("--parameter", name, vec![(0..name.len(), Problem::new("", message, cure))]))
        })
    }

    /// The number of unknowns.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.unknowns.len()
    }

    /// The values at coordinates, rounded to what is written into a case.
    #[must_use]
    pub fn values(&self, coordinates: &[f64]) -> Vec<f64> {
        self.unknowns.iter().zip(coordinates).map(|(u, c)| rounded(u.prior.value(*c))).collect()
    }

    /// The coordinates of values.
    #[must_use]
    pub fn coordinates(&self, values: &[f64]) -> Vec<f64> {
        self.unknowns.iter().zip(values).map(|(u, v)| u.prior.coordinate(*v)).collect()
    }

    /// The logarithm of the density of the priors.
    #[must_use]
    pub fn log_prior(&self, coordinates: &[f64]) -> f64 {
        self.unknowns.iter().zip(coordinates).map(|(u, c)| u.prior.log_density(*c)).sum()
    }

    /// The keys that values set, as for `--set`.
    ///
    /// # Errors
    /// Which link has no value there.
    pub fn overrides(&self, values: &[f64]) -> Result<Vec<String>, String> {
        let of = |name: &str| self.unknowns.iter().position(|u| u.name == name).map(|n| values[n]);
        let keys = self.unknowns.iter().zip(values).filter(|(u, _)| u.is_key());
        let mut overrides: Vec<String> = keys.map(|(u, v)| assignment(&u.name, *v, &u.unit)).collect();
        for link in &self.links {
            // Numbers of a link have no units: that of its key stands behind it.
            let found = link.expression.value(&|name| of(name).map(Dimensional::plain));
            let found = found.map_err(|why| format!("the link {} has no value there: {why}", link.text))?;
            overrides.push(assignment(&link.key, rounded(found.value), &link.unit));
        }
        Ok(overrides)
    }
}

fn assignment(key: &str, value: f64, unit: &str) -> String {
    if unit.is_empty() { format!("{key}={value}") } else { format!("{key}={value} {unit}") }
}

/// What is wrong and what to do about it, at a range of bytes.
type Wrong = (Range<usize>, [String; 2]);

fn error(option: &str, text: &str, (at, [message, cure]): Wrong) -> CaseError {
    CaseError::in_text(option, text, vec![(at, Problem::new("", message, cure))])
}

/// Name and right side, and where that begins.
fn halves(text: &str) -> Result<(&str, &str, usize), Wrong> {
    let cure = "write KEY=VALUE, such as soil.friction_angle=\"28 deg\"..\"45 deg\"";
    let (name, value) =
        text.split_once('=').ok_or_else(|| (0..text.len(), ["no `=`".to_owned(), cure.to_owned()]))?;
    let is_name = |c: char| c.is_alphanumeric() || "._-".contains(c);
    if name.trim().is_empty() || !name.trim().chars().all(is_name) {
        return Err((0..name.len(), [format!("`{}` is no key", name.trim()), cure.to_owned()]));
    }
    Ok((name.trim(), value, name.len() + 1))
}

fn unknown(text: &str) -> Result<Unknown, Wrong> {
    let (name, value, start) = halves(text)?;
    let (prior, unit) = Prior::read(value).map_err(|why| (start..text.len(), why))?;
    Ok(Unknown { name: name.to_owned(), unit, prior })
}

fn link(text: &str, space: &Space) -> Result<Link, Wrong> {
    let (key, value, start) = halves(text)?;
    let value = value.trim().trim_matches(['"', '\'']);
    let (formula, unit) = match value.split_once('[') {
        Some((formula, unit)) => (formula.trim(), unit.trim().trim_end_matches(']').trim()),
        None => (value, ""),
    };
    let unit = if unit == "-" { "" } else { unit };
    let at = start..text.len();
    let read = expression::parse(formula).map_err(|why| {
        let cure = "write it such as soil.minimum_density=\"2650/(1 + e_max) [kg/m^3]\"".to_owned();
        (at.clone(), [why, cure])
    })?;
    let is_known = |name: &str| space.unknowns.iter().any(|u| u.name == name);
    if let Some(name) = read.names().into_iter().find(|name| !is_known(name)) {
        let known = || space.unknowns.iter().map(|u| u.name.as_str());
        let cure = match nearest(name, known()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("parameters are {}", known().collect::<Vec<_>>().join(", ")),
        };
        return Err((at, [format!("`{name}` is no parameter"), cure]));
    }
    if !key.contains('.') || is_known(key) {
        let cure = "name a key with its section that is no parameter itself".to_owned();
        return Err((0..key.len(), [format!("`{key}` cannot be linked"), cure]));
    }
    Ok(Link { key: key.to_owned(), unit: unit.to_owned(), expression: read, text: text.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(parameters: &[&str], links: &[&str]) -> Result<Space, CaseError> {
        let owned = |list: &[&str]| list.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        Space::read(&owned(parameters), &owned(links))
    }

    #[test]
    fn parameters_and_links_become_overrides() {
        let space = read(
            &["soil.critical_friction_angle=33 ± 3 deg", "e_max=1.03 ± 0.05"],
            &["soil.minimum_density=2650/(1 + e_max) [kg/m^3]"],
        )
        .unwrap();
        let overrides = space.overrides(&space.values(&[1.0, 0.0])).unwrap();
        assert_eq!(overrides, ["soil.critical_friction_angle=36 deg", "soil.minimum_density=1305.42 kg/m^3"]);
        assert_eq!(space.coordinates(&[36.0, 1.03]), [1.0, 0.0]);
    }

    #[test]
    fn what_is_wrong_is_refused_with_its_place() {
        let refused = |parameters: &[&str], links: &[&str], message: &str, cure: &str| {
            let error = read(parameters, links).unwrap_err();
            let first = &error.problems[0];
            assert!(first.message.contains(message), "{message}: {}", first.message);
            assert!(first.cure.contains(cure), "{message}: {}", first.cure);
        };
        let phi = "soil.friction_angle=28..45 deg";
        refused(&[], &[], "0 parameters", "--parameter");
        refused(&["soil.friction_angle"], &[], "no `=`", "KEY=VALUE");
        refused(&["soil friction=1..2"], &[], "no key", "KEY=VALUE");
        refused(&["soil.friction_angle=45..28 deg"], &[], "not below", "deg");
        refused(&[phi, phi], &[], "twice", "leave");
        refused(&["friction_angle=28..45 deg"], &[], "neither a key", "soil.friction_angle");
        refused(&[phi], &["soil.cohesion"], "no `=`", "KEY=VALUE");
        refused(&[phi], &["soil.cohesion=1+ [Pa]"], "it ends where", "soil.minimum_density");
        refused(&[phi, "e_max=1..2"], &["soil.cohesion=e_mx [Pa]"], "no parameter", "did you mean `e_max`");
        refused(&[phi], &["soil.friction_angle=1"], "cannot be linked", "no parameter itself");
        let error = read(&["soil.friction_angle=45..28 deg"], &[]).unwrap_err();
        assert_eq!((error.problems[0].line, error.problems[0].column), (1, 21));
    }
}
