//! `coulter sweep collect`: tables, charts and the page of a study.

use super::folder::{Expanded, opened, read, refused};
use crate::common::{say, say_json};
use crate::failure::Failure;
use coulter::formats;
use serde_json::json;
use std::path::PathBuf;
use studies::sweep::collect::{self, Collected, Counts, Lack};
use studies::sweep::report;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Folder of a study that was expanded, or its file where that is results/NAME
    study: PathBuf,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

pub(super) fn collect(arguments: &Arguments) -> Result<(), Failure> {
    written(&read(opened(&arguments.study)?)?, arguments.json)
}

/// Most cases without results that are listed on the terminal.
const MOST_LISTED: usize = 10;

/// Collects a study, writes its files and says what has become of its cases.
pub(super) fn written(Expanded { study, store, lines }: &Expanded, json: bool) -> Result<(), Failure> {
    let collected = collect::collect(store, study, lines);
    let files = report::write(store, study, &collected).map_err(refused)?;
    let Collected { counts, lacking, .. } = &collected;
    if json {
        say_json(&document(counts, lacking, &files))?;
    } else {
        let list: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
        say(&format!("{}\nwrote {}\n", counts.text(), list.join("\n      ")))?;
    }
    match (counts.failed + counts.missing, counts.broken + counts.refused) {
        (0, 0) => Ok(()),
        (0, _) => Err(Failure::Physics(told(lacking))),
        _ => Err(Failure::Request(told(lacking))),
    }
}

fn document(counts: &Counts, lacking: &[Lack], files: &[PathBuf]) -> serde_json::Value {
    let lacking: Vec<serde_json::Value> = lacking
        .iter()
        .map(|l| json!({ "point": l.point, "id": l.id, "state": l.state, "reason": l.reason }))
        .collect();
    json!({
        "format": formats::DOCUMENT,
        "cases": counts.cases, "done": counts.done, "broken": counts.broken, "refused": counts.refused,
        "failed": counts.failed, "missing": counts.missing, "without_results": lacking, "files": files,
    })
}

/// The cases without results, and why.
fn told(lacking: &[Lack]) -> String {
    let one = |lack: &Lack| format!("  point {} ({}) {}: {}", lack.point, lack.id, lack.state, lack.reason);
    let mut lines: Vec<String> = lacking.iter().take(MOST_LISTED).map(one).collect();
    if lacking.len() > MOST_LISTED {
        lines.push(format!("  … and {} more, in without_results.csv", lacking.len() - MOST_LISTED));
    }
    format!("{} cases have no results that can be used\n{}", lacking.len(), lines.join("\n"))
}
