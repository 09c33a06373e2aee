//! In plane strain lengths and forces are those of the body, per metre of its width, whatever the slab that
//! is modelled.

use crate::support::Desk;
use serde_json::Value;

const FOOTING: &str = r#"format = 2
gravity = "0 m/s^2"
soil = { law = "tresca", shear_strength = "2 kPa", density = "1500 kg/m^3", young_modulus = "200 kPa", poisson_ratio = 0.49 }
domain = { x = ["0 m", "5 m"], z = ["-5 m", "3.5 m"], plane_strain = true, symmetric_x = true }
grid = { cell = "125 mm", growth = 1.15, fine_x = ["0 m", "1 m"], fine_z = ["-1.5 m", "0.4 m"] }
run = { duration = "2 s" }
[body.footing]
shape = "block"
size = ["1 m", "3.5 m"]
friction = "rough"
heave = { displacement = "-0.3 m", ramp = "1.5 s" }
"#;

fn forecast(desk: &Desk, sets: &[&str]) -> Value {
    let mut arguments = vec!["forecast", "footing.toml", "--json"];
    arguments.extend(sets.iter().flat_map(|set| ["--set", set]));
    serde_json::from_str(&desk.expect(0, &arguments).out).unwrap()
}

fn model<'a>(document: &'a Value, name: &str) -> &'a Value {
    document["models"].as_array().unwrap().iter().find(|model| model["name"] == name).unwrap()
}

#[test]
fn the_bearing_capacity_knows_no_grid() {
    let desk = Desk::with(&[("footing.toml", FOOTING)]);
    for grid in ["grid.cell=125 mm", "grid.cell=62.5 mm", "domain.y=['0 m', '0.4 m']"] {
        let document = forecast(&desk, &[grid]);
        let best = model(&document, "bearing capacity");
        assert_eq!(
            (&best["applicable"], &document["recommended"]),
            (&true.into(), &"bearing capacity".into()),
            "{grid}"
        );
        let force = best["vertical_N"].as_f64().unwrap();
        assert!((force / (5.45 * 2e3) - 1.0).abs() < 1e-3, "{grid}: {force} N per metre");
        // d is the height of the block, t the metre to which forces refer.
        assert!((document["groups"]["t_bar"].as_f64().unwrap() - 1.0 / 3.5).abs() < 1e-12);
    }
    for (depth, applies) in [("-2.4 m", true), ("-2.6 m", false)] {
        let document = forecast(&desk, &[&format!("body.footing.heave.displacement={depth}")]);
        assert_eq!(model(&document, "bearing capacity")["applicable"], applies, "{depth}");
    }
    // A strip two metres wide reaches its limit at five.
    let wide = ["body.footing.size=['2 m', '3.5 m']", "body.footing.heave.displacement=-3 m"];
    assert_eq!(model(&forecast(&desk, &wide), "bearing capacity")["applicable"], true);
}

#[test]
fn resistive_force_theory_in_sand_is_limited_by_the_width_of_the_strip() {
    let sand = FOOTING.replace(
        "law = \"tresca\", shear_strength = \"2 kPa\", density",
        "law = \"mohr-coulomb\", friction_angle = \"33 deg\", density",
    );
    let sand = sand.replace("gravity = \"0 m/s^2\"\n", "");
    let desk = Desk::with(&[("footing.toml", &sand)]);
    let forces = ["grid.cell=125 mm", "grid.cell=62.5 mm"].map(|grid| {
        let document = forecast(&desk, &[grid]);
        let spatial = model(&document, "3D-RFT");
        assert_eq!(spatial["applicable"], true, "{grid}: {spatial}");
        spatial["vertical_N"].as_f64().unwrap()
    });
    assert!((forces[0] / forces[1] - 1.0).abs() < 1e-9, "{forces:?}");
}

#[test]
fn a_cylinder_in_plane_strain_is_a_metre_of_it() {
    let pipe = FOOTING
        .replace(
            "law = \"tresca\", shear_strength = \"2 kPa\", density",
            "law = \"mohr-coulomb\", friction_angle = \"33 deg\", density",
        )
        .replace("gravity = \"0 m/s^2\"\n", "")
        .replace(
            "shape = \"block\"\nsize = [\"1 m\", \"3.5 m\"]",
            "shape = \"wedge\"\nlength = \"0.5 m\"\nheight = \"0.5 m\"",
        )
        .replace(", symmetric_x = true", "")
        .replace("x = [\"0 m\", \"5 m\"]", "x = [\"-5 m\", \"5 m\"]")
        .replace("fine_x = [\"0 m\"", "fine_x = [\"-1 m\"");
    let desk = Desk::with(&[("footing.toml", &pipe)]);
    let forces = ["grid.cell=125 mm", "grid.cell=62.5 mm"].map(|grid| {
        let document = forecast(&desk, &[grid, "body.footing.heave.displacement=-0.1 m"]);
        model(&document, "3D-RFT")["vertical_N"].as_f64().unwrap()
    });
    assert!(forces[0] > 100.0 && (forces[0] / forces[1] - 1.0).abs() < 0.05, "{forces:?}");
}

/// Plane strain was named of blocks alone; and values at another friction angle were announced where none are
/// shown.
#[test]
fn a_pressed_pipe_is_told_per_metre_of_width_and_what_is_announced_is_shown() {
    let pressed = |soil: &str, domain: &str, body: &str| {
        let case = format!(
            "format = 2\nsoil = {{ {soil}, unit_weight = '16 kN/m^3', young_modulus = '1 MPa' }}\n\
             domain = {{ x = ['-0.6 m', '0.6 m'], z = ['-0.6 m', '0.2 m'], {domain} }}\ngrid = {{ cell = '20 mm' }}\n\
             run = {{ duration = '1 s' }}\n[body.tool]\n{body}\nfriction = 0.5\nsinkage = '0 mm'\nheave = {{ speed = '-0.05 m/s' }}\n"
        );
        Desk::with(&[("case.toml", &case)]).expect(0, &["forecast", "case.toml"])
    };
    let pipe = "shape = 'cylinder'\naxis = 'y'\ndiameter = '0.2 m'";
    pressed("law = 'tresca', shear_strength = '2 kPa'", "plane_strain = true", pipe)
        .says(&["per metre of width"]);
    let plate = "shape = 'block'\nsize = ['0.2 m', '0.2 m', '0.05 m']";
    let sand = "law = 'mohr-coulomb', friction_angle = '32 deg', dilation_angle = '0 deg'";
    let answer = pressed(sand, "y = ['-0.6 m', '0.6 m']", plate);
    answer.says(&["non-associated"]);
    assert!(!answer.out.contains("are given as well"), "{}", answer.out);
}
