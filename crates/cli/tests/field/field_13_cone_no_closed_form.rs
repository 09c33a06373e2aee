//! Closed forms are judged at the points that are asked for, and cones, piles, pipes, growing strength and
//! uplift have one.

use crate::support::Desk;
use serde_json::Value;

const CONE: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "15 kN/m^3", young_modulus = "5 MPa" }
domain = { x = ["0 m", "0.2 m"], y = ["0 m", "0.2 m"], z = ["-0.5 m", "0.04 m"], symmetric = true, symmetric_x = true }
grid = { cell = "4.5 mm", growth = 1.25 }
run = { duration = "3 s" }
[body.cone]
shape = "cone"
diameter = "36 mm"
cone_angle = "60 deg"
length = "0.45 m"
friction = 0.3
heave = { speed = "-0.1 m/s" }
"#;
const UPPER: &str = "depth [mm],cone resistance [kPa]\n20,60\n40,120\n60,190\n80,250\n";
const FULL: &str = "depth [m],cone resistance [MPa]\n0.05,0.15\n0.10,0.31\n0.15,0.50\n0.20,0.64\n0.25,0.80\n";
const PRIOR: [&str; 4] = ["--parameter", "soil.friction_angle=28 deg..45 deg", "--samples", "500"];

/// A case of a body that is moved straight up or down, in level ground.
fn case(soil: &str, domain: &str, body: &str) -> String {
    format!(
        "format = 2\nsoil = {{ {soil}, young_modulus = \"2 MPa\" }}\nrun = {{ duration = \"1 s\" }}\ngrid = {{ cell = \"20 mm\" }}\n\
         domain = {{ {domain} }}\n[body.it]\n{body}\n"
    )
}

const SPACE: &str = r#"x = ["-2 m", "2 m"], y = ["-2 m", "2 m"], z = ["-4 m", "1 m"]"#;
const PLANE: &str = r#"x = ["-2 m", "2 m"], z = ["-4 m", "1 m"], plane_strain = true"#;
const CLAY: &str =
    r#"law = "tresca", shear_strength = "5 kPa", density = "1600 kg/m^3", poisson_ratio = 0.49"#;
const SAND: &str = r#"law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "16 kN/m^3""#;

fn forecast(text: &str, more: &[&str]) -> Value {
    let desk = Desk::with(&[("case.toml", text)]);
    let answer = desk.expect(0, &[&["forecast", "case.toml", "--json"][..], more].concat());
    serde_json::from_str(&answer.out).unwrap()
}

fn best(text: &str, more: &[&str]) -> (String, f64) {
    let seen = forecast(text, more);
    let name = seen["recommended"].as_str().unwrap_or_else(|| panic!("{}", seen["recommendation"]));
    let model = seen["models"].as_array().unwrap().iter().find(|model| model["name"] == name).unwrap();
    (name.to_owned(), model["vertical_N"].as_f64().unwrap())
}

#[test]
fn points_are_judged_for_themselves() {
    let desk = Desk::with(&[("cone.toml", CONE), ("upper.csv", UPPER), ("full.csv", FULL)]);
    desk.expect(0, &["compare", "cone.toml", "upper.csv"]).says(&["3D-RFT"]);
    let cut: &[&str] = &["--closed-form", "3D-RFT"];
    for (file, more, model, points) in [
        ("upper.csv", &[][..], "3D-RFT", 4),
        ("full.csv", &[], "cone or pile", 5),
        ("full.csv", cut, "3D-RFT", 1),
    ] {
        let all = [&["calibrate", "cone.toml", file, "--force"][..], &PRIOR, more].concat();
        let answer = desk.expect(0, &all);
        let found: Value =
            serde_json::from_str(&desk.read("results/cone-calibration/calibration.json")).unwrap();
        assert_eq!(found["closed_form"]["model"], model);
        assert_eq!(found["closed_form"]["points"], points, "{file}");
        assert_eq!(answer.text().contains("left out (lines 3 to 6"), points == 1, "{}", answer.text());
    }
    desk.expect(0, &["compare", "cone.toml", "full.csv"]).says(&["cone or pile"]);
}

#[test]
fn the_new_model_finds_the_friction_angle_of_a_whole_cone_test() {
    let desk = Desk::with(&[("cone.toml", CONE), ("full.csv", FULL)]);
    desk.expect(0, &[&["calibrate", "cone.toml", "full.csv"][..], &PRIOR].concat());
    let found: Value = serde_json::from_str(&desk.read("results/cone-calibration/calibration.json")).unwrap();
    let interval = &found["closed_form"]["parameters"][0]["interval_90"];
    let [low, high] = [&interval[0], &interval[1]].map(|end| end.as_f64().unwrap());
    assert!(low > 33.0 && high < 43.0 && high - low < 6.0, "{low} {high}");
}

#[test]
fn without_a_model_no_figure_is_given_for_its_error() {
    let desk = Desk::with(&[(
        "case.toml",
        &case(
            SAND,
            SPACE,
            "shape = \"cone\"\ndiameter = \"0.1 m\"\ncone_angle = \"30 deg\"\nlength = \"1 m\"\nfriction = 0.3\nheave = { displacement = \"-0.8 m\" }",
        ),
    )]);
    let answer = desk.expect(0, &["forecast", "case.toml"]);
    answer.says(&["No model applies (", "cone angle = 30"]);
    assert!(!answer.text().contains("a factor of"), "{}", answer.text());
}

#[test]
fn a_cone_in_clay_has_ten_to_eleven_times_its_strength_at_depth() {
    // G = 100 s_u, smooth, without weight.
    let soil =
        r#"law = "tresca", shear_strength = "6.711 kPa", density = "1600 kg/m^3", poisson_ratio = 0.49"#;
    let body = "shape = \"cone\"\ndiameter = \"36 mm\"\ncone_angle = \"60 deg\"\nlength = \"1 m\"\nfriction = 0\nheave = { displacement = \"-0.8 m\" }";
    let text = format!("gravity = \"0 m/s^2\"\n{}", case(soil, SPACE, body));
    let (name, force) = best(&text, &[]);
    let factor = force / (6711.0 * std::f64::consts::FRAC_PI_4 * 0.036 * 0.036);
    assert!(name == "cone or pile" && (10.0..11.0).contains(&factor), "{name} {factor}");
    // It is less near the surface, and grows from there.
    let at = |depth: &str| best(&text, &["--set", &format!("body.it.heave.displacement={depth}")]).1;
    let forces = ["-0.02 m", "-0.1 m", "-0.3 m", "-0.8 m"].map(at);
    assert!(forces.windows(2).all(|pair| pair[0] < pair[1]), "{forces:?}");
}

#[test]
fn growing_strength_raises_the_capacity_of_footings_cones_and_pipes() {
    let footing = "shape = \"block\"\nsize = [\"1 m\", \"1 m\"]\nfriction = \"rough\"\nheave = { displacement = \"-1e-6 m\" }";
    let pipe = "shape = \"cylinder\"\naxis = \"y\"\ndiameter = \"0.5 m\"\nfriction = 0.3\nheave = { displacement = \"-0.2 m\" }";
    let cone = "shape = \"cone\"\ndiameter = \"0.2 m\"\ncone_angle = \"120 deg\"\nlength = \"2 m\"\nfriction = 0.3\nheave = { displacement = \"-0.4 m\" }";
    let grows = ["--set", "soil.strength_gradient=5 kPa/m"];
    for (domain, body, model) in
        [(PLANE, footing, "bearing capacity"), (PLANE, pipe, "pipe"), (SPACE, cone, "cone or pile")]
    {
        let text = case(CLAY, domain, body);
        let ((name, uniform), (_, growing)) = (best(&text, &[]), best(&text, &grows));
        assert!(name == model && growing > 1.02 * uniform, "{model}: {name} {uniform} {growing}");
    }
    // Davis & Booker: 5.98 s_u for k B = s_u, per metre of width.
    let (_, force) = best(&case(CLAY, PLANE, footing), &grows);
    assert!((force / 5e3 - 5.982).abs() < 2e-3, "{force}");
}

#[test]
fn what_is_pulled_up_is_held_by_the_soil_above_it() {
    let up = "friction = 0.3\nheave = { displacement = \"0.1 m\" }";
    let pipe = format!("shape = \"cylinder\"\naxis = \"y\"\ndiameter = \"0.2 m\"\nsinkage = \"0.8 m\"\n{up}");
    let round = format!(
        "shape = \"cylinder\"\naxis = \"z\"\ndiameter = \"0.4 m\"\nlength = \"0.05 m\"\nsinkage = \"0.85 m\"\n{up}"
    );
    for (soil, domain, body) in
        [(SAND, PLANE, &pipe), (CLAY, PLANE, &pipe), (SAND, SPACE, &round), (CLAY, SPACE, &round)]
    {
        let (name, force) = best(&case(soil, domain, body), &[]);
        assert!(name == "uplift" && force < 0.0, "{name} {force}");
    }
    // Circle, φ = 35°, H/B = 2: weight (1 + 2 s K_u tan φ H/B), s = 1.5.
    let (_, force) = best(&case(SAND, SPACE, &round), &[]);
    let weight = 16e3 * 0.8 * std::f64::consts::FRAC_PI_4 * 0.16;
    let known = weight * (1.0 + 2.0 * 1.5 * 0.94 * 35_f64.to_radians().tan() * 2.0);
    assert!((force / -known - 1.0).abs() < 1e-6, "{force} {known}");
}

#[test]
fn where_there_is_none_the_reason_is_that_of_the_body() {
    let tow = "friction = 0.3\nforward = { speed = \"0.1 m/s\" }\nheave = \"fixed\"\nsinkage = \"50 mm\"";
    let disc =
        format!("shape = \"disc\"\ndiameter = \"0.4 m\"\nthickness = \"0.1 m\"\nyaw = \"20 deg\"\n{tow}");
    let blade = format!("shape = \"block\"\nsize = [\"0.05 m\", \"0.3 m\", \"0.2 m\"]\n{tow}");
    let ball =
        "shape = \"sphere\"\ndiameter = \"0.2 m\"\nfriction = 0.3\nheave = { displacement = \"-0.1 m\" }";
    for (body, reason) in
        [(disc.as_str(), "flank"), (&blade, "wedge of clay"), (ball, "level bases, cones, discs and pipes")]
    {
        let desk = Desk::with(&[("case.toml", &case(CLAY, SPACE, body))]);
        desk.expect(2, &["forecast", "case.toml"]).says(&[reason, "run the solver"]);
    }
}
