//! Commands that run no simulation, through the binary.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use serde_json::Value;

fn coulter() -> Command {
    Command::cargo_bin("coulter").unwrap()
}

fn shipped(name: &str) -> String {
    format!("{}/../../cases/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn checked(arguments: &[&str]) -> Value {
    let output = coulter().args(["check", "--json", "--untimed"]).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn close(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= 1e-9 * expected.abs(), "{value} ≠ {expected}");
}

#[test]
fn new_writes_a_case_that_checks() {
    let folder = tempfile::tempdir().unwrap();
    for (template, file) in [
        ("towed-disc", "towed_disc.toml"),
        ("footing", "strip_footing.toml"),
        ("passive-wall", "passive_wall.toml"),
        ("column", "column_collapse.toml"),
    ] {
        coulter().current_dir(&folder).args(["new", template]).assert().success();
        coulter().current_dir(&folder).args(["check", "--untimed", file]).assert().success();
        let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
        assert!(!text.contains("#:schema "), "there is no schema beside {file}");
    }
}

#[test]
fn new_does_not_overwrite_unasked() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, "mine").unwrap();
    let refusal = coulter().arg("new").arg("-o").arg(&path).assert().code(2);
    assert!(String::from_utf8_lossy(&refusal.get_output().stderr).contains("--force"));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
    coulter().args(["new", "--force", "-o"]).arg(&path).assert().success();
    assert_ne!(std::fs::read_to_string(&path).unwrap(), "mine");
}

#[test]
fn the_towed_disc_is_understood() {
    let seen = checked(&[&shipped("light_disc.toml")]);
    let case = &seen["resolved"];
    close(&case["soil"]["density"], 16e3 / 9.81);
    close(&case["soil"]["k0"], 1.0 - 35f64.to_radians().sin());
    let disc = &case["bodies"][0];
    assert_eq!(disc["name"], "disc");
    close(&disc["mass"], 40.0 / 9.81);
    close(&disc["axle_inertia"], 0.5 * 40.0 / 9.81 * 0.1 * 0.1);
    close(&disc["position"][2], 0.1);
    close(&disc["translation"][2]["free"]["load"], 0.0);
    close(&disc["translation"][2]["free"]["support"], 40.0);
    close(&disc["rotation"][2]["free"]["ramp"], 0.1);
    // 0.4 s to settle, a ramp over half the distance of the full speed, then 0.2 m/s.
    close(&case["duration"], 0.4 + 0.05 + 1.6);
    close(&seen["groups"]["disc"]["W_bar"], 40.0 / (16e3 * 0.05 * 0.2 * 0.2));
    close(&seen["groups"]["disc"]["E_bar"], 5e6 / (16e3 * 0.2));
    let cells = seen["cost"]["cells"].as_f64().unwrap();
    assert!((30e3..50e3).contains(&cells), "{cells} cells");
    for (axis, must_hold) in [(1, 0.0), (2, 0.0)] {
        let faces = case["grid"]["faces"][axis].as_array().unwrap();
        assert!(faces.iter().any(|f| f.as_f64() == Some(must_hold)), "axis {axis}");
    }
}

#[test]
fn undrained_soil_gets_its_own_viscosity() {
    let viscosity =
        |file| checked(&[&shipped(file)])["resolved"]["numerics"]["bulk_viscosity_linear"].clone();
    close(&viscosity("strip_footing.toml"), 0.06);
    close(&viscosity("light_disc.toml"), 0.02);
}

#[test]
fn overrides_take_effect() {
    let sets = [
        "--set",
        "soil.friction_angle=38 deg",
        "--set",
        "body.disc.friction=\"rough\"",
        "--set",
        "grid.growth=1.2",
    ];
    let file = shipped("light_disc.toml");
    let seen = checked(&[&[file.as_str()], &sets[..]].concat());
    close(&seen["resolved"]["soil"]["law"]["mohr-coulomb"]["friction_angle"], 38f64.to_radians());
    close(&seen["resolved"]["grid"]["growth"], 1.2);
    assert!(seen["resolved"]["bodies"][0]["friction"].is_null(), "infinite friction has no JSON number");
}

#[test]
fn box_and_fine_zone_follow_from_the_bodies() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("short.toml");
    let case = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '30 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
        [grid]\ncell = '20 mm'\n[body.a]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '80 mm'\nfriction = 0.3\n\
        forward = { speed = '0.1 m/s' }\n[run]\nduration = '1 s'\n";
    std::fs::write(&path, case).unwrap();
    let seen = checked(&[path.to_str().unwrap()]);
    close(&seen["resolved"]["domain"]["low"][0], -0.4);
    close(&seen["resolved"]["domain"]["high"][0], 0.095 + 0.4);
    close(&seen["resolved"]["domain"]["low"][2], -0.25);
    close(&seen["resolved"]["grid"]["fine_high"][2], 0.06);
}

#[test]
fn warnings_are_given() {
    let file = shipped("light_disc.toml");
    let sets = [
        "--set",
        "body.disc.thickness=30 mm",
        "--set",
        "domain.y=['0 m', '0.2 m']",
        "--set",
        "soil.cohesion=1 Pa",
        "--set",
        "soil.dilation_angle=5 deg",
        "--set",
        "numerics.bulk_viscosity_linear=0.06",
    ];
    let seen = checked(&[&[file.as_str()], &sets[..]].concat());
    let all = seen["warnings"].to_string();
    for word in ["2.4 cells across", "is tiny", "Dilation", "bulk viscosity", "walls are near"] {
        assert!(all.contains(word), "`{word}` is not in: {all}");
    }
}

#[test]
fn sand_too_loose_for_the_stress_at_rest_is_warned_of() {
    let seen = checked(&[&shipped("column_collapse.toml"), "--set", "soil.relative_density=-0.5"]);
    assert!(seen["warnings"].to_string().contains("can sustain"), "{}", seen["warnings"]);
}

#[test]
fn the_shipped_cases_raise_no_warnings() {
    for file in [
        "towed_disc.toml",
        "towed_disc_mohr_coulomb.toml",
        "light_disc.toml",
        "passive_wall.toml",
        "strip_footing.toml",
        "column_collapse.toml",
        "cmu_plate.toml",
    ] {
        let seen = checked(&[&shipped(file)]);
        assert_eq!(seen["warnings"], serde_json::json!([]), "{file}");
    }
}

#[test]
fn a_fast_tow_is_warned_of_by_what_inertia_adds() {
    let reply = |sets: &[&str]| {
        checked(&[&[shipped("light_disc.toml").as_str()], sets].concat())["warnings"].to_string()
    };
    // Held 60 mm deep at 0.5 m/s: 2 ρ v² is 816 Pa, the mean of γ z K_p 1771 Pa: 46 %.
    let held = ["--set", "body.disc.heave=fixed", "--set", "body.disc.sinkage=60 mm", "--set"];
    let fast = reply(&[&held[..], &["body.disc.forward={ speed = '0.5 m/s' }"]].concat());
    assert!(fast.contains("v²/(g z) = 0.42 at z = 0.060 m") && fast.contains("some 46 %"), "{fast}");
    assert!(!reply(&[&held[..], &["body.disc.forward={ speed = '0.1 m/s' }"]].concat()).contains("Froude"));
    // Free to sink under 40 N it carries them at any speed: 10 % of them is 4 N = 2 ρ v² z t, at 1.1 m/s and
    // z = 20 mm.
    assert!(!reply(&["--set", "body.disc.forward={ speed = '1 m/s' }"]).contains("Froude"));
    assert!(reply(&["--set", "body.disc.forward={ speed = '1.2 m/s' }"]).contains("Froude"));
}

#[test]
fn run_does_not_overwrite_unasked() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("run.json"), "{\"format\": 3}").unwrap();
    let refusal =
        coulter().args(["run", &shipped("light_disc.toml"), "-o"]).arg(folder.path()).assert().code(2);
    assert!(String::from_utf8_lossy(&refusal.get_output().stderr).contains("--force"));
}

#[test]
fn results_of_another_format_are_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    for (record, words) in [
        ("{\"format\": 4}", ["newer than this version", "install a newer version"]),
        ("{\"format\": 2}", ["no longer read", "run its case.toml again"]),
        ("{}", ["does not say in which format", "run its case.toml again"]),
    ] {
        std::fs::write(folder.path().join("run.json"), record).unwrap();
        let path = folder.path().to_str().unwrap();
        let case = shipped("light_disc.toml");
        for arguments in
            [&["report", path][..], &["run", &case, "-o", path], &["run", &case, "--force", "-o", path]]
        {
            let refusal = coulter().args(arguments).assert().code(2);
            let said = String::from_utf8_lossy(&refusal.get_output().stderr).into_owned();
            assert!(words.iter().all(|word| said.contains(word)), "{arguments:?}: {said}");
        }
        assert_eq!(std::fs::read_to_string(folder.path().join("run.json")).unwrap(), record);
    }
}

#[test]
fn usage_errors_exit_with_2() {
    coulter().assert().code(2);
    coulter().arg("chek").assert().code(2);
    coulter().args(["new", "submarine"]).assert().code(2);
    coulter().args(["check"]).assert().code(2);
    coulter().args(["report", "no-such-folder"]).assert().code(2);
}

#[test]
fn the_schema_is_json() {
    let output = coulter().arg("schema").output().unwrap();
    let schema: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(schema["properties"]["soil"]["properties"]["friction_angle"]["description"].is_string());
}

#[test]
fn faces_lie_on_the_sides_of_the_soil() {
    for (file, axis, place) in
        [("passive_wall.toml", 0, 0.0), ("passive_wall.toml", 2, 0.0), ("column_collapse.toml", 0, 0.1)]
    {
        let seen = checked(&[&shipped(file)]);
        let faces = seen["resolved"]["grid"]["faces"][axis].as_array().unwrap();
        let nearest = faces.iter().map(|f| (f.as_f64().unwrap() - place).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-12, "{file}: {nearest} m off");
    }
}

#[test]
fn a_breakdown_exits_with_1_and_leaves_what_there_is() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let failure = coulter()
        .args(["run", &shipped("light_disc.toml"), "--set", "soil.young_modulus=4 kPa"])
        .args(["--set", "grid.cell=25 mm", "-o"])
        .arg(&out)
        .assert()
        .code(1);
    let reply = String::from_utf8_lossy(&failure.get_output().stderr).into_owned();
    for word in ["between two remaps", "t = ", "step", "near (", "failed.checkpoint"] {
        assert!(reply.contains(word), "`{word}` is not in: {reply}");
    }
    // The last good checkpoint, here that of the start, is not overwritten by the state that failed.
    for file in [
        "report.html",
        "forces.csv",
        "summary.json",
        "checkpoints/last.checkpoint",
        "checkpoints/failed.checkpoint",
    ] {
        assert!(out.join(file).is_file(), "{file} is missing");
    }
    let summary = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(summary["trust"]["verdict"], "broken");
}

#[test]
fn completions_and_manual_pages_name_every_command() {
    let help = String::from_utf8(coulter().arg("--help").output().unwrap().stdout).unwrap();
    let commands: Vec<&str> = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .collect();
    assert!(commands.contains(&"render") && commands.len() > 14, "{commands:?}");
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = coulter().args(["completions", shell]).output().unwrap().stdout;
        let script = String::from_utf8(script).unwrap();
        assert!(commands.iter().all(|name| script.contains(name)), "{shell}");
    }
    let folder = tempfile::tempdir().unwrap();
    coulter().arg("man").arg(folder.path()).assert().success();
    for name in commands {
        let page = std::fs::read_to_string(folder.path().join(format!("coulter-{name}.1"))).unwrap();
        assert!(page.contains(".SH SYNOPSIS"), "{name}");
    }
    coulter().arg("man").arg(folder.path().join("missing")).assert().code(2);
}

#[test]
fn what_render_cannot_draw_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |arguments: &[&str], said: &str| {
        let output = coulter().current_dir(&folder).arg("render").args(arguments).output().unwrap();
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && text.contains(said), "{arguments:?}: {text}");
    };
    refused(&["missing"], "is not a folder");
    refused(&["."], "holds no result");
    refused(&[".", "-o", "tow.mp4"], "must end in .png");
    refused(&[".", "--size", "12x12"], "from 64 to");
    refused(&[".", "--elevation", "100"], "-20 to 90 degrees");
    refused(&[".", "--at", "3"], "with its unit");
    refused(&[".", "--zoom", "0"], "from 0.1 to 50");
    std::fs::write(folder.path().join("mine.png"), "mine").unwrap();
    refused(&[".", "-o", "mine.png"], "--force replaces it");
}

#[test]
fn the_case_of_the_readme_checks() {
    let readme = std::fs::read_to_string(format!("{}/../../README.md", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let case = readme.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("disc.toml"), case).unwrap();
    coulter().current_dir(&folder).args(["check", "disc.toml"]).assert().success();
}
