//! Fingerprints of short runs of every kind: a change that is meant to leave the physics alone leaves all of them alone.
//!
//! `fingerprints.txt` holds one line per set-up and quantity: the hash of all its values to the bit, cell by cell in the
//! order of the grid, whatever the layout of the memory. `COULTER_UPDATE_FINGERPRINTS=1 cargo test -p coulter --release --test
//! fingerprints` rewrites it, for a commit that says which arithmetic changed and why.
//!
//! Sines and logarithms come from the system's library and may differ in their last bit from one system to the next. The
//! first line is a fingerprint of that library; where it differs, nothing else is compared.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case;
use coulter::simulation::Simulation;
use solver::fields::{GAP_STRAIN, PLASTIC_STRAIN};
use solver::grid::Grid;
use solver::precision::Precision;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::Xxh3;

/// A run of so many steps.
struct SetUp {
    name: &'static str,
    /// Case file below the root of the repository.
    case: &'static str,
    overrides: &'static [&'static str],
    threads: usize,
    steps: u32,
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

const SINGLE: &str = "numerics.precision=\"single\"";
/// Remaps, which else come every few hundred steps.
const OFTEN: &str = "numerics.remap_displacement=0.01";
const PENALTY: &str = "numerics.contact=\"penalty\"";

/// Every family of the verification suite, both precisions, both contact methods, one to three threads.
const SET_UPS: [SetUp; 30] = [
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

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn hash(values: impl IntoIterator<Item = f64>) -> u64 {
    let mut hash = Xxh3::new();
    values.into_iter().for_each(|value| hash.update(&value.to_bits().to_le_bytes()));
    hash.digest()
}

/// Functions that the system's library works out.
fn library() -> u64 {
    let each = (1..2000).flat_map(|n| {
        let x = 1e-3 * f64::from(n);
        [x.sin(), x.cos(), x.tan(), x.atan(), x.exp(), x.ln(), x.powf(1.7), (0.5 * x).asin(), x.sinh()]
    });
    hash(each)
}

/// Values of a field, layer by layer; the last layers of nodes lie beyond those of cells.
fn field<R: Precision>(grid: &Grid, values: &[R], is_nodal: bool) -> u64 {
    let [nx, ny, nz] = grid.cells().map(|n| n + usize::from(is_nodal));
    let layers = (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])));
    hash(layers.map(|[i, j, k]| values[grid.index(i, j, k)].into()))
}

/// Every quantity of a run by name, with the hash of its values.
fn quantities<R: Precision>(run: &Simulation<R>) -> Vec<(String, u64)> {
    let (grid, state) = (&run.model.grid, &run.state);
    let mut all = vec![
        ("volume fraction".to_owned(), field(grid, &state.soil.fraction, false)),
        ("mass".to_owned(), field(grid, &state.soil.mass, false)),
        ("plastic strain".to_owned(), field(grid, &state.soil.history[PLASTIC_STRAIN], false)),
        ("gap strain".to_owned(), field(grid, &state.soil.history[GAP_STRAIN], false)),
        ("nodal mass".to_owned(), field(grid, &state.nodes.mass, true)),
    ];
    for (name, stress) in ["xx", "yy", "zz", "xy", "yz", "xz"].iter().zip(&state.soil.stress) {
        all.push((format!("stress {name}"), field(grid, stress, false)));
    }
    for (n, axis) in ["x", "y", "z"].iter().enumerate() {
        all.push((format!("velocity {axis}"), field(grid, &state.nodes.velocity[n], true)));
        all.push((format!("displacement {axis}"), field(grid, &state.nodes.displacement[n], true)));
    }
    for ((fixed, body), moving) in run.model.bodies.iter().zip(&state.bodies).zip(&state.mechanism.bodies) {
        let turning = [body.rotation, moving.twist.angular.y, 0.0];
        let motion = [moving.pose.position.to_array(), moving.twist.linear.to_array(), turning];
        let impulse = [body.contact_impulse.normal.to_array(), body.contact_impulse.friction.to_array()];
        let volumes = [body.contact_impulse.moment.y, body.leaked_volume, body.embedded_volume];
        all.push((format!("motion of {}", fixed.name), hash(motion.concat())));
        all.push((format!("force on {}", fixed.name), hash(impulse.concat().into_iter().chain(volumes))));
    }
    let points = state
        .contacts
        .iter()
        .flat_map(|c| [c.impulse.to_array(), c.slip.to_array(), [c.penetration, c.area, c.width]].concat());
    all.push(("contact points".to_owned(), hash(points)));
    let l = &state.energy_balance;
    let energies = [l.external, l.plastic, l.viscous, l.hourglass, l.friction, l.contact, l.remap];
    let start = [l.elastic_start, l.kinetic_start, l.volume_start, l.debris_volume, l.debris_mass];
    all.push(("energy balance".to_owned(), hash(energies.into_iter().chain(start))));
    all.push(("clock".to_owned(), hash([state.time, state.step as f64, state.remaps as f64])));
    all
}

fn go<R: Precision>(set_up: &SetUp, case: &case::Case) -> Vec<(String, u64)> {
    let mut run = Simulation::<R>::new(case);
    run.steps(set_up.steps).unwrap_or_else(|error| panic!("{}: {error}", set_up.name));
    quantities(&run)
}

fn lines() -> String {
    let mut lines = format!("{:016x} library of the system\n", library());
    for set_up in &SET_UPS {
        let overrides: Vec<String> = set_up.overrides.iter().map(|o| (*o).to_owned()).collect();
        let path = root().join(set_up.case);
        let mut case = case::load(&path, &overrides).unwrap_or_else(|e| panic!("{}: {e:?}", set_up.name));
        case.numerics.threads = set_up.threads;
        let is_single = set_up.overrides.contains(&SINGLE);
        let all = if is_single { go::<f32>(set_up, &case) } else { go::<f64>(set_up, &case) };
        for (quantity, hash) in all {
            writeln!(lines, "{hash:016x} {}: {quantity}", set_up.name).unwrap();
        }
    }
    lines
}

#[test]
fn no_bit_has_changed() {
    let path = root().join("crates/coulter/tests/fingerprints.txt");
    let found = lines();
    if std::env::var_os("COULTER_UPDATE_FINGERPRINTS").is_some() {
        std::fs::write(&path, &found).unwrap();
        return;
    }
    let kept = std::fs::read_to_string(&path).unwrap();
    if kept.lines().next() != found.lines().next() {
        // Printed by `cargo test -- --nocapture`: another system's sines are not this one's fault.
        eprintln!("the mathematical library is another one than that of fingerprints.txt: nothing compared");
        return;
    }
    let differ: Vec<&str> =
        found.lines().zip(kept.lines()).filter(|(a, b)| a != b).map(|(a, _)| &a[17..]).collect();
    assert!(differ.is_empty() && found.lines().count() == kept.lines().count(), "changed: {differ:#?}");
}
