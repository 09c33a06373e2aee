//! Ground in layers: it rests, each layer has its own soil, a body that is towed meets the same ground
//! everywhere, and what cannot be layered is refused.
use super::{SAND, fastest, read};
use coulter::simulation::Simulation;

const CLAY: &str =
    "law = \"tresca\"\nshear_strength = \"5 kPa\"\nunit_weight = \"18 kN/m^3\"\nyoung_modulus = \"3 MPa\"\n";
const DENSE: &str = "law = \"mohr-coulomb\"\nfriction_angle = \"38 deg\"\nunit_weight = \"19 kN/m^3\"\nyoung_modulus = \"8 MPa\"\n";

fn text(layers: &str, rest: &str) -> String {
    format!(
        "format = 2\ngravity = \"9.81 m/s^2\"\n[soil]\nyoung_modulus = \"5 MPa\"\n{SAND}{layers}\
         [domain]\nx = [\"-0.1 m\", \"0.1 m\"]\ny = [\"-0.05 m\", \"0.05 m\"]\nz = [\"-0.1 m\", \"0.05 m\"]\n\
         [grid]\ncell = \"10 mm\"\n{rest}\n"
    )
}

/// Three layers, the lower two out of order in the file, one of which begins within a cell.
fn layered(rest: &str) -> String {
    let layers = format!("[layer.dense]\ntop = \"70 mm\"\n{DENSE}[layer.clay]\ntop = \"33 mm\"\n{CLAY}");
    text(&layers, &format!("[run]\nduration = \"0.05 s\"\n{rest}"))
}

fn run(text: &str) -> Simulation {
    super::run(&read(text).unwrap())
}

#[test]
fn layers_rest() {
    for ground in ["", "[ground]\nslope = \"12 deg\"\n"] {
        let simulation = run(&layered(ground));
        assert!(simulation.state.step > 50);
        assert!(fastest(&simulation) < 1e-9, "{ground}: {} m/s", fastest(&simulation));
        assert!(simulation.history.energy.last().unwrap().plastic.abs() < 1e-12);
    }
}

#[test]
fn each_layer_has_its_soil() {
    let simulation = run(&layered(""));
    let names: Vec<&str> = simulation.case.layers.iter().map(|layer| &*layer.name).collect();
    assert_eq!(names, ["clay", "dense"], "from the top down");
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    let at = |k: usize| grid.index(5, 5, k);
    let material = |k: usize| soil.main_material(at(k));
    // The clay begins 3 mm below a face; the cell there is mostly clay.
    let column: Vec<usize> = (0..10).rev().map(material).collect();
    assert_eq!(column, [0, 0, 0, 1, 1, 1, 1, 2, 2, 2]);
    assert!((soil.composition[0][at(6)] - 0.7).abs() < 1e-9);
    // Vertical stress in the middle of the lowest cell.
    let sand = simulation.case.soil.unit_weight;
    let expected = -(0.033 * sand + 0.037 * 18e3 + 0.025 * 19e3);
    assert!((soil.stress[2][at(0)] - expected).abs() < 1e-6 * expected.abs(), "{}", soil.stress[2][at(0)]);
    // Its horizontal stress is that of its own layer.
    let ratio = soil.stress[0][at(0)] / soil.stress[2][at(0)];
    assert!((ratio - (1.0 - 38_f64.to_radians().sin())).abs() < 1e-9, "{ratio}");
}

#[test]
fn a_body_is_towed_over_layers() {
    let block = "[body.block]\nshape = \"block\"\nsize = [\"60 mm\", \"40 mm\", \"40 mm\"]\nfriction = 0.3\n\
                 sinkage = \"20 mm\"\nforward = { speed = \"1 m/s\", ramp = \"10 ms\" }\n";
    let layers = format!("[layer.clay]\ntop = \"33 mm\"\n{CLAY}");
    let rest = "follow = { body = \"block\" }\n";
    let simulation = run(&text(&layers, &format!("{rest}{block}[run]\nduration = \"0.12 s\"")));
    assert!(simulation.state.grid_position.x > 0.1);
    // What has entered in front, far from the block, is the same ground at rest.
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    for k in 0..grid.cells()[2] {
        let [low, high] = [grid.faces[2][k], grid.faces[2][k + 1]];
        let clay = ((-0.033 - low) / (high - low)).clamp(0.0, 1.0);
        let cell = grid.index(grid.cells()[0] - 1, 0, k);
        let found = soil.composition[0][cell];
        assert!(low >= 0.0 || (found - clay).abs() < 1e-6, "layer {k}: {found}, not {clay}");
    }
    let last = simulation.history.energy.last().unwrap();
    assert!(last.overdense == 0.0, "{}", last.overdense);
}

#[test]
fn what_cannot_be_layered_is_refused() {
    let clay = |top: &str| format!("[layer.clay]\n{top}\n{CLAY}");
    let refused = |layers: &str, rest: &str, expected: &[&str]| {
        let error = read(&text(layers, &format!("{rest}[run]\nduration = \"1 ms\""))).unwrap_err();
        assert!(expected.iter().all(|part| error.contains(part)), "{error}");
    };
    refused(&clay(""), "", &["layer.clay", "top"]);
    refused(&clay("top = \"0 mm\""), "", &["layer.clay.top"]);
    refused(&clay("top = \"20\""), "", &["layer.clay.top", "unit"]);
    refused(&clay("top = \"0.1 m\""), "", &["below the floor"]);
    refused(&clay("top = \"20 mm\"\nthickness = \"1 m\""), "", &["thickness"]);
    refused(&clay("top = \"20 mm\"\ndensity = \"1500 kg/m^3\""), "", &["one gravity acts"]);
    refused(&clay("top = \"20 mm\"\nfriction_angle = \"30 deg\""), "", &["friction_angle", "tresca"]);
    refused(&clay("top = \"20 mm\""), "[ground]\nx = [\"-0.1 m\", \"0 m\"]\n", &["column or a bank"]);
    let two = format!("{}[layer.dense]\ntop = \"20 mm\"\n{DENSE}", clay("top = \"20 mm\""));
    refused(&two, "", &["two layers begin"]);
    refused("[layer]\ntop = \"20 mm\"\n", "", &["[layer], which has no keys of its own"]);
    let averaged = format!(
        "characteristic_length = \"30 mm\"\n[layer.deep]\ntop = \"50 mm\"\nyoung_modulus = \"5 MPa\"\n{SAND}characteristic_length = \"30 mm\"\n"
    );
    refused(&averaged, "", &["only one soil"]);
    let weak = clay("top = \"20 mm\"").replace("5 kPa", "0.2 kPa");
    refused(&weak, "[ground]\noverburden = \"2 kPa\"\nsurface = \"0.05 m\"\n", &["layer.clay", "overburden"]);
    refused(&weak, "[ground]\nslope = \"20 deg\"\n", &["layer.clay", "does not rest"]);
}
