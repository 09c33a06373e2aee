//! The header of a measured curve: which column is which quantity, in which unit.

use super::Quantity;
use super::text::{Field, Line, Placed, placed};
use coulter::case::nearest;
use coulter::history::columns::{FILTERED, FORCES};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Content {
    /// Values of a quantity; how many SI units the unit of the column is.
    Values(Quantity, f64),
    /// Standard deviations of it.
    Deviations(Quantity, f64),
    /// A column of the files of a run that curves do not need.
    Ignored,
}

const EXAMPLE: &str = "name every column with its unit, such as sinkage [mm],vertical [N]";

/// The contents of the columns; a column with a problem counts as ignored.
pub(super) fn columns(line: &Line<'_>, problems: &mut Vec<Placed>) -> Vec<Content> {
    let mut contents = Vec::new();
    for field in &line.fields {
        let content = column(field).unwrap_or_else(|problem| {
            problems.push(problem);
            Content::Ignored
        });
        if content != Content::Ignored && contents.iter().any(|other| is_same(*other, content)) {
            let message = format!("\"{}\" is the second column of this quantity", field.text);
            problems.push(placed(field.at.clone(), message, "leave one of the two out"));
        }
        contents.push(content);
    }
    if problems.is_empty() {
        problems.extend(missing(&contents, line));
    }
    contents
}

fn is_same(one: Content, other: Content) -> bool {
    match (one, other) {
        (Content::Values(a, _), Content::Values(b, _)) => a == b,
        (Content::Deviations(a, _), Content::Deviations(b, _)) => a == b,
        _ => false,
    }
}

fn column(field: &Field<'_>) -> Result<Content, Placed> {
    let (name, unit) = match field.text.split_once('[') {
        Some((name, rest)) => (name.trim(), rest.trim_end().strip_suffix(']')),
        None => (field.text, None),
    };
    if name.is_empty() {
        return Err(placed(field.at.clone(), "a column without a name", EXAMPLE));
    }
    // z/d of a run: not the sinkage, whose symbol is small.
    if name == "Z" && unit == Some("-") {
        return Ok(Content::Ignored);
    }
    let (base, is_deviation) = split_deviation(name);
    let Some(quantity) = Quantity::named(base) else {
        return if is_of_a_run(name) { Ok(Content::Ignored) } else { Err(unknown(field, base)) };
    };
    let Some(unit) = unit else {
        let message = format!("the column \"{}\" has no unit", field.text);
        let cure = format!("write it as {base} [{}]", quantity.example());
        return Err(placed(field.at.clone(), message, cure));
    };
    let factor = quantity.factor(unit).map_err(|why| {
        let cure = format!("give it in a unit such as [{}]", quantity.example());
        placed(field.at.clone(), format!("{name}: {why}"), cure)
    })?;
    Ok(if is_deviation { Content::Deviations(quantity, factor) } else { Content::Values(quantity, factor) })
}

/// The name of the quantity, and whether the column holds standard deviations of it: `drag sd`, `drag ±`.
fn split_deviation(name: &str) -> (&str, bool) {
    for mark in ["±", "+-", " sd", " SD", " standard deviation"] {
        if let Some(base) = name.strip_suffix(mark) {
            return (base.trim(), true);
        }
    }
    (name, false)
}

/// Whether it is a column of `forces.csv` or `filtered.csv`.
fn is_of_a_run(name: &str) -> bool {
    let mut known = FORCES.iter().chain(FILTERED).map(|column| column.name);
    known.any(|column| column == name)
}

fn unknown(field: &Field<'_>, base: &str) -> Placed {
    let cure = match nearest(base, Quantity::names()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => {
            let known: Vec<&str> = Quantity::all().map(Quantity::name).collect();
            format!("known are {} and their aliases", known.join(", "))
        }
    };
    let message = format!("unknown column \"{}\"", field.text);
    placed(field.at.clone(), message, format!("{cure} A column that no curve needs can be left out"))
}

/// What the columns lack to be a curve.
fn missing(contents: &[Content], line: &Line<'_>) -> Option<Placed> {
    let has = |wanted: fn(Quantity) -> bool| {
        contents.iter().any(|content| matches!(content, Content::Values(q, _) if wanted(*q)))
    };
    let orphan = contents.iter().zip(&line.fields).find_map(|(content, field)| match content {
        Content::Deviations(quantity, _) => {
            let values = |other: &Content| matches!(other, Content::Values(q, _) if q == quantity);
            (!contents.iter().any(values)).then_some((field, *quantity))
        }
        _ => None,
    });
    if let Some((field, quantity)) = orphan {
        let message = format!("standard deviations of {0} without {0} itself", quantity.name());
        return Some(placed(field.at.clone(), message, format!("add the column {}", quantity.header())));
    }
    if !has(Quantity::is_abscissa) {
        let cure = "add a column such as sinkage [mm], displacement [m], time [s] or slip [-]";
        return Some(placed(line.at.clone(), "nothing along which a curve could run", cure));
    }
    let values = contents.iter().filter(|content| matches!(content, Content::Values(..))).count();
    (values < 2).then(|| {
        placed(line.at.clone(), "one quantity alone is not a curve", "add a column such as drag [N]")
    })
}
