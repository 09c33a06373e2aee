//! An instance of an FMU, driven as an importer does.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::mechanics::Twist;
use coulter::simulation::{Command, Simulation};
use coulter_fmu::c_api::{Status, fmi3DoStep, fmi3GetFloat64, fmi3Reset};
use coulter_fmu::{ExportError, Fmu, Instance, Severity, Steered, export};
use std::collections::BTreeMap;
use std::path::Path;
use std::ptr::{null, null_mut};

const CASE: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "16 kN/m^3", young_modulus = "5 MPa" }
domain = { x = ["-0.3 m", "0.3 m"], y = ["0 m", "0.25 m"], z = ["-0.2 m", "0.1 m"], symmetric = true }
grid = { cell = "25 mm", growth = 1.15 }
run = { duration = "0.1 s" }
output = { history_interval = "2 ms" }
[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "0.08 m"
friction = 0.3
weight = "60 N"
forward = "free"
heave = "free"
spin = "free"
"#;
/// References of the inputs of a body that is steered by its velocity, which come first, and of its force.
const FIRST: u32 = 3;
const FORCE: u32 = FIRST + 6;
const SET: u32 = 1;
const OUTPUT: u32 = 2;

fn fmu(how: Steered) -> Fmu {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tow.toml");
    std::fs::write(&path, CASE).unwrap();
    Fmu::of_file(&path, &[], &BTreeMap::from([("disc".to_owned(), how)])).unwrap()
}

fn instance(how: Steered) -> Instance {
    let fmu = fmu(how);
    let token = fmu.token();
    Instance::new(fmu, &token).unwrap()
}

fn begun(how: Steered) -> Instance {
    let mut instance = instance(how);
    instance.enter_initialization(0.0, None).unwrap();
    instance.exit_initialization().unwrap();
    instance
}

fn outputs(instance: &mut Instance) -> Vec<f64> {
    (FORCE..FORCE + 21).map(|n| instance.number(n).unwrap()).collect()
}

/// Presses and tows at once.
fn push(instance: &mut Instance) {
    instance.set_number(FIRST, 0.2).unwrap();
    instance.set_number(FIRST + 2, -0.1).unwrap();
}

#[test]
fn forces_are_those_of_a_simulation_to_the_bit() {
    let mut driven = begun(Steered::Velocity);
    push(&mut driven);
    let mut own = Simulation::<f64>::new(&fmu(Steered::Velocity).case);
    let mut twist = Twist::ZERO;
    (twist.linear.x, twist.linear.z) = (0.2, -0.1);
    for n in 0..20 {
        let (from, step) = (f64::from(n) * 1e-3, 1e-3);
        driven.step(from, step).unwrap();
        let soil = own.step_until(from + step, &[(0, Command::Twist(twist))]).unwrap()[0].soil;
        let force = outputs(&mut driven)[..3].to_vec();
        assert!(force == soil.force.to_array() && force[2] >= 0.0, "{n}: {force:?}, not {soil:?}");
    }
    assert!(outputs(&mut driven)[2] > 10.0);
}

#[test]
fn a_state_is_gone_back_to_to_the_bit() {
    let mut driven = begun(Steered::Velocity);
    push(&mut driven);
    driven.step(0.0, 0.01).unwrap();
    let saved = driven.save().unwrap();
    let before = outputs(&mut driven);
    driven.step(0.01, 0.01).unwrap();
    let once = outputs(&mut driven);
    driven.restore(&saved).unwrap();
    assert_eq!((outputs(&mut driven), driven.number(0).unwrap()), (before, 0.01));
    driven.step(0.01, 0.01).unwrap();
    assert_eq!(outputs(&mut driven), once);
    // By another instance, too, also after its end, and not by that of another FMU.
    let mut other = instance(Steered::Velocity);
    other.restore(&saved).unwrap();
    other.step(0.01, 0.01).unwrap();
    assert_eq!(outputs(&mut other), once);
    other.terminate().unwrap();
    other.restore(&saved).unwrap();
    other.step(0.01, 0.01).unwrap();
    assert_eq!(outputs(&mut other), once);
    assert!(instance(Steered::Load).restore(&saved).unwrap_err().message.contains("no state of this FMU"));
    driven.reset();
    driven.enter_initialization(0.0, None).unwrap();
    assert_eq!(driven.number(FORCE).unwrap(), 0.0);
}

#[test]
fn what_cannot_be_done_is_said_and_changes_nothing() {
    let mut driven = begun(Steered::Velocity);
    let refused = |own: Result<(), coulter_fmu::Refusal>, words: &str| {
        let refusal = own.unwrap_err();
        assert!(refusal.message.contains(words), "`{words}` is not in {refusal:?}");
        refusal.severity
    };
    driven.set_number(FIRST + 1, 0.1).unwrap();
    assert_eq!(refused(driven.step(0.0, 0.01), "it is to move along y"), Severity::Discard);
    driven.set_number(FIRST + 1, 0.0).unwrap();
    driven.step(0.0, 0.01).unwrap();
    assert_eq!(refused(driven.step(0.01, -0.01), "not after the present time"), Severity::Discard);
    assert_eq!(refused(driven.step(0.01, 1.0), "the case ends at 0.1 s"), Severity::Discard);
    refused(driven.step(0.05, 0.01), "is at 0.01 s, not at 0.05 s");
    refused(driven.set_number(FIRST, f64::NAN), "disc.command.velocity.x = NaN");
    refused(driven.set_number(FORCE, 1.0), "no input");
    refused(driven.set_text(SET, "grid.cell=20 mm"), "before the end of initialisation");
    refused(driven.exit_initialization(), "out of turn");
    driven.step(0.01, 0.01).unwrap();
    let with = |set: &str| {
        let mut own = instance(Steered::Velocity);
        own.set_text(SET, set).unwrap();
        own.enter_initialization(0.0, Some(1.0)).unwrap();
        own.exit_initialization().map(|()| own)
    };
    refused(with("soil.friction_angle=95 deg").map(drop), "friction_angle");
    // The importer goes on for longer than the case.
    let mut longer = with("soil.friction_angle=30 deg\ngrid.cell=30 mm").unwrap();
    longer.step(0.0, 0.11).unwrap();
    assert!(Instance::new(fmu(Steered::Own), "{coulter}").unwrap_err().message.contains("another FMU"));
}

#[test]
fn results_are_written_where_asked_and_a_body_that_is_led_out_fails() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("results");
    let mut driven = instance(Steered::Velocity);
    driven.set_text(OUTPUT, to.to_str().unwrap()).unwrap();
    driven.enter_initialization(0.0, None).unwrap();
    driven.exit_initialization().unwrap();
    push(&mut driven);
    driven.step(0.0, 0.02).unwrap();
    driven.terminate().unwrap();
    assert!(to.join("report.html").is_file());
    assert!(driven.notes.concat().contains("trust:"), "{:?}", driven.notes);
    let mut led = begun(Steered::Velocity);
    led.set_number(FIRST, 5.0).unwrap();
    let refusal = led.step(0.0, 0.1).unwrap_err();
    assert_eq!(refusal.severity, Severity::Error, "{refusal:?}");
    assert!(led.step(0.0, 0.1).unwrap_err().message.contains("out of turn"));
    led.reset();
}

#[test]
fn nothing_is_written_with_another_library() {
    let folder = tempfile::tempdir().unwrap();
    let (library, to) = (folder.path().join("other.so"), folder.path().join("tow.fmu"));
    let fmu = fmu(Steered::Own);
    assert!(matches!(export(&fmu, &library, &to), Err(ExportError::File { .. })));
    std::fs::write(&library, "something else").unwrap();
    assert!(matches!(export(&fmu, &library, &to), Err(ExportError::Library(_))));
    assert!(!to.exists());
    assert!(Fmu::in_resources(Path::new("/nowhere")).is_err());
}

#[test]
#[allow(unsafe_code)]
fn pointers_that_are_missing_are_refused() {
    // SAFETY: these are the pointers that are checked.
    unsafe {
        assert_eq!(fmi3Reset(null_mut()), Status::Error);
        assert_eq!(fmi3GetFloat64(null_mut(), null(), 0, null_mut(), 0), Status::Error);
        let none = null_mut();
        assert_eq!(fmi3DoStep(null_mut(), 0.0, 1.0, true, none, none, none, null_mut()), Status::Error);
    }
}
