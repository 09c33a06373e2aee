//! Scripts that run the cases of a study with engines that people have. Each of them does nothing but start
//! `coulter sweep run`, which leaves a case that has an outcome as it is: a script may be started again, and
//! several engines may share a study.

use super::id::CaseId;
use super::line::CaseLine;
use super::quote::{for_python, for_shell, for_snakemake};
use super::store::Store;
use crate::study::ModelKind;
use coulter::printed::is_hidden;
use coulter::run::Device;
use std::collections::BTreeSet;

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
    /// What strains the soil.
    pub device: Device,
    /// The `coulter` command.
    pub command: String,
}

/// The ids that have no outcome yet, runs of the solver first, each once.
#[must_use]
pub fn left(store: &Store, lines: &[CaseLine]) -> Vec<CaseId> {
    let mut seen = BTreeSet::new();
    let mut ids = Vec::new();
    for model in [ModelKind::Solver, ModelKind::ClosedForm] {
        for line in lines.iter().filter(|line| line.model == model) {
            if seen.insert(&line.id) && store.outcome(&line.id).is_none() {
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

/// What every script runs, as words of the shell.
struct Command {
    program: String,
    folder: String,
    threads: usize,
    /// Threads and device, as options.
    options: String,
    /// Graphics cards that a job must see to find its own, which it counts from 0.
    cards: u32,
}

impl Command {
    fn text(&self) -> String {
        format!("{} sweep run {} {}", self.program, self.folder, self.options)
    }
}

/// Threads and device, as options of `coulter sweep run`.
fn options(wish: &Wish) -> String {
    let device = match wish.device {
        Device::Processor => String::new(),
        device => format!(" --device {device}"),
    };
    format!("--threads {}{device}", wish.threads)
}

/// The script of an engine, and what to do with it.
///
/// # Errors
/// For an engine that is not known, and a folder whose name is not text.
pub fn script(store: &Store, lines: &[CaseLine], wish: &Wish) -> Result<String, String> {
    let ids = left(store, lines);
    let folder = std::path::absolute(&store.folder).unwrap_or_else(|_| store.folder.clone());
    let Some(folder) = folder.to_str() else {
        return Err(format!("the name of {} is not UTF-8; rename the folder", folder.display()));
    };
    // What a terminal or an editor shows of a script must be what it does.
    if let Some(word) = [folder, &wish.command].into_iter().find(|word| word.contains(is_hidden)) {
        return Err(format!("{word}: a control character stands in this name; rename it"));
    }
    let command = Command {
        program: for_shell(&wish.command),
        folder: for_shell(folder),
        threads: wish.threads,
        options: options(wish),
        cards: if let Device::Gpu(number) = wish.device { number.saturating_add(1) } else { 0 },
    };
    if ids.is_empty() && wish.engine != "ids" {
        let collect = format!("{} sweep collect {}", command.program, command.folder);
        return Err(format!("no case is left to run; `{collect}` writes tables, charts and the page"));
    }
    let groups: Vec<String> = ids
        .chunks(wish.chunk.max(1))
        .map(|group| group.iter().map(CaseId::as_str).collect::<Vec<_>>().join(","))
        .collect();
    match wish.engine.as_str() {
        "ids" => Ok(ids.iter().map(|id| format!("{id}\n")).collect()),
        "parallel" => Ok(parallel(&command, &groups)),
        "slurm" => Ok(slurm(&command, &groups, megabytes(lines))),
        "hyperqueue" => Ok(hyperqueue(&command, &groups)),
        "snakemake" => Ok(snakemake(&command, &ids, folder)),
        other => Err(format!("there is no engine \"{other}\"; possible: {}", ENGINES.join(", "))),
    }
}

fn listed(groups: &[String]) -> String {
    groups.iter().map(|group| format!("{group}\n")).collect()
}

fn parallel(command: &Command, groups: &[String]) -> String {
    let Command { program, folder, options, .. } = command;
    let ids = listed(groups);
    // Parallel gives what it runs to a shell once more (-q quotes it for that), and replaces words in braces
    // wherever they stand.
    let (before, run) = if [program, folder].iter().any(|word| word.contains('{')) {
        (
            format!("COULTER={program}\nSTUDY={folder}\nexport COULTER STUDY\n"),
            format!("sh -c 'exec \"$COULTER\" sweep run \"$STUDY\" {options} --id \"$1\"' sh {{}}"),
        )
    } else {
        (String::new(), format!("{} --id {{}}", command.text()))
    };
    format!(
        "#!/bin/sh\n\
         # Runs the cases that are left with GNU parallel, one job per core: sh study.sh\n\
         # More machines: add --sshloginfile nodes.txt to the line of parallel.\n\
         {before}exec parallel --will-cite --halt never --line-buffer -q {run} <<'IDS'\n{ids}IDS\n"
    )
}

fn slurm(command: &Command, groups: &[String], megabytes: f64) -> String {
    let last = groups.len().saturating_sub(1);
    let cards = match command.cards {
        0 => String::new(),
        cards => format!("#SBATCH --gres=gpu:{cards}\n"),
    };
    format!(
        "#!/bin/bash\n\
         # A job array of SLURM, one task for every line of ids: sbatch study.slurm\n\
         # Centres limit the number of tasks and how often they start: --chunk 50 puts fifty cases into each.\n\
         #SBATCH --job-name=coulter\n\
         #SBATCH --array=0-{last}\n\
         #SBATCH --ntasks=1\n\
         #SBATCH --cpus-per-task={}\n\
         #SBATCH --mem={megabytes}M\n\
         {cards}\
         #SBATCH --time=24:00:00\n\
         #SBATCH --signal=B:TERM@60\n\
         #SBATCH --requeue\n\
         #SBATCH --output=coulter-%A_%a.log\n\
         mapfile -t ids <<'IDS'\n{}IDS\n\
         # exec: the signal before the time limit reaches the run, which then leaves a checkpoint.\n\
         exec {} --id \"${{ids[$SLURM_ARRAY_TASK_ID]}}\"\n",
        command.threads,
        listed(groups),
        command.text()
    )
}

fn hyperqueue(command: &Command, groups: &[String]) -> String {
    let Command { program, folder, threads, options, .. } = command;
    // The inner shell gets program and folder as its words $0 and $1: nothing is quoted within quotes.
    format!(
        "#!/bin/sh\n\
         # A job of HyperQueue, one task for every line of ids: sh study.sh\n\
         # It needs a server (hq server start) and workers (hq worker start, or hq alloc add slurm).\n\
         list=$(mktemp)\n\
         trap 'rm -f \"$list\"' EXIT\n\
         cat > \"$list\" <<'IDS'\n{}IDS\n\
         hq submit --name coulter --cpus {threads} --each-line \"$list\" --crash-limit 5 --stdout none --stderr none -- \\\n\
         \x20   sh -c 'exec \"$0\" sweep run \"$1\" {options} --id \"$HQ_ENTRY\"' {program} {folder}\n",
        listed(groups)
    )
}

fn snakemake(command: &Command, ids: &[CaseId], folder: &str) -> String {
    let names: String = ids.iter().map(|id| format!("\"{id}\",\n       ")).collect();
    // An outcome is one even where the run is broken: only what has none fails.
    let run = format!("{} --id {{wildcards.id}} || test -e {{output}}", for_snakemake(&command.text()));
    // Braces in a name of a file stand for wildcards, which those of the folder must not: it is not part of
    // any.
    format!(
        "# Rules of Snakemake: snakemake --snakefile study.smk --cores all --keep-going\n\
         IDS = [{}]\n\
         FOLDER = {}\n\n\
         workdir: FOLDER\n\n\
         rule all:\n\
         \x20   input: expand(\"outcomes/{{id}}.json\", id=IDS)\n\n\
         rule case:\n\
         \x20   output: \"outcomes/{{id}}.json\"\n\
         \x20   threads: {}\n\
         \x20   shell: {}\n",
        names.trim_end(),
        for_python(folder),
        command.threads,
        for_python(&run)
    )
}
