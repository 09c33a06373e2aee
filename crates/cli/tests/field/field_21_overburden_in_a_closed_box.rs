//! A cone, a pile or a bar that is pushed into soil which fills its box pumps it up: K ΔV/V is known before
//! the run.

use crate::support::Desk;

const CONE: &str = r#"
format = 2
soil = { law = "tresca", shear_strength = "20 kPa", unit_weight = "0 N/m^3", density = "1700 kg/m^3", young_modulus = "5.96 MPa", poisson_ratio = 0.49, k0 = 1 }
ground = { overburden = "70 kPa" }
domain = { x = ["0 m", "0.2 m"], y = ["0 m", "0.2 m"], z = ["-0.32 m", "0 m"], symmetric = true, symmetric_x = true }
grid = { cell = "8 mm", growth = 1.3, fine_x = ["0 m", "0.04 m"], fine_y = ["0 m", "0.04 m"], fine_z = ["-0.22 m", "0 m"] }
run = { duration = "0.22 s" }
[body.cone]
shape = "cone"
diameter = "40 mm"
cone_angle = "60 deg"
length = "0.24 m"
friction = 0
sinkage = "50 mm"
heave = { speed = "-0.6 m/s", ramp = "0.02 s" }
"#;

#[test]
fn the_rise_of_pressure_is_foretold_with_the_box_that_it_takes() {
    let desk = Desk::with(&[("cone.toml", CONE)]);
    desk.expect(0, &["check", "cone.toml"]).says(&[
        "down 0.126 m from 0 to 0.22 s",
        "K ΔV/V = 307",
        "114 % of what the soil bears",
        "times its strength",
        "A box 2.2 times as long, wide and deep",
    ]);
    let large =
        ["domain.x=[\"0 m\",\"0.4 m\"]", "domain.y=[\"0 m\",\"0.4 m\"]", "domain.z=[\"-0.5 m\",\"0 m\"]"];
    let sets = large.iter().flat_map(|set| ["--set", set]);
    let arguments: Vec<&str> = ["check", "cone.toml"].into_iter().chain(sets).collect();
    desk.expect(0, &arguments).says(&["K ΔV/V = 49", "18 % of what the soil bears"]);
}

#[test]
fn a_whole_box_says_the_same_and_one_with_room_above_nothing() {
    let desk = Desk::with(&[("cone.toml", CONE)]);
    let whole = [
        "check",
        "cone.toml",
        "--set",
        "domain.symmetric=false",
        "--set",
        "domain.symmetric_x=false",
        "--set",
        "domain.x=[\"-0.2 m\",\"0.2 m\"]",
        "--set",
        "domain.y=[\"-0.2 m\",\"0.2 m\"]",
    ];
    desk.expect(0, &whole).says(&["114 % of what the soil bears"]);
    let open = [
        "check",
        "cone.toml",
        "--set",
        "ground.overburden=0 Pa",
        "--set",
        "domain.z=[\"-0.32 m\",\"0.1 m\"]",
    ];
    let answer = desk.expect(0, &open);
    assert!(!answer.text().contains("ΔV"), "{}", answer.text());
}

#[test]
fn the_run_is_graded_by_what_has_entered() {
    let desk = Desk::with(&[("cone.toml", CONE)]);
    let coarse = [
        "run",
        "cone.toml",
        "--set",
        "grid.cell=20 mm",
        "--set",
        "run.duration=0.1 s",
        "--set",
        "numerics.threads=1",
    ];
    desk.coulter(&coarse);
    assert!(desk.read("results/cone/summary.json").contains("pressure of displaced volume"));
}
