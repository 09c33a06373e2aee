//! The tables in the documents: a few figures between two markers in README.md, a line for each benchmark in
//! docs/reference/verification.md, all of them in docs/data/verification.json.

use crate::expected_failures::ExpectedFailure;
use crate::findings::Findings;
use crate::grades;
use crate::list::{BENCHMARKS, Benchmark};
use crate::plot;
use crate::row::{Expected, Judgement, Row};
use crate::run_balances::RunBalances;
use crate::table;
use serde_json::json;
use std::path::Path;

const BEGIN: &str = "<!-- verify:begin -->";
const END: &str = "<!-- verify:end -->";

/// The figures that README.md shows, chosen for what readers know from textbooks: id, case, quantity, and
/// what it is called there.
const HEADLINES: [[&str; 4]; 6] = [
    ["B2", "B/h = 32", "bearing capacity factor N_c", "strip footing on clay, N_c"],
    ["W1", "25 cells, T = 0.6", "pore pressure at the base over the exact one", "consolidation"],
    [
        "B5",
        "φ = 35°, ψ = 35°, H/h = 16, pushed 0.3 H",
        "K_p, heave included",
        "smooth passive wall, K_p at 35°",
    ],
    ["B6", "φ = 35°, δ = 23.3°, ψ = 35°, H/h = 16", "K_n = K_p cos δ", "rough passive wall"],
    ["B8", "rough cylinder, R/h = 8", "resistance factor N", "pipe deep in clay"],
    [
        "B4",
        "rough, φ = 35°, ψ = 35°, B/h = 16",
        "bearing capacity factor N_γ",
        "strip footing on sand, N_γ at 35°",
    ],
];

/// `text` with the headlines between its markers; `None` if it has none.
#[must_use]
pub fn between_markers(text: &str, rows: &[Row]) -> Option<String> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n{}\n{END}{after}", sentence(rows)))
}

/// The headlines whose benchmark was run: name, id, exact value, row, and by how much it is off.
fn headlines(rows: &[Row]) -> impl Iterator<Item = (&'static str, &'static str, f64, &Row, String)> {
    HEADLINES.iter().filter_map(|[id, case, quantity, name]| {
        let row = rows.iter().find(|row| row.id == *id && row.case == *case && row.quantity == *quantity)?;
        let Expected::Value(exact) = row.expected else { return None };
        let mark = if row.judgement() == Judgement::Fails { "**" } else { "" };
        let off = format!("{:+.1} %", 100.0 * (row.obtained / exact - 1.0)).replace('-', "−");
        Some((*name, *id, exact, row, format!("{mark}{off}{mark}")))
    })
}

/// The headlines as a sentence, and one on all rows.
fn sentence(rows: &[Row]) -> String {
    let errors: Vec<String> = headlines(rows).map(|(name, _, _, _, off)| format!("{name} {off}")).collect();
    format!(
        "Compared with exact solutions: {}. Of all rows [{}](docs/reference/verification.md).",
        errors.join("; "),
        table::closing(rows)
    )
}

/// The headlines as a table.
fn known(rows: &[Row]) -> String {
    let lines = headlines(rows).map(|(name, id, exact, row, off)| {
        format!("| {name} | {id} | {} | {} | {off} |\n", table::figure(exact), table::figure(row.obtained))
    });
    format!(
        "| | id | exact | Coulter | error |\n| --- | --- | --: | --: | --: |\n{}",
        lines.collect::<String>()
    )
}

/// One line for every benchmark: how many of its figures pass, and the largest error over its tolerance.
fn summary(rows: &[Row]) -> String {
    let mut text = String::from(
        "| id | benchmark | pass | fail | outside | largest error over its tolerance |\n\
         | --- | --- | --: | --: | --: | --: |\n",
    );
    for benchmark in BENCHMARKS {
        let own: Vec<&Row> = rows.iter().filter(|row| row.id == benchmark.id).collect();
        if own.iter().any(|row| row.judgement() != Judgement::None) {
            text.push_str(&summary_line(benchmark, &own));
        }
    }
    text
}

fn summary_line(benchmark: &Benchmark, rows: &[&Row]) -> String {
    let count = |judgement: Judgement| rows.iter().filter(|row| row.judgement() == judgement).count();
    let emphasised = |count: usize| if count > 0 { format!("**{count}**") } else { "0".to_owned() };
    let worst = rows.iter().filter_map(|row| plot::over_tolerance(row)).map(f64::abs).reduce(f64::max);
    format!(
        "| {} | {} | {} | {} | {} | {} |\n",
        benchmark.id,
        benchmark.title(),
        count(Judgement::Pass),
        emphasised(count(Judgement::Fails)),
        emphasised(count(Judgement::Outside)),
        worst.map_or(String::new(), |ratio| format!("{ratio:.2}"))
    )
}

/// The text of docs/reference/verification.md.
#[must_use]
pub fn page(findings: &Findings) -> String {
    format!(
        "# Verification\n\n\
         <!-- Made by `coulter verify --write`. -->\n\n\
         How close the solver comes to exact solutions, published figures and its own symmetries. Expected values and tolerances \
         are fixed before a run and never changed to make it pass; a figure that fails stays here. *Outside* counts figures that \
         are compared with a published range and lie outside it.\n\n\
         All {} figures, with case, expected value, tolerance, source, and the reason of each failure, are in \
         [verification.json](../data/verification.json); the book shows them in a [table to search](../data/verification.html). \
         `coulter verify ID` computes them anew.\n\n\
         {}\n{}.\n\n{}\n## Grades\n\n\
         Every run of the suite is [graded](reliability.md) as a run of yours is; {}.\n",
        findings.rows.len(),
        known(&findings.rows),
        table::closing(&findings.rows),
        summary(&findings.rows),
        grades::closing(findings)
    ) + &broken(findings)
}

fn broken(findings: &Findings) -> String {
    findings.broken.iter().map(|(id, why)| format!("\n**{id} produced no figures: {why}**\n")).collect()
}

/// The figures as the document docs/data/verification.json, a row a line.
#[must_use]
pub fn data(findings: &Findings, expected: &[ExpectedFailure]) -> String {
    let benchmarks = BENCHMARKS.iter().filter_map(|benchmark| {
        let rows: Vec<Row> = findings.rows.iter().filter(|row| row.id == benchmark.id).cloned().collect();
        let head = json!({
            "id": benchmark.id, "title": benchmark.title(), "about": benchmark.about(),
            "page": benchmark.has_page().then(|| format!("validation/{}/README.md", benchmark.folder)),
            "pictures": pictures(benchmark, findings).iter().map(|p| &p.path).collect::<Vec<_>>(),
        });
        (!rows.is_empty())
            .then(|| with_list(&head, "rows", &table::as_data(&rows, |row| reason(row, expected))))
    });
    let benchmarks: Vec<String> = benchmarks.collect();
    let runs: Vec<String> = grades::as_data(findings).iter().map(ToString::to_string).collect();
    format!(
        "{{\"heads\": {},\n\"benchmarks\": [\n{}\n],\n\"runs\": [\n{}\n]}}\n",
        json!(table::DATA_HEADS),
        benchmarks.join(",\n"),
        runs.join(",\n")
    )
}

/// An object with a list added to it, an entry a line.
fn with_list(head: &serde_json::Value, name: &str, entries: &[serde_json::Value]) -> String {
    let lines: Vec<String> = entries.iter().map(ToString::to_string).collect();
    let head = head.to_string();
    format!("{}, \"{name}\": [\n{}\n]}}", head.trim_end_matches('}'), lines.join(",\n"))
}

/// Why a row fails; empty for one that does not.
fn reason<'a>(row: &Row, expected: &'a [ExpectedFailure]) -> &'a str {
    if row.passes() != Some(false) {
        return "";
    }
    expected.iter().find(|known| known.is_about(row)).map_or("not yet explained", |known| known.reason.trim())
}

/// A picture of a benchmark.
struct Picture {
    /// Path of the picture, relative to docs/.
    path: String,
    svg: String,
}

/// The errors of a benchmark over their tolerances, and what its runs did.
fn pictures(benchmark: &Benchmark, findings: &Findings) -> Vec<Picture> {
    let rows: Vec<Row> = findings.rows.iter().filter(|row| row.id == benchmark.id).cloned().collect();
    let balances: Vec<&RunBalances> = findings.balances.iter().filter(|run| run.id == benchmark.id).collect();
    let name = format!("{} {}", benchmark.id, benchmark.title());
    let file = benchmark.id.replace('γ', "g");
    let both = [(plot::figures(&rows), "figures"), (plot::runs(&name, &balances), "runs")];
    both.into_iter()
        .filter_map(|(svg, kind)| {
            Some(Picture { path: format!("images/verification/{file}_{kind}.svg"), svg: svg? })
        })
        .collect()
}

/// Writes the documents below `root`. Returns what was written.
///
/// # Errors
/// When a file cannot be written.
pub fn write(root: &Path, findings: &Findings, expected: &[ExpectedFailure]) -> std::io::Result<Vec<String>> {
    let mut written = Vec::new();
    for (path, text) in [
        ("docs/reference/verification.md", page(findings)),
        ("docs/data/verification.json", data(findings, expected)),
    ] {
        std::fs::create_dir_all(root.join(path).parent().unwrap_or(root))?;
        std::fs::write(root.join(path), text)?;
        written.push(path.to_owned());
    }
    let folder = root.join("docs/images/verification");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    std::fs::create_dir_all(&folder)?;
    for picture in BENCHMARKS.iter().flat_map(|b| pictures(b, findings)) {
        std::fs::write(root.join("docs").join(&picture.path), picture.svg)?;
    }
    written.push("docs/images/verification".to_owned());
    if let Ok(readme) = std::fs::read_to_string(root.join("README.md"))
        && let Some(new) = between_markers(&readme, &findings.rows)
    {
        std::fs::write(root.join("README.md"), new)?;
        written.push("README.md".to_owned());
    }
    Ok(written)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_benchmark_outside_a_published_range_says_so() {
        let drag = Row::info("D3", "disc", "drag", 14.4).compared_with(15.0, 17.0, "trial");
        let torque = Row::info("D3", "disc", "torque", 0.0).at_most(0.01, "equilibrium");
        assert!(summary(&[torque, drag.clone()]).contains("| 1 | 0 | **1** | 0.00 |"));
        assert!(summary(&[drag]).contains("| 0 | 0 | **1** |  |"));
        assert!(!summary(&[Row::info("D3", "disc", "ratio", 1.0)]).contains("D3"));
    }

    #[test]
    fn every_headline_is_a_row_of_the_suite() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/data/verification.json");
        let data: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        for [id, case, quantity, _] in HEADLINES {
            let benchmark = data["benchmarks"].as_array().unwrap().iter().find(|b| b["id"] == id).unwrap();
            let rows = benchmark["rows"].as_array().unwrap();
            assert!(rows.iter().any(|row| row[0] == case && row[1] == quantity), "{id}, {case}, {quantity}");
        }
    }

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let rows =
            [Row::info("B2", "B/h = 32", "bearing capacity factor N_c", 5.2).within(5.1416, 0.02, "Prandtl")];
        let text = format!("above\n{BEGIN}\nold\n{END}\nbelow\n");
        let new = between_markers(&text, &rows).unwrap();
        assert!(new.starts_with("above\n") && new.ends_with("\nbelow\n") && !new.contains("old"));
        assert!(new.contains("strip footing on clay, N_c +1.1 %."), "{new}");
        let far =
            [Row::info("B2", "B/h = 32", "bearing capacity factor N_c", 6.0).within(5.1416, 0.02, "Prandtl")];
        assert!(between_markers(&text, &far).unwrap().contains("N_c **+16.7 %**"));
        assert_eq!(between_markers(&new, &rows).unwrap(), new);
        assert_eq!(between_markers("no markers", &rows), None);
    }
}
