//! Soils of case files, and their effects on a whole run.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case;
use coulter::simulation::Simulation;

const WALL: &str = include_str!("../../../validation/B5_passive_wall/case.toml");

/// The wall pushed 0.3 m into dilating sand: the least density of the sand [kg/m³].
fn least_density(overrides: &[&str]) -> f64 {
    let mut all = vec!["grid.cell=125 mm", "soil.dilation_angle=30 deg", "run.tow_distance=0.3 m"];
    all.extend(overrides);
    let all: Vec<String> = all.into_iter().map(str::to_owned).collect();
    let mut simulation = Simulation::<f64>::new(&case::parse(WALL, "case.toml", &all).unwrap());
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
    let (grid, soil) = (&simulation.model.grid, &simulation.state.soil);
    let [nx, ny, nz] = grid.cells();
    let mut least = f64::INFINITY;
    for (i, j, k) in (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (i, j, k)))) {
        let c = grid.index(i, j, k);
        if soil.fraction[c] > 0.5 {
            least = least.min(soil.mass[c] / (soil.fraction[c] * grid.volume(i, j, k)));
        }
    }
    least
}

#[test]
fn dense_sand_stops_dilating_at_its_critical_density() {
    let (ends, goes_on) = (least_density(&["soil.critical_density=1580 kg/m^3"]), least_density(&[]));
    assert!(ends > 0.97 * 1580.0 && ends < 1600.0, "{ends}");
    assert!(goes_on < 0.9 * 1580.0, "{goes_on}");
}

#[test]
fn a_word_is_a_relative_density() {
    let with = |density: &str| {
        let typed = format!("relative_density = {density}");
        let text = include_str!("../../../cases/cmu_plate.toml");
        let text = text.replace("unit_weight = \"13.03 kN/m^3\"", &typed);
        case::parse(&text, "case.toml", &[]).map(|case| case.soil.relative_density().unwrap())
    };
    for (typed, expected) in [("\"loose\"", 0.25), ("\"very dense\"", 0.9), ("0.4", 0.4)] {
        assert!((with(typed).unwrap() - expected).abs() < 1e-12, "{typed}");
    }
    let refusal = format!("{:?}", with("\"fluffy\"").unwrap_err());
    assert!(refusal.contains("medium dense"), "{refusal}");
}
