//! The interval of a difference is not that of its sum, and a model with a bad record is not recommended for
//! being alone.

use crate::support::Desk;

const WHEEL: &str = r#"
format = 2
gravity = "9.8 m/s^2"
soil = { law = "mohr-coulomb", friction_angle = "38.7 deg", cohesion = "0 Pa", density = "1700 kg/m^3", young_modulus = "1 MPa" }
domain = { x = ["-0.5 m", "1 m"], y = ["0 m", "0.4 m"], z = ["-0.2 m", "0.15 m"], symmetric = true }
run = { tow_distance = "0.4 m" }
grid = { cell = "10 mm" }
[body.wheel]
shape = "wheel"
diameter = "0.5 m"
thickness = "0.2 m"
grousers = 24
grouser_height = "20 mm"
grouser_thickness = "10 mm"
friction = 0.8
weight = "1000 N"
forward = { speed = "0.2 m/s", start = "0.3 s" }
heave = { load = "0 N" }
spin = { slip = 0.4 }
"#;

#[test]
fn the_interval_of_the_pull_holds_what_solver_and_particle_code_found() {
    let desk = Desk::with(&[("wheel.toml", WHEEL)]);
    let answer = desk.expect(0, &["forecast", "wheel.toml", "--json"]);
    let seen: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let model = seen["models"].as_array().unwrap().iter().find(|model| model["name"] == "3D-RFT").unwrap();
    let [low, high] = ["low", "high"].map(|end| model["interval"]["drag_N"][end].as_f64().unwrap());
    // Pulls of 252 N (a particle code) and 229 N (the solver), known when the interval was made; the soil can
    // shear W tan φ.
    assert!(low < -252.0 && high > -229.0, "{low} {high}");
    assert!(low >= -801.3, "{low}");
    assert!(seen["recommended"].is_null());
    answer.says(&["upper bound", "No model is recommended"]);
    assert!((seen["groups"]["t_bar"].as_f64().unwrap() - 0.4).abs() < 1e-9);
    assert!(!answer.text().contains("only model that applies"));
}

#[test]
fn slips_up_to_spinning_are_possible_and_no_pull_exceeds_what_the_soil_can_shear() {
    let desk = Desk::with(&[("wheel.toml", WHEEL)]);
    desk.expect(0, &["forecast", "wheel.toml", "--against", "slip=0..1", "--points", "5", "-o", "out"]);
    let curve = desk.read("out/curve.csv");
    assert_eq!(curve.lines().count(), 6, "{curve}");
    let head: Vec<&str> = curve.lines().next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|cell| cell.starts_with(name)).unwrap();
    let (applies, drag) = (column("3D-RFT applicable"), column("3D-RFT drag"));
    for line in curve.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        assert!(cells[applies] == 0.0 || cells[drag] > -801.3, "{line}");
    }
    desk.expect(0, &["forecast", "wheel.toml", "--against", "slip=0.5..1.5", "--points", "5", "-o", "more"])
        .says(&["2 points of the curve are left out"]);
}
