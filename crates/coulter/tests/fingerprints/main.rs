//! Fingerprints of short runs of every kind: a change that is meant to leave the physics alone leaves all of
//! them alone.
//!
//! `fingerprints.txt` holds one line per set-up and quantity: the hash of all its values to the bit, cell by
//! cell in the order of the grid, whatever the layout of the memory. `COULTER_UPDATE_FINGERPRINTS=1 cargo
//! test -p coulter --release --test fingerprints` rewrites it, for a commit that says which arithmetic
//! changed and why.
//!
//! Sines and logarithms come from the system's library and may differ in their last bit from one system to
//! the next. The first line is a fingerprint of that library; where it differs, nothing else is compared.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod blocks;
mod device;
mod set_ups;

use coulter::simulation::Simulation;
use set_ups::{SET_UPS, SetUp, root};
use solver::fields::{GAP_STRAIN, PLASTIC_STRAIN};
use solver::grid::Grid;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;
use std::fmt::Write as _;
use xxhash_rust::xxh3::Xxh3;

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

/// Every quantity of a state on a whole grid by name, with the hash of its values.
fn quantities<R: Precision>(model: &Model, grid: &Grid, state: &State<R>) -> Vec<(String, u64)> {
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
    for ((fixed, body), moving) in model.bodies.iter().zip(&state.bodies).zip(&state.mechanism.bodies) {
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

fn go<R: Precision>(set_up: &SetUp) -> Vec<(String, u64)> {
    let mut run = Simulation::<R>::new(&set_up.read());
    run.steps(set_up.steps).unwrap_or_else(|error| panic!("{}: {error}", set_up.name));
    quantities(&run.model, &run.model.grid, &run.state)
}

fn lines() -> String {
    let mut lines = format!("{:016x} library of the system\n", library());
    for set_up in &SET_UPS {
        let all = if set_up.is_single() { go::<f32>(set_up) } else { go::<f64>(set_up) };
        for (quantity, hash) in all {
            writeln!(lines, "{hash:016x} {}: {quantity}", set_up.name).unwrap();
        }
    }
    lines
}

#[test]
fn no_bit_has_changed() {
    let path = root().join("crates/coulter/tests/fingerprints/fingerprints.txt");
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
