//! The points of a part of a study: the level of every factor, and the keys of the case that follow.

use super::factor::numbers_of;
use super::{Design, Factor, Level, Part, Study};
use crate::expression::Dimensional;
use crate::statistics::design::{latin_hypercube, sobol};
use coulter::case::form::{Entry, Form, Value, find};
use coulter::case::keys::{self, Kind};
use coulter::case::quantity::{self, Dimension, Measure};

/// A point of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The level of every factor of the study; of one that its part does not vary that of the case, where
    /// this says it.
    pub levels: Vec<Option<Level>>,
    /// What is set in the case, as `--set` takes it: `soil.friction_angle="30 deg"`.
    pub set: Vec<String>,
}

/// A formula that has no value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the formula of {key}: {why}")]
pub(super) struct Formless {
    /// The key that the formula gives.
    pub key: String,
    /// Why the formula has no value.
    pub why: String,
}

/// The points of a part; `tree` holds the entries of the case.
///
/// # Errors
/// Which formula has no value, and why.
pub fn points(study: &Study, part: &Part, tree: &[Entry]) -> Result<Vec<Point>, String> {
    let rows = levels(study, part, tree)?;
    let one = |levels| point(study, part, tree, levels).map_err(|error| error.to_string());
    rows.into_iter().map(one).collect()
}

/// The number of points of a part, known before they are made.
pub(super) fn count(study: &Study, part: &Part) -> f64 {
    let counts = part.factors.iter().map(|n| study.factors[*n].levels.len() as f64);
    match part.design {
        Design::Grid => counts.product(),
        Design::List => counts.fold(f64::INFINITY, f64::min),
        Design::OneAtATime => 1.0 + counts.sum::<f64>(),
        Design::LatinHypercube | Design::Sobol => part.points as f64,
    }
}

/// The levels of the factors at every point.
fn levels(study: &Study, part: &Part, tree: &[Entry]) -> Result<Vec<Vec<Level>>, String> {
    let factors: Vec<&Factor> = part.factors.iter().map(|n| &study.factors[*n]).collect();
    let cube = match part.design {
        Design::LatinHypercube => latin_hypercube(part.points, factors.len(), part.seed),
        Design::Sobol => sobol(part.points, factors.len(), part.seed),
        Design::Grid | Design::List | Design::OneAtATime => Ok(Vec::new()),
    };
    let cube = cube.map_err(|why| why.to_string())?;
    Ok(match part.design {
        Design::Grid => factors.iter().fold(vec![Vec::new()], |rows, factor| {
            rows.iter()
                .flat_map(|row| factor.levels.iter().map(|level| [row.clone(), vec![level.clone()]].concat()))
                .collect()
        }),
        Design::List => {
            let count = factors.iter().map(|factor| factor.levels.len()).min().unwrap_or(0);
            (0..count).map(|n| factors.iter().map(|factor| factor.levels[n].clone()).collect()).collect()
        }
        Design::OneAtATime => one_at_a_time(&factors, part, tree),
        Design::LatinHypercube | Design::Sobol => filled(&factors, &cube),
    })
}

/// The case itself, and every other level of every factor alone. A factor of which the case says nothing has
/// its first level there.
fn one_at_a_time(factors: &[&Factor], part: &Part, tree: &[Entry]) -> Vec<Vec<Level>> {
    let own = |factor: &&Factor| fixed_level(factor, part, tree).or_else(|| factor.levels.first().cloned());
    let Some(base) = factors.iter().map(own).collect::<Option<Vec<Level>>>() else { return Vec::new() };
    let mut rows = vec![base.clone()];
    for (n, factor) in factors.iter().enumerate() {
        for level in factor.levels.iter().filter(|level| !is_same(level, &base[n])) {
            let mut row = base.clone();
            row[n] = level.clone();
            rows.push(row);
        }
    }
    rows
}

fn is_same(a: &Level, b: &Level) -> bool {
    match (a.number, b.number) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-12 * a.abs().max(b.abs()),
        _ => a.toml == b.toml,
    }
}

/// The levels of points in the unit cube; words are taken from their list.
fn filled(factors: &[&Factor], cube: &[Vec<f64>]) -> Vec<Vec<Level>> {
    let one = |(factor, fraction): (&&Factor, &f64)| match factor.at(*fraction) {
        Some(number) => Some(factor.level(number)),
        None => {
            let n = (fraction * factor.levels.len() as f64) as usize;
            factor.levels.get(n.min(factor.levels.len().saturating_sub(1))).cloned()
        }
    };
    cube.iter().filter_map(|row| factors.iter().zip(row).map(one).collect()).collect()
}

/// The point of these levels of the factors of a part, with everything that it sets in the case.
pub(super) fn point(
    study: &Study,
    part: &Part,
    tree: &[Entry],
    varied: Vec<Level>,
) -> Result<Point, Formless> {
    let mut set: Vec<String> = part.set.iter().map(|(key, toml)| format!("{key}={toml}")).collect();
    let mut levels: Vec<Option<Level>> =
        study.factors.iter().map(|factor| fixed_level(factor, part, tree)).collect();
    for (n, level) in part.factors.iter().zip(varied) {
        set.extend(study.factors[*n].key.as_ref().map(|key| format!("{key}={}", level.toml)));
        levels[*n] = Some(level);
    }
    let mut found: Vec<(&str, Dimensional)> = Vec::new();
    for (key, formula) in &part.derived {
        let known = |name: &str| {
            let earlier = found.iter().find(|(key, _)| *key == name).map(|(_, quantity)| *quantity);
            let is_named = |factor: &Factor| factor.name == name || factor.key.as_deref() == Some(name);
            let factors = study.factors.iter().zip(&levels).filter(|(factor, _)| is_named(factor));
            let of_factor = || factors.filter_map(|(factor, level)| of_level(factor, level.as_ref()?)).next();
            earlier.or_else(of_factor).or_else(|| of_case(name, part, tree))
        };
        let value = formula.value(&known).map_err(|why| Formless { key: key.clone(), why })?;
        set.push(format!("{key}={}", written(key, value)));
        found.push((key, value));
    }
    Ok(Point { levels, set })
}

/// The level of a factor where it is not varied: what the part sets, what the case says; of one without a key
/// the first, where a formula of the part uses it.
fn fixed_level(factor: &Factor, part: &Part, tree: &[Entry]) -> Option<Level> {
    let Some(key) = &factor.key else {
        return factor.levels.first().filter(|_| part.uses(&factor.name)).cloned();
    };
    match part.set.iter().rev().find(|(set, _)| set == key) {
        Some((_, toml)) => factor.own_level(&value_of(toml)?),
        None => factor.own_level(find(tree, key)?),
    }
}

/// The number of a key of the case, as the part sets it or as the case says.
fn of_case(key: &str, part: &Part, tree: &[Entry]) -> Option<Dimensional> {
    match part.set.iter().rev().find(|(set, _)| set == key) {
        Some((_, toml)) => of_value(&value_of(toml)?),
        None => find(tree, key).and_then(of_value),
    }
}

fn of_level(factor: &Factor, level: &Level) -> Option<Dimensional> {
    let (size, dimension) = factor.unit.as_ref()?.size?;
    Some(Dimensional { value: level.number? * size, dimension })
}

/// The value that a text in TOML stands for.
fn value_of(toml: &str) -> Option<Value> {
    let form = Form::read(&format!("x = {toml}"), "").ok()?;
    find(&form.entries, "x").cloned()
}

fn of_value(value: &Value) -> Option<Dimensional> {
    let (unit, numbers) = numbers_of(std::slice::from_ref(value))?;
    let (size, dimension) = unit.size?;
    Some(Dimensional { value: numbers[0] * size, dimension })
}

/// A value as the key wants it, as TOML.
fn written(key: &str, Dimensional { value, dimension }: Dimensional) -> String {
    if dimension == Dimension([0; 4]) {
        return value.to_string();
    }
    let measure = keys::at(key).and_then(|key| match key.kind {
        Kind::Quantity(measure) => Some(measure),
        _ => None,
    });
    let fits = |measure: &Measure| measure.dimension == dimension;
    match measure.filter(fits) {
        Some(measure) => {
            let size = quantity::parse_any(&format!("1 {}", measure.unit)).map_or(1.0, |(size, _)| size);
            format!("\"{} {}\"", value / size, measure.unit)
        }
        None => format!("\"{value} {dimension}\""),
    }
}
