//! One dimensionless weight, W̄ = W/(γ t d²), for every shape and command.

use crate::support::Desk;
use serde_json::Value;

const CASE: &str = r#"format = 2
[soil]
law = "mohr-coulomb"
friction_angle = "33 deg"
unit_weight = "16 kN/m^3"
young_modulus = "2 MPa"
[grid]
cell = "15 mm"
[body.own]
friction = 0.3
weight = "20 N"
"#;

fn json(desk: &Desk, command: &str) -> Value {
    serde_json::from_str(&desk.expect(0, &[command, "case.toml", "--json"]).out).unwrap()
}

/// `check` and `forecast` give these t/d and W/(γ t d²) of a shape [m, m].
fn agree(shape: &str, [t, d]: [f64; 2]) {
    let desk = Desk::with(&[("case.toml", &format!("{CASE}{shape}\n[run]\nduration = \"1 s\"\n"))]);
    let (check, forecast) = (json(&desk, "check"), json(&desk, "forecast"));
    for (groups, command) in [(&check["groups"]["own"], "check"), (&forecast["groups"], "forecast")] {
        let number = |key: &str| groups[key].as_f64().unwrap_or(f64::NAN);
        assert!(
            (number("t_bar") / (t / d) - 1.0).abs() < 1e-9,
            "{shape}: {command} has t/d = {}",
            number("t_bar")
        );
        let weight = 20.0 / (16e3 * t * d * d);
        assert!(
            (number("W_bar") / weight - 1.0).abs() < 1e-9,
            "{shape}: {command} has {}, not {weight}",
            number("W_bar")
        );
    }
    let scale = 16e3 * t * d * d;
    for model in forecast["models"].as_array().unwrap().iter().filter(|model| !model["vertical_N"].is_null())
    {
        let [force, group] = ["vertical_N", "F_V_bar"].map(|key| model[key].as_f64().unwrap());
        assert!((group * scale - force).abs() < 1e-9 * force.abs().max(1.0), "{shape}: {model}");
    }
}

const TOW: &str = "forward = { speed = \"0.1 m/s\" }\nheave = { load = \"0 N\" }\n";
const PRESSED: &str = "heave = { load = \"0 N\" }\n";

#[test]
fn towed_shapes_have_one_dimensionless_weight() {
    agree(
        &format!("shape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"60 mm\"\n{TOW}spin = \"free\""),
        [0.06, 0.2],
    );
    agree(
        &format!(
            "shape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"60 mm\"\nyaw = \"20 deg\"\n{TOW}spin = \"free\""
        ),
        [0.06, 0.2],
    );
    let wheel = "shape = \"wheel\"\ndiameter = \"0.25 m\"\nthickness = \"0.12 m\"\ngrousers = 16\ngrouser_height = \"15 mm\"\n\
                 grouser_thickness = \"20 mm\"\n";
    agree(&format!("{wheel}{TOW}spin = {{ slip = 0.3 }}"), [0.12, 0.25]);
    agree(&format!("shape = \"sphere\"\ndiameter = \"0.2 m\"\n{TOW}"), [0.2, 0.2]);
    agree(&format!("shape = \"block\"\nsize = [\"0.1 m\", \"0.15 m\", \"0.2 m\"]\n{TOW}"), [0.15, 0.2]);
    agree(
        &format!("shape = \"cylinder\"\naxis = \"x\"\ndiameter = \"0.1 m\"\nlength = \"0.3 m\"\n{TOW}"),
        [0.1, 0.1],
    );
}

#[test]
fn a_block_towed_along_its_width_has_its_length_for_a_width() {
    let along_y = "forward = \"fixed\"\nlateral = { speed = \"0.1 m/s\" }\nheave = { load = \"0 N\" }\n";
    agree(&format!("shape = \"block\"\nsize = [\"0.15 m\", \"0.1 m\", \"0.2 m\"]\n{along_y}"), [0.15, 0.2]);
    agree(
        &format!("shape = \"cylinder\"\naxis = \"x\"\ndiameter = \"0.1 m\"\nlength = \"0.3 m\"\n{along_y}"),
        [0.3, 0.1],
    );
}

#[test]
fn pressed_shapes_have_one_dimensionless_weight() {
    agree(&format!("shape = \"block\"\nsize = [\"0.2 m\", \"0.1 m\", \"0.3 m\"]\n{PRESSED}"), [0.1, 0.3]);
    agree(
        &format!("shape = \"cylinder\"\naxis = \"z\"\ndiameter = \"0.15 m\"\nlength = \"0.3 m\"\n{PRESSED}"),
        [0.15, 0.15],
    );
    agree(
        &format!(
            "shape = \"cone\"\ndiameter = \"0.15 m\"\ncone_angle = \"60 deg\"\nlength = \"0.4 m\"\n{PRESSED}"
        ),
        [0.15, 0.15],
    );
}

#[test]
fn in_plane_strain_the_width_is_a_metre() {
    let strip = "shape = \"block\"\nsize = [\"0.2 m\", \"0.3 m\"]\n";
    agree(&format!("{strip}{PRESSED}[domain]\nplane_strain = true"), [1.0, 0.3]);
    agree(&format!("{strip}{TOW}[domain]\nplane_strain = true"), [1.0, 0.3]);
    agree(&format!("{strip}{PRESSED}[domain]\nplane_strain = true\ny = [\"0 m\", \"40 mm\"]"), [1.0, 0.3]);
}
