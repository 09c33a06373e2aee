//! The stress below a footing was given from contact point to contact point, a saw-tooth of 0 to 15 kPa about
//! 5: file and plot go by way of the nodes.

use crate::support::Desk;

const FOOTING: &str = r#"
format = 2
[soil]
law = "tresca"
shear_strength = "1 kPa"
unit_weight = "0 N/m^3"
density = "2000 kg/m^3"
young_modulus = "1 MPa"
poisson_ratio = 0.3
[domain]
x = ["-2 m", "2 m"]
z = ["-1.5 m", "0.5 m"]
plane_strain = true
[grid]
cell = "0.125 m"
[body.footing]
shape = "block"
size = ["1 m", "0.5 m"]
friction = 0
heave = { speed = "-0.05 m/s", ramp = "0.1 s" }
[run]
duration = "0.6 s"
"#;

/// The points of a curve of a chart: values on its ordinate.
fn ordinates(svg: &str, name: &str) -> Vec<f64> {
    let numbers = |attribute: &str| -> Vec<f64> {
        let text = svg.split(&format!("{attribute}=\"")).nth(1).unwrap().split('"').next().unwrap();
        text.split(' ').map(|number| number.parse().unwrap()).collect()
    };
    let (range, place) = (numbers("data-range"), numbers("data-box"));
    let line = svg.lines().find(|line| line.contains(&format!("data-name=\"{name}"))).unwrap();
    let path = line.split("d=\"").nth(1).unwrap().split('"').next().unwrap();
    let at = |point: &str| point.split(' ').nth(1).unwrap().parse::<f64>().unwrap();
    let value = |y: f64| range[2] + (place[3] - y) / (place[3] - place[2]) * (range[3] - range[2]);
    path.split(['M', 'L']).filter(|point| !point.is_empty()).map(at).map(value).collect()
}

/// How far neighbours differ, over their mean.
fn roughness(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>() / (values.len() - 1) as f64 / mean
}

#[test]
fn contact_stress_along_the_rim_can_be_read() {
    let desk = Desk::with(&[("footing.toml", FOOTING)]);
    desk.expect(0, &["run", "footing.toml", "-o", "out", "--force"]);
    let rim = desk.read("out/rim.csv");
    let head: Vec<&str> = rim.lines().next().unwrap().split(',').collect();
    let at = head.iter().position(|name| name.starts_with("normal stress")).unwrap();
    let points: Vec<f64> =
        rim.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect();
    let raw: Vec<f64> = points.into_iter().filter(|stress| *stress > 0.0).collect();
    let svg = desk.read("out/plots/footing_rim_stress.svg");
    let shown = ordinates(&svg, "normal stress");
    assert!(roughness(&shown) < 0.2 && roughness(&raw) < 0.2, "{raw:?} {shown:?}");
    // Forces and depths of the same times stand side by side, and a pressed body has no key numbers of a tow.
    assert!(desk.read("out/filtered.csv").lines().next().unwrap().contains("sinkage z [m]"));
    let html = desk.read("out/report.html");
    let key = html.split("key numbers</h2>").nth(1).unwrap().split("</table>").next().unwrap();
    assert!(key.contains("Peak vertical force") && key.contains("Deepest sinkage"), "{key}");
    for name in ["Turn ratio", "Slip", "Drag", "Tow power"] {
        assert!(!key.contains(name), "{name}: {key}");
    }
    for word in ["NaN", "not a number", ">null<", ">None<"] {
        assert!(!html.split("<section class=\"case\">").next().unwrap().contains(word), "{word}");
    }
}

#[test]
fn what_is_checked_is_said_in_the_digits_that_people_read() {
    let sand = FOOTING.replace(
        "law = \"tresca\"\nshear_strength = \"1 kPa\"",
        "law = \"mohr-coulomb\"\nfriction_angle = \"32 deg\"",
    );
    let desk = Desk::with(&[(
        "footing.toml",
        &sand.replace("\"0 N/m^3\"", "\"14.4 kN/m^3\"").replace("density = \"2000 kg/m^3\"\n", ""),
    )]);
    let answer = desk.expect(0, &["check", "footing.toml"]);
    answer.says(&["φ = 32°", "γ = 14.4 kN/m³", "E = 1 MPa", "cells of 125 mm"]);
    assert!(!answer.out.contains("000°") && !answer.out.contains(".0000"), "{}", answer.out);
}
