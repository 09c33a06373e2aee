//! Runs of every kind whose soil is strained on a stand-in for a device: the same bits, whatever the order of
//! the blocks of threads.

use super::quantities;
use super::set_ups::{SET_UPS, SetUp};
use coulter::simulation::Simulation;
use solver::device::replay::Replay;
use solver::precision::Precision;

/// Steps of each run.
const STEPS: u32 = 1000;

/// Runs a set-up, with a sample of the history on the way.
fn run<R: Precision>(simulation: &mut Simulation<R>, set_up: &SetUp) {
    let first = STEPS / 2;
    simulation.steps(first).unwrap_or_else(|error| panic!("{}: {error}", set_up.name));
    simulation.advance().unwrap_or_else(|error| panic!("{}: {error}", set_up.name));
    let left = STEPS.saturating_sub(simulation.state.step as u32);
    simulation.steps(left).unwrap_or_else(|error| panic!("{}: {error}", set_up.name));
}

/// What differs, or nothing if the run could not be compared.
fn compare<R: Precision>(set_up: &SetUp) -> Option<Vec<String>> {
    let case = set_up.read();
    let (mut expected, mut found) = (Simulation::<R>::new(&case), Simulation::<R>::new(&case));
    if found.use_device(Box::new(Replay::default())).is_err() {
        assert!(expected.model.pore_water.is_some(), "{}", set_up.name);
        return None;
    }
    run(&mut expected, set_up);
    run(&mut found, set_up);
    let all = |run: &Simulation<R>| quantities(&run.model, &run.model.grid, &run.state);
    let (expected_all, found_all) = (all(&expected), all(&found));
    let pairs = expected_all.into_iter().zip(found_all);
    let mut differ: Vec<_> = pairs.filter(|(a, b)| a != b).map(|(a, _)| a.0).collect();
    if expected.history != found.history {
        differ.push("history".to_owned());
    }
    Some(differ)
}

#[test]
fn a_device_changes_no_bit() {
    let compare =
        |set_up: &SetUp| if set_up.is_single() { compare::<f32>(set_up) } else { compare::<f64>(set_up) };
    let all: Vec<_> = SET_UPS.iter().filter_map(|set_up| Some((set_up.name, compare(set_up)?))).collect();
    let differ: Vec<_> = all.iter().filter(|(_, differ)| !differ.is_empty()).collect();
    assert!(differ.is_empty(), "{differ:#?}");
    assert_eq!(all.len(), SET_UPS.len() - 1);
}
