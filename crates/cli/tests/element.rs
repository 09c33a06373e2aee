//! `coulter element` through the binary.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use serde_json::Value;
use std::fs;

fn cases() -> String {
    format!("{}/../../cases", env!("CARGO_MANIFEST_DIR"))
}

fn element(test: &str, case: &str, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("coulter").unwrap();
    command.args(["element", test]).arg(format!("{}/{case}", cases())).args(arguments);
    command
}

fn stdout(command: &mut Command) -> String {
    String::from_utf8_lossy(&command.assert().success().get_output().stdout).into_owned()
}

fn refusal(command: &mut Command) -> String {
    String::from_utf8_lossy(&command.assert().code(2).get_output().stderr).into_owned()
}

#[test]
fn the_table_has_a_line_for_each_specimen() {
    let text = stdout(&mut element("triaxial", "light_disc.toml", &[]));
    for word in ["φ = 35°", "φ peak", "ψ peak", "100 kPa", "add -o DIR"] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    let densities = ["--relative-density", "0.2", "--relative-density", "0.8", "--pressure", "2 kPa"];
    let text = stdout(&mut element("shear", "sands/toyoura.toml", &densities));
    assert_eq!(text.lines().filter(|line| line.contains("2.00 kPa")).count(), 2, "{text}");
}

#[test]
fn the_document_keeps_its_names() {
    let json = |test: &str| -> Value {
        let text = stdout(&mut element(test, "sands/toyoura.toml", &["--json"]));
        serde_json::from_str(&text).unwrap()
    };
    let seen = json("triaxial");
    assert_eq!((seen["case"].as_str(), seen["test"].as_str()), (Some("toyoura"), Some("triaxial")));
    let specimen = &seen["specimens"][1];
    assert_eq!(specimen["pressure_Pa"], 1e4);
    assert_eq!(specimen["ending"], "complete");
    for key in [
        "density_kg_m3",
        "relative_density",
        "initial_modulus_Pa",
        "secant_modulus_50_Pa",
        "deviatoric_stress_peak_Pa",
        "friction_angle_peak_rad",
        "strain_peak",
        "dilatancy_peak",
        "dilation_angle_peak_rad",
        "friction_angle_end_rad",
        "dilatancy_end",
        "volumetric_strain_end",
        "density_end_kg_m3",
        "relative_density_end",
    ] {
        assert!(specimen[key].is_f64(), "{key}: {specimen}");
    }
    let oedometer = &json("oedometer")["specimens"][0];
    assert_eq!(oedometer["secant_moduli"][1]["from_Pa"], 1e4);
    assert!(oedometer["secant_moduli"][1]["modulus_Pa"].as_f64().unwrap() > 5e6);
    assert!(oedometer["k0_largest"].is_f64() && oedometer["unloading_modulus_Pa"].is_f64());
    assert!(json("isotropic")["specimens"][0]["strain_left"].is_f64());
    assert!(json("shear")["specimens"][0]["stress_ratio_end"].is_f64());
}

#[test]
fn curves_and_plots_are_written_and_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let write = |test: &str, more: &[&str]| {
        let mut command = element(test, "sands/toyoura.toml", more);
        command.arg("-o").arg(&out);
        command
    };
    stdout(&mut write("triaxial", &[]));
    let header = |text: &str| text.lines().next().unwrap().to_owned();
    let text = fs::read_to_string(out.join("curves.csv")).unwrap();
    assert_eq!(
        header(&text),
        "specimen [-],pressure at the start [Pa],density at the start [kg/m^3],axial strain [-],volumetric strain [-],\
         vertical stress [Pa],lateral stress [Pa],mean pressure p [Pa],Mises stress q [Pa],density [kg/m^3],unloading [-],\
         mobilised friction angle [rad]"
    );
    assert!(text.lines().count() > 1000 && text.lines().count() < 3000);
    for plot in ["strength.svg", "volume.svg"] {
        let svg = fs::read_to_string(out.join(plot)).unwrap();
        assert!(svg.contains("I_D = 0.500") || svg.contains("0.500"), "{svg}");
    }
    let summary: Value = serde_json::from_slice(&fs::read(out.join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["specimens"].as_array().unwrap().len(), 3);
    assert!(refusal(&mut write("oedometer", &[])).contains("--force"));
    stdout(&mut write("oedometer", &["--force"]));
    let text = fs::read_to_string(out.join("curves.csv")).unwrap();
    assert!(header(&text).ends_with("lateral over vertical stress [-]"));
    assert!(out.join("compression.svg").exists());
}

#[test]
fn every_sand_that_is_shipped_can_be_tested() {
    let mut count = 0;
    for entry in fs::read_dir(format!("{}/sands", cases())).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let text = stdout(&mut element("triaxial", &format!("sands/{name}"), &["--pressure", "10 kPa"]));
        assert!(text.contains("sand, φ_cv"), "{text}");
        count += 1;
    }
    assert!(count >= 5);
}

#[test]
fn wrong_requests_are_refused_with_their_cure() {
    for (test, case, arguments, words) in [
        ("triaxial", "light_disc.toml", &["--pressure", "4"][..], "no unit"),
        ("triaxial", "light_disc.toml", &["--pressure", "-4 kPa"], "out of range"),
        ("triaxial", "light_disc.toml", &["--relative-density", "0.5"], "--density"),
        ("triaxial", "light_disc.toml", &["--largest-pressure", "1 MPa"], "oedometer and isotropic"),
        ("oedometer", "light_disc.toml", &["--strain", "0.1"], "triaxial and shear"),
        ("shear", "sands/toyoura.toml", &["--relative-density", "1.5"], "from -0.5 to 1.2"),
        ("shear", "sands/toyoura.toml", &["--force"], "--output"),
        ("shear", "light_disc.toml", &["--set", "soil.k0=0.1"], "k0 = 1"),
        ("shear", "light_disc.toml", &["--set", "soil.friction_angle=95 deg"], "friction_angle"),
        ("shear", "absent.toml", &[], "cannot be read"),
        ("torsion", "light_disc.toml", &[], "possible values"),
    ] {
        let reply = refusal(&mut element(test, case, arguments));
        assert!(reply.contains(words), "{words} is missing in\n{reply}");
    }
    let reply = refusal(&mut element("triaxial", "sands/toyoura.toml", &["--set", "gravity=-1 m/s^2"]));
    assert!(reply.contains("gravity"), "{reply}");
}
