//! Bodies that are connected: welds, joints, frames, shared faces, and what is refused.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{Case, parse};
use coulter::forecast::outlook;
use coulter::history::BodySample;
use coulter::run::watch::watch;
use coulter::simulation::Simulation;

/// A small box of sand on coarse cells.
const SAND: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
     [domain]\nx = ['-0.24 m', '0.24 m']\ny = ['-0.24 m', '0.24 m']\nz = ['-0.16 m', '0.08 m']\n[grid]\ncell = '20 mm'\ngrowth = 1\n\
     fine_x = ['-0.24 m', '0.24 m']\nfine_y = ['-0.24 m', '0.24 m']\nfine_z = ['-0.16 m', '0.08 m']\n[run]\nduration = '0.2 s'\n\
     [output]\nhistory_interval = '1 ms'\n";

/// A thick disc, towed and pressed down.
const DISC: &str = "[body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '80 mm'\nfriction = 0.3\nweight = '40 N'\nsinkage = '15 mm'\n\
     heave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n";

/// The same as two halves that are welded together.
const HALVES: &str = "[body.left]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '40 mm'\nfriction = 0.3\nweight = '20 N'\nsinkage = '15 mm'\ny = '20 mm'\n\
     heave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n\
     [body.right]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '40 mm'\nfriction = 0.3\nweight = '20 N'\nsinkage = '15 mm'\ny = '-20 mm'\n\
     welded_to = 'left'\n";

/// Two discs on hinges of a frame that sinks as they do.
const GANG: &str = "[body.frame]\nshape = 'frame'\nelevation = '0.3 m'\nmass = '3 kg'\nheave = 'free'\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\n\
     [body.left]\nshape = 'disc'\ndiameter = '0.16 m'\nthickness = '60 mm'\nfriction = 0.4\nweight = '20 N'\nsinkage = '10 mm'\ny = '80 mm'\n\
     [body.right]\nshape = 'disc'\ndiameter = '0.16 m'\nthickness = '60 mm'\nfriction = 0.4\nweight = '20 N'\nsinkage = '10 mm'\ny = '-80 mm'\n\
     [joint.left]\nkind = 'hinge'\nbodies = ['frame', 'left']\n[joint.right]\nkind = 'hinge'\nbodies = ['frame', 'right']\n";

fn case(bodies: &str, overrides: &[&str]) -> Result<Case, String> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    parse(&format!("{SAND}{bodies}"), "assembly.toml", &overrides).map_err(|error| format!("{error:?}"))
}

/// The run after some samples.
fn run(bodies: &str, overrides: &[&str], samples: u32) -> Simulation {
    let mut simulation = Simulation::<f64>::new(&case(bodies, overrides).unwrap());
    for _ in 0..samples {
        simulation.advance().unwrap();
    }
    simulation
}

fn of<'a>(simulation: &'a Simulation, name: &str) -> &'a [BodySample] {
    let n = simulation.history.names.iter().position(|body| body == name).unwrap();
    &simulation.history.bodies[n]
}

/// The same halves welded to a frame in the middle.
fn on_a_frame() -> String {
    let motions = "heave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n";
    let halves =
        HALVES.replace(motions, "welded_to = 'axle'\n").replace("welded_to = 'left'", "welded_to = 'axle'");
    format!(
        "[body.axle]\nshape = 'frame'\nelevation = '85 mm'\nmass = '1e-9 kg'\naxle_inertia = '1e-12 kg*m^2'\n{motions}{halves}"
    )
}

#[test]
fn two_half_discs_that_are_welded_are_one_disc() {
    let whole = run(DISC, &[], 20);
    assert!(whole.state.step > 100, "{} steps", whole.state.step);
    are_one_disc(&whole, &run(HALVES, &[], 20), "left");
    are_one_disc(&whole, &run(&on_a_frame(), &[], 20), "axle");
}

fn are_one_disc(whole: &Simulation, halves: &Simulation, name: &str) {
    let (a, b) = (of(whole, "disc"), of(halves, name));
    let scale = a.iter().map(|s| s.vertical.abs()).fold(0.0, f64::max);
    let apart = |a: &BodySample, b: &BodySample| {
        let forces =
            [a.drag - b.drag, a.vertical - b.vertical, a.lateral - b.lateral, a.axle_torque - b.axle_torque];
        let apart = forces.into_iter().map(f64::abs).fold(0.0, f64::max) / scale;
        apart.max((a.rotation - b.rotation).abs()).max((a.sinkage - b.sinkage).abs())
    };
    let largest = a.iter().zip(b).map(|(a, b)| apart(a, b)).fold(0.0, f64::max);
    eprintln!("{name}: {largest:e} after {} steps", whole.state.step);
    assert!(largest < 1e-9, "{name}: {largest:e}");
    // Each half has half of the force, and both together the whole.
    let parts = &halves.history.parts;
    assert_eq!(halves.history.part_names, ["left", "right"]);
    let (left, right) = (parts[0].last().unwrap(), parts[1].last().unwrap());
    let (force, last) = (left.force_z + right.force_z, b.last().unwrap());
    assert!((force - last.vertical).abs() < 1e-9 * scale, "{force} of {}", last.vertical);
    assert!((left.force_z - right.force_z).abs() < 1e-6 * scale, "{left:?} {right:?}");
}

#[test]
fn discs_on_hinges_sink_and_roll_with_their_frame() {
    let gang = run(GANG, &[], 60);
    let (frame, left) = (of(&gang, "frame").last().unwrap(), of(&gang, "left").last().unwrap());
    assert!((frame.displacement - left.displacement).abs() < 1e-9 * 0.16);
    assert!(frame.displacement > 0.01 && left.rotation > 0.1 * frame.displacement / 0.08, "{left:?}");
    for (samples, body) in gang.history.joints.iter().zip(["left", "right"]) {
        let weight = 20.0;
        let torque = samples.iter().map(|s| s.moment_y.abs()).fold(0.0, f64::max);
        assert!(torque <= 1e-9 * weight * 0.16, "a free hinge bears no torque: {torque:e}");
        let drift = samples.iter().map(|s| s.distance).fold(0.0, f64::max);
        assert!(drift <= 1e-9 * 0.16, "{drift:e}");
        // The frame pulls the disc against its drag.
        let (last, disc) = (samples.last().unwrap(), of(&gang, body).last().unwrap());
        assert!((last.force_x - disc.drag).abs() < 0.3 * disc.drag.abs() + 1.0, "{last:?} {disc:?}");
    }
    let closure = gang.history.energy.last().unwrap().closure();
    // That of soil and contact: what joints do is exact (crates/mechanics/tests).
    assert!(closure.abs() < 5e-3, "{closure:e}");
}

#[test]
fn a_rigid_axle_turns_its_discs_together() {
    let axle = GANG.replace("[joint.left]\nkind = 'hinge'\nbodies = ['frame', 'left']\n[joint.right]\nkind = 'hinge'\nbodies = ['frame', 'right']\n", "")
        .replace("[body.left]\n", "[body.left]\nwelded_to = 'axle'\n")
        .replace("[body.right]\n", "[body.right]\nwelded_to = 'axle'\n")
        + "[body.axle]\nshape = 'frame'\nelevation = '70 mm'\nmass = '1 kg'\naxle_inertia = '1e-3 kg*m^2'\n\
           [joint.axle]\nkind = 'hinge'\nbodies = ['frame', 'axle']\naxis = [0, 1, 0]\n";
    let gang = run(&axle, &[], 40);
    assert_eq!(gang.history.names, ["frame", "axle"]);
    assert_eq!(gang.history.part_names, ["left", "right"]);
    let last = of(&gang, "axle").last().unwrap();
    assert!(last.rotation > 0.0 && last.vertical > 0.0, "{last:?}");
    let sum: f64 = gang.history.parts.iter().map(|samples| samples.last().unwrap().force_z).sum();
    assert!((sum - last.vertical).abs() < 1e-9 * last.vertical);
}

#[test]
fn a_cable_tows_a_disc() {
    let towed = "[body.boat]\nshape = 'frame'\nx = '0.5 m'\nelevation = '0.085 m'\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\n\
         [body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '80 mm'\nfriction = 0.3\nweight = '20 N'\nsinkage = '15 mm'\n\
         heave = 'free'\nforward = 'free'\nspin = 'free'\n\
         [joint.warp]\nkind = 'cable'\nbodies = ['boat', 'disc']\nstiffness = '20 kN/m'\nlength = '0.505 m'\n";
    let run = run(towed, &[], 80);
    let pull: Vec<f64> = run.history.joints[0].iter().map(|s| s.force_x).collect();
    assert!(pull[5] == 0.0, "slack at first: {pull:?}");
    assert!(pull.iter().all(|force| *force >= -1e-9) && pull.iter().any(|force| *force > 10.0), "{pull:?}");
    assert!(of(&run, "disc").last().unwrap().displacement > 1e-3);
}

#[test]
fn bodies_that_run_into_each_other_end_the_run() {
    let block = "[body.wall]\nshape = 'block'\nsize = ['60 mm', '0.2 m', '0.1 m']\nx = '0.14 m'\nsinkage = '15 mm'\nfriction = 0.3\n";
    let mut run = Simulation::<f64>::new(&case(&format!("{DISC}{block}"), &[]).unwrap());
    let met = (0..200).find_map(|_| {
        run.advance().unwrap();
        watch(&run).err()
    });
    let message = met.unwrap().to_string();
    assert!(message.contains("the bodies `disc` and `wall` have run into each other"), "{message}");
}

#[test]
fn the_forecast_shares_the_weight_of_an_assembly() {
    let one = "[body.disc]\nshape = 'disc'\ndiameter = '0.16 m'\nthickness = '60 mm'\nfriction = 0.4\nweight = '35 N'\nheave = 'free'\n\
         forward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n";
    let frame = ["body.frame.mass=3.058104 kg", "body.frame.elevation=0.3 m"];
    let (single, gang) =
        (outlook(&case(one, &[]).unwrap()).unwrap(), outlook(&case(GANG, &frame).unwrap()).unwrap());
    assert_eq!(gang.input.bodies.len(), 2);
    let drag = |outlook: &coulter::forecast::Outlook| {
        outlook.recommended().unwrap().prediction.as_ref().unwrap().drag
    };
    let ratio = drag(&gang) / drag(&single);
    assert!((ratio / 2.0 - 1.0).abs() < 0.05, "{ratio}");
    assert!(gang.input.remarks.iter().any(|remark| remark.contains("shared equally among the 2 surfaces")));
}

#[test]
fn what_cannot_be_connected_is_refused() {
    for (sets, expected) in [
        (&["joint.left.bodies=['frame', 'lift']"][..], "did you mean \"left\"?"),
        (&["joint.left.bodies=['left', 'left']"], "two different bodies"),
        (&["joint.left.bodies=['left', 'ground']"], "the ground can only be the first"),
        (&["joint.left.bodies=['frame']"], "expected the names of two bodies"),
        (&["joint.left.kind=hing"], "did you mean \"hinge\"?"),
        (&["joint.left.stiffness=2 N/m"], "`stiffness` does not apply to kind = \"hinge\""),
        (&["joint.left.axis=[0, 0, 0]"], "the axis has no direction"),
        (&["joint.left.at=['0 m', '0 m']"], "a point has three coordinates"),
        (&["joint.left.kind=slider"], "`joint.left.axis` is missing"),
        (&["joint.left.kind=cable"], "`joint.left.stiffness` is missing"),
        (
            &["joint.left.bodies=['right', 'left']", "joint.right.bodies=['left', 'right']"],
            "carry each other in a ring",
        ),
        (&["body.left.y=-30 mm"], "`left` and `right` overlap at the start"),
        (&["body.frame.friction=0.3"], "a frame has no surface, and no `friction`"),
        (&["body.left.elevation=0.1 m"], "both say how high the body stands"),
        (
            &["body.left.welded_to=frame", "joint.left.bodies=['frame', 'left']"],
            "what is carried is the whole",
        ),
        (&["body.left.welded_to=fram"], "did you mean \"frame\"?"),
        (&["body.left.welded_to=right", "body.right.welded_to=left"], "welded to each other in a ring"),
        (&["body.left.welded_to=right", "body.left.heave=free"], "has no motions of its own"),
        (
            &["body.left.welded_to=right", "body.left.friction=0.2", "joint.left.bodies=['frame', 'right']"],
            "its friction differs",
        ),
        (&["body.ground.shape=frame", "body.ground.elevation=1 m"], "is what joints call the ground"),
    ] {
        let refusal = case(GANG, sets).unwrap_err().replace("\\\"", "\"");
        assert!(refusal.contains(expected), "{sets:?}: {refusal}");
    }
    let arm = format!(
        "{DISC}[joint.arm]\nkind = 'hinge'\nbodies = ['ground', 'disc']\nat = ['0.4 m', '0 m', '0.1 m']\naxis = [1, 0, 0]\n"
    );
    let half = ["domain.symmetric=true", "domain.y=['0 m', '0.24 m']", "grid.fine_y=['0 m', '0.24 m']"];
    let refusal = case(&arm, &half).unwrap_err();
    assert!(refusal.contains("in the plane of the tow only"), "{refusal}");
    let massless = GANG.replace("weight = '20 N'\n", "");
    let refusal = case(&massless, &[]).unwrap_err();
    assert!(refusal.contains("for a joint carries it, but its weight is not given"), "{refusal}");
}
