//! The name of every column of a motion table counts: sinkage goes down, what is no motion is refused; times
//! that never come into the run are said.

use crate::support::Desk;

const PLATE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "15 kN/m^3", young_modulus = "1 MPa" }
domain = { x = ["0 m", "0.25 m"], y = ["0 m", "0.25 m"], z = ["-0.25 m", "0.1 m"], symmetric = true, symmetric_x = true }
grid = { cell = "12.5 mm", growth = 1.3 }
run = { duration = "0.5 s" }
[body.plate]
shape = "block"
size = ["0.1 m", "0.1 m", "0.05 m"]
friction = 0.3
sinkage = "0 mm"
heave = { table = "log.csv" }
"#;

fn desk(log: &str) -> Desk {
    Desk::with(&[("plate.toml", PLATE), ("log.csv", log)])
}

/// A log of 25 mm in half a second.
fn log(header: &str) -> String {
    format!("{header}\n0,0\n0.1,5\n0.2,10\n0.3,15\n0.4,20\n0.5,25\n")
}

#[test]
fn a_sinkage_goes_down_and_that_is_said() {
    for name in ["sinkage", "depth", "penetration", "settlement", "sinkage z"] {
        let answer = desk(&log(&format!("time [s],{name} [mm]"))).expect(0, &["check", "plate.toml"]);
        answer.says(&["counts downwards"]);
    }
    for name in ["displacement", "z", "elevation"] {
        let answer = desk(&log(&format!("time [s],{name} [mm]"))).expect(0, &["check", "plate.toml"]);
        assert!(!answer.text().contains("counts downwards"), "{name}");
    }
}

#[test]
fn what_is_no_motion_or_no_time_is_refused() {
    for header in
        ["time [s],foo [mm]", "seconds [s],force [mm]", "foo [s],displacement [mm]", "time [s],angle [mm]"]
    {
        desk(&log(header)).expect(2, &["check", "plate.toml"]).says(&[
            "log.csv",
            "time [s],displacement [mm]",
            "sinkage",
        ]);
    }
    desk(&log("time [s],sinkge [mm]")).expect(2, &["check", "plate.toml"]).says(&["did you mean `sinkage`?"]);
}

#[test]
fn times_that_never_come_are_refused_or_shifted() {
    let epoch = "time [s],sinkage [mm]\n1700000000,0\n1700000000.5,25\n";
    desk(epoch)
        .expect(2, &["check", "plate.toml"])
        .says(&["the motion never begins", "from = \"first line\""]);
    desk("time [s],sinkage [mm]\n-0.2,0\n0.5,25\n")
        .expect(2, &["check", "plate.toml"])
        .says(&["before the run does"]);
    let shifted = ["check", "plate.toml", "--set", "body.plate.heave.from=first line"];
    desk(epoch).expect(0, &shifted).says(&["counts downwards"]);
    let displaced =
        PLATE.replace(r#"{ table = "log.csv" }"#, r#"{ displacement = "-20 mm", start = "5 s" }"#);
    Desk::with(&[("plate.toml", &displaced)])
        .expect(2, &["check", "plate.toml"])
        .says(&["never begins", "`start`"]);
    let moved = PLATE.replace(r#"table = "log.csv""#, r#"speed = "-20 mm/s", from = "first line""#);
    Desk::with(&[("plate.toml", &moved)])
        .expect(2, &["check", "plate.toml"])
        .says(&["only a table has a `from`"]);
}

#[test]
fn a_table_shorter_than_the_run_is_said() {
    desk("time [s],sinkage [mm]\n0.1,0\n0.4,25\n").expect(0, &["check", "plate.toml"]).says(&[
        "its table begins at 0.1 s",
        "its table ends at 0.4 s, 0.1 s before the run; after that the body is at rest",
    ]);
    desk("time [s],speed [mm/s]\n0,-1\n0.4,-25\n")
        .expect(0, &["check", "plate.toml"])
        .says(&["keeps its last speed, -0.025"]);
}
