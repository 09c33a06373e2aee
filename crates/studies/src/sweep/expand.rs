//! From a study to its cases.

use super::id::CaseId;
use super::line::{CaseLine, FactorLevel};
use crate::study::{ModelKind, Part, Point, Study, points};
use coulter::case::estimate::cost;
use coulter::case::form::Form;
use coulter::case::{self, Case, CaseError};
use xxhash_rust::xxh3::xxh3_64;

/// The cases of a study, in the order of its points. One that is not valid is a line, too, and says why.
///
/// # Errors
/// [`CaseError`] where the file of the case cannot be read, or a formula has no value.
pub fn expand(study: &Study) -> Result<Vec<CaseLine>, CaseError> {
    let tree = Form::read(&study.case_text, &study.case_path)?.entries;
    let mut lines = Vec::new();
    let mut number = 0;
    for part in &study.parts {
        let points = points(study, part, &tree)
            .map_err(|why| CaseError::unreadable(&study.case_path, why, "change the formula in [derived]"))?;
        for point in points {
            number += 1;
            lines.extend(part.models.iter().map(|model| line(study, part, (number, &point), *model)));
        }
    }
    Ok(lines)
}

fn line(study: &Study, part: &Part, (number, point): (usize, &Point), model: ModelKind) -> CaseLine {
    let levels = study.factors.iter().zip(&point.levels);
    let factors = levels.filter_map(|(factor, level)| {
        let level = level.as_ref()?;
        Some(FactorLevel { name: factor.name.clone(), number: level.number, shown: level.shown.clone() })
    });
    let mut line = CaseLine {
        id: CaseId::of_refused(0),
        point: number,
        part: part.name.clone(),
        model,
        factors: factors.collect(),
        set: point.set.clone(),
        memory_bytes: 0.0,
        refused: String::new(),
    };
    match read(&study.case_text, &study.case_path, &line) {
        Ok(case) => {
            line.id = id(&case, model);
            if model == ModelKind::Solver {
                line.memory_bytes = cost(&case).memory_bytes;
            }
        }
        Err(error) => {
            line.id = CaseId::of_refused(xxh3_64(format!("{model:?}{:?}", line.set).as_bytes()));
            line.refused = reason(&error);
        }
    }
    line
}

/// The case of a line.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong with it.
pub fn read(text: &str, path: &str, line: &CaseLine) -> Result<Case, CaseError> {
    match line.model {
        ModelKind::Solver => case::parse(text, path, &line.set),
        ModelKind::ClosedForm => case::parse_for_forecast(text, path, &line.set).map(|(case, _)| case),
    }
}

/// The id of a case: the hash of the case as understood, and of what is evaluated. A run does not depend on
/// what only the closed forms read.
#[must_use]
pub fn id(case: &Case, model: ModelKind) -> CaseId {
    match model {
        ModelKind::ClosedForm => {
            CaseId::of_closed_form(xxh3_64(case::case_text_with_forecast(case).as_bytes()))
        }
        ModelKind::Solver => CaseId::of_run(xxh3_64(case::case_text(case).as_bytes())),
    }
}

/// What is wrong with a case, in one line.
pub(super) fn reason(error: &CaseError) -> String {
    let all: Vec<String> =
        error.problems.iter().map(|problem| format!("{} ({})", problem.message, problem.cure)).collect();
    all.join("; ")
}
