//! A body that is pressed in single precision stopped at once: "more than half of the energy unexplained", of
//! energies that rounding makes.

use super::support::Desk;

const CASE: &str = r#"format = 2
[soil]
law = "tresca"
shear_strength = "3185.5 Pa"
unit_weight = "15127 N/m^3"
young_modulus = "4.6687e+05 Pa"
poisson_ratio = 0.4
strength_gradient = "6411.5 Pa/m"
[domain]
symmetric = true
[grid]
cell = "0.04 m"
growth = 1.45
[body.thing]
shape = "disc"
diameter = "0.20547 m"
thickness = "0.089259 m"
friction = "rough"
heave = { speed = "-0.10467 m/s", ramp = "0.20612 s" }
[run]
duration = "0.2 s"
[output]
field_interval = "1 h"
[numerics]
precision = "single"
"#;

#[test]
fn single_precision_runs_where_double_does() {
    let desk = Desk::with(&[("case.toml", CASE)]);
    let closure = |results: &str| desk.graded(results, "energy balance").unwrap();
    desk.expect(0, &["run", "case.toml", "-o", "single"]);
    desk.expect(0, &["run", "case.toml", "-o", "double", "--set", "numerics.precision=double"]);
    let ([single, double], [one, other]) = (
        [closure("single").0.unwrap(), closure("double").0.unwrap()],
        [closure("single").1, closure("double").1],
    );
    assert!((single - double).abs() < 0.5, "{single} and {double} %");
    assert_eq!([one, other], ["good", "good"]);
}
