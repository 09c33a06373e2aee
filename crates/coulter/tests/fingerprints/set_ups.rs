//! Short runs of every kind.
#![allow(unreachable_pub)]

use coulter::case::{self, Case};
use std::path::{Path, PathBuf};

/// A run of so many steps.
pub struct SetUp {
    pub name: &'static str,
    /// Case file below the root of the repository.
    pub case: &'static str,
    pub overrides: &'static [&'static str],
    pub threads: usize,
    pub steps: u32,
}

const fn set_up(
    name: &'static str,
    case: &'static str,
    overrides: &'static [&'static str],
    threads: usize,
    steps: u32,
) -> SetUp {
    SetUp { name, case, overrides, threads, steps }
}

pub const SINGLE: &str = "numerics.precision=\"single\"";
/// Remaps, which else come every few hundred steps.
const OFTEN: &str = "numerics.remap_displacement=0.01";
const PENALTY: &str = "numerics.contact=\"penalty\"";

/// Every family of the verification suite, both precisions, both contact methods, one to three threads.
pub const SET_UPS: [SetUp; 35] = [
    set_up(
        "sand at rest",
        "validation/A4_soil_at_rest/case.toml",
        &["ground.surface=\"25 mm\"", "grid.growth=1.1"],
        1,
        300,
    ),
    set_up("sand that moves", "validation/A4_soil_at_rest/case.toml", &[VELOCITY], 2, 300),
    set_up("elastic bounce", "validation/A6_rigid_mechanics/bouncing.toml", &[], 2, 400),
    set_up("elastic bounce, penalty", "validation/A6_rigid_mechanics/bouncing.toml", &[PENALTY], 1, 400),
    set_up("rolling wheel", "validation/A6_rigid_mechanics/rolling.toml", &["grid.cell=\"25 mm\""], 1, 600),
    set_up("sliding block", "validation/A6_rigid_mechanics/sliding.toml", &[], 3, 600),
    set_up("wall under water", "validation/W2_wall_under_water/case.toml", &[OFTEN], 2, 400),
    set_up("plane wheel", "validation/A7_scaling/case.toml", &[OFTEN], 1, 400),
    set_up("towed disc", "validation/A8_repeatability/case.toml", &[OFTEN], 1, 400),
    set_up(
        "towed disc, 2 threads, single",
        "validation/A8_repeatability/case.toml",
        &[SINGLE, OFTEN],
        2,
        400,
    ),
    set_up("towed disc, penalty", "validation/A8_repeatability/case.toml", &[PENALTY, OFTEN], 3, 400),
    set_up(
        "towed disc, penalty, single",
        "validation/A8_repeatability/case.toml",
        &[PENALTY, SINGLE],
        1,
        400,
    ),
    set_up("strip on a moving bank", "validation/A8_repeatability/moving.toml", MOVING, 2, 300),
    set_up("Taylor bar", "validation/A10_taylor_bar/case.toml", &[], 1, 500),
    set_up("Taylor bar, single", "validation/A10_taylor_bar/case.toml", &[SINGLE], 3, 500),
    set_up("Taylor bar on a block", "validation/A10_taylor_bar/on_block.toml", &[], 2, 500),
    set_up("pushed block", "validation/A11_position_and_direction/block.toml", COARSE, 1, 500),
    set_up(
        "pushed rotated block",
        "validation/A11_position_and_direction/rotated_block.toml",
        ROTATED,
        2,
        500,
    ),
    set_up("light cylinder", "validation/A12_light_body/case.toml", &[], 1, 800),
    set_up("rough strip footing", "validation/B2_rough_strip_footing/case.toml", COARSE, 2, 500),
    set_up("circular footing on sand", "validation/B3g_circular_footing_on_sand/case.toml", COARSE, 1, 150),
    set_up("passive wall, single", "validation/B5_passive_wall/case.toml", &[SINGLE], 2, 500),
    set_up("sphere deep in clay", "validation/B8_deep_flow/sphere.toml", COARSE, 3, 200),
    set_up("column collapse", "validation/C1_column_collapse/case.toml", &["grid.cell=\"10 mm\""], 1, 1000),
    set_up(
        "round column, single",
        "validation/C2_round_column/case.toml",
        &[SINGLE, "grid.cell=\"20 mm\""],
        2,
        600,
    ),
    set_up("locked disc", "validation/E2_disc_drag/case.toml", &[], 2, 150),
    set_up("smooth potential", "cases/light_disc.toml", SMOOTH, 1, 500),
    set_up("plate on loose sand", "cases/cmu_plate.toml", LOOSE, 2, 400),
    set_up("plate on dense sand, single", "cases/cmu_plate.toml", DENSE, 3, 400),
    set_up("two bodies", "validation/A8_repeatability/case.toml", TWO, 2, 300),
    // Ground that enters a travelling grid whose rows are not all as wide.
    set_up(
        "assembly",
        "cases/rockhopper.toml",
        &["grid.cell=\"18 mm\"", "grid.fine_y=[\"-0.1 m\", \"0.1 m\"]", OFTEN],
        2,
        200,
    ),
    set_up("disc on a boulder", "cases/disc_over_boulder.toml", BOULDER, 2, 200),
    set_up("softening bank", "validation/B5n_softening_bank/case.toml", SOFTENING, 2, 400),
    set_up("two layers", "validation/B11_two_layers/case.toml", LAYERS, 2, 300),
    // Three laws, an average, and ground that enters a travelling grid.
    set_up("disc over three soils", "validation/A8_repeatability/case.toml", THREE_SOILS, 2, 400),
];
const SOFTENING: &[&str] = &["grid.cell=\"125 mm\"", OFTEN, "body.wall.forward.ramp=\"10 ms\""];
const THREE_SOILS: &[&str] = &[
    OFTEN,
    "layer.middle={ top = \"15 mm\", law = \"sand\", critical_friction_angle = \"32 deg\", minimum_density = \"1400 kg/m^3\", maximum_density = \"1700 kg/m^3\", relative_density = 0.5, characteristic_length = \"60 mm\", young_modulus = \"5 MPa\", poisson_ratio = 0.3 }",
    "layer.lower={ top = \"30 mm\", law = \"tresca\", shear_strength = \"3 kPa\", density = \"1800 kg/m^3\", young_modulus = \"5 MPa\", poisson_ratio = 0.45 }",
    "grid.follow={ body = \"disc\", axes = \"x\" }",
];
const LAYERS: &[&str] = &[
    "grid.cell=\"125 mm\"",
    OFTEN,
    "body.footing.heave.speed=\"-0.1 m/s\"",
    "body.footing.heave.ramp=\"10 ms\"",
];
const BOULDER: &[&str] = &[
    "grid.cell=\"12 mm\"",
    OFTEN,
    "body.boulder.x=\"0 m\"",
    "body.boulder.sinkage=\"0.12 m\"",
    "run.tow_distance=\"0.2 m\"",
];
const VELOCITY: &str = "ground.velocity=[\"0.3 m/s\", \"0.1 m/s\", \"0 m/s\"]";
const MOVING: &[&str] = &[
    "grid.cell=\"125 mm\"",
    "body.footing.forward.speed=\"0.2 m/s\"",
    "ground.velocity=[\"0.2 m/s\", \"0 m/s\"]",
];
const COARSE: &[&str] = &["grid.cell=\"125 mm\"", OFTEN];
const ROTATED: &[&str] = &["grid.cell=\"125 mm\"", OFTEN, "body.block.pitch=\"30 deg\""];
const SMOOTH: &[&str] = &[
    "grid.cell=\"25 mm\"",
    "soil.flow_potential=\"menetrey-willam\"",
    "soil.dilation_angle=\"10 deg\"",
    "soil.critical_density=\"1550 kg/m^3\"",
    "body.disc.sinkage=\"20 mm\"",
    "body.disc.forward={ speed = \"0.2 m/s\", ramp = \"0.02 s\" }",
    "body.disc.heave={ load = \"0 N\", ramp = \"0.02 s\" }",
];
const LOOSE: &[&str] = &["grid.cell=\"16 mm\"", OFTEN, "body.plate.heave.ramp=\"1 ms\""];
const DENSE: &[&str] = &[
    "grid.cell=\"16 mm\"",
    OFTEN,
    SINGLE,
    "body.plate.heave.ramp=\"1 ms\"",
    "soil.minimum_density=\"1250 kg/m^3\"",
    "soil.maximum_density=\"1400 kg/m^3\"",
];
const TWO: &[&str] = &[
    "body.ball={ shape = \"sphere\", diameter = \"0.1 m\", x = \"0.2 m\", sinkage = \"20 mm\", friction = 0.2, heave = { speed = \"-0.1 m/s\", ramp = \"20 ms\" } }",
];

impl SetUp {
    /// Its case.
    pub fn read(&self) -> Case {
        let overrides: Vec<String> = self.overrides.iter().map(|o| (*o).to_owned()).collect();
        let case = case::load(&root().join(self.case), &overrides);
        let mut case = case.unwrap_or_else(|e| panic!("{}: {e:?}", self.name));
        case.numerics.threads = self.threads;
        case
    }

    /// Whether its fields are in single precision.
    pub fn is_single(&self) -> bool {
        self.overrides.contains(&SINGLE)
    }
}

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
