//! Figures of a paper, F̄ over Z: scaled with the reference quantities of the case or run beside them.

use crate::support::Desk;
use serde_json::Value;

const PLATE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "14 kN/m^3", young_modulus = "2 MPa" }
grid = { cell = "8 mm" }
run = { duration = "0.4 s" }
[body.plate]
shape = "cylinder"
axis = "z"
diameter = "100 mm"
length = "50 mm"
friction = 0.4
heave = { speed = "-0.08 m/s", ramp = "0.02 s" }
"#;

#[test]
fn a_curve_without_dimensions_is_that_with_them() {
    // d = t = 0.1 m, γ t d² = 14 N.
    let desk = Desk::with(&[
        ("plate.toml", PLATE),
        ("big.toml", &PLATE.replace("100 mm", "200 mm")),
        ("groups.csv", "Z [-],F_V_bar [-]\n0.05,2\n0.1,5\n0.2,9\n"),
        ("groups_too.csv", "z/d (-);F_V (-)\n0,05;2\n0,1;5\n0,2;9\n"),
        ("plain.csv", "sinkage [mm],vertical [N]\n5,28\n10,70\n20,126\n"),
        (
            "both.csv",
            "sinkage z [m],Z [-],vertical F_V [N],F_V_bar [-]\n0.005,7,28,7\n0.01,7,70,7\n0.02,7,126,7\n",
        ),
    ]);
    let bias = |file: &str| {
        let answer = desk.expect(0, &["compare", "plate.toml", file, "--json"]);
        let document: Value = serde_json::from_str(&answer.out).unwrap();
        assert_eq!(
            document["remarks"].to_string().matches("d = 0.1 m").count(),
            usize::from(file.starts_with("groups"))
        );
        document["compared"][0]["differences"]["bias"].as_f64().unwrap()
    };
    let expected = bias("plain.csv");
    for file in ["groups.csv", "groups_too.csv", "both.csv"] {
        assert!((bias(file) - expected).abs() < 1e-9 * expected.abs(), "{file}");
    }
    desk.expect(2, &["compare", "groups.csv", "plain.csv"])
        .says(&["\"Z [-]\" is dimensionless", "sinkage [m]"]);
    desk.expect(2, &["compare", "plate.toml", "big.toml", "groups.csv"])
        .says(&["different reference quantities"]);
    let parameter = ["--parameter", "soil.friction_angle=28..42 deg"];
    desk.expect(2, &[&["calibrate", "plate.toml", "groups.csv"][..], &parameter].concat())
        .says(&["is dimensionless"]);
}
