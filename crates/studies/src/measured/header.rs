//! The header of a measured curve: which column is which quantity, in which unit.

use super::choice::ColumnChoice;
use super::quantity::{Quantity, split_deviation};
use super::record::Group;
use coulter::case::nearest;
use coulter::case::table_file::{Placed, TableColumn, TableFile, placed, plain_name};
use coulter::history::columns::{FILTERED, FORCES};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Content {
    /// Values of a quantity.
    Values(Values),
    /// Standard deviations of a quantity; how many SI units the unit of the column is.
    Deviations(Quantity, f64),
    /// A column that curves do not need, or that is not known.
    Ignored,
}

/// Values of a quantity, and how a column has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Values {
    pub(super) quantity: Quantity,
    /// How many SI units the unit of the column is; negative where it counts the other way.
    pub(super) factor: f64,
    /// The reference of which the values are parts, of a dimensionless column.
    pub(super) group: Option<Group>,
    pub(super) sign: Sign,
}

/// Which way a column counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    /// The sign follows from the values.
    Open,
    /// The sign was stated, or is that of a column which a run writes.
    Stated,
    /// Upwards, of a depth: a height.
    Height,
}

/// The columns of a file: what each holds, and what is to be said of those that are left out.
pub(super) struct Header {
    pub(super) contents: Vec<Content>,
    pub(super) remarks: Vec<String>,
}

const EXAMPLE: &str = "name every column with its unit, such as sinkage [mm],vertical [N]";
/// How a column that was not understood can be named, or left out.
const CHOOSE: &str = "say what a column is with --column NAME=QUANTITY, or leave it out with --column NAME=-";
/// Names of depths that count upwards.
const HEIGHTS: [&str; 3] = ["elevation", "height", "level"];

/// What each column holds; a column with a problem counts as ignored.
pub(super) fn columns(table: &TableFile, choices: &[ColumnChoice], problems: &mut Vec<Placed>) -> Header {
    let mut header = Header { contents: Vec::new(), remarks: Vec::new() };
    let (mut unknown, mut groups) = (Vec::new(), Vec::new());
    for (n, column) in table.columns().iter().enumerate() {
        let content = match choices.iter().find(|choice| choice.is_of(column, n)) {
            Some(choice) => chosen(choice, column),
            None => known(column),
        };
        let content = match content {
            Ok(Some(content)) => content,
            Ok(None) => {
                unknown.push(n);
                Content::Ignored
            }
            Err(problem) => {
                problems.push(problem);
                Content::Ignored
            }
        };
        if matches!(content, Content::Values(Values { group: Some(_), .. })) {
            groups.push((n, content));
            header.contents.push(Content::Ignored);
            continue;
        }
        if header.contents.iter().any(|other| is_same(*other, content)) {
            let message = format!("\"{}\" is the second column of this quantity", column.title);
            problems.push(placed(column.at.clone(), message, format!("leave one of the two out: {CHOOSE}")));
        }
        header.contents.push(content);
    }
    // Beside the quantity itself its dimensionless form says nothing new.
    for (n, group) in groups {
        if !header.contents.iter().any(|other| is_same(*other, group)) {
            header.contents[n] = group;
        }
    }
    if problems.is_empty()
        && let Some(problem) = missing(&header.contents, table)
    {
        // What is missing may be what was not understood.
        problems.extend(unknown.iter().filter(|n| !table.is_text(**n)).map(|n| not_known(table, *n)));
        if problems.is_empty() {
            problems.push(problem);
        }
    }
    header.remarks.extend(unknown.iter().filter_map(|n| left_out(table, *n)));
    header
}

fn is_same(one: Content, other: Content) -> bool {
    match (one, other) {
        (Content::Values(a), Content::Values(b)) => a.quantity == b.quantity,
        (Content::Deviations(a, _), Content::Deviations(b, _)) => a == b,
        _ => false,
    }
}

/// What a column is by its header; `None` where its name is not known.
fn known(column: &TableColumn) -> Result<Option<Content>, Placed> {
    if let Some(found) = grouped(column) {
        return Ok(Some(Content::Values(found)));
    }
    let named = |name: &str| {
        let (base, is_deviation) = split_deviation(name);
        let is_height = HEIGHTS.contains(&plain_name(base).as_str());
        let quantity = if is_height { Some(Quantity::Sinkage) } else { Quantity::named(base) };
        quantity.map(|quantity| (quantity, is_deviation, is_height))
    };
    let is_unit = |meaning: &(Quantity, bool, bool), unit: &str| meaning.0.factor(unit).is_ok();
    let Some(((quantity, is_deviation, is_height), unit)) = column.meaning(named, is_unit) else {
        return Ok(is_of_a_run(&column.name).then_some(Content::Ignored));
    };
    let Some(unit) = unit else {
        let message = format!("the column \"{}\" has no unit", column.title);
        let cure = format!("write it as {} [{}]; {CHOOSE}", column.name, quantity.example());
        return Err(placed(column.at.clone(), message, cure));
    };
    let factor = match quantity.factor(unit) {
        Ok(factor) => factor,
        // One letter means many things: u is a displacement, and the pressure of the pore water.
        Err(_) if column.name.chars().count() == 1 => return Ok(None),
        Err(why) => {
            let cure = format!("give it in a unit such as [{}]; {CHOOSE}", quantity.example());
            return Err(placed(column.at.clone(), format!("{}: {why}", column.name), cure));
        }
    };
    if is_deviation {
        return Ok(Some(Content::Deviations(quantity, factor)));
    }
    let sign = match () {
        () if is_height => Sign::Height,
        () if is_of_a_run(&column.name) => Sign::Stated,
        () => Sign::Open,
    };
    Ok(Some(Content::Values(Values { quantity, factor, group: None, sign })))
}

/// A length over d or a force over γ t d², as runs write them: `Z [-]`, `u_bar [-]`, `F_H_bar [-]`.
fn grouped(column: &TableColumn) -> Option<Values> {
    if !matches!(column.unit.as_deref(), Some("-" | "–" | "1")) {
        return None;
    }
    let plain = plain_name(column.name.strip_suffix("/d").unwrap_or(&column.name));
    let quantity = Quantity::named(plain.strip_suffix("bar").unwrap_or(&plain))?;
    let group = match quantity {
        Quantity::Displacement | Quantity::Sinkage => Group::Length,
        Quantity::Drag | Quantity::Vertical | Quantity::Lateral => Group::Force,
        _ => return None,
    };
    Some(Values { quantity, factor: 1.0, group: Some(group), sign: Sign::Open })
}

/// What a column was said to be.
fn chosen(choice: &ColumnChoice, column: &TableColumn) -> Result<Option<Content>, Placed> {
    let Some(meaning) = &choice.meaning else { return Ok(Some(Content::Ignored)) };
    let quantity = meaning.quantity;
    let suffix = || {
        let is_unit = |(): &(), unit: &str| quantity.factor(unit).is_ok();
        column.meaning(|name| (name != column.name).then_some(()), is_unit).and_then(|(_, unit)| unit)
    };
    let Some(unit) = meaning.unit.as_deref().or(column.unit.as_deref()).or_else(suffix) else {
        let message = format!("the column \"{}\" has no unit", column.title);
        let cure = format!(
            "give it one: --column \"{}\"=\"{} [{}]\"",
            column.title,
            quantity.name(),
            quantity.example()
        );
        return Err(placed(column.at.clone(), message, cure));
    };
    let factor = quantity.factor(unit).map_err(|why| {
        let cure = format!("give it in a unit such as [{}]", quantity.example());
        placed(column.at.clone(), format!("\"{}\" as {}: {why}", column.title, quantity.name()), cure)
    })?;
    Ok(Some(match meaning.is_deviation {
        true => Content::Deviations(quantity, factor),
        false => Content::Values(Values {
            quantity,
            factor: meaning.sign * factor,
            group: None,
            sign: Sign::Stated,
        }),
    }))
}

/// Whether a column is one of `forces.csv` or `filtered.csv`.
fn is_of_a_run(name: &str) -> bool {
    let mut known = FORCES.iter().chain(FILTERED).map(|column| column.name);
    known.any(|column| column == name)
}

/// The name that was probably meant: of a quantity that has the unit of the column.
fn hint(column: &TableColumn) -> Option<String> {
    const LEAST_LETTERS: usize = 3;
    let base = split_deviation(&column.name).0;
    let has_unit =
        |quantity: &Quantity| column.unit.as_deref().is_none_or(|unit| quantity.factor(unit).is_ok());
    let names = Quantity::all().filter(has_unit).flat_map(|quantity| quantity.aliases().iter().copied());
    let is_word = |name: &&str| name.chars().count() >= LEAST_LETTERS;
    let near = nearest(base, names.filter(is_word)).filter(|_| is_word(&base))?;
    Some(format!("did you mean `{near}`?"))
}

fn not_known(table: &TableFile, n: usize) -> Placed {
    let column = &table.columns()[n];
    if column.name.is_empty() {
        return placed(column.at.clone(), "a column without a name", EXAMPLE);
    }
    let known = || {
        let all: Vec<&str> = Quantity::all().map(Quantity::name).collect();
        format!("known are {} and their aliases.", all.join(", "))
    };
    let cure = hint(column).unwrap_or_else(known);
    placed(column.at.clone(), format!("unknown column \"{}\"", column.title), format!("{cure} Or {CHOOSE}."))
}

/// What is said of a column that is left out; nothing of an empty one.
fn left_out(table: &TableFile, n: usize) -> Option<String> {
    let column = &table.columns()[n];
    let is_text = table.is_text(n);
    if column.title.is_empty() {
        return (!is_text).then(|| format!("column {} left out: it has no name", n + 1));
    }
    let why = if is_text {
        "text".to_owned()
    } else {
        hint(column).map_or_else(|| "not known".to_owned(), |hint| format!("not known; {hint}"))
    };
    Some(format!("column \"{}\" left out: {why}", column.title))
}

/// What the columns lack to be a curve.
fn missing(contents: &[Content], table: &TableFile) -> Option<Placed> {
    let values = || {
        contents.iter().filter_map(|content| if let Content::Values(v) = content { Some(v) } else { None })
    };
    let orphan = contents.iter().zip(table.columns()).find_map(|(content, column)| match content {
        Content::Deviations(quantity, _) => {
            (!values().any(|values| values.quantity == *quantity)).then_some((column, *quantity))
        }
        _ => None,
    });
    if let Some((column, quantity)) = orphan {
        let message = format!("standard deviations of {0} without {0} itself", quantity.name());
        return Some(placed(column.at.clone(), message, format!("add the column {}", quantity.header())));
    }
    if table.columns().is_empty() {
        return Some(placed(table.header(), "the file begins with numbers, not with a header", EXAMPLE));
    }
    if !values().any(|values| values.quantity.is_abscissa()) {
        let cure = "add a column such as sinkage [mm], displacement [m], time [s] or slip [-]";
        return Some(placed(table.header(), "nothing along which a curve could run", cure));
    }
    (values().count() < 2)
        .then(|| placed(table.header(), "one quantity alone is not a curve", "add a column such as drag [N]"))
}
