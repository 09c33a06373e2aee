//! `coulter import`: a case from an input deck of Abaqus.

use crate::common::say;
use crate::failure::Failure;
use coulter::case::{Case, CaseError, Problem, load};
use coulter_import::{Imported, Refused, Units};
use deck::{Deck, Entry, Outcome};
use std::fmt::Write;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The input deck (.inp); files that it includes lie in its folder or below
    deck: PathBuf,
    /// Where to write: a folder, or the case file, beside which everything else is written [default: a folder
    /// with the name of the deck, in the current one]
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// Units of length, mass and time in the deck, such as mm-t-s or m-kg-s [default: those in which its
    /// gravity is that of the Earth and its soil weighs what soil does]
    #[arg(long, value_name = "UNITS")]
    units: Option<Units>,
    /// Overwrite existing files
    #[arg(long)]
    force: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let stem =
        arguments.deck.file_stem().map_or_else(|| "case".to_owned(), |stem| plain(&stem.to_string_lossy()));
    let deck = deck::read(&arguments.deck).map_err(Failure::Request)?;
    let shown = arguments.deck.display().to_string();
    let imported = coulter_import::import(&deck, arguments.units.as_ref(), &stem);
    let imported = imported.map_err(|refused| Failure::Case(error(&shown, &refused)))?;
    let output = arguments.output.clone().unwrap_or_else(|| stem.clone().into());
    let case = if output.extension().is_some_and(|ending| ending == "toml") {
        output
    } else {
        output.join(stem + ".toml")
    };
    let report = case.with_extension("import.md");
    write_all(&case, &report, &imported, arguments.force)?;
    // What was written is read back before it counts as done.
    let read = load(&case, &[])?;
    say(&summary(&deck, &imported, &read))?;
    let [case, report] = [case, report].map(|path| path.display().to_string());
    say(&format!("report   {report}\nwrote {case}; next: coulter check {case}\n"))
}

/// A name for files, from that of the deck.
fn plain(stem: &str) -> String {
    let letters =
        stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' || c == '_' { c } else { '-' });
    letters.take(80).collect()
}

fn write_all(case: &Path, report: &Path, imported: &Imported, force: bool) -> Result<(), Failure> {
    let folder = case.parent().map(Path::to_path_buf).unwrap_or_default();
    let mut files: Vec<(PathBuf, &[u8])> =
        imported.files.iter().map(|(name, bytes)| (folder.join(name), bytes.as_slice())).collect();
    files.push((report.to_path_buf(), imported.report.as_bytes()));
    files.push((case.to_path_buf(), imported.case.as_bytes()));
    if let Some((there, _)) = files.iter().find(|(path, _)| !force && path.exists()) {
        let message =
            format!("{} exists already; --force overwrites it, -o FOLDER writes elsewhere", there.display());
        return Err(Failure::Request(message));
    }
    let problem = |path: &Path, error: std::io::Error| {
        Failure::Request(format!("{} cannot be written: {error}", path.display()))
    };
    std::fs::create_dir_all(&folder).map_err(|error| problem(&folder, error))?;
    for (path, bytes) in files {
        std::fs::write(&path, bytes).map_err(|error| problem(&path, error))?;
    }
    Ok(())
}

/// What is refused, at its lines.
fn error(name: &str, refused: &Refused) -> CaseError {
    let missing = refused.missing.iter().map(|what| Problem::new("", what.clone(), ""));
    let mut error = CaseError::new(name, missing.collect());
    for (number, source) in refused.sources.iter().enumerate() {
        let here =
            |entry: &&Entry| matches!(entry.outcome, Outcome::Refused(_)) && entry.place.file == number;
        let mut starts = vec![0];
        starts.extend(source.text.match_indices('\n').map(|(at, _)| at + 1));
        let problems = refused.entries.iter().filter(here).map(|entry| {
            let start = starts.get(entry.place.line.saturating_sub(1)).copied().unwrap_or(0);
            let end = source.text[start..].find(['\r', '\n']).map_or(source.text.len(), |n| start + n);
            let message = format!("*{}: {}", entry.keyword.to_lowercase(), entry.outcome.text());
            (start..end, Problem::new("", message, ""))
        });
        let found = CaseError::in_text(&source.name, &source.text, problems.collect());
        error.problems.extend(found.problems);
        error.unseen += found.unseen;
    }
    error
}

/// Counts, what is approximated and ignored, and how well the cells fit.
fn summary(deck: &Deck, imported: &Imported, case: &Case) -> String {
    let mut text = String::new();
    let count = |rank: u8| imported.entries.iter().filter(|entry| entry.outcome.rank() == rank).count();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "keywords {}: {} understood, {} approximated, {} ignored",
        imported.entries.len(),
        count(0),
        count(2),
        count(1)
    );
    for (rank, word) in [(2, "approximated"), (1, "ignored")] {
        for entry in imported.entries.iter().filter(|entry| entry.outcome.rank() == rank) {
            let keyword = entry.keyword.to_lowercase();
            let place = deck.place(entry.place);
            let _ = writeln!(text, "{word} {place} *{keyword}: {}", entry.outcome.text());
        }
    }
    let cells = case.grid.faces.each_ref().map(|faces| (faces.len() - 1).to_string()).join(" × ");
    let _ =
        writeln!(text, "cells    {cells}, of the deck {}", imported.cells.map(|n| n.to_string()).join(" × "));
    text
}
