//! What of a study can be checked only as a whole: whether designs have what they need, and names lead
//! somewhere.

use super::assignments::assignments;
use super::points::{Formless, count, point};
use super::{ChartWish, Design, Level, ModelKind, Part, Study, keys};
use crate::{history_columns, responses};
use coulter::case::form::{Entry, Form, Problems, Value, find, join, nearest};
use coulter::case::keys::NAMED;
use std::collections::BTreeSet;

/// Reports what is wrong with a study as a whole.
pub(super) fn check(form: &Form, study: &Study, problems: &mut Problems) {
    let mut trees = Vec::new();
    for case in &study.cases {
        let Ok(form) = Form::read(&case.text, &case.path) else {
            let message = format!("the file of the case, {}, is not TOML", case.path);
            problems.add("case", message, "`coulter check` says what is wrong with it");
            return;
        };
        trees.push(form.entries);
    }
    for (n, factor) in study.factors.iter().enumerate() {
        let path = join("factor", &factor.name);
        match &factor.key {
            Some(key) => {
                for case in cases_of(study, n) {
                    has_section(key, &join(&path, "key"), &trees[case], problems);
                }
            }
            None if study.parts.iter().all(|part| !part.uses(&factor.name)) => problems.add_to_name(
                path,
                format!("`{}` has no key, and no formula uses it", factor.name),
                "add key = \"soil.friction_angle\", or use it in [derived]",
            ),
            None => {}
        }
    }
    for part in &study.parts {
        let path = if part.name.is_empty() { String::new() } else { join("part", &part.name) };
        let given = problems.len();
        design(study, part, &path, problems);
        if problems.len() == given {
            formulas(study, part, (form, &path, &trees[part.case]), problems);
        }
    }
    charts(study, problems);
}

/// The cases in which a factor is varied, each once; of one that no part varies, the first.
fn cases_of(study: &Study, factor: usize) -> BTreeSet<usize> {
    let parts = study.parts.iter().filter(|part| part.factors.contains(&factor));
    let found: BTreeSet<usize> = parts.map(|part| part.case).collect();
    if found.is_empty() { BTreeSet::from([0]) } else { found }
}

/// Reports a key of a named section that the case does not have.
fn has_section(key: &str, at: &str, tree: &[Entry], problems: &mut Problems) {
    let names: Vec<&str> = key.split('.').collect();
    let [kind, name, _, ..] = names[..] else { return };
    if !NAMED.contains(&kind) || find(tree, &join(kind, name)).is_some() {
        return;
    }
    let known: Vec<&str> = match find(tree, kind) {
        Some(Value::Table(entries)) => entries.iter().map(|entry| entry.key.as_str()).collect(),
        _ => Vec::new(),
    };
    let cure = match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean `{kind}.{near}`?"),
        None if known.is_empty() => format!("the case has no section [{kind}.NAME]"),
        None => format!("the case has {}", known.join(", ")),
    };
    problems.add(at, format!("the case has no section [{kind}.{name}]"), cure);
}

/// Reports factors that lack what the design needs.
fn design(study: &Study, part: &Part, path: &str, problems: &mut Problems) {
    let factors = || part.factors.iter().map(|n| &study.factors[*n]);
    let at = join(path, "design");
    for factor in factors() {
        let lacks = if part.design.fills_space() {
            factor.range.is_none_or(|[low, high]| low >= high) && factor.levels.len() < 2
        } else {
            factor.levels.is_empty()
        };
        if lacks {
            let message = format!("the factor `{}` has nothing that the design could vary", factor.name);
            let cure = if part.design.fills_space() {
                "give it range = [\"30 deg\", \"45 deg\"]"
            } else {
                "give it values = [\"30 deg\", \"35 deg\"], or levels = 4 over its range"
            };
            problems.add_to_name(join("factor", &factor.name), message, cure);
        }
    }
    if part.design == Design::List {
        let counts: Vec<String> =
            factors().map(|factor| format!("{} has {}", factor.name, factor.levels.len())).collect();
        if factors().any(|factor| Some(factor.levels.len()) != factors().next().map(|f| f.levels.len())) {
            let message = format!("a list needs as many levels of every factor: {}", counts.join(", "));
            problems.add(at.clone(), message, "give every factor as many values, or write design = \"grid\"");
        }
    }
    if part.factors.is_empty() && part.design != Design::Grid {
        let cure = "name one, leave the key out for all, or write design = \"grid\" for the case alone";
        problems.add(join(path, "factors"), "no factor is varied", cure);
    }
    let points = count(study, part);
    if points > keys::MOST_POINTS {
        let message = format!("the design has {points} points, at most {} are possible", keys::MOST_POINTS);
        problems.add(at, message, "use fewer levels, or design = \"sobol\" with points = 1000");
    }
}

/// Reports formulas that have no value at the first levels.
fn formulas(
    study: &Study,
    part: &Part,
    (form, path, tree): (&Form, &str, &[Entry]),
    problems: &mut Problems,
) {
    if part.derived.is_empty() {
        return;
    }
    let first = |n: &usize| -> Option<Level> {
        let factor = &study.factors[*n];
        factor.levels.first().cloned().or_else(|| factor.at(0.5).map(|number| factor.level(number)))
    };
    let Some(levels) = part.factors.iter().map(first).collect::<Option<Vec<Level>>>() else { return };
    let Err(Formless { key, why }) = point(study, part, tree, levels) else { return };
    // It stands in the part, or at the top of the file.
    let own = join(path, "derived");
    let in_part = assignments(find(&form.entries, &own).cloned(), "").iter().any(|(name, _)| *name == key);
    let at = join(if in_part { &own } else { "derived" }, &key);
    let cure = "use names of factors, or keys that the case gives a number";
    problems.add(at, format!("the formula of {key}: {why}"), cure);
}

/// Reports charts of columns and parts that do not exist.
fn charts(study: &Study, problems: &mut Problems) {
    let factors: Vec<&str> = study.factors.iter().map(|factor| factor.name.as_str()).collect();
    let columns: Vec<&str> = factors.iter().copied().chain(responses::names()).collect();
    let parts: Vec<&str> = study.parts.iter().map(|part| part.name.as_str()).collect();
    let responses: Vec<&str> = responses::names().collect();
    for (n, typed) in study.responses.iter().enumerate() {
        lead_nowhere(&format!("responses[{n}]"), (typed, &responses), "response", problems);
    }
    let histories = history_columns::names();
    for chart in &study.charts {
        let path = join("chart", &chart.name);
        // Columns of a history have several names each.
        let is_known = |name: &str| chart.history && history_columns::find(name).is_some();
        let axes = if chart.history { &histories } else { &columns };
        let wanted = [
            ("x", Some(&chart.x).filter(|x| !is_known(x)), axes, "column"),
            ("y", Some(&chart.y).filter(|y| !is_known(y)), axes, "column"),
            ("family", chart.family.as_ref(), &factors, "factor"),
            ("part", chart.part.as_ref(), &parts, "part"),
        ];
        for (key, typed, known, what) in wanted {
            if let Some(typed) = typed {
                lead_nowhere(&join(&path, key), (typed, known), what, problems);
            }
        }
        if chart.history {
            history(study, chart, problems);
        }
    }
}

/// Reports a chart of histories that no run has.
fn history(study: &Study, chart: &ChartWish, problems: &mut Problems) {
    let path = join("chart", &chart.name);
    let mut parts =
        study.parts.iter().filter(|part| chart.part.as_ref().is_none_or(|name| *name == part.name));
    if !parts.any(|part| part.models.contains(&ModelKind::Solver)) {
        let message = "a history is that of a run, and no run is part of the chart";
        problems.add(join(&path, "history"), message, "name a part with models = [\"solver\"]");
    }
    if chart.collapse {
        let message = "points of a history are not expected to fall onto one curve";
        problems.add(join(&path, "collapse"), message, "leave it out");
    }
}

/// Reports a name that is not among the known ones.
fn lead_nowhere(at: &str, (typed, known): (&str, &[&str]), what: &str, problems: &mut Problems) {
    if known.contains(&typed) {
        return;
    }
    let near = nearest(typed, known.iter().copied());
    let cure = near
        .map_or_else(|| format!("there are {}", known.join(", ")), |near| format!("did you mean `{near}`?"));
    problems.add(at, format!("the study has no {what} `{typed}`"), cure);
}
