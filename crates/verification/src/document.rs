//! The tables in the documents: a few figures between two markers in README.md, all of them in
//! docs/reference/verification.md.

use crate::expected_failures::ExpectedFailure;
use crate::findings::Findings;
use crate::grades;
use crate::list::{BENCHMARKS, Benchmark};
use crate::plot;
use crate::row::{Expected, Judgement, Row};
use crate::run_balances::RunBalances;
use crate::table;
use std::fmt::Write;
use std::path::Path;

const BEGIN: &str = "<!-- verify:begin -->";
const END: &str = "<!-- verify:end -->";

/// The figures that README.md shows, chosen for what readers know from textbooks: id, case, quantity, and
/// what it is called there.
const HEADLINES: [[&str; 4]; 6] = [
    ["B2", "B/h = 32", "bearing capacity factor N_c", "rough strip footing on clay, N_c"],
    [
        "B8",
        "rough cylinder, R/h = 8",
        "resistance factor N",
        "pipe moved through clay, deep, resistance factor",
    ],
    [
        "B5",
        "φ = 35°, ψ = 35°, H/h = 16, pushed 0.3 H",
        "K_p, heave included",
        "smooth wall, passive, K_p at φ = 35°",
    ],
    [
        "B6",
        "φ = 35°, δ = 23.3°, ψ = 35°, H/h = 16",
        "K_n = K_p cos δ",
        "rough wall, passive, normal part of K_p at φ = 35°",
    ],
    [
        "B4",
        "rough, φ = 35°, ψ = 35°, B/h = 16",
        "bearing capacity factor N_γ",
        "rough strip footing on sand, N_γ at φ = 35°",
    ],
    [
        "W1",
        "25 cells, T = 0.6",
        "pore pressure at the base over the exact one",
        "consolidation, pore pressure over Terzaghi's",
    ],
];

/// `text` with the headlines between its markers; `None` if it has none.
#[must_use]
pub fn between_markers(text: &str, rows: &[Row]) -> Option<String> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n{}\n{}.\n{END}{after}", headlines(rows), table::closing(rows)))
}

/// The table of the headlines; those whose benchmark was not run are left out.
fn headlines(rows: &[Row]) -> String {
    let mut text = String::from(
        "| beside an exact solution | id | exact | Coulter | off by |\n| --- | --- | --: | --: | --: |\n",
    );
    for [id, case, quantity, name] in HEADLINES {
        let found = rows.iter().find(|row| row.id == id && row.case == case && row.quantity == quantity);
        let Some(row) = found else { continue };
        let Expected::Value(exact) = row.expected else { continue };
        let mark = if row.judgement() == Judgement::Fails { "**" } else { "" };
        let off = format!("{mark}{:+.1} %{mark}", 100.0 * (row.obtained / exact - 1.0)).replace('-', "−");
        let (expected, obtained) = (table::expected(row), table::figure(row.obtained));
        let _ = writeln!(text, "| {name} | {id} | {expected} | {obtained} | {off} |");
    }
    text
}

/// One line for every benchmark: how many of its figures pass, and the one that deviates most from what was
/// expected.
fn summary(rows: &[Row]) -> String {
    let mut text = String::from(
        "| id | benchmark | pass | fail | outside | figure with the largest error over its tolerance | expected | obtained | error over tolerance |\n\
         | --- | --- | --: | --: | --: | --- | --: | --: | --: |\n",
    );
    for benchmark in BENCHMARKS {
        let own: Vec<&Row> = rows.iter().filter(|row| row.id == benchmark.id).collect();
        if own.iter().any(|row| row.judgement() != Judgement::None) {
            text.push_str(&summary_line(benchmark, &own));
        }
    }
    text
}

/// The line of one benchmark: its counts, and the judged figure with the largest error over its tolerance;
/// without judged figures, one outside a published range or any that is compared with one.
fn summary_line(benchmark: &Benchmark, rows: &[&Row]) -> String {
    let count = |judgement: Judgement| rows.iter().filter(|row| row.judgement() == judgement).count();
    let emphasised = |count: usize| if count > 0 { format!("**{count}**") } else { "0".to_owned() };
    let judged = rows.iter().filter_map(|row| Some((*row, plot::over_tolerance(row)?.abs())));
    let worst = judged.max_by(|a, b| a.1.total_cmp(&b.1));
    let first = |judgement: Judgement| rows.iter().find(|row| row.judgement() == judgement).copied();
    let (row, ratio) = match worst {
        Some((row, ratio)) => (Some(row), format!("{ratio:.2}")),
        None => (first(Judgement::Outside).or_else(|| first(Judgement::Inside)), String::new()),
    };
    let Some(row) = row else { return String::new() };
    format!(
        "| {} | {} | {} | {} | {} | {}, {} | {} | {} | {ratio} |\n",
        benchmark.id,
        benchmark.title(),
        count(Judgement::Pass),
        emphasised(count(Judgement::Fails)),
        emphasised(count(Judgement::Outside)),
        row.case,
        row.quantity,
        table::expected(row),
        table::figure(row.obtained)
    )
}

/// The text of docs/reference/verification.md.
#[must_use]
pub fn page(findings: &Findings, expected: &[ExpectedFailure]) -> String {
    let mut text = String::from(
        "# Verification\n\n\
         Made by `coulter verify --write`; do not edit. Every figure is computed by this version of the solver. \
         Expected values and tolerances are never changed to make a case pass: a case that fails stays here, marked \
         as failing. A row that is compared with a published range without a tolerance says whether it lies inside or outside it; \
         rows with – are for information. The error is a fraction of the expected value where the tolerance is one, otherwise in \
         the unit of the quantity.\n\n",
    );
    let _ = writeln!(text, "{}.\n\n{}", table::closing(&findings.rows), summary(&findings.rows));
    for benchmark in BENCHMARKS {
        let rows: Vec<Row> = findings.rows.iter().filter(|row| row.id == benchmark.id).cloned().collect();
        if rows.is_empty() {
            continue;
        }
        let _ = writeln!(text, "## {} {}\n\n{}\n", benchmark.id, benchmark.title(), benchmark.about());
        if benchmark.has_page() {
            let folder = benchmark.folder;
            let _ = writeln!(text, "More in [validation/{folder}](../../validation/{folder}/README.md).\n");
        }
        for picture in pictures(benchmark, findings) {
            let _ = writeln!(text, "![{}]({})\n", picture.what, picture.path);
        }
        text.push_str(&table::markdown(&rows));
        text.push('\n');
        sources(&rows, &mut text);
        reasons(&rows, expected, &mut text);
    }
    text.push_str(&grades::section(findings));
    for (id, why) in &findings.broken {
        let _ = writeln!(text, "**{id} produced no figures: {why}**\n");
    }
    text
}

/// A picture of a benchmark.
struct Picture {
    what: String,
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
    let both = [
        (plot::figures(&rows), "errors over tolerances", "figures"),
        (plot::runs(&name, &balances), "what the runs did", "runs"),
    ];
    both.into_iter()
        .filter_map(|(svg, what, kind)| {
            let path = format!("images/verification/{file}_{kind}.svg");
            Some(Picture { what: format!("{name}: {what}"), path, svg: svg? })
        })
        .collect()
}

fn sources(rows: &[Row], text: &mut String) {
    let mut seen: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|row| !row.source.is_empty()) {
        if !seen.contains(&row.source.as_ref()) {
            seen.push(&row.source);
        }
    }
    if !seen.is_empty() {
        let _ = writeln!(text, "Sources: {}.\n", seen.join("; "));
    }
}

fn reasons(rows: &[Row], expected: &[ExpectedFailure], text: &mut String) {
    let mut failing: Vec<(&str, Vec<String>)> = Vec::new();
    for row in rows.iter().filter(|row| row.passes() == Some(false)) {
        let reason =
            expected.iter().find(|k| k.is_about(row)).map_or("not yet explained", |k| k.reason.trim());
        let name = format!("{}, {}", row.case, row.quantity);
        match failing.iter_mut().find(|(other, _)| *other == reason) {
            Some((_, names)) => names.push(name),
            None => failing.push((reason, vec![name])),
        }
    }
    for (reason, names) in failing {
        let _ = writeln!(text, "* Fails ({}): {reason}", names.join("; "));
    }
    text.push('\n');
}

/// Writes both documents below `root`. Returns what was written.
///
/// # Errors
/// When a file cannot be written.
pub fn write(root: &Path, findings: &Findings, expected: &[ExpectedFailure]) -> std::io::Result<Vec<String>> {
    let mut written = Vec::new();
    std::fs::create_dir_all(root.join("docs/reference"))?;
    std::fs::write(root.join("docs/reference/verification.md"), page(findings, expected))?;
    written.push("docs/reference/verification.md".to_owned());
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
        assert!(summary(&[torque, drag.clone()]).contains("| 1 | 0 | **1** | disc, torque | 0 | 0 | 0.00 |"));
        assert!(summary(&[drag]).contains("| 0 | 0 | **1** | disc, drag | 15.00 to 17.00 | 14.40 |  |"));
        assert!(!summary(&[Row::info("D3", "disc", "ratio", 1.0)]).contains("D3"));
    }

    #[test]
    fn every_headline_is_a_row_of_the_suite() {
        let page =
            std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/verification.md"))
                .unwrap();
        for [id, case, quantity, _] in HEADLINES {
            assert!(page.contains(&format!("| {id} | {case} | {quantity} |")), "{id}, {case}, {quantity}");
        }
    }

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let rows =
            [Row::info("B2", "B/h = 32", "bearing capacity factor N_c", 5.2).within(5.1416, 0.02, "Prandtl")];
        let text = format!("above\n{BEGIN}\nold\n{END}\nbelow\n");
        let new = between_markers(&text, &rows).unwrap();
        assert!(new.starts_with("above\n") && new.ends_with("\nbelow\n") && !new.contains("old"));
        assert!(new.contains("N_c | B2 | 5.142 | 5.200 | +1.1 % |"), "{new}");
        let far =
            [Row::info("B2", "B/h = 32", "bearing capacity factor N_c", 6.0).within(5.1416, 0.02, "Prandtl")];
        assert!(between_markers(&text, &far).unwrap().contains("| **+16.7 %** |"));
        assert_eq!(between_markers(&new, &rows).unwrap(), new);
        assert_eq!(between_markers("no markers", &rows), None);
    }
}
