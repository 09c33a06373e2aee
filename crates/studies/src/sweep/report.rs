//! The files of a study that has been collected: tables, charts, the page.

use super::collect::Collected;
use super::figures::{self, FigureSet};
use super::part_rows::{self, of_part};
use super::store::{Store, StudyError};
use crate::analysis::{Analysis, AnalysisRequest, NamedTable, USUAL_RESPONSES, analyse};
use crate::page::{Page, page};
use crate::study::{ChartWish, Part, Study};
use crate::table::{Column, Role, Table, Values, to_csv, to_parquet};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Writes the collected files of a study into its folder; returns their paths.
///
/// # Errors
/// Where one cannot be written.
pub fn write(store: &Store, study: &Study, collected: &Collected) -> Result<Vec<PathBuf>, StudyError> {
    let table = &collected.table;
    let other = |why: String| StudyError::Content { path: store.folder.clone(), problem: why };
    let csv = to_csv(table).map_err(|error| other(error.to_string()))?;
    let parquet = to_parquet(table).map_err(|error| other(error.to_string()))?;
    let lacking = to_csv(&lacking(collected)).map_err(|error| other(error.to_string()))?;
    let leading = leading(table);
    let FigureSet { figures, shown, remarks } = figures::figures(store, study, &leading);
    let mut analysis = analysis(study, &leading);
    analysis.remarks.splice(0..0, remarks);
    let mut files = vec![
        store.write("table.csv", csv.as_bytes())?,
        store.write("table.parquet", &parquet)?,
        store.write("without_results.csv", lacking.as_bytes())?,
    ];
    for chart in &analysis.charts {
        store.write(&format!("charts/{}.svg", chart.name), chart.svg.as_bytes())?;
    }
    files.extend(figures::write(store, &figures)?);
    for NamedTable { name, table, .. } in &analysis.tables {
        let text = to_csv(table).map_err(|error| other(error.to_string()))?;
        files.push(store.write(&format!("{name}.csv"), text.as_bytes())?);
    }
    let description = collected.counts.text();
    let mut whole = Page::of(&study.title, &description, table, analysis);
    whole.figures = shown;
    whole.tables.push(points(study, table));
    let text = page(&whole);
    files.push(store.write("report.html", text.map_err(|error| other(error.to_string()))?.as_bytes())?);
    Ok(files)
}

/// The first row of every point and model: of a run of several bodies that of all of them together.
fn leading(table: &Table) -> Table {
    let (points, models) =
        (table.numbers("point").unwrap_or_default(), table.words("model").unwrap_or_default());
    let mut seen = BTreeSet::new();
    let mut is_new = |(point, model): (&Option<f64>, &Option<String>)| {
        seen.insert((point.map(f64::to_bits), model.clone()))
    };
    let keep: Vec<bool> = points.iter().zip(models).map(&mut is_new).collect();
    part_rows::rows(table, &keep)
}

/// The points with what the study looks at, as the page shows them.
fn points(study: &Study, table: &Table) -> NamedTable {
    let charts = study.charts.iter().flat_map(|chart| [&chart.x, &chart.y]);
    let mut looked_at: Vec<&str> = study.responses.iter().chain(charts).map(String::as_str).collect();
    if study.responses.is_empty() {
        looked_at.extend(USUAL_RESPONSES);
    }
    let is_shown = |column: &&Column| match column.role {
        Role::Key => !["id", "closed_form"].contains(&column.name.as_str()),
        Role::Factor => true,
        Role::Response => looked_at.contains(&column.name.as_str()),
        // Why rows are not used stands above all else.
        Role::Remark => column.name != "reason",
    };
    let columns = table.columns.iter().filter(is_shown).cloned().collect();
    NamedTable { name: "table".to_owned(), title: "Points".to_owned(), table: Table { columns } }
}

/// The cases without results as a table.
fn lacking(collected: &Collected) -> Table {
    let all = &collected.lacking;
    let words = |name: &str, values: Vec<Option<String>>| Column {
        name: name.to_owned(),
        unit: String::new(),
        label: name.to_owned(),
        role: Role::Remark,
        values: Values::Words(values),
    };
    let point = Values::Numbers(all.iter().map(|lack| Some(lack.point as f64)).collect());
    Table {
        columns: vec![
            Column { unit: "-".to_owned(), values: point, ..words("point", Vec::new()) },
            words("id", all.iter().map(|lack| Some(lack.id.to_string())).collect()),
            words("state", all.iter().map(|lack| Some(lack.state.clone())).collect()),
            words("reason", all.iter().map(|lack| Some(lack.reason.clone())).collect()),
        ],
    }
}

/// What the study says: each part for itself, since each has a design of its own.
fn analysis(study: &Study, table: &Table) -> Analysis {
    let mut all = Analysis::default();
    for part in study.evaluated_parts().filter(|part| !part.factors.is_empty()) {
        let is_asked = |chart: &&ChartWish| match &chart.part {
            Some(name) => *name == part.name,
            None => study.parts.len() == 1,
        };
        let mut asked = study.charts.iter().filter(is_asked);
        let has_charts = asked.clone().next().is_some();
        let request = AnalysisRequest {
            responses: study.responses.clone(),
            has_collapse: asked.any(|chart| chart.collapse && chart.y == "F_H_bar" && chart.x == "Z"),
            seed: part.seed,
            ..Default::default()
        };
        add(&mut all, analyse(&of_part(table, part), &request), part, has_charts);
    }
    all
}

/// Remarks, `drag (solver): there is no tornado`, of which those that say the same of several stand once.
fn grouped(remarks: Vec<String>) -> Vec<String> {
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    for remark in remarks {
        let (of, what) = remark.split_once(": ").map_or(("", remark.as_str()), |(of, what)| (of, what));
        match found.iter_mut().find(|(known, _)| known == what) {
            Some((_, all)) => all.push(of.to_owned()),
            None => found.push((what.to_owned(), vec![of.to_owned()])),
        }
    }
    let text = |(what, of): (String, Vec<String>)| match of.as_slice() {
        [one] if one.is_empty() => what,
        [one] => format!("{one}: {what}"),
        several => format!("{} and {} more: {what}", several[0], several.len() - 1),
    };
    found.into_iter().map(text).collect()
}

/// Adds the analysis of a part, named after it in a study of parts; without charts where the file asks for
/// some of the part.
fn add(all: &mut Analysis, found: Analysis, part: &Part, has_charts: bool) {
    let is_named = !part.name.is_empty();
    for mut chart in found.charts.into_iter().filter(|_| !(is_named && has_charts)) {
        if is_named {
            chart.name = format!("{}_{}", part.name, chart.name);
            chart.caption = format!("Part {}. {}", part.name, chart.caption);
        }
        all.charts.push(chart);
    }
    for mut table in found.tables {
        if is_named {
            table.name = format!("{}_{}", part.name, table.name);
            table.title = format!("{}: {}", part.name, table.title);
        }
        table.name = format!("tables/{}", table.name);
        all.tables.push(table);
    }
    let told = grouped(found.remarks).into_iter();
    all.remarks.extend(told.map(|text| if is_named { format!("Part {}: {text}", part.name) } else { text }));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_said_of_several_stands_once() {
        let remarks = ["drag: no", "sinkage: no", "alone", "slip: other", "lift: no"].map(str::to_owned);
        assert_eq!(grouped(remarks.to_vec()), ["drag and 2 more: no", "alone", "slip: other"]);
    }
}
