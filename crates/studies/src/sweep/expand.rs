//! From a study to its cases.

use super::id::CaseId;
use super::line::{CaseLine, FactorLevel};
use crate::study::{BaseCase, Level, ModelKind, Part, Point, Study, points};
use coulter::case::estimate::cost;
use coulter::case::form::Form;
use coulter::case::{self, Case, CaseError};
use xxhash_rust::xxh3::xxh3_64;

/// The cases of a study, in the order of its points. One that is not valid is a line, too, and says why.
///
/// # Errors
/// [`CaseError`] where the file of the case cannot be read, or a formula has no value.
pub fn expand(study: &Study) -> Result<Vec<CaseLine>, CaseError> {
    let mut lines = Vec::new();
    let mut number = 0;
    for part in study.evaluated_parts() {
        let case = study.case_of(part);
        let tree = Form::read(&case.text, &case.path)?.entries;
        let points = points(study, part, &tree)
            .map_err(|why| CaseError::unreadable(&case.path, why, "change the formula in [derived]"))?;
        for point in points {
            number += 1;
            lines.extend(part.models.iter().map(|model| line(study, part, (number, &point), *model)));
        }
    }
    Ok(lines)
}

fn line(study: &Study, part: &Part, (number, point): (usize, &Point), model: ModelKind) -> CaseLine {
    let levels = study.factors.iter().zip(&point.levels);
    let factors = levels.enumerate().filter_map(|(n, (factor, level))| {
        let Level { number, shown, .. } = level.clone()?;
        Some(FactorLevel { name: factor.name.clone(), number, shown, is_varied: part.factors.contains(&n) })
    });
    let mut line = CaseLine {
        id: CaseId::of_refused(0),
        point: number,
        part: part.name.clone(),
        case: part.case,
        model,
        meshes: part.meshes,
        factors: factors.collect(),
        set: point.set.clone(),
        memory_bytes: 0.0,
        refused: String::new(),
    };
    match read(study.case_of(part), &line) {
        Ok(case) => {
            line.id = id(&case, &line);
            if model == ModelKind::Solver {
                line.memory_bytes = cost(&case).memory_bytes;
            }
        }
        Err(error) => {
            line.id = CaseId::of_refused(xxh3_64(format!("{model:?}{:?}{}", line.set, part.case).as_bytes()));
            line.refused = reason(&error);
        }
    }
    line
}

/// The case of a line.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong with it.
pub fn read(base: &BaseCase, line: &CaseLine) -> Result<Case, CaseError> {
    match line.model {
        ModelKind::Solver => case::parse(&base.text, &base.path, &line.set),
        ModelKind::ClosedForm => {
            case::parse_for_forecast(&base.text, &base.path, &line.set).map(|(case, _)| case)
        }
    }
}

/// The id of the case of a line: the hash of the case as understood, and of what is evaluated. A run does not
/// depend on what only the closed forms read.
#[must_use]
pub fn id(case: &Case, line: &CaseLine) -> CaseId {
    let hash = |text: String| {
        let beside = line.meshes.map_or_else(String::new, |meshes| match line.model {
            ModelKind::ClosedForm => "with intervals".to_owned(),
            ModelKind::Solver => format!("on {meshes} meshes"),
        });
        xxh3_64((text + &beside).as_bytes())
    };
    match line.model {
        ModelKind::ClosedForm => CaseId::of_closed_form(hash(case::case_text_with_forecast(case))),
        ModelKind::Solver => CaseId::of_run(hash(case::case_text(case))),
    }
}

/// What is wrong with a case, in one line.
pub(super) fn reason(error: &CaseError) -> String {
    let all: Vec<String> =
        error.problems.iter().map(|problem| format!("{} ({})", problem.message, problem.cure)).collect();
    all.join("; ")
}
