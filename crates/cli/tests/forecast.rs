//! `coulter forecast` and `coulter pressure` through the binary.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use serde_json::Value;

fn coulter() -> Command {
    Command::cargo_bin("coulter").unwrap()
}

fn shipped(name: &str) -> String {
    format!("{}/../../cases/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn forecast(arguments: &[&str]) -> Command {
    let mut command = coulter();
    command.arg("forecast").arg(shipped("light_disc.toml")).args(arguments);
    command
}

fn json(arguments: &[&str]) -> Value {
    let output = forecast(arguments).arg("--json").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn refusal(command: &mut Command) -> String {
    let refused = command.assert().code(2);
    String::from_utf8_lossy(&refused.get_output().stderr).into_owned()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

fn model<'a>(document: &'a Value, name: &str) -> &'a Value {
    document["models"].as_array().unwrap().iter().find(|m| m["name"] == name).unwrap()
}

#[test]
fn the_table_recommends_a_model() {
    let reply = forecast(&[]).assert().success();
    let text = String::from_utf8_lossy(&reply.get_output().stdout).into_owned();
    for word in [
        "F_H [N]",
        "slip",
        "mechanism",
        "3D-RFT",
        "do not apply here",
        "cone_index = ",
        "5–95 %",
        "Recommended",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
}

#[test]
fn the_document_keeps_its_names() {
    let seen = json(&[]);
    let groups = &seen["groups"];
    assert_eq!(number(&groups["t_bar"]), 0.25);
    assert!((number(&groups["W_bar"]) - 1.25).abs() < 1e-12);
    assert!((number(&groups["E_bar"]) - 1562.5).abs() < 1e-9);
    let best = model(&seen, seen["recommended"].as_str().unwrap());
    assert_eq!(best["applicable"], true);
    // It carries the weight, and does not roll quite as fast as it is towed.
    assert!((number(&best["vertical_N"]) - 40.0).abs() < 1e-3);
    assert!((-0.5..0.0).contains(&number(&best["slip"])));
    assert!((number(&best["Z"]) - number(&best["sinkage_m"]) / 0.2).abs() < 1e-12);
    assert!((number(&best["F_H_bar"]) - number(&best["drag_N"]) / 32.0).abs() < 1e-9);
    let inclination = (number(&best["drag_N"]) / number(&best["vertical_N"])).atan();
    assert!((number(&best["force_inclination_rad"]) - inclination).abs() < 1e-6);
    assert!((number(&best["contact_angle_rad"]).cos() - (1.0 - 2.0 * number(&best["Z"]))).abs() < 1e-9);
    assert!(["sideways", "forwards"].contains(&best["mechanism"].as_str().unwrap()));
    assert!(number(&seen["spread"]["count"]) >= 2.0);
    // Every model that applies shows an interval, here for an assumed uncertainty of the friction angle.
    assert_eq!(seen["interval_inputs"][0]["assumed"], true);
    for applied in seen["models"].as_array().unwrap().iter().filter(|m| m["applicable"] == true) {
        for quantity in ["drag_N", "sinkage_m"] {
            let [low, high] = ["low", "high"].map(|end| number(&applied["interval"][quantity][end]));
            let value = number(&applied[quantity]);
            assert!(low < value && value < high, "{applied}");
        }
    }
    let absent = model(&seen, "Brixius");
    assert!(absent["drag_N"].is_null() && !absent["note"].as_str().unwrap().is_empty());
}

#[test]
fn a_driven_disc_has_the_textbooks_slip_and_keeps_its_older_key() {
    // ωr/v = 1/0.7: a slip of 0.3, which is 0.4286 as ωr/v − 1.
    let driven = json(&["--set", "body.disc.spin={ speed = \"2.857142857142857 rad/s\" }"]);
    assert!((number(&driven["drive"]["slip"]) - 0.3).abs() < 1e-12);
    let best = driven["models"].as_array().unwrap().iter().find(|m| !m["slip"].is_null()).unwrap().clone();
    assert!((number(&best["slip"]) - 0.3).abs() < 1e-9 && (number(&best["skid"]) - 3.0 / 7.0).abs() < 1e-9);
}

#[test]
fn a_sideways_tow_has_its_direction_and_a_sideways_load_is_refused() {
    let sets = |lateral: &'static str| {
        let whole = [
            "domain.symmetric=false",
            "domain.y=[\"-0.3 m\", \"0.6 m\"]",
            "grid.fine_y=[\"-0.15 m\", \"0.4 m\"]",
        ];
        [lateral].into_iter().chain(whole).flat_map(|set| ["--set", set]).collect::<Vec<_>>()
    };
    let towed = json(&sets("body.disc.lateral={ speed = \"0.1 m/s\" }"));
    let remarks = towed["remarks"].to_string();
    assert!(remarks.contains("towed at 26.57° from x"), "{remarks}");
    let reply = refusal(&mut forecast(&sets("body.disc.lateral={ load = \"5 N\" }")));
    assert!(reply.contains("sideways") && reply.contains("lateral = \"fixed\""), "{reply}");
}

#[test]
fn a_tow_in_which_inertia_counts_is_said_to_be_one() {
    let remarks = |speed: &str| {
        json(&["--set", &format!("body.disc.forward={{ speed = \"{speed}\" }}")])["remarks"].to_string()
    };
    assert!(remarks("2 m/s").contains("inertia"), "{}", remarks("2 m/s"));
    assert!(!remarks("0.1 m/s").contains("inertia"), "{}", remarks("0.1 m/s"));
}

#[test]
fn the_axle_and_the_heave_are_understood() {
    assert_eq!(json(&["--set", "body.disc.spin=\"locked\""])["drive"]["kind"], "locked");
    let rotated = json(&["--set", "body.disc.spin={ speed = \"1 rad/s\" }"]);
    assert!((number(&rotated["drive"]["slip"]) + 0.5).abs() < 1e-12);
    let held = ["--set", "body.disc.heave=\"fixed\"", "--set", "body.disc.sinkage=\"20 mm\""];
    let held = json(&held);
    assert!((number(&held["load"]["sinkage_m"]) - 0.02).abs() < 1e-12);
    assert!(held["remarks"][0].as_str().unwrap().contains("deepest"));
    let pushed = json(&[
        "--set",
        "body.disc.heave={ speed = \"-0.01 m/s\", start = \"0 s\", ramp = \"0 s\", end = \"1 s\" }",
    ]);
    assert!((number(&pushed["load"]["sinkage_m"]) - 0.01).abs() < 1e-9);
}

#[test]
fn what_it_cannot_answer_is_refused_with_the_reason() {
    let why = refusal(coulter().arg("forecast").arg(shipped("column_collapse.toml")));
    assert!(why.contains("no body"), "{why}");
    let weightless = ["--set", "soil.unit_weight=0 N/m^3", "--set", "soil.density=1600 kg/m^3"];
    for (keys, word) in [
        (&weightless[..], "weightless"),
        (&["--set", "body.disc.heave=\"fixed\""], "never moves below"),
        (&["--against", "Z=0.1"], "Z=0.02..0.4"),
        (&["--against", "soil.colour=1..2", "-o", "nowhere"], "soil.friction_angle"),
        (&["--against", "soil.cohesion=\"0 Pa\"..\"5 kPa\"", "--log"], "above 0"),
        (&["--uncertainty"], "--spread"),
        (&["--log"], "--against"),
        (&["--points", "9"], "--against"),
        (&["--force"], "--against"),
        (&["--against", "sinkage_exponent=0.5..1.5"], "terrain ="),
        (&["--set", "forecast.sinkage_exponent=1.1"], "forecast.cohesive_modulus"),
        (&["--set", "forecast.frictional_modulus=5 kN/m^3"], "must contain n"),
        (&["--set", "forecast.terrain=\"LETE\""], "LETE sand"),
        (&["--set", "forecast.shear_deformation_modulus=5 mm"], "does nothing"),
        (&["--set", "forecast.backfill=40 deg"], "from -10 deg to 25 deg"),
        (&["--uncertainty", "--spread", "soil.friction_angle=2 m"], "an angle is needed"),
    ] {
        let why = refusal(&mut forecast(keys));
        assert!(why.contains(word), "{word} is missing in {why}");
    }
}

#[test]
fn curves_are_written_and_not_overwritten_unasked() {
    let folder = tempfile::tempdir().unwrap();
    let run = |against: &str, more: &[&str]| {
        let mut command = forecast(&["--against", against, "--points", "9"]);
        command.current_dir(&folder).args(more);
        command
    };
    run("Z=0.02..0.4", &[]).assert().success();
    let written = folder.path().join("results/light_disc-forecast");
    let curve = std::fs::read_to_string(written.join("curve.csv")).unwrap();
    assert_eq!(curve.lines().count(), 10);
    assert!(curve.starts_with("sinkage z [m],Z = z/d"));
    let width = curve.lines().next().unwrap().split(',').count();
    assert!(curve.lines().all(|line| line.split(',').count() == width));
    for name in ["drag", "vertical", "drag_dimensionless", "vertical_dimensionless"] {
        let svg = std::fs::read_to_string(written.join(format!("{name}.svg"))).unwrap();
        assert!(svg.contains("BC") && svg.ends_with("</svg>\n"), "{name}");
    }
    assert!(written.join("models.csv").is_file() && written.join("forecast.json").is_file());
    assert!(refusal(&mut run("Z=0.02..0.4", &[])).contains("--force"));
    run("body.disc.weight=5 N..80 N", &["--log", "--force"]).assert().success();
    assert!(written.join("sinkage.svg").is_file());
    for key in [
        "soil.friction_angle=\"30 deg\"..\"45 deg\"",
        "thickness=10 mm..90 mm",
        "diameter=0.1 m..0.4 m",
        "friction=0..0.6",
        "forecast.cone_index=100 kPa..1 MPa",
        "forecast.plate_stiffness=500 kN/m^3..2 MN/m^3",
        "bow_wave=0..0.5",
        "backfill=-5 deg..20 deg",
        "slip=-0.9..0",
        "z=2 mm..60 mm",
        "dilation_angle=0 deg..35 deg",
        "cohesion=0 Pa..500 Pa",
        "unit_weight=9 kN/m^3..18 kN/m^3",
    ] {
        run(key, &["--force"]).assert().success();
    }
}

#[test]
fn standard_deviations_become_intervals() {
    let typed =
        ["--uncertainty", "--spread", "soil.friction_angle=2 deg", "--spread", "body.disc.weight=2 N"];
    let seen = json(&typed);
    let all = seen["uncertainty"]["quantities"].as_array().unwrap();
    let sinkage = all.iter().find(|q| q["quantity"] == "sinkage_m").unwrap();
    assert!(number(&sinkage["low"]) < number(&sinkage["middle"]));
    assert!(number(&sinkage["middle"]) < number(&sinkage["high"]));
    let indices: Vec<f64> = sinkage["first_order"].as_array().unwrap().iter().map(number).collect();
    // Friction angle, weight, and the error of the model itself, which counts as much as two degrees.
    assert!(
        indices.len() == 3 && indices[0] > 3.0 * indices[1] && indices[2] > 3.0 * indices[1],
        "{indices:?}"
    );
    assert!(indices.iter().sum::<f64>() > 0.9, "{indices:?}");
    // The same from the case itself; a run uses the means.
    let stated =
        ["--set", "soil.friction_angle=35 ± 2 deg", "--set", "body.disc.weight=40 ± 2 N", "--uncertainty"];
    let same = json(&stated);
    assert_eq!(same["uncertainty"]["quantities"], seen["uncertainty"]["quantities"]);
    assert_eq!(same["models"], seen["models"]);
    for name in ["weaker of BC and PW", "BC", "3D-RFT", "2-D RFT"] {
        assert_eq!(all.iter().filter(|q| q["model"] == name).count(), 2, "{name}");
    }
}

/// The section `[forecast]` makes more models apply, and does not affect a run.
#[test]
fn plate_constants_and_cone_index_make_more_models_apply() {
    let given = ["--set", "forecast.terrain=\"LETE sand\"", "--set", "forecast.cone_index=300 kPa"];
    let seen = json(&given);
    for name in ["Bekker", "Wong-Reece", "Wismer-Luth", "Brixius"] {
        assert_eq!(model(&seen, name)["applicable"], true, "{name}");
    }
    let typed = json(&[
        "--set",
        "forecast.sinkage_exponent=0.793",
        "--set",
        "forecast.cohesive_modulus=102 kN/m^(n+1)",
        "--set",
        "forecast.frictional_modulus=5301 kPa/m^n",
        "--set",
        "forecast.cone_index=0.3 MPa",
    ]);
    assert_eq!(model(&typed, "Bekker"), model(&seen, "Bekker"));
    let checked =
        coulter().args(["check", "--untimed"]).arg(shipped("light_disc.toml")).args(given).output().unwrap();
    assert!(checked.status.success());
    assert!(String::from_utf8_lossy(&checked.stdout).contains("`coulter forecast` only"));
    let with_bow_wave = json(&["--set", "forecast.bow_wave=0.3", "--set", "forecast.factors=\"lyamin\""]);
    let (before, after) = (model(&seen, "BC"), model(&with_bow_wave, "BC"));
    assert!(number(&before["sinkage_m"]) != number(&after["sinkage_m"]));
}

/// A body of the shape on sand or clay, pressed 20 mm down or by a load.
fn pressed(shape: &str, soil: &str, heave: &str) -> Value {
    let (_folder, path) = tool(&[
        ("shape = \"block\"\nsize = [\"0.06 m\", \"0.3 m\", \"0.25 m\"]\nsinkage = \"0.1 m\"", shape),
        ("forward = { speed = \"0.2 m/s\", ramp = \"0.1 s\" }\nheave = \"fixed\"", heave),
        ("law = \"mohr-coulomb\"\nfriction_angle = \"35 deg\"\ndilation_angle = \"35 deg\"", soil),
    ]);
    forecast_of(&path, &[])
}

const DOWN: &str = "heave = { speed = \"-0.02 m/s\", start = \"0 s\", ramp = \"0 s\" }";
const LOOSE: &str = "law = \"mohr-coulomb\"\nfriction_angle = \"32 deg\"\ndilation_angle = \"0 deg\"";
const DENSE: &str = "law = \"mohr-coulomb\"\nfriction_angle = \"38 deg\"\ndilation_angle = \"10 deg\"";
const CLAY: &str = "law = \"tresca\"\nshear_strength = \"10 kPa\"";

/// Plates, discs and other bodies that are pressed down, in loose and in dense sand.
#[test]
fn bodies_that_are_pressed_down_have_a_forecast() {
    let round = "shape = \"cylinder\"\naxis = \"z\"\ndiameter = \"0.2 m\"\nlength = \"0.05 m\"";
    let square = "shape = \"block\"\nsize = [\"0.2 m\", \"0.2 m\", \"0.05 m\"]";
    let disc = "shape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"0.05 m\"";
    let sphere = "shape = \"sphere\"\ndiameter = \"0.2 m\"";
    for (soil, recommended) in [(LOOSE, "3D-RFT"), (DENSE, "bearing capacity")] {
        for shape in [round, square, disc] {
            let seen = pressed(shape, soil, DOWN);
            assert_eq!(
                (&seen["recommended"], &seen["drive"]["kind"]),
                (&recommended.into(), &"pressed".into())
            );
            let best = model(&seen, recommended);
            let force = number(&best["vertical_N"]);
            let [low, high] = ["low", "high"].map(|end| number(&best["interval"]["vertical_N"][end]));
            assert!(number(&best["drag_N"]) == 0.0 && low < force && force < high, "{best}");
            assert!((number(&best["sinkage_m"]) - 0.02).abs() < 1e-9);
        }
        assert_eq!(pressed(sphere, soil, DOWN)["recommended"], "3D-RFT");
    }
    // The area of a circle is π/4 of that of the square.
    let [circle, whole] =
        [round, square].map(|shape| number(&model(&pressed(shape, LOOSE, DOWN), "3D-RFT")["vertical_N"]));
    assert!((circle / whole - 0.25 * std::f64::consts::PI).abs() < 1e-9);
    // A load instead: the sinkage.
    let loaded = pressed(square, LOOSE, "weight = \"200 N\"\nheave = \"free\"");
    let best = model(&loaded, "3D-RFT");
    assert!((number(&best["vertical_N"]) - 200.0).abs() < 1e-6 && number(&best["sinkage_m"]) > 1e-3);
    let carried = pressed(square, DENSE, "weight = \"20 N\"\nheave = \"free\"");
    assert_eq!(number(&model(&carried, "bearing capacity")["sinkage_m"]), 0.0);
    assert!(carried["recommendation"].as_str().unwrap().contains("does not sink"));
}

/// Undrained clay: exact at the surface of a strip; discs and plates with Skempton's factors; other bodies
/// are refused.
#[test]
fn undrained_clay_has_a_forecast() {
    let strip = forecast_of(&shipped("strip_footing.toml"), &["--set", "body.footing.heave.speed=-1e-6 m/s"]);
    let found = number(&model(&strip, "bearing capacity")["vertical_N"]);
    assert!((found / ((2.0 + std::f64::consts::PI) * 1e3) - 1.0).abs() < 1e-3, "{found}");
    let square = "shape = \"block\"\nsize = [\"0.2 m\", \"0.2 m\", \"0.05 m\"]";
    let pushed = pressed(square, CLAY, DOWN);
    // 5.14 × 1.2 (square) × 1.02 (depth), and the overburden.
    let expected = (10e3 * (2.0 + std::f64::consts::PI) * 1.2 * 1.02 + 16e3 * 0.02) * 0.04;
    assert!((number(&model(&pushed, "bearing capacity")["vertical_N"]) / expected - 1.0).abs() < 1e-9);
    assert_eq!(pushed["interval_inputs"][0]["key"], "soil.shear_strength");
    let metal = pressed(square, "law = \"von-mises\"\nyield_stress = \"17.320508075688772 kPa\"", DOWN);
    assert_eq!(metal["recommended"], "bearing capacity");
    let [one, other] = [&pushed, &metal].map(|seen| number(&model(seen, "bearing capacity")["vertical_N"]));
    assert!((one / other - 1.0).abs() < 1e-9);
    let disc =
        "shape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"0.05 m\"\nweight = \"150 N\"\nspin = \"free\"";
    let towed = pressed(disc, CLAY, "forward = { speed = \"0.2 m/s\" }\nheave = \"free\"");
    assert_eq!(towed["recommended"], "BC");
    let best = model(&towed, "BC");
    assert!((number(&best["vertical_N"]) - 150.0).abs() < 1e-6 && number(&best["drag_N"]) > 0.0, "{best}");
    let (_folder, path) =
        tool(&[("law = \"mohr-coulomb\"\nfriction_angle = \"35 deg\"\ndilation_angle = \"35 deg\"", CLAY)]);
    assert!(refusal(coulter().args(["forecast", &path])).contains("undrained clay"));
}

/// A disc thinner than the cells: no run, but a forecast.
#[test]
fn a_thin_disc_is_not_refused_for_the_sake_of_the_grid() {
    let thin = ["--set", "body.disc.thickness=2 mm", "--set", "body.disc.weight=5 N"];
    assert!(number(&model(&json(&thin), "BC")["drag_N"]) > 0.0);
    let why = refusal(coulter().arg("check").arg(shipped("light_disc.toml")).args(thin));
    assert!(why.contains("too few to resolve contact"), "{why}");
}

#[test]
fn equal_discs_in_a_row_are_an_assembly() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(shipped("light_disc.toml")).unwrap();
    let whole =
        text.replace("symmetric = true", "symmetric = false").replace("y = [\"0 m\"", "y = [\"-0.3 m\"");
    let whole = whole.replace("fine_y = [\"0 m\"", "fine_y = [\"-0.15 m\"");
    let disc = whole.split("[body.disc]").nth(1).unwrap().split("[run]").next().unwrap();
    let second = format!("[body.other]{disc}y = \"0.1 m\"\n\n[run]");
    let path = folder.path().join("pair.toml");
    std::fs::write(&path, whole.replace("[run]", &second)).unwrap();
    let output = coulter().arg("forecast").arg(&path).arg("--json").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let seen: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(seen["discs"].as_array().unwrap().len(), 2);
    assert!((number(&seen["load"]["weight_N"]) - 80.0).abs() < 1e-9);
    assert!(seen["remarks"][0].as_str().unwrap().contains("assembly"));
    std::fs::write(&path, whole.replace("[run]", &second.replace("0.05 m", "0.06 m"))).unwrap();
    assert!(refusal(coulter().arg("forecast").arg(&path)).contains("not equal"));
}

#[test]
fn pressure_gives_null_and_a_reason() {
    let face = ["--friction-angle", "33 deg", "--wall-friction", "10 deg", "--surface", "47 deg"];
    let output =
        coulter().arg("pressure").args(face).args(["--backfill", "5 deg", "--json"]).output().unwrap();
    let seen: Value = serde_json::from_slice(&output.stdout).unwrap();
    for key in ["rankine", "coulomb", "lancellotta"] {
        assert!(seen[key].is_null(), "{key}");
        assert!(seen["reasons"][key].as_str().unwrap().contains("does not exist"), "{key}");
    }
    let exact = number(&seen["sokolovskii"]["K_n"]);
    assert!(number(&seen["en1997"]) < exact && exact < number(&seen["log_spiral"]));
    assert!(number(&seen["sokolovskii"]["rupture_ratio"]) > 1.0);
    let wall = coulter().args(["pressure", "--friction-angle", "30 deg", "--json"]).output().unwrap();
    let wall: Value = serde_json::from_slice(&wall.stdout).unwrap();
    assert!((number(&wall["rankine"]) - 3.0).abs() < 1e-9);
    coulter().args(["pressure", "--friction-angle", "33 deg"]).assert().success();
    for (angles, word) in [
        (["--friction-angle", "33"], "deg"),
        (["--friction-angle", "95 deg"], "friction angle"),
        (["--friction-angle", "-5 deg"], "friction angle"),
    ] {
        let why = refusal(coulter().arg("pressure").args(angles));
        assert!(why.contains(word), "{why}");
    }
}

/// A case file with a blade 0.3 m wide and 0.1 m deep, or with another towed body.
fn tool(changes: &[(&str, &str)]) -> (tempfile::TempDir, String) {
    let mut text = String::from(
        r#"
format = 2
title = "A tool"
[soil]
law = "mohr-coulomb"
friction_angle = "35 deg"
dilation_angle = "35 deg"
unit_weight = "16 kN/m^3"
young_modulus = "5 MPa"
[domain]
x = ["-0.5 m", "1 m"]
y = ["-0.6 m", "0.6 m"]
z = ["-0.4 m", "0.3 m"]
[grid]
cell = "20 mm"
[body.tool]
shape = "block"
size = ["0.06 m", "0.3 m", "0.25 m"]
sinkage = "0.1 m"
friction = 0.4
forward = { speed = "0.2 m/s", ramp = "0.1 s" }
heave = "fixed"
[run]
duration = "1 s"
"#,
    );
    for (old, new) in changes {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tool.toml");
    std::fs::write(&path, text).unwrap();
    let path = path.display().to_string();
    (folder, path)
}

fn forecast_of(path: &str, arguments: &[&str]) -> Value {
    let output = coulter().args(["forecast", path, "--json"]).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The wall of `cases`: Rankine's thrust on its slab, at the full friction angle and at Davis'.
#[test]
fn the_passive_wall_is_rankines() {
    let seen = forecast_of(&shipped("passive_wall.toml"), &[]);
    assert_eq!((&seen["kind"], &seen["recommended"]), (&"block".into(), &"PW plane strain".into()));
    let full = seen["models_full_friction"].as_array().unwrap();
    let full = full.iter().find(|m| m["name"] == "PW plane strain").unwrap();
    assert!((number(&full["drag_N"]) / (0.5 * 16e3 * 3.0) - 1.0).abs() < 1e-4);
    let davis = number(&seen["operative_friction_angle_rad"]);
    let passive = (0.25 * std::f64::consts::PI + 0.5 * davis).tan().powi(2);
    let drag = number(&model(&seen, "PW plane strain")["drag_N"]);
    assert!((drag / (0.5 * 16e3 * passive) - 1.0).abs() < 1e-4);
    assert!(seen["remarks"].to_string().contains("floor"));
}

#[test]
fn a_blade_has_a_forecast_with_its_lengths() {
    let (folder, path) = tool(&[]);
    let seen = forecast_of(&path, &[]);
    assert_eq!(seen["recommended"], "PW");
    assert!((number(&seen["groups"]["t_bar"]) - 1.2).abs() < 1e-12);
    let scale = 16e3 * 0.3 * 0.25 * 0.25;
    assert!((number(&seen["groups"]["force_scale_N"]) - scale).abs() < 1e-9);
    for applied in seen["models"].as_array().unwrap().iter().filter(|m| m["applicable"] == true) {
        let drag = number(&applied["drag_N"]);
        assert!((number(&applied["F_H_bar"]) - drag / scale).abs() < 1e-12);
        assert!((number(&applied["Z"]) - 0.4).abs() < 1e-12);
        let [low, high] = ["low", "high"].map(|end| number(&applied["interval"]["drag_N"][end]));
        assert!(low < drag && drag < high, "{applied}");
    }
    for name in ["Wismer-Luth", "BC", "McKyes-Ali", "3D-RFT", "PW plane strain"] {
        let absent = model(&seen, name);
        assert!(absent["applicable"] == false && !absent["note"].as_str().unwrap().is_empty(), "{absent}");
    }
    for against in [
        "Z=0.05..0.9",
        "soil.friction_angle=\"25 deg\"..\"44 deg\"",
        "pitch=-60 deg..30 deg",
        "backfill=0 deg..15 deg",
    ] {
        let mut command = coulter();
        command.current_dir(&folder).args([
            "forecast",
            &path,
            "--points",
            "7",
            "--force",
            "--against",
            against,
        ]);
        command.assert().success();
    }
    let written = folder.path().join("results/tool-forecast");
    let curve = std::fs::read_to_string(written.join("curve.csv")).unwrap();
    assert!(curve.contains("PW drag F_H [N]") && curve.lines().count() == 8);
    assert!(std::fs::read_to_string(written.join("drag_dimensionless.svg")).unwrap().contains("PW"));
    let text = coulter().args(["forecast", &path]).assert().success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    for word in ["not rotating", "Recommended: PW", "Brinch Hansen", "under its base"] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    for (arguments, word) in [
        (["--against", "diameter=0.1 m..0.2 m"], "no model of a block"),
        (["--against", "Z=1.1..2"], "at most 0.25 m"),
        (["--set", "body.tool.heave={ speed = \"-0.28 m/s\" }"], "at most 0.25 m"),
        (["--set", "body.tool.forward=\"fixed\""], "neither towed nor pressed down"),
        (["--set", "soil.friction_angle=\"52 deg\""], "10°"),
    ] {
        let why = refusal(coulter().args(["forecast", &path]).args(arguments));
        assert!(why.contains(word), "{word} is missing in {why}");
    }
}

#[test]
fn blocks_sink_and_lean_and_are_uncertain() {
    let free = ("heave = \"fixed\"", "heave = \"free\"\nweight = \"600 N\"");
    let (_folder, path) = tool(&[free, ("sinkage = \"0.1 m\"", "")]);
    let spread = ["--uncertainty", "--spread", "weight=20 N", "--spread", "friction_angle=2 deg"];
    let seen = forecast_of(&path, &spread);
    let best = model(&seen, seen["recommended"].as_str().unwrap());
    assert!((number(&best["vertical_N"]) - 600.0).abs() < 1e-6 && number(&best["sinkage_m"]) > 1e-3);
    // The drag includes friction on the base, which carries the load.
    assert!(number(&best["drag_N"]) > 0.4 * 600.0 * 0.9);
    let all = seen["uncertainty"]["quantities"].as_array().unwrap();
    assert_eq!(all.iter().filter(|q| q["model"] == "PW").count(), 2);
    // Leaning back it is McKyes and Ali's, unless it is thick; leaning forward the exact one.
    let (_folder, path) = tool(&[("size = [\"0.06 m\"", "pitch = \"-30 deg\"\nsize = [\"0.06 m\"")]);
    assert_eq!(forecast_of(&path, &[])["recommended"], "3D-RFT");
    assert_eq!(forecast_of(&path, &["--set", "body.tool.pitch=-10 deg"])["recommended"], "McKyes-Ali");
    assert_eq!(forecast_of(&path, &["--set", "body.tool.pitch=20 deg"])["recommended"], "PW");
    // Towed the other way it is its own mirror image.
    let mirrored = ["--set", "body.tool.forward.speed=-0.2 m/s", "--set", "body.tool.pitch=-20 deg"];
    let ahead = forecast_of(&path, &["--set", "body.tool.pitch=20 deg"]);
    assert_eq!(forecast_of(&path, &mirrored)["models"], ahead["models"]);
}

#[test]
fn round_bodies_have_resistive_force_theory() {
    let block = "shape = \"block\"\nsize = [\"0.06 m\", \"0.3 m\", \"0.25 m\"]";
    let sphere = "shape = \"sphere\"\ndiameter = \"0.2 m\"\nspin = \"free\"\nweight = \"60 N\"";
    let (_folder, path) =
        tool(&[(block, sphere), ("heave = \"fixed\"", "heave = \"free\""), ("sinkage = \"0.1 m\"", "")]);
    let seen = forecast_of(&path, &[]);
    assert_eq!((&seen["kind"], &seen["recommended"]), (&"sphere".into(), &"3D-RFT".into()));
    let best = model(&seen, "3D-RFT");
    assert!((number(&best["vertical_N"]) / 60.0 - 1.0).abs() < 1e-3 && number(&best["slip"]) < 0.0);
    assert!(number(&model(&seen, "2-D RFT")["drag_N"]) > 0.0);
    assert!(model(&seen, "PW")["note"].as_str().unwrap().contains("plane front"));
    for axis in ["x", "z"] {
        let shape =
            format!("shape = \"cylinder\"\naxis = \"{axis}\"\ndiameter = \"0.1 m\"\nlength = \"0.2 m\"");
        let (_folder, path) = tool(&[(block, &shape), ("sinkage = \"0.1 m\"", "sinkage = \"0.05 m\"")]);
        let seen = forecast_of(&path, &[]);
        let best = model(&seen, "3D-RFT");
        assert!(best["applicable"] == true && number(&best["drag_N"]) > 0.0 && best["slip"].is_null());
    }
    // Across the tow it is a disc as thick as it is long.
    let roller = "shape = \"cylinder\"\naxis = \"y\"\ndiameter = \"0.2 m\"\nlength = \"0.3 m\"";
    let disc = "shape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"0.3 m\"";
    let sinkage = ("sinkage = \"0.1 m\"", "sinkage = \"0.04 m\"");
    let [roller, disc] = [roller, disc].map(|shape| {
        let (_folder, path) = tool(&[(block, shape), sinkage]);
        forecast_of(&path, &[])
    });
    assert_eq!(roller["models"], disc["models"]);
    assert_eq!(roller["recommended"], "weaker of BC and PW");
}
