//! A simulation that another program steps and steers.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{self, Case};
use coulter::simulation::{
    Command, Coupled, Exchange, ExchangeError, Reaction, Simulation, Steerer, Stop, Wish,
};
use coulter::trust::limits;
use glam::{DQuat, DVec3};
use mechanics::{Mobility, Pose, Twist, Wrench};
use solver::device::replay::Replay;
use solver::precision::Precision;
use std::f64::consts::TAU;

const DISC: &str = include_str!("../../../cases/light_disc.toml");

/// A disc of a few cells with a sample every 20 ms.
fn disc(set: &[&str]) -> Case {
    let coarse = [
        "grid.cell=25 mm",
        "body.disc.sinkage=30 mm",
        "body.disc.forward={ speed = \"0.2 m/s\", start = \"0 s\", ramp = \"0 s\" }",
        "run.tow_distance=30 mm",
        "output.history_interval=20 ms",
    ];
    let set: Vec<String> = coarse.iter().chain(set).map(|&one| one.to_owned()).collect();
    case::parse(DISC, "case.toml", &set).unwrap()
}

/// Free to sink, and let go at once.
const FREE: &str = "body.disc.heave={ load = \"0 N\", start = \"0 s\", ramp = \"0 s\" }";

fn bits(simulation: &Simulation<impl Precision>) -> Vec<u8> {
    simulation.checkpoint().to_bytes().unwrap()
}

fn along(x: f64, z: f64) -> DVec3 {
    DVec3::new(x, 0.0, z)
}

/// A twist in the plane of the disc.
fn twist(x: f64, z: f64, spin: f64) -> Twist {
    Twist { linear: along(x, z), angular: DVec3::new(0.0, spin, 0.0) }
}

/// Between exchanges that are whole steps apart, bodies that move as the case says do so to the bit.
fn own_motions_keep_their_bits<R: Precision>(numerics: &str) {
    let case = disc(&[numerics]);
    let mut alone = Simulation::<R>::new(&case);
    let mut stepped = Simulation::<R>::new(&case);
    let dt = alone.model.time_step();
    for number in [1, 7, 20, 3] {
        alone.advance_by(number);
        let next = stepped.state.time + f64::from(number) * dt;
        stepped.step_until(next, &[(0, Command::Own)]).unwrap();
        assert!(bits(&alone) == bits(&stepped));
    }
}

/// What is saved, restored and told in a run whose soil a device strains is what it is on the processor.
#[test]
fn a_device_keeps_the_bits_of_exchanges() {
    let case = disc(&[FREE]);
    let run = |device: Option<Replay>| {
        let mut simulation = Simulation::<f64>::new(&case);
        device.into_iter().for_each(|device| simulation.use_device(Box::new(device)).unwrap());
        let mut steerer = Saving::default();
        let stop = simulation.run_steered(&mut [], &mut steerer).unwrap();
        assert_eq!(stop, Stop::Finished);
        let at_end = bits(&simulation);
        simulation.step_until(simulation.state.time + 0.01, &[]).unwrap();
        (steerer.said, at_end, bits(&simulation))
    };
    assert!(run(None) == run(Some(Replay::default())));
}

/// Saves a state between two remaps, goes on, goes back to it, and looks at the ground.
#[derive(Default)]
struct Saving {
    wishes: usize,
    saved: Vec<u8>,
    said: Vec<String>,
}

impl Steerer for Saving {
    fn next(&mut self, exchange: Exchange) -> Wish {
        self.said.push(format!("{exchange:?}"));
        self.wishes += 1;
        match self.wishes {
            2 => Wish::Save,
            4 => Wish::Restore(self.saved.clone()),
            5 => Wish::Ground(vec![[0.05, 0.0], [0.1, 0.0]]),
            7 => Wish::Finish,
            _ => Wish::Until(exchange.time + 0.0123, Vec::new()),
        }
    }

    fn refused(&mut self, why: String) {
        panic!("{why}");
    }

    fn ground(&mut self, heights: Vec<Option<f64>>) {
        self.said.push(format!("{heights:?}"));
    }

    fn saved(&mut self, state: Vec<u8>) {
        self.saved = state;
        self.said.push(format!("{:?}", self.saved));
    }
}

/// Steps with the samples that are due.
trait AdvanceBy {
    fn advance_by(&mut self, number: u32);
}

impl<R: Precision> AdvanceBy for Simulation<R> {
    fn advance_by(&mut self, number: u32) {
        let dt = self.model.time_step();
        for _ in 0..number {
            self.step_until(self.state.time + dt, &[]).unwrap();
        }
    }
}

#[test]
fn own_motions_keep_their_bits_in_double_precision() {
    own_motions_keep_their_bits::<f64>("numerics.precision=double");
}

#[test]
fn own_motions_keep_their_bits_in_single_precision() {
    own_motions_keep_their_bits::<f32>("numerics.precision=single");
}

/// A run in one go has the bits of one in steps, and the samples.
#[test]
fn a_run_has_the_bits_of_its_steps() {
    let case = disc(&[]);
    let mut alone = Simulation::<f64>::new(&case);
    while !alone.is_done() {
        alone.advance().unwrap();
    }
    let mut stepped = Simulation::<f64>::new(&case);
    let dt = stepped.model.time_step();
    while !stepped.is_done() {
        let next = (stepped.state.time + 5.0 * dt).min(alone.state.time);
        stepped.step_until(next, &[]).unwrap();
    }
    assert!(bits(&alone) == bits(&stepped));
}

/// A twist from outside does what the same twist of the case does.
#[test]
fn a_twist_from_outside_is_that_of_a_case() {
    let fixed = [
        "body.disc.heave={ speed = \"-0.05 m/s\", start = \"0 s\", ramp = \"0 s\" }",
        "body.disc.spin={ speed = \"1 rad/s\", start = \"0 s\", ramp = \"0 s\" }",
    ];
    let mut alone = Simulation::<f64>::new(&disc(&fixed));
    let mut led = Simulation::<f64>::new(&disc(&[]));
    let dt = alone.model.time_step();
    let mut forces = DVec3::ZERO;
    for _ in 0..40 {
        let next = alone.state.time + 5.0 * dt;
        let own = alone.step_until(next, &[]).unwrap()[0];
        let reaction = led.step_until(next, &[(0, Command::Twist(twist(0.2, -0.05, 1.0)))]).unwrap()[0];
        let difference = (reaction.soil.force - own.soil.force).length();
        assert!(difference <= 1e-9 * own.soil.force.length().max(1.0), "{reaction:?} {own:?}");
        assert!(reaction.pose.position.distance(own.pose.position) < 1e-12);
        forces += reaction.soil.force;
    }
    assert!(forces.z > 40.0 && forces.x < 0.0, "{forces}");
    let [a, b] = [&alone, &led].map(|s| s.history.energy.last().unwrap().external);
    assert!((a - b).abs() < 1e-9 * a.abs(), "{a} {b}");
}

/// Exchanges need not be whole steps apart, and a body is then where it was to be, turned as it was to be.
#[test]
fn a_pose_is_reached_at_any_time() {
    let mut simulation = Simulation::<f64>::new(&disc(&[]));
    let start = *simulation.state.pose(0);
    let dt = simulation.model.time_step();
    for n in 1..=20 {
        let time = 0.0037 * f64::from(n);
        let turn = DQuat::from_rotation_y(0.02 * f64::from(n));
        let to = Pose {
            position: start.position + along(0.15 * time, -0.04 * time),
            rotation: turn * start.rotation,
        };
        let reaction = simulation.step_until(time, &[(0, Command::Pose(to))]).unwrap()[0];
        assert!((simulation.state.time - time).abs() < 1e-6 * dt);
        assert!(reaction.pose.position.distance(to.position) < 1e-9, "{reaction:?}");
        assert!(reaction.pose.rotation.angle_between(to.rotation) < 1e-7, "{reaction:?}");
    }
    assert!(simulation.state.step > 20);
    let exchanged = simulation.trust(None);
    let check = exchanged.checks.iter().find(|check| check.name == limits::EXCHANGE.name).unwrap();
    assert!(check.value.unwrap() < limits::EXCHANGE.good, "{check:?}");
}

/// A body of another program with mass and moment of inertia, integrated there by symplectic Euler.
struct Client {
    mass: f64,
    inertia: f64,
    pose: Pose,
    twist: Twist,
}

impl Client {
    fn of(simulation: &Simulation, mass: f64) -> Self {
        let pose = *simulation.state.pose(0);
        Self { mass, inertia: 0.5 * mass * 0.01, pose, twist: twist(0.2, 0.0, 0.0) }
    }

    /// As it stands; nothing but the soil holds it up.
    fn coupled(&self) -> Coupled {
        let mut rows = [[0.0; 6]; 6];
        rows[2][2] = 1.0 / self.mass;
        rows[4][4] = 1.0 / self.inertia;
        Coupled {
            pose: self.pose,
            twist: self.twist,
            mobility: Mobility::of(&rows).unwrap(),
            acceleration: twist(0.0, -9.81, 0.0),
        }
    }

    fn integrate(&mut self, reaction: &Reaction, interval: f64) {
        let Wrench { force, moment } = reaction.soil;
        self.twist.linear.z += interval * (force.z / self.mass - 9.81);
        self.twist.angular.y += interval * moment.y / self.inertia;
        self.pose = self.pose.moved(&self.twist, interval);
    }
}

/// Sinkage, mean soil force and spin of a disc that another program moves for a while.
fn moved_elsewhere(cell: &str, mass: f64, steps: f64) -> (f64, f64, f64, f64) {
    let mut simulation = Simulation::<f64>::new(&disc(&[cell, "run.tow_distance=60 mm"]));
    let mut client = Client::of(&simulation, mass);
    let interval = steps * simulation.model.time_step();
    let (mut time, mut impulse, mut last) = (0.0, 0.0, 0.0);
    let mut reaction = None;
    while time + interval < 0.25 {
        time += interval;
        let now = simulation.step_until(time, &[(0, Command::Coupled(client.coupled()))]).unwrap()[0];
        client.integrate(&now, interval);
        impulse += interval * now.soil.force.z;
        last = now.sinkage;
        reaction = Some(now);
    }
    assert!(client.pose.position.distance(reaction.unwrap().pose.position) < 1e-4);
    let trust = simulation.trust(None);
    let value = |limit: &limits::Limit| {
        trust.checks.iter().find(|check| check.name == limit.name).unwrap().value.unwrap()
    };
    assert!(value(&limits::EXCHANGE) < 1.0, "{}", value(&limits::EXCHANGE));
    assert!(value(&limits::ENERGY_BALANCE) < 1.0, "{}", value(&limits::ENERGY_BALANCE));
    (last, impulse / time, client.twist.angular.y, client.twist.linear.z)
}

/// Wider cells scatter by some per cent, whoever moves the body.
const FINE: &str = "grid.cell=16.6667 mm";

/// A body that another program integrates moves as one that the solver does.
#[test]
fn a_coupled_body_moves_as_one_of_the_case() {
    let mass = 40.0 / 9.81;
    let case = disc(&[FINE, FREE, "run.tow_distance=60 mm"]);
    let mut alone = Simulation::<f64>::new(&case);
    let dt = alone.model.time_step();
    let mut impulse = 0.0;
    let mut reaction = None;
    while alone.state.time + dt < 0.25 {
        let now = alone.step_until(alone.state.time + dt, &[]).unwrap()[0];
        impulse += dt * now.soil.force.z;
        reaction = Some(now);
    }
    let own = reaction.unwrap();
    for steps in [1.0, 4.0] {
        let (sinkage, force, spin, _) = moved_elsewhere(FINE, mass, steps);
        let near =
            |a: f64, b: f64, within: f64| assert!((a - b).abs() < within * b.abs(), "{steps}: {a} {b}");
        near(sinkage, own.sinkage, 0.01);
        near(force, impulse / alone.state.time, 0.01);
        near(spin, own.twist.angular.y, 0.1);
    }
}

/// A body much lighter than the soil that moves with it: forces of the last exchange would throw it about.
#[test]
fn a_light_body_comes_to_rest_on_the_soil() {
    let (_, force, _, speed) = moved_elsewhere("grid.cell=25 mm", 0.05, 3.0);
    assert!((force - 0.05 * 9.81).abs() < 0.1 * 0.05 * 9.81, "{force}");
    assert!(speed.abs() < 5e-3, "{speed}");
}

/// A load from outside is one of the case.
#[test]
fn a_load_from_outside_presses() {
    let free = [FREE, "run.tow_distance=60 mm"];
    let run = |load: Wrench| {
        let mut simulation = Simulation::<f64>::new(&disc(&free));
        let mut reaction = None;
        for n in 1..=25 {
            let command = [(0, Command::Load(load))];
            reaction = Some(simulation.step_until(0.01 * f64::from(n), &command).unwrap()[0]);
        }
        reaction.unwrap().sinkage
    };
    let pressed = Wrench { force: along(0.0, -40.0), moment: DVec3::ZERO };
    let own = run_of_case("body.disc.heave={ load = \"-40 N\", start = \"0 s\", ramp = \"0 s\" }");
    assert!((run(pressed) - own).abs() < 1e-3 * own, "{} {own}", run(pressed));
    assert!(run(Wrench::ZERO) < run(pressed));
}

/// Sinkage after 0.25 s of a disc that the case moves.
fn run_of_case(heave: &str) -> f64 {
    let mut simulation = Simulation::<f64>::new(&disc(&[heave, "run.tow_distance=60 mm"]));
    (1..=25).fold(0.0, |_, n| simulation.step_until(0.01 * f64::from(n), &[]).unwrap()[0].sinkage)
}

/// What was saved goes on to the bit, in the same simulation and in another, whoever moves the bodies.
#[test]
fn a_saved_state_goes_on_to_the_bit() {
    let case = disc(&[]);
    let mut simulation = Simulation::<f64>::new(&case);
    let commands = |n: u32| match n % 3 {
        0 => Command::Twist(twist(0.1, -0.05, 1.0)),
        1 => Command::Own,
        _ => Command::Load(Wrench { force: along(1.0, -5.0), moment: DVec3::ZERO }),
    };
    let go = |simulation: &mut Simulation<f64>, numbers: std::ops::Range<u32>| {
        for n in numbers {
            simulation.step_until(0.0023 * f64::from(n + 1), &[(0, commands(n))]).unwrap();
        }
    };
    for at in [0, 4, 5, 6] {
        let mut simulation = Simulation::<f64>::new(&case);
        go(&mut simulation, 0..at);
        let saved = bits(&simulation);
        go(&mut simulation, at..12);
        let end = bits(&simulation);
        simulation.restore(&saved).unwrap();
        go(&mut simulation, at..12);
        assert!(end == bits(&simulation), "{at}");
        let mut other = Simulation::<f64>::new(&case);
        other.restore(&saved).unwrap();
        go(&mut other, at..12);
        assert!(end == bits(&other), "{at}");
    }
    go(&mut simulation, 0..2);
    let saved = bits(&simulation);
    let mut other = Simulation::<f64>::new(&disc(&["soil.friction_angle=36 deg"]));
    assert!(other.restore(&saved).unwrap_err().to_string().contains("another case"));
    assert!(other.restore(&saved[..100]).is_err());
    assert!(Simulation::<f32>::new(&disc(&["numerics.precision=single"])).restore(&saved).is_err());
}

#[test]
fn what_cannot_be_done_is_refused_and_changes_nothing() {
    let mut simulation = Simulation::<f64>::new(&disc(&[]));
    simulation.step_until(0.01, &[]).unwrap();
    let before = bits(&simulation);
    let mut refused = |time: f64, commands: &[(usize, Command)], why: &str| {
        match simulation.step_until(time, commands) {
            Err(ExchangeError::Request(said)) => assert!(said.contains(why), "{said}"),
            other => panic!("{why}: {other:?}"),
        }
        assert!(bits(&simulation) == before, "{why}");
    };
    refused(0.01, &[], "is not after the present time");
    refused(f64::NAN, &[], "is not after the present time");
    refused(9.0, &[], "run.duration");
    refused(0.02, &[(1, Command::Own)], "no body number 1");
    let sideways = Twist { linear: DVec3::new(0.2, 0.1, 0.0), angular: DVec3::ZERO };
    refused(0.02, &[(0, Command::Twist(sideways))], "along y");
    let yaw = Twist { linear: DVec3::ZERO, angular: DVec3::Z };
    refused(0.02, &[(0, Command::Twist(yaw))], "in yaw");
    refused(0.02, &[(0, Command::Twist(twist(f64::NAN, 0.0, 0.0)))], "a number is missing");
    refused(0.02, &[(0, Command::Twist(twist(0.0, 0.0, 1e5)))], "in a step");
    let zero = Pose { position: DVec3::ZERO, rotation: DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0) };
    refused(0.02, &[(0, Command::Pose(zero))], "no rotation");
    let far = Coupled {
        pose: Pose::at(DVec3::new(0.0, 0.0, 1.0)),
        twist: Twist::ZERO,
        mobility: Mobility::default(),
        acceleration: Twist::ZERO,
    };
    refused(0.02, &[(0, Command::Coupled(far))], "exchange more often");
    let mut rows = [[0.0; 6]; 6];
    rows[0][1] = 1.0;
    assert_eq!(Mobility::of(&rows), None);
    rows[1][0] = 1.0;
    assert_eq!(Mobility::of(&rows), None);
}

/// A body that is led out of the box ends the simulation with its name.
#[test]
fn a_body_that_is_led_out_of_the_box_is_named() {
    let mut simulation = Simulation::<f64>::new(&disc(&["run.tow_distance=600 mm"]));
    let ended = (1..40).find_map(|n| {
        let back = Command::Twist(twist(-1.0, 0.0, 0.0));
        simulation.step_until(0.02 * f64::from(n), &[(0, back)]).err()
    });
    let said = ended.unwrap().to_string();
    assert!(said.contains("disc") && said.contains("behind"), "{said}");
}

const FIELD: &str = include_str!("../../../cases/furrowed_field.toml");

/// A disc above furrows on a coarse grid.
fn field(set: &[&str]) -> Case {
    let coarse = ["grid.cell=12 mm", "run.tow_distance=0.3 m"];
    let set: Vec<String> = coarse.iter().chain(set).map(|&one| one.to_owned()).collect();
    case::parse(FIELD, "case.toml", &set).unwrap()
}

/// Height of the furrows in front of the disc of `field`, at most this far from their formula [m].
fn furrows_are_sensed(simulation: &Simulation<impl Precision>, within: f64) {
    let x = simulation.state.pose(0).position.x;
    let places: Vec<[f64; 2]> = (0..40).map(|n| [x + 0.15 + 0.004 * f64::from(n), 0.01]).collect();
    let heights = simulation.ground(&places);
    let formula = |x: f64| 0.01 * (TAU * x / 0.2).cos();
    let off = places.iter().zip(&heights).map(|([x, _], height)| (height.unwrap() - formula(*x)).abs());
    let most = off.fold(0.0, f64::max);
    println!("{} s: {most:.5} m", simulation.state.time);
    assert!(most < within, "{most}");
    // The furrows run straight across the plane of symmetry.
    let mirrored: Vec<[f64; 2]> = places.iter().map(|[x, y]| [*x, -y]).collect();
    assert_eq!(simulation.ground(&mirrored), heights);
}

/// Furrows are sensed as they are, at the start and under a grid that has travelled; level ground exactly.
fn ground_is_sensed<R: Precision>(numerics: &str) {
    let level = Simulation::<R>::new(&disc(&[numerics]));
    let heights = level.ground(&[[0.25, 0.1], [-0.3, -0.1], [0.25, 9.0], [9.0, 0.0], [f64::NAN, 0.0]]);
    assert_eq!(heights, [Some(0.0), Some(0.0), None, None, None]);
    // Cells are 24 mm wide, an eighth of a furrow, and 12 mm high.
    let mut simulation = Simulation::<R>::new(&field(&[numerics]));
    furrows_are_sensed(&simulation, 0.002);
    let ahead = simulation.case.domain.high.x + 0.05;
    assert_eq!(simulation.ground(&[[ahead, 0.0]]), [None]);
    while simulation.state.grid_position.x < 0.1 {
        let next = simulation.state.time + 0.02;
        let forward = Command::Twist(Twist { linear: along(0.5, 0.0), angular: DVec3::ZERO });
        simulation.step_until(next, &[(0, forward)]).unwrap();
    }
    furrows_are_sensed(&simulation, 0.003);
    assert!(simulation.ground(&[[ahead, 0.0]])[0].is_some());
}

#[test]
fn ground_is_sensed_in_double_precision() {
    ground_is_sensed::<f64>("numerics.precision=double");
}

#[test]
fn ground_is_sensed_in_single_precision() {
    ground_is_sensed::<f32>("numerics.precision=single");
}

/// A disc that is led through the soil leaves a groove behind, and none in front; to look at it changes no
/// bit.
#[test]
fn a_groove_is_sensed_and_the_run_goes_on_as_without() {
    let case = disc(&[FINE, "run.tow_distance=0.25 m"]);
    let [mut watched, mut alone] = [(); 2].map(|()| Simulation::<f64>::new(&case));
    let along_x = |simulation: &Simulation<f64>, x: f64| {
        let x = simulation.state.pose(0).position.x + x;
        simulation.ground(&[[x, 0.0], [x, 0.28]])
    };
    for n in 1..=40 {
        let forward = [(0, Command::Twist(twist(0.5, 0.0, 2.5)))];
        watched.step_until(0.01 * f64::from(n), &forward).unwrap();
        assert!(along_x(&watched, 0.2).iter().all(Option::is_some));
        alone.step_until(0.01 * f64::from(n), &forward).unwrap();
    }
    assert!(bits(&watched) == bits(&alone));
    let [behind, ahead] = [-0.1, 0.22].map(|x| along_x(&watched, x)[0].unwrap());
    println!("behind {behind} m, in front {ahead} m");
    assert!(behind < -0.01 && behind > -0.035 && ahead.abs() < 0.002, "{behind} {ahead}");
}
