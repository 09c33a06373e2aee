//! `coulter compare` and `coulter calibrate` through the binary: what they write, and that what is wrong is
//! refused with its place.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

const PLATE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../studies/tests/calibration/plate.toml");
const CURVE: &str = "sinkage [mm],vertical [N]\n5,1300\n10,1400\n20,1600\n30,1800\n40,2000\n50,2200\n";
const PHI: &str = "soil.friction_angle=28..42 deg";

fn coulter(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("coulter").unwrap().current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("plate.csv"), CURVE).unwrap();
    folder
}

#[test]
fn a_measured_plate_is_compared_with_its_closed_form() {
    let folder = folder();
    let (code, out, _) = coulter(folder.path(), &["compare", PLATE, "plate.csv", "-o", "c", "--json"]);
    assert_eq!(code, 0, "{out}");
    let document: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["reference"], 1);
    assert_eq!(document["compared"][0]["differences"]["points"], 6);
    for name in ["comparison.html", "comparison.csv", "comparison.json"] {
        assert!(folder.path().join("c").join(name).is_file(), "{name}");
    }
    assert_eq!(coulter(folder.path(), &["compare", PLATE, "plate.csv", "-o", "c"]).0, 2, "overwritten");
    assert_eq!(
        coulter(folder.path(), &["compare", PLATE, "plate.csv", "-o", "c", "--force", "--align"]).0,
        0
    );
}

#[test]
fn a_calibrated_case_holds_the_values_that_were_found() {
    let folder = folder();
    let request =
        ["calibrate", PLATE, "plate.csv", "--parameter", PHI, "--noise", "5%", "-o", "k", "--samples", "300"];
    let (code, out, error) = coulter(folder.path(), &request);
    assert_eq!(code, 0, "{error}");
    assert!(out.contains("soil.friction_angle [deg]"), "{out}");
    let file = |name: &str| std::fs::read_to_string(folder.path().join("k").join(name)).unwrap();
    let document: Value = serde_json::from_str(&file("calibration.json")).unwrap();
    let best = document["closed_form"]["parameters"][0]["best"].as_f64().unwrap();
    assert!(file("calibrated.toml").contains(&format!("friction_angle = \"{best} deg\"")));
    assert!(file("calibration.html").contains("</svg>") && file("samples.csv").lines().count() > 300);
    // The same request again is welcome, another one is not.
    assert_eq!(coulter(folder.path(), &request).0, 0);
    let other = [&request[..5], &["--noise", "9%", "-o", "k", "--samples", "300"]].concat();
    let (code, _, error) = coulter(folder.path(), &other);
    assert!(code == 2 && error.contains("another request"), "{error}");
    assert_eq!(coulter(folder.path(), &[&other[..], &["--force"]].concat()).0, 0);
}

#[test]
fn what_is_wrong_is_refused_with_place_and_cure() {
    let folder = folder();
    std::fs::write(folder.path().join("bad.csv"), "sinkage [mm],vertical [N]\n5,22\n10,x\n").unwrap();
    let refused = |arguments: &[&str], words: &[&str]| {
        let (code, _, error) = coulter(folder.path(), arguments);
        assert_eq!(code, 2, "{arguments:?}: {error}");
        for word in words {
            assert!(error.contains(word), "{arguments:?}: {word}: {error}");
        }
    };
    refused(&["compare", PLATE, "bad.csv"], &["bad.csv:3:4", "\"x\" is not a number", "help"]);
    refused(&["compare", PLATE, "none.csv"], &["none.csv", "check the path"]);
    refused(&["compare", PLATE], &["ITEM"]);
    refused(&["compare", PLATE, "plate.csv", "--against", "drag"], &["curves run along"]);
    refused(&["compare", PLATE, "plate.csv", "--against", "t"], &["does not run along time"]);
    refused(&["compare", PLATE, "plate.csv", "--quantity", "vertcal"], &["did you mean `vertical`"]);
    refused(&["compare", PLATE, "plate.csv", "--window", "1 m"], &["no `..`"]);
    let calibrate = |more: &[&'static str]| [&["calibrate", PLATE, "plate.csv"], more].concat();
    refused(&calibrate(&[]), &["0 parameters"]);
    refused(&calibrate(&["--parameter", "soil.friction_angle=45..28 deg"]), &["not below", "help"]);
    refused(&calibrate(&["--parameter", "soil.frction_angle=28..45 deg"]), &["friction_angle", "help"]);
    refused(&calibrate(&["--parameter", PHI, "--noise", "x"]), &["--noise x"]);
    refused(&calibrate(&["--parameter", PHI, "--model", "solver", "--budget", "3"]), &["--budget 3"]);
    refused(
        &calibrate(&["--parameter", PHI, "--link", "soil.cohesion=phi [Pa]"]),
        &["`phi` is no parameter"],
    );
}
