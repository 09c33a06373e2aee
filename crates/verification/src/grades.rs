//! How the runs of the suite are graded: whether those with the right answer are graded good, and how the
//! others are.

use crate::findings::Findings;
use crate::row::{Judgement, Row};
use crate::run_balances::RunBalances;
use coulter::trust;

/// Whether all judged rows that depend on a run pass: those of its own case or, where the rows are named
/// differently, all rows of its benchmark.
fn passes(run: &RunBalances, rows: &[Row]) -> bool {
    let of_benchmark = || rows.iter().filter(|row| row.id == run.id);
    let own: Vec<&Row> = of_benchmark().filter(|row| row.case.starts_with(&run.case)).collect();
    let judged = |rows: &[&Row]| rows.iter().any(|row| row.passes().is_some());
    let rows = if judged(&own) { own } else { of_benchmark().collect() };
    judged(&rows) && rows.iter().all(|row| row.judgement() != Judgement::Fails)
}

/// Number of runs with each verdict: good, doubtful, broken.
fn counts<'a>(runs: impl Iterator<Item = &'a RunBalances>) -> [usize; 3] {
    let mut counts = [0; 3];
    for run in runs {
        counts[run.trust.verdict as usize] += 1;
    }
    counts
}

/// One line: the verdicts of the runs whose figures pass, and of the others.
#[must_use]
pub fn closing(findings: &Findings) -> String {
    let (right, others): (Vec<&RunBalances>, Vec<&RunBalances>) =
        findings.balances.iter().partition(|run| passes(run, &findings.rows));
    let line = |runs: &[&RunBalances]| {
        let [good, doubtful, broken] = counts(runs.iter().copied());
        format!("{} runs: {good} good, {doubtful} doubtful, {broken} broken", runs.len())
    };
    let [good, doubtful, _] = counts(right.iter().copied());
    let per_cent = 100.0 * (good + doubtful) as f64 / right.len().max(1) as f64;
    format!(
        "{per_cent:.1} % of the runs whose figures pass are good or doubtful ({}); the others: {}",
        line(&right),
        line(&others)
    )
}

/// The runs as lists for docs/data/verification.json: run, whether its figures pass, verdict, checks that are
/// not good.
pub(crate) fn as_data(findings: &Findings) -> Vec<serde_json::Value> {
    let entries = findings.balances.iter().map(|run| {
        let checks: Vec<String> = run.trust.concerns().iter().map(|c| described(c)).collect();
        let figures = if passes(run, &findings.rows) { "pass" } else { "fail, or are not judged" };
        serde_json::json!([
            format!("{}, {}", run.id, run.case),
            figures,
            run.trust.verdict.name(),
            checks.join("; ")
        ])
    });
    entries.collect()
}

fn described(check: &trust::Check) -> String {
    let value = check
        .value
        .map_or("not available".to_owned(), |v| format!("{} {}", crate::table::figure(v), check.unit));
    let mark = if check.verdict == trust::Verdict::Broken { " (broken)" } else { "" };
    format!("{} {}{mark}", check.name, value.trim_end())
}
