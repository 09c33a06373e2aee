//! The benchmarks, in the order of the tables.

use super::bench::Bench;
use super::error::VerifyError;
use super::{
    circle, column, control, disc, element, flow, footing, ledger, light, peers, places, plate, precision,
    repeat, rest, rigid, rough_wall, round_column, scaling, strip_sand, taylor, transport, turning, wall,
    wave,
};

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
    pub(super) work: Work,
}

/// How a benchmark comes to its rows.
pub(super) enum Work {
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

/// The id of a benchmark as typed, in either case.
#[must_use]
pub fn find(typed: &str) -> Option<&'static str> {
    BENCHMARKS.iter().map(|b| b.id).find(|id| id.eq_ignore_ascii_case(typed))
}
