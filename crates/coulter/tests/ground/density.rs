//! Sand whose density grows with depth: its mass and weight follow, it rests, enters a grid that travels, and
//! stays within its limits.
use super::{SAND, complaints, fastest, read, run};
use coulter::simulation::Simulation;
use solver::fields::PRECONSOLIDATION;
use solver::halo::Halo;

fn text(gradient: &str, rest: &str) -> String {
    format!(
        "format = 2\n[soil]\nyoung_modulus = \"5 MPa\"\n{}{gradient}[domain]\nx = [\"-0.1 m\", \"0.1 m\"]\ny = [\"-0.05 m\", \"0.05 m\"]\n\
         z = [\"-0.2 m\", \"0.05 m\"]\n[grid]\ncell = \"10 mm\"\n{rest}",
        SAND.replace("relative_density = 0.5", "relative_density = 0.2")
    )
}

const GRADIENT: &str = "relative_density_gradient = \"3 1/m\"\n";
const REST: &str = "[run]\nduration = \"50 ms\"\n";

/// Density at a relative density [kg/m³].
fn density(relative: f64) -> f64 {
    1400.0 * 1700.0 / (1700.0 - relative * 300.0)
}

#[test]
fn mass_and_stress_follow_the_density() {
    let simulation = Simulation::<f64>::new(&read(&text(GRADIENT, REST)).unwrap());
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    // The integral by Simpson's rule.
    let steps = 200;
    let at = |n: i32| density(0.2 + 3.0 * 0.2 * f64::from(n) / f64::from(steps));
    let weights = (0..=steps).map(|n| if n == 0 || n == steps { 1.0 } else { f64::from(2 + 2 * (n % 2)) });
    let mean: f64 =
        weights.enumerate().map(|(n, w)| w * at(n as i32)).sum::<f64>() / (3.0 * f64::from(steps));
    let mass: f64 = soil.mass.iter().sum();
    assert!((mass / (mean * 0.2 * 0.1 * 0.2) - 1.0).abs() < 1e-4, "{}", mass / (mean * 0.2 * 0.1 * 0.2));
    let lowest = grid.index(5, 5, 0);
    let expected = -9.81 * (mean * 0.2 - 0.5 * 0.01 * density(0.8));
    let found = soil.stress[2][lowest];
    assert!((found / expected - 1.0).abs() < 1e-3, "{found}, not {expected} Pa");
    let relative = soil.mass[lowest] / grid.volume(5, 5, 0);
    assert!((relative / density(0.2 + 3.0 * 0.195) - 1.0).abs() < 1e-9, "{relative}");
}

#[test]
fn sand_whose_density_grows_rests() {
    let simulation = run(&read(&text(GRADIENT, REST)).unwrap());
    assert!(simulation.state.step > 50);
    assert!(fastest(&simulation) < 1e-9, "{} m/s", fastest(&simulation));
    let last = simulation.history.energy.last().unwrap();
    assert!(last.plastic.abs() < 1e-12 && last.overdense == 0.0, "{last:?}");
}

#[test]
fn what_enters_a_grid_is_as_dense_as_its_place() {
    let block = "[body.block]\nshape = \"block\"\nsize = [\"60 mm\", \"40 mm\", \"40 mm\"]\nfriction = 0.3\nsinkage = \"20 mm\"\n\
                 forward = { speed = \"1 m/s\", ramp = \"10 ms\" }\n[run]\nduration = \"0.12 s\"\n";
    let simulation =
        run(&read(&text(GRADIENT, &format!("follow = {{ body = \"block\" }}\n{block}"))).unwrap());
    assert!(simulation.state.grid_position.x > 0.1);
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    for k in 0..grid.cells()[2] {
        let depth = -0.5 * (grid.faces[2][k] + grid.faces[2][k + 1]);
        if depth < 0.0 {
            break;
        }
        let cell = grid.index(grid.cells()[0] - 1, 0, k);
        let found = soil.mass[cell] / (soil.fraction[cell] * grid.volume(grid.cells()[0] - 1, 0, k));
        let expected = density(0.2 + 3.0 * depth);
        assert!((found / expected - 1.0).abs() < 1e-6, "{depth} m: {found}, not {expected} kg/m³");
    }
    let map = coulter::output::fields::HeightMap::of(
        &simulation.case,
        (grid, &Halo::whole()),
        &simulation.state,
        &[],
    )
    .unwrap();
    // Where nothing has moved little is compacted: by the elastic strain ahead of the block, at a modulus of
    // some 0.5 MPa.
    let undisturbed = map.column(map.centres[0].len() - 1, 0);
    assert!(undisturbed.compaction.abs() < 5e-4, "{undisturbed:?}");
}

#[test]
fn a_layer_counts_from_its_own_top() {
    let layer = format!(
        "[layer.deep]\ntop = \"0.1 m\"\nyoung_modulus = \"5 MPa\"\n{}{GRADIENT}",
        SAND.replace("relative_density = 0.5", "relative_density = 0.6")
    );
    let simulation = Simulation::<f64>::new(&read(&text(&format!("{GRADIENT}{layer}"), REST)).unwrap());
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    for (k, relative) in [(0, 0.6 + 3.0 * 0.095), (9, 0.6 + 3.0 * 0.005), (10, 0.2 + 3.0 * 0.095)] {
        let found = soil.mass[grid.index(3, 3, k)] / grid.volume(3, 3, k);
        assert!((found / density(relative) - 1.0).abs() < 1e-9, "layer {k}: {found}");
    }
}

#[test]
fn a_density_beyond_the_densest_is_refused() {
    let refused = |gradient: &str, expected: &str| {
        let error = complaints(&text(gradient, REST));
        assert!(error.contains(expected), "{gradient}: {error}");
    };
    refused("relative_density_gradient = \"5 1/m\"\n", "at a depth of 0.1600 m");
    refused("relative_density_gradient = \"-1 1/m\"\n", "0 or more");
    refused("relative_density_gradient = 3\n", "unit");
    refused("relative_density_gradient = \"3 m\"\n", "a growth of relative density with depth is needed");
    let clay = "[layer.clay]\ntop = \"50 mm\"\nlaw = \"tresca\"\nshear_strength = \"5 kPa\"\nunit_weight = \"18 kN/m^3\"\n\
                young_modulus = \"3 MPa\"\nrelative_density_gradient = \"1 1/m\"\n";
    refused(clay, "does not apply to law = \"tresca\"");
}

#[test]
fn ground_that_was_pressed_before_remembers_it_and_rests() {
    let pressed = "preconsolidation_pressure = \"50 kPa\"\n";
    let layer = format!("[layer.deep]\ntop = \"0.1 m\"\nyoung_modulus = \"5 MPa\"\n{SAND}");
    let case = read(&text(&format!("{pressed}{layer}"), REST)).unwrap();
    let simulation = Simulation::<f64>::new(&case);
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    for (k, pressure) in [(0, 0.0), (9, 0.0), (10, 50e3), (19, 50e3), (20, 0.0)] {
        let found = soil.history[PRECONSOLIDATION][grid.index(3, 3, k)];
        assert!((found - pressure).abs() < 1e-6, "layer {k}: {found} Pa");
    }
    let at_rest = run(&case);
    assert!(fastest(&at_rest) < 1e-9, "{} m/s", fastest(&at_rest));
    assert!(complaints(&text("preconsolidation_pressure = \"-1 kPa\"\n", REST)).contains("0 or more"));
}
