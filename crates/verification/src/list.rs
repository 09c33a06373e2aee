//! The benchmarks, in the order of the tables.

use crate::error::VerifyError;
use crate::expectations::Expectations;
use crate::runner::Runner;
use crate::{
    attitude, blade, circle, column, conservation, consolidation, control, disc, element, falls, few_cells,
    flow, footing, friction, group, light, long_tow, other_codes, plate, positions, precision, repeat, rest,
    rigid, rotating, rough_wall, round_column, scaling, softening, strip_sand, taylor, three_meshes,
    touching, transport, wall, wall_under_water, wave, yielding_box,
};
use std::sync::LazyLock;

/// One benchmark.
pub struct Benchmark {
    /// Short name of the benchmark: "B1".
    pub id: &'static str,
    /// Folder of the benchmark in `validation/`.
    pub folder: &'static str,
    /// Text of the file of what the benchmark expects.
    expected: &'static str,
    pub(crate) work: Procedure,
}

/// How a benchmark obtains its rows.
pub(crate) enum Procedure {
    /// By running something.
    Run(fn(&mut Runner) -> Result<(), VerifyError>),
    /// From the balances of all runs.
    Balances(fn(&mut Runner) -> Result<(), VerifyError>),
}

impl std::fmt::Debug for Benchmark {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.id, self.title())
    }
}

/// A benchmark: id, folder in `validation/`, kind and function.
macro_rules! benchmark {
    ($id:literal, $folder:literal, $kind:ident, $work:path) => {
        Benchmark {
            id: $id,
            folder: $folder,
            expected: include_str!(concat!("../validation/", $folder, "/expected.toml")),
            work: Procedure::$kind($work),
        }
    };
}

/// All benchmarks, in the order of the tables.
pub const BENCHMARKS: &[Benchmark] = &[
    benchmark!("A1", "A1_elastic_wave", Run, wave::run),
    benchmark!("A2", "A2_transport", Run, transport::run),
    benchmark!("A3", "A3_rotating_block", Run, rotating::run),
    benchmark!("A4", "A4_soil_at_rest", Run, rest::run),
    benchmark!("A5", "A5_element_tests", Run, element::run),
    benchmark!("A6", "A6_rigid_mechanics", Run, rigid::run),
    benchmark!("A7", "A7_scaling", Run, scaling::run),
    benchmark!("A8", "A8_repeatability", Run, repeat::run),
    benchmark!("A9", "A9_energy_balance", Balances, conservation::energy),
    benchmark!("A10", "A10_taylor_bar", Run, taylor::run),
    benchmark!("A11", "A11_position_and_direction", Run, positions::run),
    benchmark!("A12", "A12_light_body", Run, light::run),
    benchmark!("A13", "A13_bodies_that_touch", Run, touching::run),
    benchmark!("B1", "B1_strip_footing", Run, footing::run),
    benchmark!("B2", "B2_rough_strip_footing", Run, footing::rough),
    benchmark!("B3", "B3_circular_footing", Run, circle::clay),
    benchmark!("B3γ", "B3g_circular_footing_on_sand", Run, circle::sand),
    benchmark!("B4", "B4_strip_footing_on_sand", Run, strip_sand::run),
    benchmark!("B5", "B5_passive_wall", Run, wall::run),
    benchmark!("B5n", "B5n_softening_bank", Run, softening::run),
    benchmark!("B6", "B6_rough_passive_wall", Run, rough_wall::run),
    benchmark!("B7", "B7_inclined_plate", Run, plate::run),
    benchmark!("B8", "B8_deep_flow", Run, flow::run),
    benchmark!("B9", "B9_locking", Run, footing::locking),
    benchmark!("B10", "B10_strength_with_depth", Run, footing::growing_strength),
    benchmark!("B11", "B11_two_layers", Run, footing::two_layers),
    benchmark!("B12", "B12_box_at_constant_stress", Run, yielding_box::run),
    benchmark!("C1", "C1_column_collapse", Run, column::run),
    benchmark!("C2", "C2_round_column", Run, round_column::run),
    benchmark!("C3", "C3_soil_volume", Balances, conservation::volume),
    benchmark!("C4", "C4_soil_inside_bodies", Balances, conservation::leak),
    benchmark!("C5", "C5_falls_and_slots", Run, falls::run),
    benchmark!("C6", "C6_bodies_on_few_cells", Run, few_cells::run),
    benchmark!("D3", "D3_towed_disc", Run, disc::run),
    benchmark!("D8", "D8_yaw_and_tilt", Run, attitude::run),
    benchmark!("D9", "D9_discs_on_an_axle", Run, group::run),
    benchmark!("D10", "D10_long_tow", Run, long_tow::run),
    benchmark!("D11", "D11_three_meshes", Run, three_meshes::run),
    benchmark!("E1", "E1_sand_column", Run, other_codes::column),
    benchmark!("E2", "E2_disc_drag", Run, other_codes::disc),
    benchmark!("E3", "E3_wall", Run, other_codes::wall),
    benchmark!("F1", "F1_friction_on_known_faces", Run, friction::run),
    benchmark!("F2", "F2_pressure_before_a_blade", Run, blade::run),
    benchmark!("W1", "W1_consolidation", Run, consolidation::run),
    benchmark!("W2", "W2_wall_under_water", Run, wall_under_water::run),
    benchmark!("P1", "P1_single_precision", Run, precision::run),
    benchmark!("N1", "N1_wrong_angle", Run, control::run),
];

/// What the benchmarks expect, in the same order; or the benchmark whose file is wrong, and why.
static EXPECTATIONS: LazyLock<Result<Vec<Expectations>, (&'static str, String)>> = LazyLock::new(|| {
    let read = |benchmark: &Benchmark| {
        let name = format!("validation/{}/expected.toml", benchmark.folder);
        Expectations::read(&name, benchmark.expected)
            .and_then(|read| {
                if read.id == benchmark.id {
                    Ok(read)
                } else {
                    Err(format!("{name}: expected id = \"{}\"", benchmark.id))
                }
            })
            .map_err(|why| (benchmark.id, why))
    };
    BENCHMARKS.iter().map(read).collect()
});

/// What all benchmarks expect.
///
/// # Errors
/// The benchmark whose file is wrong, and why; a test makes sure that none is.
pub fn expectations() -> Result<&'static [Expectations], (&'static str, String)> {
    EXPECTATIONS.as_deref().map_err(Clone::clone)
}

impl Benchmark {
    /// Expectations of the benchmark; `None` if the files cannot be read.
    fn expectations(&self) -> Option<&'static Expectations> {
        expectations().ok()?.iter().find(|known| known.id == self.id)
    }

    /// A short title.
    #[must_use]
    pub fn title(&self) -> &'static str {
        self.expectations().map_or("", |known| &known.title)
    }

    /// A few sentences for the documentation.
    #[must_use]
    pub fn about(&self) -> &'static str {
        self.expectations().map_or("", |known| &known.about)
    }

    /// Whether a page explains the benchmark; one on the balances of other runs has none.
    #[must_use]
    pub fn has_page(&self) -> bool {
        matches!(self.work, Procedure::Run(_))
    }
}

/// The id of a benchmark as typed, in either case.
#[must_use]
pub fn find(typed: &str) -> Option<&'static str> {
    BENCHMARKS.iter().map(|b| b.id).find(|id| id.eq_ignore_ascii_case(typed))
}
