//! The verification suite: benchmarks with a known answer, run, read and compared.
//!
//! A benchmark is a file here and a folder in `validation/` that explains it. It runs on a [`bench::Bench`] and leaves
//! [`row::Row`]s there. Benchmarks that a case file can describe are run from one, through the door that users have.

pub mod bench;
mod carried;
mod circle;
mod column;
mod confined;
mod control;
mod disc;
pub mod document;
mod element;
pub mod error;
pub mod findings;
mod flow;
mod footing;
pub mod grades;
mod kept;
pub mod known;
mod ledger;
mod light;
mod line;
mod list;
mod moving;
pub mod options;
mod peers;
mod places;
pub mod plain;
mod plate;
pub mod plot;
mod precision;
mod probe;
pub mod refine;
mod repeat;
mod rest;
mod rigid;
mod rough_wall;
mod round_column;
pub mod row;
pub mod run_ledgers;
mod scaling;
mod specimen;
mod strip_sand;
pub mod table;
mod taylor;
pub mod trace;
mod transport;
mod turning;
mod wall;
mod wave;

pub use findings::Findings;
pub use list::{BENCHMARKS, Benchmark, find};

use bench::Bench;
use list::Work;
use options::Wish;
use std::time::Instant;

/// Runs the benchmarks with these ids (all if there are none); `tell` hears how it goes.
pub fn verify(ids: &[&'static str], wish: &Wish, tell: &mut dyn FnMut(&str)) -> Findings {
    let is_wanted = |b: &Benchmark| ids.is_empty() || ids.contains(&b.id);
    // Ledgers that are asked for by themselves are those of all runs, else those of the runs asked for besides.
    let needs_all = BENCHMARKS.iter().all(|b| !is_wanted(b) || matches!(b.work, Work::Ledgers(_)));
    let mut bench = Bench::new(wish, tell);
    let mut broken = Vec::new();
    let runs = BENCHMARKS.iter().filter(|b| matches!(b.work, Work::Run(_)) && (needs_all || is_wanted(b)));
    let count = runs.clone().count();
    for (n, benchmark) in runs.enumerate() {
        let Work::Run(work) = benchmark.work else { continue };
        let clock = Instant::now();
        bench.tell(&format!("{} {} … ({} of {count})", benchmark.id, benchmark.title, n + 1));
        if let Err(error) = bench.part(benchmark.id, "all of it", work) {
            bench.tell(&format!("{}: broke down: {error}", benchmark.id));
            broken.push((benchmark.id, error.to_string()));
        }
        bench.tell(&format!("{}: {:.1} s", benchmark.id, clock.elapsed().as_secs_f64()));
    }
    for benchmark in BENCHMARKS.iter().filter(|b| is_wanted(b)) {
        if let Work::Ledgers(work) = benchmark.work {
            work(&mut bench);
        }
    }
    let mut rows = bench.rows;
    rows.retain(|row| ids.is_empty() || ids.contains(&row.id));
    rows.sort_by_key(|row| BENCHMARKS.iter().position(|b| b.id == row.id));
    Findings { ledgers: bench.ledgers, rows, broken }
}
