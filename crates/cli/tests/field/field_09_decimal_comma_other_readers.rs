//! Tables as Excel saves them in German, French or Dutch: read alike as ground, as motion and as measurement,
//! and said once.

use crate::support::Desk;

pub(crate) const GROUND: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", cohesion = "0.3 kPa", unit_weight = "15 kN/m^3", young_modulus = "1 MPa" }
domain = { x = ["-0.4 m", "0.4 m"], y = ["-0.3 m", "0.3 m"], z = ["-0.25 m", "0.2 m"] }
grid = { cell = "20 mm" }
run = { duration = "0.2 s" }
[height_map]
file = "ground.csv"
[body.plate]
shape = "block"
size = ["0.1 m", "0.1 m", "0.1 m"]
friction = 0.3
sinkage = "-30 mm"
heave = { speed = "-0.1 m/s" }
"#;

const TOW: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "15 kN/m^3", young_modulus = "1 MPa" }
grid = { cell = "20 mm" }
run = { duration = "1 s" }
[body.plate]
shape = "block"
size = ["0.1 m", "0.1 m", "0.2 m"]
friction = 0.3
sinkage = "50 mm"
forward = { table = "tow.csv" }
"#;

/// The same table as other programs write it: with decimal points, for the case as in `text`.
fn dialects(text: &str) -> Vec<(String, bool)> {
    let german =
        |end: &str| format!("\u{feff}{}", text.replace(',', ";").replace('.', ",").replace('\n', end));
    let tabs = |end: &str| text.replace(',', "\t").replace('.', ",").replace('\n', end);
    vec![
        (text.to_owned(), false),
        (german("\r\n"), true),
        (german("\r"), true),
        (german("\n").replace('\n', ";\n"), true),
        (tabs("\r\n"), true),
        (text.replace(',', " "), false),
    ]
}

fn ground() -> String {
    let mut text = "x [m],y [m],z [mm]\n".to_owned();
    for n in 0..143 {
        let (x, y) = (f64::from(n % 13 - 6) / 10.0, f64::from(n / 13 - 5) / 10.0);
        text += &format!("{x:.1},{y:.1},{:.1}\n", 10.0 * (6.0 * x).sin());
    }
    text
}

/// What `check` says, without what it says of commas.
fn checked(desk: &Desk, case: &str, has_comma: bool) -> String {
    let answer = desk.expect(0, &["check", case]);
    let text = answer.text();
    assert_eq!(text.matches("decimal commas were read as points").count(), usize::from(has_comma), "{text}");
    let lines = answer.out.lines().chain(answer.error.lines());
    // How long it takes depends on the moment.
    let same = lines
        .filter(|line| line.contains("surface") || line.contains("ground") || line.contains("displacement"));
    same.filter(|line| !line.contains("decimal commas")).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_map_and_a_motion_are_read_in_every_dialect() {
    let tow: String =
        (0..=20).map(|n| format!("{:.2},{:.1}\n", 0.05 * f64::from(n), 10.0 * f64::from(n))).collect();
    let tow = format!("time [s],displacement [mm]\n{tow}");
    for (case, name, text) in [(GROUND, "ground.csv", ground()), (TOW, "tow.csv", tow)] {
        let mut first = None;
        for (dialect, has_comma) in dialects(&text) {
            let desk = Desk::with(&[("case.toml", case), (name, &dialect)]);
            let said = checked(&desk, "case.toml", has_comma);
            assert_eq!(*first.get_or_insert(said.clone()), said, "{}", &dialect[..60]);
        }
    }
}

#[test]
fn a_fault_is_named_with_its_line_whatever_ends_lines() {
    for end in ["\n", "\r\n", "\r"] {
        let text = format!(
            "\u{feff}{}",
            ground().replace(',', ";").replace('.', ",").replacen("-0,5;", "-0,5x;", 1).replace('\n', end)
        );
        let desk = Desk::with(&[("case.toml", GROUND), ("ground.csv", &text)]);
        desk.expect(2, &["check", "case.toml"]).says(&["ground.csv: line 2: \"-0,5x\" is not a number"]);
        let text = ["time [s];displacement [mm]", "0,0;0,0", "0,5;x", "1,0;3,0", ""].join(end);
        let desk = Desk::with(&[("case.toml", TOW), ("tow.csv", &text)]);
        desk.expect(2, &["check", "case.toml"]).says(&["tow.csv: line 3: \"x\" is not a number"]);
    }
}
