//! Sharp tips and thin discs on few cells: the leak that breaks the run is foretold.

use crate::support::Desk;

/// A body on cells of a size, in a soil.
fn case(soil: &str, body: &str, cell: &str) -> String {
    format!(
        "format = 2\n[soil]\n{soil}\nyoung_modulus = '3 MPa'\n[domain]\nsymmetric = true\n[grid]\ncell = '{cell}'\ngrowth = 1.45\n\
         [body.thing]\n{body}\n[run]\nduration = '0.6 s'\n"
    )
}

const FRICTIONAL: &str = "law = 'mohr-coulomb'\nfriction_angle = '37.7 deg'\nunit_weight = '17.4 kN/m^3'";
const MEDIUM: &str = "law = 'sand'\ncritical_friction_angle = '33.3 deg'\nminimum_density = '1400 kg/m^3'\n\
                      maximum_density = '1700 kg/m^3'\nrelative_density = 0.45\nstiffness_limit = '15 kPa'";
const CLAY: &str = "law = 'tresca'\nshear_strength = '10 kPa'\nunit_weight = '16 kN/m^3'";
const CONE: &str = "shape = 'cone'\ndiameter = '80 mm'\ncone_angle = '60 deg'\nlength = '0.24 m'\nfriction = 0.3\n\
                    heave = { speed = '-0.1 m/s', ramp = '0.2 s' }";
const DISC: &str = "shape = 'disc'\ndiameter = '0.3 m'\nthickness = '20 mm'\nfriction = 0.3\nsinkage = '60 mm'\n\
                    forward = { speed = '0.2 m/s', ramp = '0.2 s' }";

fn warnings(soil: &str, body: &str, cell: &str) -> String {
    let desk = Desk::with(&[("case.toml", &case(soil, body, cell))]);
    desk.expect(0, &["check", "case.toml"]).text()
}

#[test]
fn a_cone_on_few_cells_is_said_to_leak_with_the_cells_that_it_takes() {
    for soil in [FRICTIONAL, MEDIUM, CLAY] {
        for cell in ["20 mm", "11.5 mm"] {
            let text = warnings(soil, CONE, cell);
            assert!(text.contains("cells across the cone: soil will leak into it"), "{cell}: {text}");
        }
    }
    assert!(
        warnings(FRICTIONAL, CONE, "20 mm")
            .contains("12 cells or more are advisable there, grid.cell = \"6.6 mm\"")
    );
    assert!(!warnings(FRICTIONAL, CONE, "6.6 mm").contains("leak"));
}

#[test]
fn a_thin_disc_along_the_tow_is_said_to_leak_and_a_thick_one_is_not() {
    assert!(
        warnings(CLAY, DISC, "20 mm").contains("1.0 cells across the thickness of the disc: soil will leak")
    );
    assert!(!warnings(CLAY, DISC, "7 mm").contains("leak"));
}
