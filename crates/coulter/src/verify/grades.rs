//! How the runs of the suite are graded: whether those with the right answer are believed, and what the others are told.

use super::findings::Findings;
use super::row::{Row, Verdict};
use super::run_ledgers::Ledgers;
use crate::trust;
use std::fmt::Write;

/// Whether the judged rows that a run is behind all pass: those of its own case or, where the rows are named otherwise, all
/// of its benchmark.
fn passes(run: &Ledgers, rows: &[Row]) -> bool {
    let of_benchmark = || rows.iter().filter(|row| row.id == run.id);
    let own: Vec<&Row> = of_benchmark().filter(|row| row.case.starts_with(&run.case)).collect();
    let judged = |rows: &[&Row]| rows.iter().any(|row| row.passes().is_some());
    let rows = if judged(&own) { own } else { of_benchmark().collect() };
    judged(&rows) && rows.iter().all(|row| row.verdict() != Verdict::FallsShort)
}

/// Number of runs with each verdict: good, doubtful, broken.
fn counts<'a>(runs: impl Iterator<Item = &'a Ledgers>) -> [usize; 3] {
    let mut counts = [0; 3];
    for run in runs {
        counts[run.trust.verdict as usize] += 1;
    }
    counts
}

/// One line: the verdicts of the runs whose figures pass, and of the others.
#[must_use]
pub fn closing(findings: &Findings) -> String {
    let (right, others): (Vec<&Ledgers>, Vec<&Ledgers>) =
        findings.ledgers.iter().partition(|run| passes(run, &findings.rows));
    let line = |runs: &[&Ledgers]| {
        let [good, doubtful, broken] = counts(runs.iter().copied());
        format!("{} runs: {good} good, {doubtful} doubtful, {broken} broken", runs.len())
    };
    let [good, doubtful, _] = counts(right.iter().copied());
    let share = 100.0 * (good + doubtful) as f64 / right.len().max(1) as f64;
    format!(
        "graded: of the runs whose figures pass {share:.1} % good or doubtful ({}); the others, {}",
        line(&right),
        line(&others)
    )
}

/// The section of docs/verification.md.
#[must_use]
pub fn section(findings: &Findings) -> String {
    let mut text = format!(
        "## How the runs are graded\n\nEvery run of the suite gets the verdict that a user's run gets \
         ([reliability.md](reliability.md)). {}.\n\n| run | figures | verdict | checks that are not good |\n| --- | --- | --- | --- |\n",
        closing(findings)
    );
    for run in &findings.ledgers {
        let checks: Vec<String> = run.trust.doubts().iter().map(|c| told(c)).collect();
        let figures = if passes(run, &findings.rows) { "pass" } else { "fall short or not judged" };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {}, {} | {figures} | {} | {} |",
            run.id,
            run.case,
            run.trust.verdict.name(),
            checks.join("; ")
        );
    }
    text.push('\n');
    text
}

fn told(check: &trust::Check) -> String {
    let value =
        check.value.map_or("no figure".to_owned(), |v| format!("{} {}", super::table::figure(v), check.unit));
    let mark = if check.verdict == trust::Verdict::Broken { "**" } else { "" };
    format!("{mark}{} {}{mark}", check.name, value.trim_end())
}
