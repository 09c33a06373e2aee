//! Undrained strength that grows with depth, is lost by remoulding and grows with the rate: where it is at
//! the start, what enters a grid that travels, what friction it admits, and what is refused.
use super::{fastest, read};
use coulter::forecast::outlook;
use coulter::simulation::Simulation;
use solver::fields::INTACT_STRENGTH;

const CLAY: &str =
    "law = \"tresca\"\nunit_weight = \"16 kN/m^3\"\nyoung_modulus = \"3 MPa\"\npoisson_ratio = 0.49\n";

fn text(soil: &str, rest: &str) -> String {
    format!(
        "format = 2\ngravity = \"9.81 m/s^2\"\n[soil]\n{CLAY}{soil}\n\
         [domain]\nx = [\"-0.1 m\", \"0.1 m\"]\ny = [\"-0.05 m\", \"0.05 m\"]\nz = [\"-0.1 m\", \"0.05 m\"]\n\
         [grid]\ncell = \"10 mm\"\n{rest}\n"
    )
}

/// Whether the intact clay in a column of cells has the strength [kPa] that is expected at the depth of each
/// [m].
fn is_strong(simulation: &Simulation, [i, j]: [usize; 2], expected: impl Fn(f64) -> f64) {
    let (grid, soil) = (&simulation.model.grid, &simulation.state.soil);
    for k in 0..grid.cells()[2] {
        let depth = -0.5 * (grid.faces[2][k] + grid.faces[2][k + 1]);
        let found = 1e-3 * soil.history[INTACT_STRENGTH][grid.index(i, j, k)];
        let expected = if depth > 0.0 { expected(depth) } else { 0.0 };
        assert!((found - expected).abs() < 1e-6, "at {depth} m {found} kPa, not {expected}");
    }
}

#[test]
fn strength_grows_with_depth_from_the_top_of_each_layer() {
    let lower = format!(
        "[layer.stiff]\ntop = \"40 mm\"\n{CLAY}shear_strength = \"4 kPa\"\nstrength_gradient = \"20 kPa/m\"\n"
    );
    let soil = format!("shear_strength = \"0 kPa\"\nstrength_gradient = \"50 kPa/m\"\n{lower}");
    for slope in ["", "[ground]\nslope = \"5 deg\"\n"] {
        let simulation =
            super::run(&read(&text(&soil, &format!("{slope}[run]\nduration = \"0.03 s\""))).unwrap());
        assert!(fastest(&simulation) < 1e-9, "{slope}: {} m/s", fastest(&simulation));
        let expected = |depth: f64| if depth < 0.04 { 50.0 * depth } else { 4.0 + 20.0 * (depth - 0.04) };
        is_strong(&simulation, [5, 5], expected);
    }
}

#[test]
fn the_clay_that_enters_in_front_has_the_same_strength_and_the_one_behind_is_remoulded() {
    let block = "[body.block]\nshape = \"block\"\nsize = [\"60 mm\", \"40 mm\", \"40 mm\"]\nfriction = \"rough\"\nadhesion_factor = 0.5\n\
                 sinkage = \"20 mm\"\nforward = { speed = \"1 m/s\", ramp = \"10 ms\" }\n";
    let soil = "shear_strength = \"1 kPa\"\nstrength_gradient = \"20 kPa/m\"\nsensitivity = 4\nremoulding_strain = 2\n\
                rate_strengthening = 0.1";
    let rest = format!("follow = {{ body = \"block\" }}\n{block}[run]\nduration = \"0.1 s\"");
    let simulation = super::run(&read(&text(soil, &rest)).unwrap());
    assert!(simulation.state.grid_position.x > 0.08);
    let ahead = simulation.model.grid.cells()[0] - 1;
    is_strong(&simulation, [ahead, 0], |depth| 1.0 + 20.0 * depth);
    // Friction is limited by half of the strength of the clay at each point, which is less where it is
    // remoulded. Some points, behind the block, have no clay next to them.
    let contacts = &simulation.state.contacts;
    // The limit counts for what a point represents: here faces are 1.5 to 1.56 times as large as the area
    // round their points.
    let limits: Vec<f64> =
        contacts.iter().map(|contact| contact.shear_limit / 1.5).filter(|limit| *limit > 0.0).collect();
    assert!(5 * limits.len() > 4 * contacts.len(), "{} of {}", limits.len(), contacts.len());
    let [least, most] =
        limits.iter().fold([f64::INFINITY, 0.0_f64], |[least, most], x| [least.min(*x), most.max(*x)]);
    assert!(
        least > 0.5 * 0.25e3 && least < 0.25e3 && most > 0.6e3 && most < 0.5 * 1.8e3,
        "{least} to {most} Pa"
    );
}

#[test]
fn what_has_no_strength_or_no_effect_is_refused() {
    for (soil, message) in [
        ("shear_strength = \"0 kPa\"", "no strength at any depth"),
        ("shear_strength = \"1 kPa\"\nsensitivity = 0.5", "sensitivity"),
        ("shear_strength = \"1 kPa\"\nremoulding_strain = 5", "has no effect without `sensitivity`"),
        (
            "shear_strength = \"1 kPa\"\nreference_rate = \"1e-5 1/s\"",
            "has no effect without `rate_strengthening`",
        ),
        ("shear_strength = \"1 kPa\"\nstrength_gradient = \"1 kPa\"", "a growth of strength with depth"),
    ] {
        let refused = read(&text(soil, "[run]\nduration = \"0.03 s\"")).unwrap_err();
        assert!(refused.contains(message), "{soil}: {refused}");
    }
}

#[test]
fn the_closed_forms_are_for_uniform_strength() {
    let disc = "[body.disc]\nshape = \"disc\"\ndiameter = \"80 mm\"\nthickness = \"40 mm\"\nfriction = 0.3\nweight = \"10 N\"\n\
                forward = { speed = \"0.1 m/s\", ramp = \"10 ms\" }\nheave = \"free\"\n[run]\nduration = \"0.1 s\"";
    let grown = read(&text("shear_strength = \"1 kPa\"\nstrength_gradient = \"20 kPa/m\"", disc)).unwrap();
    assert!(outlook(&grown).map_or(true, |outlook| outlook.recommended().is_none()));
    let sensitive = read(&text("shear_strength = \"1 kPa\"\nsensitivity = 3", disc)).unwrap();
    assert!(outlook(&sensitive).is_ok());
}
