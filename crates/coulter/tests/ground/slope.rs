//! Ground on a slope: soil at rest stays at rest, bodies are drawn downhill, and what the slope contradicts
//! is refused.
use super::{SAND, fastest, read, run};
use coulter::case::Case;

fn text(soil: &str, ground: &str, body: &str) -> String {
    format!(
        "format = 2\ngravity = \"9.81 m/s^2\"\n[soil]\nyoung_modulus = \"5 MPa\"\n{soil}\n[ground]\n{ground}\n\
         [domain]\nx = [\"-0.1 m\", \"0.1 m\"]\ny = [\"-0.05 m\", \"0.05 m\"]\nz = [\"-0.1 m\", \"0.05 m\"]\n\
         [grid]\ncell = \"10 mm\"\n{body}\n[run]\nduration = \"0.05 s\"\n"
    )
}

const FRICTIONAL: &str = "law = \"mohr-coulomb\"\nfriction_angle = \"35 deg\"\nunit_weight = \"16 kN/m^3\"";
const CLAY: &str = "law = \"tresca\"\nshear_strength = \"5 kPa\"\nunit_weight = \"16 kN/m^3\"";

fn case(soil: &str, ground: &str, body: &str) -> Result<Case, String> {
    read(&text(soil, ground, body))
}

#[test]
fn soil_rests_on_a_slope() {
    for soil in [SAND, FRICTIONAL, CLAY] {
        for ground in ["slope = \"20 deg\"", "slope = \"-12 deg\"\ncross_slope = \"15 deg\""] {
            let simulation = run(&case(soil, ground, "").unwrap());
            assert!(simulation.state.step > 50);
            assert!(fastest(&simulation) < 1e-9, "{soil}, {ground}: {} m/s", fastest(&simulation));
            let energy = simulation.history.energy.last().unwrap();
            assert!(energy.plastic.abs() < 1e-12, "{soil}: {} J", energy.plastic);
        }
    }
}

#[test]
fn a_free_body_is_drawn_downhill() {
    let body = "[body.sledge]\nshape = \"frame\"\nmass = \"2 kg\"\nforward = { load = \"0 N\", ramp = \"0 s\" }\nlateral = { load = \"0 N\", ramp = \"0 s\" }\nheave = \"fixed\"";
    for (ground, expected) in [
        ("slope = \"10 deg\"", [-(10_f64.to_radians().sin()), 0.0]),
        ("cross_slope = \"-10 deg\"", [0.0, 10_f64.to_radians().sin()]),
    ] {
        let simulation = run(&case(FRICTIONAL, ground, body).unwrap());
        let velocity = simulation.state.twist(0).linear / simulation.state.time / 9.81;
        // Velocities lie half a step behind.
        assert!(
            (velocity.x - expected[0]).abs() < 1e-3 && (velocity.y - expected[1]).abs() < 1e-3,
            "{velocity}"
        );
    }
}

#[test]
fn what_a_slope_contradicts_is_refused() {
    let refused = |soil: &str, ground: &str, body: &str, words: &str| {
        let message = case(soil, ground, body).unwrap_err();
        assert!(message.contains(words), "{message}");
    };
    refused(FRICTIONAL, "slope = \"36 deg\"", "", "does not rest on a slope of 36.0°");
    refused(FRICTIONAL, "slope = \"50 deg\"", "", "out of range");
    refused(&format!("{FRICTIONAL}\nk0 = 0.3"), "slope = \"20 deg\"", "", "does not rest");
    let walls = text(FRICTIONAL, "slope = \"20 deg\"", "")
        .replace("[grid]", "x_walls = [\"smooth\", \"fixed\"]\n[grid]");
    let message = read(&walls).unwrap_err();
    assert!(message.contains("smooth wall across a slope"), "{message}");
    let plane = text(FRICTIONAL, "cross_slope = \"20 deg\"", "")
        .replace("y = [\"-0.05 m\"", "symmetric = true\ny = [\"0 m\"");
    let message = read(&plane).unwrap_err();
    assert!(message.contains("across a plane of symmetry"), "{message}");
}

#[test]
fn a_grid_that_follows_a_body_has_no_walls_on_a_slope_either() {
    let body = "follow = { body = \"sledge\" }\n[body.sledge]\nshape = \"block\"\nsize = [\"40 mm\", \"40 mm\", \"40 mm\"]\nfriction = 0.3\n\
                sinkage = \"-5 mm\"\nforward = { speed = \"1 m/s\", start = \"0 s\", ramp = \"5 ms\" }";
    let simulation = run(&case(FRICTIONAL, "slope = \"20 deg\"", body).unwrap());
    assert!(simulation.state.grid_position.x > 0.02 && simulation.state.remaps > 0);
    // The block glides over the ground: the ground that enters rests as the rest of it does.
    assert!(fastest(&simulation) < 1e-9, "{} m/s", fastest(&simulation));
}
