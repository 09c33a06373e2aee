//! Stages of a run, and motions that are displacements or tables: what they do, what ends them, and what is
//! refused.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{Case, parse};
use coulter::forecast::model_input;
use coulter::simulation::Simulation;
use solver::error::Breakdown;

/// A small box of sand on coarse cells, with a disc that just touches it.
const SAND: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
     [domain]\nx = ['-0.24 m', '0.24 m']\ny = ['-0.24 m', '0.24 m']\nz = ['-0.16 m', '0.08 m']\n[grid]\ncell = '20 mm'\ngrowth = 1\n\
     fine_x = ['-0.24 m', '0.24 m']\nfine_y = ['-0.24 m', '0.24 m']\nfine_z = ['-0.16 m', '0.08 m']\n\
     [output]\nhistory_interval = '1 ms'\n\
     [body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '80 mm'\nfriction = 0.3\nweight = '40 N'\n";

const STAGES: &str = "[stage.press]\ndisc.heave = { speed = '-0.2 m/s', ramp = '2 ms' }\nduration = '0.2 s'\n\
     until = { body = 'disc', vertical_force = '60 N' }\n\
     [stage.hold]\ndisc.heave = 'fixed'\nduration = '0.03 s'\n\
     [stage.tow]\ndisc.forward = { speed = '0.3 m/s', ramp = '5 ms' }\ndisc.spin = 'free'\nduration = '0.1 s'\n\
     until = { body = 'disc', displacement = '10 mm' }\n\
     [stage.lift]\ndisc.heave = { displacement = '20 mm', ramp = '0.05 s' }\ndisc.forward = 'fixed'\nduration = '0.05 s'\n";

fn case(more: &str, overrides: &[&str]) -> Result<Case, String> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    parse(&format!("{SAND}{more}"), "stages.toml", &overrides).map_err(|error| format!("{error:?}"))
}

fn ended(case: &Case) -> Simulation {
    let mut simulation = Simulation::<f64>::new(case);
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
    simulation
}

#[test]
fn each_stage_ends_where_it_should_and_the_next_goes_on_from_there() {
    let case = case(STAGES, &[]).unwrap();
    assert_eq!((case.duration, case.steady_stage()), (0.2 + 0.03 + 0.1 + 0.05, Some(2)));
    let run = ended(&case);
    let [press, hold, tow, lift] = [0, 1, 2, 3].map(|stage| run.history.stage_times(stage).unwrap());
    assert_eq!([press[1], hold[1], tow[1]], [hold[0], tow[0], lift[0]]);
    let samples = &run.history.bodies[0];
    let at = |time: f64| samples.iter().find(|sample| sample.time == time).unwrap();
    assert!(at(press[1]).vertical >= 60.0);
    assert!(samples.iter().all(|sample| sample.time >= press[1] || sample.vertical < 60.0));
    let dt = run.model.time_step();
    assert!((hold[1] - hold[0] - 0.03).abs() <= dt);
    // The press comes to a halt within 20 ms: half of what its speed would cover.
    let halted = at(hold[1]);
    assert_eq!(halted.heave_speed, 0.0);
    assert!((halted.sinkage - at(press[1]).sinkage - 0.5 * 0.2 * 0.02).abs() < 2.0 * dt * 0.2);
    let towed = at(tow[1]).displacement - halted.displacement;
    assert!((0.01..0.01 + 0.3 * 0.0011).contains(&towed), "{towed}");
    assert!((at(lift[1]).sinkage - at(tow[1]).sinkage + 0.02).abs() < 1e-4);
    let part = run.steady_part();
    assert_eq!(part.during, Some(tow));
}

#[test]
fn averages_are_taken_over_the_stage_that_says_so() {
    let held = STAGES.replace("'fixed'\nduration = '0.03 s'", "'fixed'\nduration = '0.03 s'\nsteady = true");
    assert_eq!(case(&held, &[]).unwrap().steady_stage(), Some(1));
    let twice = case(&held, &["stage.tow.steady=true"]).unwrap_err();
    assert!(twice.contains("stage.tow.steady") && twice.contains("all but one stage"), "{twice}");
}

#[test]
fn a_run_of_one_stage_is_that_of_the_same_motions_without() {
    let motions = "heave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n";
    let plain = case(&format!("{motions}[run]\nduration = '20 ms'\n"), &[]).unwrap();
    let staged: String = motions.lines().map(|line| format!("disc.{line}\n")).collect();
    let staged = case(&format!("[stage.tow]\nduration = '20 ms'\n{staged}"), &[]).unwrap();
    assert_eq!(ended(&plain).history.bodies, ended(&staged).history.bodies);
}

#[test]
fn a_run_goes_on_from_any_stage_to_the_bit() {
    let case = case(STAGES, &[]).unwrap();
    let whole = ended(&case);
    for time in [0.01, 0.11, 0.14, 0.17] {
        let mut first = Simulation::<f64>::new(&case);
        while first.state.time < time && !first.is_done() {
            first.advance().unwrap();
        }
        let mut resumed = Simulation::resume(&case, first.checkpoint().kept(), 0.0);
        while !resumed.is_done() {
            resumed.advance().unwrap();
        }
        assert_eq!(resumed.history, whole.history, "{time}");
        assert!(resumed.state == whole.state, "{time}");
    }
}

#[test]
fn a_stage_that_does_not_reach_its_end_breaks_the_run() {
    let case = case(
        STAGES,
        &["stage.press.until={ body = 'disc', vertical_force = '100 kN' }", "stage.press.duration=10 ms"],
    );
    let mut simulation = Simulation::<f64>::new(&case.unwrap());
    let cause = loop {
        if let Err(cause) = simulation.advance() {
            break cause;
        }
        assert!(!simulation.is_done());
    };
    let Breakdown::Untrustworthy { what, .. } = &cause else { panic!("{cause}") };
    assert!(what.contains("`press` has not reached a vertical force of 100000 N"), "{what}");
}

#[test]
fn a_displacement_is_reached_and_a_table_is_followed() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("press.csv"), "time [ms],speed [mm/s]\n0,0\n10,-400\n20,0\n").unwrap();
    let text = format!(
        "{SAND}heave = {{ table = 'press.csv' }}\nforward = {{ displacement = '5 mm', ramp = '20 ms' }}\n[run]\nduration = '30 ms'\n"
    );
    let case = parse(&text, &folder.path().join("case.toml").display().to_string(), &[]).unwrap();
    let run = ended(&case);
    let last = run.history.bodies[0].last().unwrap();
    assert!((last.displacement - 0.005).abs() < 1e-6, "{}", last.displacement);
    assert!((last.sinkage - 0.004).abs() < 1e-6, "{}", last.sinkage);
    assert_eq!(case.tables.len(), 1);
}

#[test]
fn a_forecast_is_that_of_the_stage_with_the_tow() {
    let stages = STAGES.replace("vertical_force = '60 N'", "sinkage = '20 mm'");
    let staged = model_input(&case(&stages, &[]).unwrap()).unwrap();
    let fixed =
        "sinkage = '20 mm'\nforward = { speed = '0.3 m/s' }\nspin = 'free'\n[run]\nduration = '0.1 s'\n";
    let plain = model_input(&case(fixed, &[]).unwrap()).unwrap();
    assert_eq!(staged.towing.load, plain.towing.load);
    assert!(staged.remarks.iter().any(|remark| remark.contains("stage `tow`")));
    let by_force = model_input(&case(STAGES, &[]).unwrap()).unwrap_err();
    assert!(by_force.contains("follows from the run"), "{by_force}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (more, overrides, message) in [
        (STAGES, &["run.duration=1 s"][..], "the stages determine the end"),
        (STAGES, &["stage.tow.disk.heave=free"], "there is no body"),
        (STAGES, &["stage.tow.disc.heaves=free"], "`heaves`"),
        (STAGES, &["stage.tow.durations=1 s"], "`durations`"),
        (STAGES, &["stage.tow.duration=0 s"], "out of range"),
        (STAGES, &["stage.tow.until={ sinkage = '1 mm' }"], "`body` is missing"),
        (STAGES, &["stage.tow.until={ body = 'disc' }"], "0 quantities instead of one"),
        (STAGES, &["stage.tow.until={ body = 'disc', sinkage = '1 mm', drag = '1 N' }"], "2 quantities"),
        (STAGES, &["stage.tow.until={ body = 'disc', sinkages = '1 mm' }"], "`sinkages`"),
        (STAGES, &["stage.tow.until=rest"], "expected a table"),
        (
            STAGES,
            &["stage.tow.disc.forward={ speed = '1 m/s', end = '1 s' }"],
            "motions of a stage end with it",
        ),
        (STAGES, &["stage.tow.disc.forward={ speed = '1 m/s', displacement = '1 m' }"], "more than one of"),
        (STAGES, &["stage.tow.disc.forward={ displacement = '1 m', ramp = '0 s' }"], "within no time"),
        (STAGES, &["stage.tow.disc.forward={ table = 'none.csv' }"], "cannot be read"),
        (
            STAGES,
            &[
                "stage.tow.disc.forward={ speed = '9 m/s' }",
                "stage.tow.until={ body = 'disc', displacement = '1 m' }",
            ],
            "domain",
        ),
        ("[stage.tow]\ndisc.spin = 'free'\n", &[], "`stage.tow.duration` is missing"),
    ] {
        let refused = case(more, overrides).unwrap_err();
        assert!(refused.contains(message), "{overrides:?}: {refused}");
    }
}
