//! A body that is driven in yaw: moments about every axis can be compared, and its `moment` is that about z.

use crate::support::Desk;
use serde_json::Value;

/// The case of the field on coarse cells, for a few milliseconds.
const CYLINDER: &str = r#"format = 2
soil = { law = "tresca", shear_strength = "9 kPa", unit_weight = "0 N/m^3", density = "1700 kg/m^3", young_modulus = "1.8 MPa", poisson_ratio = 0.49, k0 = 1 }
ground = { overburden = "70 kPa" }
[domain]
x = ["-0.12 m", "0.12 m"]
y = ["-0.12 m", "0.12 m"]
z = ["-0.22 m", "0 m"]
[grid]
cell = "20 mm"
growth = 1
[body.cylinder]
shape = "cylinder"
axis = "z"
diameter = "0.1 m"
length = "0.1 m"
friction = "rough"
elevation = "-0.11 m"
yaw_motion = { speed = "1 rad/s", ramp = "5 ms" }
[run]
duration = "0.03 s"
[output]
field_interval = "1 h"
"#;

#[test]
fn the_moment_of_a_vane_is_that_about_z() {
    let rows = "0.015,20\n0.02,20\n0.025,20\n0.03,20\n";
    let desk = Desk::with(&[
        ("cylinder.toml", CYLINDER),
        ("moment.csv", &format!("time [s],moment [N m]\n{rows}")),
        ("z.csv", &format!("time [s],moment z [N m]\n{}", rows.replace(",20", ",-20"))),
        ("x.csv", &format!("time [s],moment x [N m]\n{rows}")),
    ]);
    desk.coulter(&["run", "cylinder.toml", "-o", "results", "--threads", "1"]);
    let compared = |file: &str| -> Value {
        serde_json::from_str(&desk.expect(0, &["compare", "results", file, "--json"]).out).unwrap()
    };
    let last = desk.read("results/forces.csv").lines().last().unwrap().to_owned();
    let header = desk.read("results/forces.csv").lines().next().unwrap().to_owned();
    let column = header.split(',').position(|name| name == "moment z [N m]").unwrap();
    let moment: f64 = last.split(',').nth(column).unwrap().parse().unwrap();
    assert!(moment < -5.0, "the soil resists the turn to the left: {moment} N m");
    for file in ["moment.csv", "z.csv"] {
        let document = compared(file).to_string();
        assert!(!document.contains("null,null,null"), "{document}");
    }
    compared("x.csv");
    let text = desk.expect(0, &["compare", "results", "moment.csv"]).text();
    assert!(!text.contains("-100") && text.contains("torque"), "{text}");
}
