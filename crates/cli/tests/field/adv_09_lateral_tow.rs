//! A tow in any direction is a tow.

use crate::support::Desk;
use serde_json::Value;

/// A block in sand, coarse: its box, its edges along x and y, and its tow.
fn case(x: &str, y: &str, size: &str, tow: &str) -> String {
    format!(
        r#"format = 2
[soil]
law = "mohr-coulomb"
friction_angle = "33 deg"
unit_weight = "16 kN/m^3"
young_modulus = "1 MPa"
[grid]
cell = "25 mm"
growth = 1.45
fit = false
[domain]
x = {x}
y = {y}
z = ["-0.3 m", "0.16 m"]
[body.a]
shape = "block"
size = {size}
friction = "rough"
sinkage = "0.1 m"
{tow}
[run]
duration = "0.06 s"
[output]
field_interval = "1 h"
"#
    )
}

const LONG: &str = r#"["-0.4 m", "0.5 m"]"#;
const WIDE: &str = r#"["-0.35 m", "0.35 m"]"#;
const ALONG_X: &str = r#"["0.1 m", "0.125 m", "0.2 m"]"#;
const SPEED: &str = r#"{ speed = "1.2 m/s", ramp = "0.02 s" }"#;

/// The summary of a run.
fn summary(text: &str) -> Value {
    let desk = Desk::with(&[("tow.toml", text)]);
    desk.expect(0, &["run", "tow.toml", "-o", "results", "--threads", "1"]);
    serde_json::from_str(&desk.read("results/summary.json")).unwrap()
}

fn steady(summary: &Value, key: &str) -> f64 {
    summary["bodies"]["a"]["steady"][key].as_f64().unwrap()
}

#[test]
fn a_tow_along_y_or_backwards_is_graded_as_one_along_x() {
    let ahead = summary(&case(LONG, WIDE, ALONG_X, &format!("forward = {SPEED}")));
    let names = |summary: &Value| {
        let checks = summary["trust"]["checks"].as_array().unwrap();
        // A tow backwards is unusual, and said to be so.
        let names = checks.iter().map(|check| check["name"].as_str().unwrap().to_owned());
        names.filter(|name| name != "unusual values").collect::<Vec<_>>()
    };
    assert!(names(&ahead).contains(&"steady drag".to_owned()), "{:?}", names(&ahead));
    let along_y = r#"["0.125 m", "0.1 m", "0.2 m"]"#;
    let lateral = case(WIDE, LONG, along_y, &format!("lateral = {SPEED}"));
    let backwards =
        case(r#"["-0.5 m", "0.4 m"]"#, WIDE, ALONG_X, &format!("forward = {}", SPEED.replace("1.2", "-1.2")));
    for (text, mirror) in [(lateral, "along y"), (backwards, "backwards")] {
        let turned = summary(&text);
        assert_eq!(names(&ahead), names(&turned), "{mirror}");
        assert_eq!(ahead["trust"]["verdict"], turned["trust"]["verdict"], "{mirror}");
        // The soil scatters, here on four cells and within 20 mm: speeds that differ by 0.03 % find 227 to
        // 242 N along x.
        for (key, scatter) in [("drag_N", 0.08), ("vertical_N", 0.1)] {
            let [one, other] = [steady(&ahead, key), steady(&turned, key)];
            assert!(one > 0.0 && (other / one - 1.0).abs() < scatter, "{mirror}, {key}: {one} and {other}");
        }
        assert!((steady(&turned, "to_m") / steady(&ahead, "to_m") - 1.0).abs() < 1e-9);
        assert!(steady(&turned, "lateral_N").abs() < 0.02 * steady(&ahead, "drag_N"), "{mirror}");
        for key in ["cells over sinkage", "cells over width"] {
            let value = |summary: &Value| {
                let all = summary["trust"]["checks"].as_array().unwrap().clone();
                all.iter().find(|check| check["name"] == key).unwrap()["value"].as_f64().unwrap()
            };
            assert!((value(&ahead) - value(&turned)).abs() < 1e-9, "{mirror}, {key}");
        }
    }
}

#[test]
fn check_and_forecast_see_the_same_body_whichever_way_it_goes() {
    let tow = "forward = { speed = \"0.2 m/s\" }";
    let desk = Desk::with(&[
        ("x.toml", &case(LONG, WIDE, ALONG_X, tow)),
        ("y.toml", &case(WIDE, LONG, r#"["0.125 m", "0.1 m", "0.2 m"]"#, &tow.replace("forward", "lateral"))),
    ]);
    let forecast = |name: &str| -> Value {
        serde_json::from_str(&desk.expect(0, &["forecast", name, "--json"]).out).unwrap()
    };
    let [x, y] = [forecast("x.toml"), forecast("y.toml")];
    assert_eq!(x["recommended"], y["recommended"]);
    for (a, b) in x["models"].as_array().unwrap().iter().zip(y["models"].as_array().unwrap()) {
        assert_eq!((&a["name"], &a["applicable"]), (&b["name"], &b["applicable"]));
        if let (Some(a), Some(b)) = (a["drag_N"].as_f64(), b["drag_N"].as_f64()) {
            assert!((a - b).abs() < 1e-6 * a.abs(), "{a} and {b}");
        }
    }
    let cells = |name: &str| {
        let text = desk.expect(0, &["check", name]).text();
        text.match_indices("cells across").map(|(at, _)| text[at - 5..at].to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(cells("x.toml"), cells("y.toml"));
}
