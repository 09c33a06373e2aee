//! Observers of a run: what they are told, and how they end it.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{self, Case};
use coulter::simulation::{Next, Observer, ObserverError, Simulation, Stop};
use solver::error::{Breakdown, Location};
use solver::precision::Precision;
use std::cell::RefCell;

const COLUMN: &str = include_str!("../../../cases/column_collapse.toml");

/// A column of a few cells that collapses, with a sample every 20 ms.
fn column() -> Case {
    let coarse = ["grid.cell=50 mm", "run.duration=0.1 s", "output.history_interval=20 ms"];
    case::parse(COLUMN, "case.toml", &coarse.map(str::to_owned)).unwrap()
}

/// What the observers of a run were told, in order.
type Told = RefCell<Vec<String>>;

/// Writes down what it is told, except that it is asked between steps; answers each question as it is bidden.
struct Witness<'a> {
    name: &'static str,
    told: &'a Told,
    at_sample: fn(u64) -> Result<Next, ObserverError>,
    between: fn(u64) -> Result<Next, ObserverError>,
}

impl<'a> Witness<'a> {
    fn new(name: &'static str, told: &'a Told) -> Self {
        Self { name, told, at_sample: |_| Ok(Next::Continue), between: |_| Ok(Next::Continue) }
    }
}

impl<R: Precision> Observer<R> for Witness<'_> {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        let samples = simulation.history.energy.len();
        assert_eq!(simulation.history.energy[samples - 1].time, simulation.state.time);
        self.told.borrow_mut().push(format!("{} {samples}", self.name));
        (self.at_sample)(simulation.state.step)
    }

    fn between_steps(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        (self.between)(simulation.state.step)
    }

    fn ended(&mut self, _: &Simulation<R>, stop: &Stop) -> Result<(), ObserverError> {
        self.told.borrow_mut().push(format!("{} {stop:?}", self.name));
        Ok(())
    }
}

fn bits(simulation: &Simulation<impl Precision>) -> Vec<u8> {
    postcard::to_stdvec(&(&simulation.state, &simulation.history)).unwrap()
}

fn observers_change_no_bit<R: Precision>() {
    let mut alone = Simulation::<R>::new(&column());
    while !alone.is_done() {
        alone.advance().unwrap();
    }
    let told = Told::default();
    let mut observed = Simulation::<R>::new(&column());
    let (mut a, mut b) = (Witness::new("a", &told), Witness::new("b", &told));
    assert_eq!(observed.run(&mut [&mut a, &mut b]).unwrap(), Stop::Finished);
    assert!(bits(&observed) == bits(&alone));
    // The first sample is that of the start, before there was anyone to tell.
    let samples = (2..=6).flat_map(|n| [format!("a {n}"), format!("b {n}")]);
    let ends = ["a Finished", "b Finished"].map(str::to_owned);
    assert_eq!(told.into_inner(), samples.chain(ends).collect::<Vec<_>>());
}

#[test]
fn all_are_told_of_every_sample_and_change_nothing() {
    observers_change_no_bit::<f64>();
    observers_change_no_bit::<f32>();
}

#[test]
fn a_run_that_was_stopped_between_steps_goes_on_to_the_same_end() {
    let mut whole = Simulation::<f64>::new(&column());
    assert_eq!(whole.run(&mut []).unwrap(), Stop::Finished);
    let told = Told::default();
    let mut simulation = Simulation::<f64>::new(&column());
    let between =
        |step| Ok(if step == 7 { Next::Stop("the seventh step".to_owned()) } else { Next::Continue });
    let (mut a, mut b) = (Witness { between, ..Witness::new("a", &told) }, Witness::new("b", &told));
    let stop = simulation.run(&mut [&mut a, &mut b]).unwrap();
    assert_eq!((stop, simulation.state.step), (Stop::Asked("the seventh step".to_owned()), 7));
    assert_eq!(told.borrow().len(), 2, "both are told of the end: {told:?}");
    assert_eq!(simulation.run(&mut []).unwrap(), Stop::Finished);
    assert!(bits(&simulation) == bits(&whole));
    assert_eq!(simulation.run(&mut []).unwrap(), Stop::Finished, "there is nothing left to do");
    assert!(bits(&simulation) == bits(&whole));
}

#[test]
fn the_first_that_ends_a_run_decides() {
    let told = Told::default();
    let broken = |step| {
        let location = Location::UNKNOWN;
        let (what, cure) = ("nonsense".to_owned(), String::new());
        Ok(Next::BreakDown(Breakdown::Untrustworthy { what, cure, time: 0.0, step, location }))
    };
    let stopped = |_| Ok(Next::Stop("too late".to_owned()));
    let mut a = Witness::new("a", &told);
    let mut b = Witness { at_sample: broken, ..Witness::new("b", &told) };
    let mut c = Witness { at_sample: stopped, ..Witness::new("c", &told) };
    let stop = Simulation::<f64>::new(&column()).run(&mut [&mut a, &mut b, &mut c]).unwrap();
    assert!(matches!(stop, Stop::BrokenDown(Breakdown::Untrustworthy { .. })), "{stop:?}");
    let told = told.into_inner();
    assert_eq!(told[..2], ["a 2", "b 2"], "{told:?}");
    assert!(told.len() == 5 && told[4].starts_with("c BrokenDown"), "{told:?}");
}

#[test]
fn one_that_fails_ends_the_run_at_once() {
    let told = Told::default();
    let mut a = Witness::new("a", &told);
    let mut b = Witness { at_sample: |_| Err("no paper left".into()), ..Witness::new("b", &told) };
    let mut simulation = Simulation::<f64>::new(&column());
    let error = simulation.run(&mut [&mut a, &mut b]).unwrap_err();
    assert_eq!(error.to_string(), "no paper left");
    assert_eq!(told.into_inner(), ["a 2", "b 2"]);
    assert!(!simulation.is_done());
}
