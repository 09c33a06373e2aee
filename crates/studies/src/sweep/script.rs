//! Scripts that run the cases of a study with engines that people have. Each of them does nothing but start `coulter sweep run`, which
//! leaves a case that has an outcome as it is: a script may be started again, and several engines may share a study.

use super::line::CaseLine;
use super::store::Store;
use crate::study::ModelKind;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// The engines, by their names on the command line.
pub const ENGINES: [&str; 5] = ["parallel", "slurm", "hyperqueue", "snakemake", "ids"];

/// How a script is to be written.
#[derive(Clone, Debug)]
pub struct Wish {
    /// The engine.
    pub engine: String,
    /// Cases of one job: one engine task runs so many, one after the other.
    pub chunk: usize,
    /// Threads of each run of the solver.
    pub threads: usize,
    /// The `coulter` command.
    pub command: String,
}

/// The ids that have no outcome yet, runs of the solver first, each once.
#[must_use]
pub fn left(store: &Store, lines: &[CaseLine]) -> Vec<String> {
    let mut seen = BTreeSet::new();
    let mut ids = Vec::new();
    for model in [ModelKind::Solver, ModelKind::ClosedForm] {
        for line in lines.iter().filter(|line| line.model == model) {
            if seen.insert(line.id.as_str()) && store.outcome(&line.id).is_none() {
                ids.push(line.id.clone());
            }
        }
    }
    ids
}

/// The largest memory that a case needs, with a margin [MB].
fn megabytes(lines: &[CaseLine]) -> f64 {
    let most = lines.iter().map(|line| line.memory_bytes).fold(50e6, f64::max);
    (1.25 * most / 1e6).ceil() + 50.0
}

/// The script of an engine, and what to do with it.
///
/// # Errors
/// For an engine that is not known.
pub fn script(store: &Store, lines: &[CaseLine], wish: &Wish) -> Result<String, String> {
    let ids = left(store, lines);
    if ids.is_empty() && wish.engine != "ids" {
        let collect = format!("{} sweep collect {}", wish.command, store.folder.display());
        return Err(format!("no case is left to run; `{collect}` writes tables, charts and the page"));
    }
    let folder = std::path::absolute(&store.folder).unwrap_or_else(|_| store.folder.clone());
    let folder = quoted(&folder.display().to_string());
    let groups: Vec<String> = ids.chunks(wish.chunk.max(1)).map(|group| group.join(",")).collect();
    let run = format!("{} sweep run {folder} --threads {}", quoted(&wish.command), wish.threads);
    match wish.engine.as_str() {
        "ids" => Ok(ids.iter().map(|id| format!("{id}\n")).collect()),
        "parallel" => Ok(parallel(&run, &groups)),
        "slurm" => Ok(slurm(&run, &groups, wish, megabytes(lines))),
        "hyperqueue" => Ok(hyperqueue(&run, &groups, wish)),
        "snakemake" => Ok(snakemake(&run, &ids, wish, &folder)),
        other => Err(format!("there is no engine \"{other}\"; possible: {}", ENGINES.join(", "))),
    }
}

/// A word as the shell takes it.
fn quoted(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+:@%".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

fn listed(groups: &[String]) -> String {
    groups.iter().fold(String::new(), |mut text, group| {
        let _ = writeln!(text, "{group}");
        text
    })
}

fn parallel(run: &str, groups: &[String]) -> String {
    format!(
        "#!/bin/sh\n\
         # Runs the cases that are left with GNU parallel, one job per core: sh study.sh\n\
         # More machines: add --sshloginfile nodes.txt to the line of parallel.\n\
         exec parallel --will-cite --halt never --line-buffer {} --id {{}} <<'IDS'\n{}IDS\n",
        run,
        listed(groups)
    )
}

fn slurm(run: &str, groups: &[String], wish: &Wish, megabytes: f64) -> String {
    let last = groups.len().saturating_sub(1);
    format!(
        "#!/bin/bash\n\
         # A job array of SLURM, one task for every line of ids: sbatch study.slurm\n\
         # Centres limit the number of tasks and how often they start: --chunk 50 puts fifty cases into each.\n\
         #SBATCH --job-name=coulter\n\
         #SBATCH --array=0-{last}\n\
         #SBATCH --ntasks=1\n\
         #SBATCH --cpus-per-task={}\n\
         #SBATCH --mem={megabytes}M\n\
         #SBATCH --time=24:00:00\n\
         #SBATCH --signal=B:TERM@60\n\
         #SBATCH --requeue\n\
         #SBATCH --output=coulter-%A_%a.log\n\
         mapfile -t ids <<'IDS'\n{}IDS\n\
         # exec: the signal before the time limit reaches the run, which then leaves a checkpoint.\n\
         exec {run} --id \"${{ids[$SLURM_ARRAY_TASK_ID]}}\"\n",
        wish.threads,
        listed(groups)
    )
}

fn hyperqueue(run: &str, groups: &[String], wish: &Wish) -> String {
    format!(
        "#!/bin/sh\n\
         # A job of HyperQueue, one task for every line of ids: sh study.sh\n\
         # It needs a server (hq server start) and workers (hq worker start, or hq alloc add slurm).\n\
         list=$(mktemp)\n\
         trap 'rm -f \"$list\"' EXIT\n\
         cat > \"$list\" <<'IDS'\n{}IDS\n\
         hq submit --name coulter --cpus {} --each-line \"$list\" --crash-limit 5 --stdout none --stderr none -- \\\n\
         \x20   sh -c '{run} --id \"$HQ_ENTRY\"'\n",
        listed(groups),
        wish.threads
    )
}

fn snakemake(run: &str, ids: &[String], wish: &Wish, folder: &str) -> String {
    let names: String = ids.iter().fold(String::new(), |mut text, id| {
        let _ = write!(text, "\"{id}\",\n       ");
        text
    });
    let folder = folder.trim_matches('\'');
    format!(
        "# Rules of Snakemake: snakemake --snakefile study.smk --cores all --keep-going\n\
         IDS = [{}]\n\
         FOLDER = {folder:?}\n\n\
         rule all:\n\
         \x20   input: expand(FOLDER + \"/outcomes/{{id}}.json\", id=IDS)\n\n\
         rule case:\n\
         \x20   output: FOLDER + \"/outcomes/{{id}}.json\"\n\
         \x20   threads: {}\n\
         \x20   shell: {:?}\n",
        names.trim_end(),
        wish.threads,
        // An outcome is one even where the run is broken: only what has none fails.
        format!("{run} --id {{wildcards.id}} || test -e {{output}}")
    )
}
