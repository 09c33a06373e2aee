//! `coulter verify`: the verification suite.

use super::{Failure, say};
use crate::verify::options::Wish;
use crate::verify::row::Row;
use crate::verify::{self, document, grades, known, refine, table};
use std::io::Write;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Which benchmarks, such as A4 B1 [default: all]
    #[arg(value_name = "ID")]
    ids: Vec<String>,
    /// Only what takes about a minute in all: coarse grids
    #[arg(long)]
    fast: bool,
    /// Instead of the table: so many meshes of each benchmark that can be refined, with the observed order of convergence
    #[arg(long, value_name = "MESHES", value_parser = clap::value_parser!(u32).range(3..=5), conflicts_with_all = ["fast", "strict", "write"])]
    refine: Option<u32>,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
    /// Fail unless exactly the rows in validation/known.toml fall short
    #[arg(long)]
    strict: bool,
    /// Write the table into README.md and docs/verification.md of the current folder
    #[arg(long)]
    write: bool,
    /// Sets a key in every case that is run from a case file, such as numerics.contact=impulse; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Threads; 0 for one per core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = super::threads())]
    threads: u16,
    /// Where finished parts are kept; the same request goes on from them after a stop
    #[arg(short, long, value_name = "DIR", default_value = "results/verify")]
    output: PathBuf,
    /// Do everything anew, also what is kept
    #[arg(long)]
    fresh: bool,
}

pub(super) fn verify(arguments: &Arguments) -> Result<(), Failure> {
    let ids = ids(&arguments.ids)?;
    if arguments.write && !Path::new("validation").is_dir() {
        let message = "--write belongs to the root of the repository: there is no validation/ here";
        return Err(Failure::Request(message.into()));
    }
    let wish = Wish {
        fast: arguments.fast,
        overrides: arguments.overrides.clone(),
        threads: usize::from(arguments.threads),
        folder: Some(arguments.output.clone()),
        fresh: arguments.fresh,
    };
    let mut tell = |text: &str| {
        let _ = writeln!(std::io::stderr().lock(), "{text}");
    };
    let findings = match arguments.refine {
        Some(meshes) => {
            if let Some(id) = ids.iter().find(|id| !refine::ids().contains(id)) {
                let all = refine::ids().join(", ");
                return Err(Failure::Request(format!("{id} cannot be refined; these can: {all}")));
            }
            refine::refine(&ids, meshes, &wish, &mut tell)
        }
        None => verify::verify(&ids, &wish, &mut tell),
    };
    let known = known::known();
    if arguments.json {
        super::say_json(&findings.rows.iter().map(Row::plain).collect::<Vec<_>>())?;
    } else {
        say(&format!(
            "{}
{}
",
            table::plain(&findings.rows),
            table::closing(&findings.rows)
        ))?;
        say(&format!(
            "{}
",
            grades::closing(&findings)
        ))?;
    }
    if arguments.write {
        let written = document::write(Path::new("."), &findings, &known);
        let written = written.map_err(|e| Failure::Request(format!("the table cannot be written: {e}")))?;
        let _ = writeln!(std::io::stderr().lock(), "wrote {}", written.join(" and "));
    }
    let mut complaints: Vec<String> =
        findings.broken.iter().map(|(id, why)| format!("{id} broke down: {why}")).collect();
    if arguments.strict {
        complaints.extend(known::disagreements(&findings.rows, &known, arguments.fast));
    }
    if complaints.is_empty() { Ok(()) } else { Err(Failure::Physics(complaints.join("\n       "))) }
}

/// The ids as the suite knows them.
fn ids(typed: &[String]) -> Result<Vec<&'static str>, Failure> {
    let all = || verify::BENCHMARKS.iter().map(|b| b.id).collect::<Vec<_>>().join(", ");
    let known = |id: &String| {
        verify::find(id)
            .ok_or_else(|| Failure::Request(format!("there is no benchmark {id}; there are {}", all())))
    };
    typed.iter().map(known).collect()
}
