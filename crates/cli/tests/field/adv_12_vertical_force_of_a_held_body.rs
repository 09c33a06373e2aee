//! A run graded good on cells of both widths, whose vertical force changed by a fifth from one to the other.

use super::support::Desk;

const CASE: &str = r#"format = 2
[soil]
law = "sand"
critical_friction_angle = "29.127 deg"
minimum_density = "1350 kg/m^3"
maximum_density = "1650 kg/m^3"
relative_density = 0.73
young_modulus = "10 MPa"
stiffness_limit = "11.791 kPa"
poisson_ratio = 0.3
[ground]
slope = "1.5993 deg"
[domain]
symmetric = true
[grid]
cell = "0.04642 m"
growth = 1.45
[body.thing]
shape = "disc"
diameter = "0.39304 m"
thickness = "0.23572 m"
rim = "rounded"
friction = 0.4
sinkage = "0.22111 m"
forward = { speed = "0.37176 m/s", start = "0 s", ramp = "0.05 s" }
[run]
tow_distance = "0.04 m"
[output]
field_interval = "1 h"
"#;

#[test]
fn the_cells_that_a_vertical_force_needs_are_graded() {
    let desk = Desk::with(&[("case.toml", CASE)]);
    desk.coulter(&["run", "case.toml", "-o", "held"]);
    let (cells, verdict) = desk.graded("held", "cells for the vertical force").unwrap();
    assert!((cells.unwrap() - 4.76).abs() < 0.05 && verdict == "doubtful", "{cells:?} {verdict}");
    // The drag has cells enough, and noise and change of the vertical force are graded as well.
    assert_eq!(desk.graded("held", "cells over sinkage").unwrap().1, "good");
    assert!(desk.graded("held", "vertical noise").is_some());
    assert!(desk.graded("held", "steady vertical force").is_some());
}
