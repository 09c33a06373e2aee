//! The files of a study that has been collected: tables, charts, the page.

use super::collect::Collected;
use super::store::{Store, StudyError};
use crate::analysis::{Analysis, AnalysisRequest, NamedTable, USUAL_RESPONSES, analyse};
use crate::charts::ChartRequest;
use crate::page::{Page, page};
use crate::study::{Part, Study};
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
    let analysis = analysis(study, &leading(table));
    let mut files = vec![
        store.write("table.csv", csv.as_bytes())?,
        store.write("table.parquet", &parquet)?,
        store.write("without_results.csv", lacking.as_bytes())?,
    ];
    for chart in &analysis.charts {
        store.write(&format!("charts/{}.svg", chart.name), chart.svg.as_bytes())?;
    }
    for NamedTable { name, table, .. } in &analysis.tables {
        let text = to_csv(table).map_err(|error| other(error.to_string()))?;
        files.push(store.write(&format!("{name}.csv"), text.as_bytes())?);
    }
    let description = collected.counts.text();
    let mut shown = Page::of(&study.title, &description, table, analysis);
    shown.tables.push(points(study, table));
    let text = page(&shown);
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
    rows(table, &keep)
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

/// What the study says: each part for itself, since each has a design of its own, and the charts that the
/// file asks for.
fn analysis(study: &Study, table: &Table) -> Analysis {
    let mut all = Analysis::default();
    for part in study.evaluated_parts() {
        let rows = of_part(table, part);
        let request = AnalysisRequest {
            responses: study.responses.clone(),
            charts: charts(study, Some(part)),
            seed: part.seed,
            ..Default::default()
        };
        add(&mut all, analyse(&rows, &request), part, &request.charts);
    }
    // Charts over all parts; a study of one part has had its own.
    let over_all = charts(study, None);
    if !over_all.is_empty() {
        let request = AnalysisRequest { charts: over_all, ..Default::default() };
        let analysis = analyse(&without_factors(table), &request);
        all.charts.extend(analysis.charts.into_iter().filter(|chart| is_asked_for(study, &chart.name)));
    }
    // What was asked for comes first.
    all.charts.sort_by_key(|chart| !is_asked_for(study, &chart.name));
    all
}

fn is_asked_for(study: &Study, name: &str) -> bool {
    study.charts.iter().any(|chart| name == chart.name)
}

/// The charts that the file asks for of a part, or of all parts.
fn charts(study: &Study, part: Option<&Part>) -> Vec<ChartRequest> {
    let is_single = study.parts.len() == 1;
    let wanted = study.charts.iter().filter(|chart| match (&chart.part, part) {
        (Some(name), Some(part)) => *name == part.name,
        (None, Some(_)) => is_single,
        (None, None) => !is_single,
        (Some(_), None) => false,
    });
    wanted
        .map(|chart| ChartRequest {
            name: chart.name.clone(),
            x: chart.x.clone(),
            y: chart.y.clone(),
            family: chart.family.clone(),
            logarithmic: chart.logarithmic,
            logarithmic_x: chart.logarithmic_x,
            collapse: chart.collapse,
        })
        .collect()
}

/// Adds the analysis of a part. Where the file names charts of it, only these are drawn; of a study of parts,
/// others are named after their part.
fn add(all: &mut Analysis, found: Analysis, part: &Part, asked: &[ChartRequest]) {
    let is_asked = |name: &str| asked.iter().any(|chart| chart.name == name);
    let is_named = !part.name.is_empty();
    for mut chart in found.charts {
        if is_named && !asked.is_empty() && !is_asked(&chart.name) {
            continue;
        }
        if is_named && !is_asked(&chart.name) {
            chart.name = format!("{}_{}", part.name, chart.name);
        }
        if is_named {
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
    let told = found.remarks.into_iter();
    all.remarks.extend(told.map(|text| if is_named { format!("Part {}: {text}", part.name) } else { text }));
}

/// The rows of a part, with the factors that it varies.
fn of_part(table: &Table, part: &Part) -> Table {
    if part.name.is_empty() {
        return table.clone();
    }
    let names = table.words("part").unwrap_or_default();
    let keep: Vec<bool> = names.iter().map(|name| name.as_deref() == Some(part.name.as_str())).collect();
    rows(table, &keep)
}

/// The rows of a table that are kept.
fn rows(table: &Table, keep: &[bool]) -> Table {
    let columns =
        table.columns.iter().map(|column| Column { values: kept(&column.values, keep), ..column.clone() });
    Table { columns: columns.collect() }
}

fn kept(values: &Values, keep: &[bool]) -> Values {
    match values {
        Values::Numbers(list) => Values::Numbers(
            list.iter().zip(keep).filter(|(_, keep)| **keep).map(|(value, _)| *value).collect(),
        ),
        Values::Words(list) => Values::Words(
            list.iter().zip(keep).filter(|(_, keep)| **keep).map(|(word, _)| word.clone()).collect(),
        ),
    }
}

/// The table with its factors as plain columns: no effects are looked for.
fn without_factors(table: &Table) -> Table {
    let plain = |column: &Column| match column.role {
        Role::Factor => Column { role: Role::Key, ..column.clone() },
        _ => column.clone(),
    };
    Table { columns: table.columns.iter().map(plain).collect() }
}
