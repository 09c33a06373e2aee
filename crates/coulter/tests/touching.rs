//! Bodies that touch: on a block, over a stone, in a row; and what is refused.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{Case, parse};
use coulter::mechanics::{Mobility, Twist};
use coulter::run::watch::watch;
use coulter::simulation::{Command, Coupled, Simulation};

/// A small box of sand on coarse cells, with much air above.
const SAND: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
     [domain]\nx = ['-0.24 m', '0.24 m']\ny = ['0 m', '0.16 m']\nz = ['-0.16 m', '0.24 m']\nsymmetric = true\n[grid]\ncell = '20 mm'\ngrowth = 1\n\
     [run]\nduration = '1 s'\n[output]\nhistory_interval = '2 ms'\n";
/// A block that does not move, its top 60 mm above the sand.
const BLOCK: &str = "[body.block]\nshape = 'block'\nsize = ['0.3 m', '0.2 m', '0.1 m']\nfriction = 0.4\nsinkage = '40 mm'\n\
     forward = 'fixed'\nheave = 'fixed'\nspin = 'locked'\n";
/// A ball, 10 mm above it.
const BALL: &str = "[body.ball]\nshape = 'sphere'\ndiameter = '0.1 m'\nfriction = 0.3\nweight = '10 N'\nsinkage = '-70 mm'\n\
     heave = { load = '0 N', ramp = '0 s' }\n";
/// A stone that does not move, half of it above the sand, and a disc that is towed over it.
const STONE: &str = "[body.stone]\nshape = 'sphere'\ndiameter = '0.16 m'\nfriction = 0.4\nsinkage = '80 mm'\n\
     forward = 'fixed'\nheave = 'fixed'\nspin = 'locked'\n\
     [body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '60 mm'\nfriction = 0.3\nweight = '50 N'\nx = '-20 mm'\nsinkage = '-80 mm'\n\
     forward = { speed = '0.1 m/s', ramp = '20 ms' }\nheave = 'free'\nspin = 'free'\n\
     [joint.stone]\nkind = 'contact'\nbodies = ['stone', 'disc']\nfriction = 0.6\n";

fn case(bodies: &str, overrides: &[&str]) -> Result<Case, String> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    parse(&format!("{SAND}{bodies}"), "touching.toml", &overrides).map_err(|error| format!("{error:?}"))
}

fn contact(bodies: &str, more: &str) -> String {
    format!("{bodies}[joint.touch]\nkind = 'contact'\nbodies = ['block', 'ball']\nfriction = 0.4\n{more}")
}

#[test]
fn a_ball_falls_on_a_block_and_comes_to_rest() {
    let bodies = contact(&format!("{BLOCK}{BALL}"), "restitution = 0.5\n");
    for method in ["impulse", "penalty"] {
        let own = case(&bodies, &[&format!("numerics.contact={method}")]).unwrap();
        let mut simulation = Simulation::<f64>::new(&own);
        let (mut lowest, mut after, mut has_risen, mut fastest) = (f64::INFINITY, 0.0_f64, false, 0.0_f64);
        let mut middle = None;
        while simulation.state.time < 0.35 {
            simulation.steps(1).unwrap();
            let z = simulation.state.pose(1).position.z - 0.11;
            let speed = simulation.state.twist(1).linear.z;
            lowest = lowest.min(z);
            has_risen |= speed > 0.0 && lowest < 1e-4;
            if has_risen {
                after = after.max(z);
            } else {
                fastest = fastest.max(-speed);
            }
            if simulation.state.time > 0.1 && middle.is_none() {
                middle = Some(simulation.checkpoint().to_bytes().unwrap());
            }
        }
        assert!(lowest > -1e-9, "{lowest}");
        // It falls by 10 mm and rebounds to a quarter of that, from up to a step's way before it touches.
        let way = fastest * simulation.model.time_step();
        assert!((after - 2.5e-3).abs() < 1.1 * way, "{after}, not 2.5 mm within {way}");
        // What touches is not in the state: a run that goes on ends in the same bits.
        let mut resumed = Simulation::<f64>::new(&own);
        resumed.restore(&middle.unwrap()).unwrap();
        while resumed.state.step < simulation.state.step {
            resumed.steps(1).unwrap();
        }
        assert!(resumed.state.mechanism == simulation.state.mechanism);
        // At rest the block bears the weight.
        (0..2).for_each(|_| simulation.advance().unwrap());
        let force = simulation.history.joints[0].last().unwrap();
        assert!((force.force_z / 10.0 - 1.0).abs() < 1e-6, "{force:?}");
    }
}

#[test]
fn without_contact_a_ball_that_falls_on_a_block_ends_the_run() {
    let mut simulation = Simulation::<f64>::new(&case(&format!("{BLOCK}{BALL}"), &[]).unwrap());
    let failure = std::iter::from_fn(|| {
        simulation.advance().unwrap();
        Some(watch(&simulation))
    })
    .take(100)
    .find_map(Result::err);
    assert!(failure.unwrap().to_string().contains("let them touch, by a joint of kind \"contact\""));
}

#[test]
fn a_disc_is_towed_over_a_stone() {
    let mut simulation = Simulation::<f64>::new(&case(STONE, &[]).unwrap());
    let start = simulation.state.pose(1).position;
    while simulation.state.time < 0.5 {
        simulation.advance().unwrap();
        assert!(watch(&simulation).is_ok());
    }
    let now = simulation.state.pose(1).position;
    // Both centres are a sum of radii apart, but for the fall at the start.
    let middle = simulation.state.pose(0).position;
    let apart = |p: glam::DVec3| p.distance(middle) - 0.18;
    assert!(apart(start) > 1e-3 && apart(now).abs() < 1e-6, "{} {}", apart(start), apart(now));
    assert!(now.x > 0.025);
    // It rolls: the point of contact slips at less than a ten-thousandth of its speed.
    let twist = simulation.state.twist(1);
    let normal = (now - middle) / 0.18;
    let slip = twist.at(-0.1 * normal).length();
    assert!(slip < 1e-5, "{slip}");
    let force = simulation.history.joints[0].last().unwrap();
    assert!(force.force_z > 45.0 && force.force_z < 55.0, "{force:?}");
    let error = simulation.setting().closure(simulation.history.energy.last().unwrap());
    assert!(error.abs() < 1e-2, "{error}");
}

#[test]
fn a_row_of_balls_passes_on_the_drag_of_those_ahead() {
    let ball = |name: &str, x: f64, forward: &str| {
        format!(
            "[body.{name}]\nshape = 'sphere'\ndiameter = '0.1 m'\nfriction = 0.4\nweight = '10 N'\nsinkage = '10 mm'\nx = '{x} m'\n\
             forward = {forward}\nheave = 'free'\nlateral = 'fixed'\nspin = 'locked'\n"
        )
    };
    let bodies = [
        ball("a", -0.12, "{ speed = '0.1 m/s', ramp = '20 ms' }"),
        ball("b", -0.019, "'free'"),
        ball("c", 0.082, "'free'"),
        "[joint.ab]\nkind = 'contact'\nbodies = ['a', 'b']\nfriction = 0\n".to_owned(),
        "[joint.bc]\nkind = 'contact'\nbodies = ['b', 'c']\nfriction = 0\n".to_owned(),
    ];
    let mut simulation = Simulation::<f64>::new(&case(&bodies.concat(), &[]).unwrap());
    while simulation.state.time < 0.4 {
        simulation.advance().unwrap();
    }
    let history = &simulation.history;
    let later = |n: usize| history.joints[n].iter().filter(|sample| sample.time > 0.2);
    let mean = |n: usize| later(n).map(|s| s.force_x).sum::<f64>() / later(n).count() as f64;
    let drag = |n: usize| {
        let own = history.bodies[n].iter().filter(|sample| sample.time > 0.2);
        own.clone().map(|s| s.drag).sum::<f64>() / own.count() as f64
    };
    assert!(drag(2) > 1.0, "{}", drag(2));
    // But for the momentum that they gain or lose.
    assert!((mean(1) / drag(2) - 1.0).abs() < 0.05, "{} {}", mean(1), drag(2));
    assert!((mean(0) / (drag(1) + drag(2)) - 1.0).abs() < 0.05, "{} {}", mean(0), drag(1) + drag(2));
}

#[test]
fn what_cannot_touch_is_refused() {
    let both = format!("{BLOCK}{BALL}");
    for (bodies, overrides, words) in [
        (contact(&both, ""), &["joint.touch.friction=-1"][..], "friction"),
        (contact(&both, ""), &["joint.touch.restitution=1.5"], "restitution"),
        (
            contact(&both, ""),
            &["joint.touch.stiffness=2 N/m"],
            "`stiffness` does not apply to kind = \\\"contact\\\"",
        ),
        (contact(&both, ""), &["joint.touch.bodies=['ground', 'ball']"], "has no surface"),
        (contact(&both, ""), &["body.ball.heave=fixed"], "neither of the two can give way"),
        (
            contact(&both, "[joint.again]\nkind = 'contact'\nbodies = ['ball', 'block']\nfriction = 0.1\n"),
            &[],
            "they are in contact by [joint.touch] already",
        ),
        (both.clone() + "[joint.touch]\nkind = 'contact'\nbodies = ['block', 'ball']\n", &[], "friction"),
    ] {
        let refusal = case(&bodies, overrides).unwrap_err();
        assert!(refusal.contains(words), "`{words}` is not in {refusal}");
    }
    // What moves it would not know of the block.
    let mut simulation = Simulation::<f64>::new(&case(&contact(&both, ""), &[]).unwrap());
    let (pose, twist) = (*simulation.state.pose(1), Twist::ZERO);
    let coupled = Coupled { pose, twist, mobility: Mobility::default(), acceleration: twist };
    let refusal = simulation.step_until(0.01, &[(1, Command::Coupled(coupled))]).unwrap_err().to_string();
    assert!(refusal.contains("it has the joint `touch` here"), "{refusal}");
}

/// A free body that is pushed along with the grid was said to be left behind by it.
#[test]
fn a_body_that_is_pushed_along_may_go_farther_than_the_box_is_long() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/row_of_balls.toml");
    let far = coulter::case::load(path.as_ref(), &["run.tow_distance=3 m".to_owned()]);
    assert!(far.is_ok(), "{far:?}");
}
