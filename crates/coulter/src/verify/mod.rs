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
mod flow;
mod footing;
mod kept;
pub mod known;
mod ledger;
mod light;
mod line;
mod moving;
mod peers;
mod places;
pub mod plain;
mod plate;
pub mod plot;
mod precision;
pub mod refine;
mod repeat;
mod rest;
mod rigid;
mod rough_wall;
mod round_column;
pub mod row;
mod scaling;
mod specimen;
mod strip_sand;
pub mod table;
mod taylor;
mod transport;
mod turning;
mod wall;
mod wave;

use bench::{Bench, Ledgers, VerifyError, Wish};
use row::Row;
use std::time::Instant;

/// One benchmark.
pub struct Benchmark {
    /// As in the design's list.
    pub id: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// A few sentences for the documentation.
    pub about: &'static str,
    /// Its folder in `validation/`, if it has one.
    pub folder: Option<&'static str>,
    work: Work,
}

/// How a benchmark comes to its rows.
enum Work {
    /// By running something.
    Run(fn(&mut Bench) -> Result<(), VerifyError>),
    /// From the ledgers of all runs.
    Ledgers(fn(&mut Bench)),
}

impl std::fmt::Debug for Benchmark {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.id, self.title)
    }
}

const fn run(
    id: &'static str,
    title: &'static str,
    folder: &'static str,
    about: &'static str,
    work: fn(&mut Bench) -> Result<(), VerifyError>,
) -> Benchmark {
    Benchmark { id, title, about, folder: Some(folder), work: Work::Run(work) }
}

const fn ledgers(
    id: &'static str,
    title: &'static str,
    about: &'static str,
    work: fn(&mut Bench),
) -> Benchmark {
    Benchmark { id, title, about, folder: None, work: Work::Ledgers(work) }
}

/// All benchmarks, in the order of the tables.
pub const BENCHMARKS: &[Benchmark] = &[
    run("A1", "Elastic wave", "A1_elastic_wave", wave::ABOUT, wave::run),
    run("A2", "Transport of the volume fraction", "A2_transport", transport::ABOUT, transport::run),
    run("A3", "Turning block", "A3_rotating_block", turning::ABOUT, turning::run),
    run("A4", "Sand at rest", "A4_soil_at_rest", rest::ABOUT, rest::run),
    run("A5", "Element tests of the soil law", "A5_element_tests", element::ABOUT, element::run),
    run("A6", "Rigid bodies and friction", "A6_rigid_mechanics", rigid::ABOUT, rigid::run),
    run("A7", "One case at several scales", "A7_scaling", scaling::ABOUT, scaling::run),
    run("A8", "Repeatability and mirror image", "A8_repeatability", repeat::ABOUT, repeat::run),
    ledgers("A9", "Energy ledger", ledger::ABOUT_ENERGY, ledger::energy),
    run("A10", "Taylor bar", "A10_taylor_bar", taylor::ABOUT, taylor::run),
    run("A11", "Place and direction", "A11_place_and_direction", places::ABOUT, places::run),
    run("A12", "Light bodies", "A12_light_body", light::ABOUT, light::run),
    run("B1", "Smooth strip footing, Tresca", "B1_strip_footing", footing::ABOUT, footing::run),
    run("B2", "Rough strip footing, Tresca", "B2_rough_strip_footing", footing::ABOUT_ROUGH, footing::rough),
    run("B3", "Circular footing, Tresca", "B3_circular_footing", circle::ABOUT, circle::clay),
    run("B3γ", "Circular footing on sand", "B3g_circular_footing_on_sand", circle::ABOUT_SAND, circle::sand),
    run("B4", "Strip footing on sand", "B4_strip_footing_on_sand", strip_sand::ABOUT, strip_sand::run),
    run("B5", "Smooth passive wall", "B5_passive_wall", wall::ABOUT, wall::run),
    run("B6", "Rough passive wall", "B6_rough_passive_wall", rough_wall::ABOUT, rough_wall::run),
    run("B7", "Smooth inclined plate", "B7_inclined_plate", plate::ABOUT, plate::run),
    run("B8", "Deep flow, Tresca", "B8_deep_flow", flow::ABOUT, flow::run),
    run("B9", "Nearly incompressible soil", "B9_locking", footing::ABOUT_LOCKING, footing::locking),
    run("C1", "Collapse of a column of sand", "C1_column_collapse", column::ABOUT, column::run),
    run("C2", "Collapse of a round column", "C2_round_column", round_column::ABOUT, round_column::run),
    ledgers("C3", "Soil volume", ledger::ABOUT_VOLUME, ledger::volume),
    ledgers("C4", "Soil inside the bodies", ledger::ABOUT_LEAK, ledger::leak),
    run("D3", "Free disc, towed", "D3_towed_disc", disc::ABOUT, disc::run),
    run("E1", "Column of sand, as other codes ran it", "E1_sand_column", peers::ABOUT_COLUMN, peers::column),
    run("E2", "Disc drag, as another code ran it", "E2_disc_drag", peers::ABOUT_DISC, peers::disc),
    run("E3", "Smooth wall in the sand of E1", "E3_wall", peers::ABOUT_WALL, peers::wall),
    run("P1", "Single precision", "P1_single_precision", precision::ABOUT, precision::run),
    run("N1", "Negative control", "N1_wrong_angle", control::ABOUT, control::run),
];

/// What the suite found.
#[derive(Debug, Default)]
pub struct Findings {
    /// The ledgers of the runs.
    pub ledgers: Vec<Ledgers>,
    /// The rows, in the order of the benchmarks.
    pub rows: Vec<Row>,
    /// Benchmarks that gave no figures, and why.
    pub broken: Vec<(&'static str, String)>,
}

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

/// The id of a benchmark as typed, in either case.
#[must_use]
pub fn find(typed: &str) -> Option<&'static str> {
    BENCHMARKS.iter().map(|b| b.id).find(|id| id.eq_ignore_ascii_case(typed))
}
