//! The verification suite: benchmarks with a known answer, run, read and compared.
//!
//! A benchmark is a folder in `validation/`, which explains it and says in `expected.toml` what is expected
//! of every figure, and a file here, which varies the case and reads the figures. It uses a
//! [`runner::Runner`], which puts each figure beside what is expected: the [`row::Row`]s. Benchmarks that a
//! case file can describe are run from one, through the public API.

mod advection;
mod attitude;
mod bearing;
mod blade;
mod cache;
mod circle;
mod column;
mod confined;
mod conservation;
mod consolidation;
mod control;
mod disc;
pub mod document;
mod element;
pub mod error;
pub mod expectation;
pub mod expectations;
pub mod expected_failures;
mod falls;
mod few_cells;
pub mod findings;
mod flow;
mod footing;
mod friction;
pub mod grades;
mod grid_convergence;
mod group;
pub mod json_row;
mod light;
mod line;
mod list;
mod long_tow;
mod mechanisms;
mod moving;
pub mod options;
mod other_codes;
mod plate;
pub mod plot;
mod positions;
mod precision;
mod probe;
pub mod refine;
mod repeat;
mod rest;
mod rigid;
mod rotating;
mod rough_wall;
mod round_column;
pub mod row;
pub mod run_balances;
pub mod runner;
mod scaling;
mod softening;
mod specimen;
mod strip_sand;
pub mod table;
mod taylor;
mod three_meshes;
mod touching;
pub mod trace;
mod transport;
mod wall;
mod wall_under_water;
mod wave;
mod yielding_box;

pub use findings::Findings;
pub use list::{BENCHMARKS, Benchmark, expectations, find};

use list::Procedure;
use options::SuiteOptions;
use runner::Runner;
use std::time::Instant;

/// Runs the benchmarks with these ids (all if there are none); `progress` is called with every line on
/// progress.
pub fn verify(ids: &[&'static str], options: &SuiteOptions, progress: &mut dyn FnMut(&str)) -> Findings {
    let is_wanted = |b: &Benchmark| ids.is_empty() || ids.contains(&b.id);
    // Benchmarks on the balances, asked for alone, need all runs; otherwise those of the runs asked for with
    // them.
    let needs_all = BENCHMARKS.iter().all(|b| !is_wanted(b) || matches!(b.work, Procedure::Balances(_)));
    let expectations = match expectations() {
        Ok(expectations) => expectations,
        Err(unreadable) => return Findings { broken: vec![unreadable], ..Findings::default() },
    };
    let mut runner = Runner::new(expectations, options, progress);
    let mut broken = Vec::new();
    let runs =
        BENCHMARKS.iter().filter(|b| matches!(b.work, Procedure::Run(_)) && (needs_all || is_wanted(b)));
    let count = runs.clone().count();
    for (n, benchmark) in runs.enumerate() {
        let Procedure::Run(work) = benchmark.work else { continue };
        let clock = Instant::now();
        runner.report_progress(&format!("{} {} … ({} of {count})", benchmark.id, benchmark.title(), n + 1));
        if let Err(error) = runner.part(benchmark.id, "all", work) {
            runner.report_progress(&format!("{}: broke down: {error}", benchmark.id));
            broken.push((benchmark.id, error.to_string()));
        }
        runner.report_progress(&format!("{}: {:.1} s", benchmark.id, clock.elapsed().as_secs_f64()));
    }
    for benchmark in BENCHMARKS.iter().filter(|b| is_wanted(b)) {
        if let Procedure::Balances(work) = benchmark.work
            && let Err(error) = work(&mut runner)
        {
            broken.push((benchmark.id, error.to_string()));
        }
    }
    let mut rows = runner.rows;
    rows.retain(|row| ids.is_empty() || ids.contains(&row.id));
    rows.sort_by_key(|row| BENCHMARKS.iter().position(|b| b.id == row.id));
    Findings { balances: runner.balances, rows, broken }
}
