//! The analysis of a study: every response of every model.

use super::effects::{EffectRow, effect_table};
use super::factors::{VariedFactor, varied_factors};
use super::indices::{IndexRow, index_table};
use super::named::NamedTable;
use super::request::AnalysisRequest;
use super::response::{Answer, Question};
use super::sample::Sample;
use crate::charts::{ChartRequest, NamedChart, collapse_chart, models};
use crate::table::{Column, Table, Values};
use std::collections::BTreeSet;

/// Responses that are analysed unless others are asked for.
pub const USUAL_RESPONSES: [&str; 3] = ["drag", "vertical", "sinkage"];
/// The groups of a collapse that every study with them gets: y, x.
const COLLAPSE: [&str; 2] = ["F_H_bar", "Z"];

/// The analysis of a study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Analysis {
    /// Charts. Names are unique.
    pub charts: Vec<NamedChart>,
    /// `indices`, and `effects_…` for each response with main effects.
    pub tables: Vec<NamedTable>,
    /// What could not be computed and why, a sentence each.
    pub remarks: Vec<String>,
}

/// Analyses the table of a study: the rows that are done. Nothing fails: what cannot be computed is among the
/// remarks.
#[must_use]
pub fn analyse(table: &Table, request: &AnalysisRequest) -> Analysis {
    let table = &table.without_unused();
    let mut analysis = Analysis::default();
    analysis.charts.extend(usual_collapse(table, request));
    let factors = varied_factors(table);
    if factors.is_empty() {
        analysis.remarks.push("No factor varies: there are no effects.".to_owned());
    } else {
        let mut rows = Vec::new();
        for response in responses(table, request, &mut analysis.remarks) {
            rows.extend(add_response(&mut analysis, (table, request), &factors, response));
        }
        if !rows.is_empty() {
            let (name, title) = ("indices".to_owned(), "What each factor means".to_owned());
            analysis.tables.insert(0, NamedTable { name, title, table: index_table(&rows) });
        }
    }
    make_unique(&mut analysis.charts);
    analysis
}

/// The responses to analyse; those asked for that the table lacks are remarked.
fn responses<'a>(table: &'a Table, request: &AnalysisRequest, remarks: &mut Vec<String>) -> Vec<&'a Column> {
    let numbers =
        |name: &str| table.column(name).filter(|column| matches!(column.values, Values::Numbers(_)));
    if request.responses.is_empty() {
        return USUAL_RESPONSES.iter().filter_map(|name| numbers(name)).collect();
    }
    let mut found = Vec::new();
    for name in &request.responses {
        match numbers(name) {
            Some(column) => found.push(column),
            None => remarks.push(format!("There is no response `{name}` of numbers.")),
        }
    }
    found
}

/// Adds what there is to say of a response, for each model; its rows for the table of indices.
fn add_response(
    analysis: &mut Analysis,
    (table, request): (&Table, &AnalysisRequest),
    factors: &[VariedFactor<'_>],
    response: &Column,
) -> Vec<IndexRow> {
    let Values::Numbers(values) = &response.values else { return Vec::new() };
    let all = models(table);
    let (mut rows, mut effects): (Vec<IndexRow>, Vec<EffectRow>) = (Vec::new(), Vec::new());
    for class in all.iter().filter(|class| request.models.is_empty() || request.models.contains(&class.label))
    {
        let model = if all.len() > 1 { class.label.as_str() } else { "" };
        let question = Question { response, model, factors, seed: request.seed };
        let sample = Sample::of(factors, values, &class.rows);
        if sample.values.len() < 2 {
            // A model that does not know this response at all is no news.
            if !sample.values.is_empty() {
                analysis.remarks.push(question.said("only one point has a value"));
            }
        } else if !sample.varies() {
            analysis.remarks.push(question.said("it is the same at all points"));
        } else {
            let answer: Answer = question.answer(&sample);
            analysis.charts.extend(answer.charts);
            analysis.remarks.extend(answer.remarks);
            rows.extend(answer.rows);
            for (k, levels) in answer.effects {
                effects.extend(levels.iter().map(|level| EffectRow::of(model, &factors[k], *level)));
            }
        }
    }
    if !effects.is_empty() {
        analysis.tables.push(effect_table(response, &effects));
    }
    rows
}

/// The collapse of drag over depth, both dimensionless, unless it was asked for or does not vary.
fn usual_collapse(table: &Table, request: &AnalysisRequest) -> Option<NamedChart> {
    let [y, x] = COLLAPSE;
    let varies = |name: &str| {
        let mut present = table.numbers(name)?.iter().flatten();
        let first = present.next()?;
        present.any(|other| other != first).then_some(())
    };
    varies(x).and(varies(y))?;
    if request.has_collapse {
        return None;
    }
    let family = if models(table).len() > 1 {
        Some("model".to_owned())
    } else {
        varied_factors(table).first().map(|factor| factor.column.name.clone())
    };
    let chart =
        ChartRequest { x: x.to_owned(), y: y.to_owned(), family, collapse: true, ..ChartRequest::default() };
    collapse_chart(table, &chart).ok()
}

/// Numbers the second and later charts of one name.
fn make_unique(charts: &mut [NamedChart]) {
    let mut names = BTreeSet::new();
    for chart in charts {
        let base = chart.name.clone();
        let mut number = 2;
        while !names.insert(chart.name.clone()) {
            chart.name = format!("{base}_{number}");
            number += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::charts::samples::{column as plain, grid};
    use crate::statistics::design::sobol;
    use crate::table::Role;

    /// A table of one model over a Sobol design of three factors, the last of which does nothing.
    fn filled(points: usize) -> Table {
        let design = sobol(points, 3, 1).unwrap_or_default();
        let factor = |name: &str, k: usize| {
            plain(name, "m", Role::Factor, Values::Numbers(design.iter().map(|x| Some(x[k])).collect()))
        };
        let drag = design.iter().map(|x| Some(100.0 + 3.0 * x[0] + 4.0 * x[1] * x[1])).collect();
        let level = design.iter().map(|_| Some(2.0)).collect();
        Table {
            columns: vec![
                factor("a", 0),
                factor("b", 1),
                factor("c", 2),
                plain("drag", "N", Role::Response, Values::Numbers(drag)),
                plain("sinkage", "m", Role::Response, Values::Numbers(level)),
            ],
        }
    }

    #[test]
    fn a_design_that_fills_its_space_gives_indices() {
        let analysis = analyse(&filled(64), &AnalysisRequest::default());
        let names: Vec<&str> = analysis.charts.iter().map(|chart| chart.name.as_str()).collect();
        assert_eq!(names, ["main_effects_drag", "tornado_drag", "surrogate_drag", "sobol_drag"]);
        assert_eq!(analysis.remarks, ["sinkage: it is the same at all points."]);
        let table = &analysis.tables[0].table;
        let total: Vec<f64> = table.numbers("total").unwrap().iter().flatten().copied().collect();
        // Variances of 3a and 4b²: 9/12 and 16 (1/5 − 1/9).
        assert!(
            (total[0] - 0.345).abs() < 0.02 && (total[1] - 0.655).abs() < 0.02 && total[2] < 0.01,
            "{total:?}"
        );
        assert!(table.numbers("rank_coefficient").unwrap()[0].unwrap() > 0.4);
        assert_eq!(analysis, analyse(&filled(64), &AnalysisRequest::default()));
    }

    #[test]
    fn a_design_that_does_not_fill_its_space_says_so() {
        let analysis = analyse(&filled(20), &AnalysisRequest::default());
        assert!(
            analysis.remarks.iter().any(|remark| remark.contains("30 are needed")),
            "{:?}",
            analysis.remarks
        );
        assert!(analysis.charts.iter().any(|chart| chart.name == "tornado_drag"));
        let grid = analyse(&grid(), &AnalysisRequest::default());
        assert!(grid.remarks.iter().any(|remark| remark.contains("19 points for 3")), "{:?}", grid.remarks);
        assert!(grid.charts.iter().any(|chart| chart.name == "tornado_drag_plain_model"));
    }

    #[test]
    fn a_single_factor_has_no_tornado_and_no_indices() {
        let mut table = filled(64);
        table.columns.retain(|column| !["b", "c"].contains(&column.name.as_str()));
        let analysis = analyse(&table, &AnalysisRequest::default());
        let names: Vec<&str> = analysis.charts.iter().map(|chart| chart.name.as_str()).collect();
        assert_eq!(names, ["main_effects_drag"]);
        assert!(analysis.charts[0].svg.contains(">a [m]<") && !analysis.charts[0].svg.contains("place in"));
        assert_eq!(
            analysis.tables.iter().map(|table| table.name.as_str()).collect::<Vec<_>>(),
            ["effects_drag"]
        );
        assert!(
            !analysis.remarks.iter().any(|remark| remark.contains("Sobol") || remark.contains("tornado"))
        );
    }

    #[test]
    fn rows_that_are_not_done_are_in_no_chart() {
        let mut table = grid();
        let Values::Numbers(drag) = &mut table.columns[4].values else { panic!("numbers") };
        // A broken run keeps its figure.
        drag[3] = Some(1e9);
        let drawn = |table: &Table| analyse(table, &AnalysisRequest::default());
        assert_eq!(drawn(&table), drawn(&grid()));
    }

    #[test]
    fn responses_that_are_not_there_are_remarked() {
        let request = AnalysisRequest {
            has_collapse: false,
            responses: vec!["lift".into()],
            models: vec!["solver".into()],
            seed: 0,
        };
        let analysis = analyse(&grid(), &request);
        assert_eq!((analysis.charts.len(), analysis.remarks.len()), (0, 1));
        assert!(analyse(&Table::default(), &AnalysisRequest::default()).remarks[0].contains("No factor"));
    }
}
