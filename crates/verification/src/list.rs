//! The benchmarks, in the order of the tables.

use crate::error::VerifyError;
use crate::runner::Runner;
use crate::{
    circle, column, conservation, control, disc, element, flow, footing, light, other_codes, plate,
    positions, precision, repeat, rest, rigid, rotating, rough_wall, round_column, scaling, strip_sand,
    taylor, transport, wall, wave,
};

/// One benchmark.
pub struct Benchmark {
    /// As in the design's list.
    pub id: &'static str,
    /// A short title.
    pub title: &'static str,
    /// A few sentences for the documentation.
    pub about: &'static str,
    /// Its folder in `validation/`, if it has one.
    pub folder: Option<&'static str>,
    pub(crate) work: Procedure,
}

/// How a benchmark obtains its rows.
pub(crate) enum Procedure {
    /// By running something.
    Run(fn(&mut Runner) -> Result<(), VerifyError>),
    /// From the balances of all runs.
    Balances(fn(&mut Runner)),
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
    work: fn(&mut Runner) -> Result<(), VerifyError>,
) -> Benchmark {
    Benchmark { id, title, about, folder: Some(folder), work: Procedure::Run(work) }
}

const fn balances(
    id: &'static str,
    title: &'static str,
    about: &'static str,
    work: fn(&mut Runner),
) -> Benchmark {
    Benchmark { id, title, about, folder: None, work: Procedure::Balances(work) }
}

/// All benchmarks, in the order of the tables.
pub const BENCHMARKS: &[Benchmark] = &[
    run("A1", "Elastic wave", "A1_elastic_wave", wave::ABOUT, wave::run),
    run("A2", "Transport of the volume fraction", "A2_transport", transport::ABOUT, transport::run),
    run("A3", "Rotating block", "A3_rotating_block", rotating::ABOUT, rotating::run),
    run("A4", "Sand at rest", "A4_soil_at_rest", rest::ABOUT, rest::run),
    run("A5", "Element tests of the soil law", "A5_element_tests", element::ABOUT, element::run),
    run("A6", "Rigid bodies and friction", "A6_rigid_mechanics", rigid::ABOUT, rigid::run),
    run("A7", "One case at several scales", "A7_scaling", scaling::ABOUT, scaling::run),
    run("A8", "Repeatability and mirror image", "A8_repeatability", repeat::ABOUT, repeat::run),
    balances("A9", "Energy balance", conservation::ABOUT_ENERGY, conservation::energy),
    run("A10", "Taylor bar", "A10_taylor_bar", taylor::ABOUT, taylor::run),
    run("A11", "Position and direction", "A11_position_and_direction", positions::ABOUT, positions::run),
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
    balances("C3", "Soil volume", conservation::ABOUT_VOLUME, conservation::volume),
    balances("C4", "Soil inside the bodies", conservation::ABOUT_LEAK, conservation::leak),
    run("D3", "Free disc, towed", "D3_towed_disc", disc::ABOUT, disc::run),
    run(
        "E1",
        "Column of sand, as other codes ran it",
        "E1_sand_column",
        other_codes::ABOUT_COLUMN,
        other_codes::column,
    ),
    run(
        "E2",
        "Disc drag, as another code ran it",
        "E2_disc_drag",
        other_codes::ABOUT_DISC,
        other_codes::disc,
    ),
    run("E3", "Smooth wall in the sand of E1", "E3_wall", other_codes::ABOUT_WALL, other_codes::wall),
    run("P1", "Single precision", "P1_single_precision", precision::ABOUT, precision::run),
    run("N1", "Negative control", "N1_wrong_angle", control::ABOUT, control::run),
];

/// The id of a benchmark as typed, in either case.
#[must_use]
pub fn find(typed: &str) -> Option<&'static str> {
    BENCHMARKS.iter().map(|b| b.id).find(|id| id.eq_ignore_ascii_case(typed))
}
