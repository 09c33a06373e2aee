//! The table of a study: a row for every case and model, whatever has become of it.

use super::id::CaseId;
use super::line::CaseLine;
use super::outcome::{Ending, Outcome};
use super::store::Store;
use crate::responses::{Figures, ResponseColumn, responses};
use crate::study::{ModelKind, Study};
use crate::table::{Column, Role, Table, Values};
use std::collections::BTreeMap;

/// How many cases have become what.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Cases.
    pub cases: usize,
    /// Cases with results.
    pub done: usize,
    /// Broken runs.
    pub broken: usize,
    /// Cases that are not valid, or to which no closed form applies.
    pub refused: usize,
    /// Cases that could not be brought to an outcome.
    pub failed: usize,
    /// Cases that have not been run to an end.
    pub missing: usize,
}

impl Counts {
    /// Whether every case has an outcome.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.failed + self.missing == 0
    }

    /// The counts in words.
    #[must_use]
    pub fn text(&self) -> String {
        let parts = [
            (self.done, "done"),
            (self.broken, "broken"),
            (self.refused, "refused"),
            (self.failed, "failed"),
            (self.missing, "missing"),
        ];
        let shown: Vec<String> =
            parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}")).collect();
        let cases = if self.cases == 1 { "case" } else { "cases" };
        format!("{} {cases}: {}", self.cases, if shown.is_empty() { "none".into() } else { shown.join(", ") })
    }
}

/// A case that has no results, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lack {
    /// Number of the point of the case.
    pub point: usize,
    /// Id of the case.
    pub id: CaseId,
    /// `broken`, `refused`, `failed` or `missing`.
    pub state: String,
    /// Why the case has no results.
    pub reason: String,
}

/// The collected results of a study.
#[derive(Clone, Debug)]
pub struct Collected {
    /// The table.
    pub table: Table,
    /// How many cases have become what.
    pub counts: Counts,
    /// The cases without results, in their order.
    pub lacking: Vec<Lack>,
}

/// One row before it is put into columns.
struct Row<'a> {
    line: &'a CaseLine,
    figures: Figures,
    /// Name of the closed form; empty of the solver.
    closed_form: String,
    state: &'static str,
    reason: String,
}

/// Collects the outcomes of all cases.
#[must_use]
pub fn collect(store: &Store, study: &Study, lines: &[CaseLine]) -> Collected {
    let mut outcomes: BTreeMap<&CaseId, Option<Outcome>> = BTreeMap::new();
    for line in lines {
        outcomes.entry(&line.id).or_insert_with(|| store.outcome(&line.id));
    }
    let (mut counts, mut lacking, mut rows) = (Counts::default(), Vec::new(), Vec::new());
    for line in lines {
        counts.cases += 1;
        let outcome = outcomes.get(&line.id).and_then(Option::as_ref);
        let ended = outcome.map(|outcome| ending(study, line, outcome));
        let (state, reason) = state(store, line, ended, &mut counts);
        if state != Ending::Done.word() {
            let lack = Lack {
                point: line.point,
                id: line.id.clone(),
                state: state.to_owned(),
                reason: reason.clone(),
            };
            lacking.push(lack);
        }
        let mut found = outcome.map_or_else(Vec::new, |outcome| chosen(study, line, outcome));
        if found.is_empty() {
            let model = if line.model == ModelKind::Solver { "solver" } else { CLOSED_FORM };
            found.push(Figures { model: model.to_owned(), ..Figures::default() });
        }
        rows.extend(found.into_iter().map(|figures| row(study, line, figures, (state, &reason))));
    }
    Collected { table: table(study, &rows), counts, lacking }
}

/// The row of some figures. Where only the recommended closed form is wanted it is one model, whatever its
/// name at a point.
fn row<'a>(
    study: &Study,
    line: &'a CaseLine,
    mut figures: Figures,
    (state, reason): (&'static str, &str),
) -> Row<'a> {
    let mut closed_form = String::new();
    if line.model == ModelKind::ClosedForm {
        closed_form.clone_from(&figures.model);
        if !study.all_closed_forms {
            CLOSED_FORM.clone_into(&mut figures.model);
        }
    }
    Row { line, figures, closed_form, state, reason: reason.to_owned() }
}

/// The model of a row of a closed form that has no results, or of the recommended one.
const CLOSED_FORM: &str = "closed form";

/// How a case has ended for a study, and why: where none of the closed forms that are wanted has an answer,
/// it is refused.
fn ending(study: &Study, line: &CaseLine, outcome: &Outcome) -> (Ending, String) {
    if outcome.ending == Ending::Done && chosen(study, line, outcome).is_empty() {
        let none = if study.all_closed_forms { "applies" } else { "is recommended" };
        let why = format!("no closed form {none} here. {}", outcome.reason);
        return (Ending::Refused, why.trim_end().to_owned());
    }
    (outcome.ending, outcome.reason.clone())
}

/// What has become of a case, and why.
fn state(
    store: &Store,
    line: &CaseLine,
    ended: Option<(Ending, String)>,
    counts: &mut Counts,
) -> (&'static str, String) {
    match ended {
        Some((ending, reason)) => {
            match ending {
                Ending::Done => counts.done += 1,
                Ending::Broken => counts.broken += 1,
                Ending::Refused => counts.refused += 1,
            }
            (ending.word(), reason)
        }
        None => match store.failure(&line.id) {
            Some(why) => {
                counts.failed += 1;
                ("failed", why)
            }
            None => {
                counts.missing += 1;
                ("missing", "not run to its end yet".to_owned())
            }
        },
    }
}

/// The rows of an outcome that the study wants.
fn chosen(study: &Study, line: &CaseLine, outcome: &Outcome) -> Vec<Figures> {
    let all = study.all_closed_forms || line.model == ModelKind::Solver;
    outcome.rows.iter().filter(|row| all || row.recommended).cloned().collect()
}

/// The columns with the ends of the intervals of a response, `drag_low` and `drag_high`; none without any.
fn ends(response: &ResponseColumn, rows: &[Row]) -> Vec<Column> {
    let interval = |row: &Row| row.figures.intervals.get(response.name).copied();
    if rows.iter().all(|row| interval(row).is_none()) {
        return Vec::new();
    }
    let one = |(n, end): (usize, &str)| Column {
        name: format!("{}_{end}", response.name),
        unit: response.unit.to_owned(),
        label: format!(
            "{} end of the interval of {}",
            if n == 0 { "lower" } else { "upper" },
            response.label
        ),
        role: Role::Remark,
        values: Values::Numbers(rows.iter().map(|row| interval(row).map(|ends| ends[n])).collect()),
    };
    ["low", "high"].into_iter().enumerate().map(one).collect()
}

fn table(study: &Study, rows: &[Row]) -> Table {
    let numbers = |of: &dyn Fn(&Row) -> Option<f64>| Values::Numbers(rows.iter().map(of).collect());
    let words = |of: &dyn Fn(&Row) -> Option<String>| Values::Words(rows.iter().map(of).collect());
    let word = |name: &str, role: Role, values: Values| Column {
        name: name.to_owned(),
        unit: String::new(),
        label: name.to_owned(),
        role,
        values,
    };
    let filled = |text: &str| Some(text.to_owned()).filter(|text| !text.is_empty());
    let mut columns = vec![
        Column {
            unit: "-".to_owned(),
            ..word("point", Role::Key, numbers(&|row| Some(row.line.point as f64)))
        },
        word("part", Role::Key, words(&|row| filled(&row.line.part))),
        word("id", Role::Key, words(&|row| filled(row.line.id.as_str()))),
        word("model", Role::Key, words(&|row| filled(&row.figures.model))),
        word("closed_form", Role::Key, words(&|row| filled(&row.closed_form))),
        word("body", Role::Key, words(&|row| filled(&row.figures.body))),
    ];
    for factor in &study.factors {
        let level = |row: &Row| row.line.factors.iter().find(|level| level.name == factor.name).cloned();
        let values = match &factor.unit {
            Some(_) => numbers(&|row| level(row)?.number),
            None => words(&|row| Some(level(row)?.shown)),
        };
        let unit = factor.unit.as_ref().map_or_else(String::new, |unit| unit.symbol.clone());
        columns.push(Column {
            name: factor.name.clone(),
            unit,
            label: factor.label.clone(),
            role: Role::Factor,
            values,
        });
    }
    for response in responses() {
        // A factor may have the name of a dimensionless group, and is then that group.
        if study.factors.iter().any(|factor| factor.name == response.name) {
            continue;
        }
        let values: Vec<Option<f64>> = rows.iter().map(|row| row.figures.get(response.name)).collect();
        if values.iter().any(Option::is_some) {
            let ends = ends(&response, rows);
            columns.push(Column {
                name: response.name.to_owned(),
                unit: response.unit.to_owned(),
                label: response.label,
                role: Role::Response,
                values: Values::Numbers(values),
            });
            columns.extend(ends);
        }
    }
    columns.push(word("state", Role::Remark, words(&|row| filled(row.state))));
    columns.push(word("grade", Role::Remark, words(&|row| row.figures.grade.clone())));
    columns.push(word("reason", Role::Remark, words(&|row| filled(&row.reason))));
    Table { columns }
}
