//! `coulter verify`: the verification suite.

use crate::common::{default_threads, say, tell};
use crate::failure::Failure;
use coulter::formats;
use serde_json::json;
use std::path::{Path, PathBuf};
use verification::expected_failures::{disagreements, expected_failures};
use verification::options::SuiteOptions;
use verification::row::Row;
use verification::{BENCHMARKS, document, grades, refine, table};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Which benchmarks, such as A4 B1 [default: all]
    #[arg(value_name = "ID")]
    ids: Vec<String>,
    /// Only what takes about a minute in all, on coarse grids
    #[arg(long)]
    fast: bool,
    /// Instead of the table: each benchmark that can be refined on this many meshes, with the observed order
    /// of convergence
    #[arg(long, value_name = "MESHES", value_parser = clap::value_parser!(u32).range(3..=5), conflicts_with_all = ["fast", "strict", "write"])]
    refine: Option<u32>,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
    /// Fail unless exactly the rows in validation/expected_failures.toml fail
    #[arg(long)]
    strict: bool,
    /// Write the figures of all benchmarks into README.md, docs/reference/verification.md and docs/data of
    /// the current folder
    #[arg(long, conflicts_with = "ids")]
    write: bool,
    /// Sets a key in every case that is run from a case file, such as numerics.contact=impulse; may be
    /// repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Threads; 0 for as many as a run has by default (`coulter run --help`)
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = crate::common::threads())]
    threads: u16,
    /// Folder of the result cache, from which the same command continues after an interruption
    #[arg(short, long, value_name = "DIR", default_value = "results/verify")]
    output: PathBuf,
    /// Ignore the result cache
    #[arg(long)]
    fresh: bool,
}

pub(super) fn verify(arguments: &Arguments) -> Result<(), Failure> {
    let ids = ids(&arguments.ids)?;
    if arguments.write && !Path::new("validation").is_dir() {
        let message = "--write must be run in the root of the repository: there is no validation/ here";
        return Err(Failure::Request(message.into()));
    }
    let options = SuiteOptions {
        fast: arguments.fast,
        overrides: arguments.overrides.clone(),
        threads: default_threads(usize::from(arguments.threads)),
        folder: Some(arguments.output.clone()),
        fresh: arguments.fresh,
        only_list: false,
    };
    let mut progress = |text: &str| {
        tell(text);
    };
    let findings = match arguments.refine {
        Some(meshes) => {
            if let Some(id) = ids.iter().find(|id| !refine::ids().contains(id)) {
                let all = refine::ids().join(", ");
                return Err(Failure::Request(format!("{id} cannot be refined; possible: {all}")));
            }
            refine::refine(&ids, meshes, &options, &mut progress)
        }
        None => verification::verify(&ids, &options, &mut progress),
    };
    let expected = expected_failures();
    if arguments.json {
        let rows: Vec<_> = findings.rows.iter().map(Row::json).collect();
        crate::common::say_json(&json!({ "format": formats::DOCUMENT, "rows": rows }))?;
    } else {
        say(&format!("{}\n{}\n", table::text(&findings.rows), table::closing(&findings.rows)))?;
        say(&format!("grades: {}\n", grades::closing(&findings)))?;
    }
    if arguments.write {
        let written = document::write(Path::new("."), &findings, &expected);
        let written = written.map_err(|e| Failure::Request(format!("the table cannot be written: {e}")))?;
        tell(&format!("wrote {}", written.join(" and ")));
    }
    let mut complaints: Vec<String> =
        findings.broken.iter().map(|(id, why)| format!("{id} broke down: {why}")).collect();
    if arguments.strict {
        complaints.extend(disagreements(&findings.rows, &expected, arguments.fast));
    }
    if complaints.is_empty() { Ok(()) } else { Err(Failure::Physics(complaints.join("\n       "))) }
}

/// The ids as the suite spells them.
fn ids(typed: &[String]) -> Result<Vec<&'static str>, Failure> {
    let all = || BENCHMARKS.iter().map(|b| b.id).collect::<Vec<_>>().join(", ");
    let find = |id: &String| {
        verification::find(id)
            .ok_or_else(|| Failure::Request(format!("there is no benchmark {id}; possible: {}", all())))
    };
    typed.iter().map(find).collect()
}
