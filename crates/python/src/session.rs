//! `coulter.Simulation`: a run on a thread of its own, which waits at every exchange for what the calling
//! thread wants.

use crate::attend::ask_to_stop;
use crate::failure::{internal, raised, refused};
use crate::run::start;
use crate::source::{Source, SourceText, count, device, request};
use coulter::interrupts::Interrupts;
use coulter::mechanics::{Mobility, Pose, Twist, Wrench};
use coulter::session::{Said, Session as Line};
use coulter::simulation::{Command, Coupled, Exchange, Reaction, Wish};
use coulter_cli::{Failure, PreparedRun, RunRequest, graded};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::Deserialize;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::Duration;

/// How long the calling thread waits before it looks for signals again.
const PATIENCE: Duration = Duration::from_millis(50);

/// The call that begins a simulation, as the Python part writes it.
#[derive(Debug, Deserialize)]
struct SessionCall {
    source: Source,
    set: Vec<String>,
    output: Option<PathBuf>,
    start: String,
    threads: Option<i64>,
    device: String,
}

/// How a body moves until the next exchange, as the Python part writes it; quaternions begin with their real
/// part.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CommandCall {
    Load { force: [f64; 3], moment: [f64; 3] },
    Twist(TwistCall),
    Pose(PoseCall),
    Coupled { pose: PoseCall, twist: TwistCall, mobility: [[f64; 6]; 6], acceleration: TwistCall },
}

#[derive(Debug, Deserialize)]
struct TwistCall {
    linear: [f64; 3],
    angular: [f64; 3],
}

#[derive(Debug, Deserialize)]
struct PoseCall {
    position: [f64; 3],
    quaternion: [f64; 4],
}

impl From<TwistCall> for Twist {
    fn from(TwistCall { linear, angular }: TwistCall) -> Self {
        Self { linear: linear.into(), angular: angular.into() }
    }
}

impl From<PoseCall> for Pose {
    fn from(PoseCall { position, quaternion: [w, x, y, z] }: PoseCall) -> Self {
        let mut pose = Self::at(position.into());
        (pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w) = (x, y, z, w);
        pose
    }
}

impl CommandCall {
    fn command(self) -> PyResult<Command> {
        Ok(match self {
            Self::Load { force, moment } => {
                Command::Load(Wrench { force: force.into(), moment: moment.into() })
            }
            Self::Twist(twist) => Command::Twist(twist.into()),
            Self::Pose(pose) => Command::Pose(pose.into()),
            Self::Coupled { pose, twist, mobility, acceleration } => Command::Coupled(Coupled {
                pose: pose.into(),
                twist: twist.into(),
                mobility: Mobility::of(&mobility).ok_or_else(|| {
                    refused("the mobility must be symmetric and positive semi-definite: J M⁻¹ Jᵀ")
                })?,
                acceleration: acceleration.into(),
            }),
        })
    }
}

/// A simulation that Python steers.
#[pyclass]
pub(crate) struct Session {
    folder: PathBuf,
    names: Vec<String>,
    interrupts: Interrupts,
    /// The way to the run while it is on.
    line: Mutex<Option<Line<Result<(), Failure>>>>,
}

/// Time, longest step, and of every body force, moment, position, quaternion, velocity, angular velocity,
/// sinkage and work.
type Standing = (f64, f64, Vec<Vec<f64>>);

#[pymethods]
impl Session {
    /// Begins a run, or goes on with one. `warn(text)` gets the warnings before it begins.
    #[new]
    fn new(py: Python<'_>, call: &str, warn: Bound<'_, PyAny>) -> PyResult<Self> {
        let SessionCall { source, set, output, start: word, threads, device: strained_by } = request(call)?;
        let SourceText { text, name } = source.text()?;
        let wanted = RunRequest {
            text,
            source_name: name,
            overrides: set,
            output,
            start: start(&word)?,
            threads: count("threads", threads)?,
            variations: None,
            accuracy: None,
            quiet: true,
            device: device(&strained_by)?,
        };
        let prepared = py.detach(|| wanted.prepare()).map_err(|failure| raised(&failure))?;
        for warning in &prepared.warnings {
            warn.call1((warning,))?;
        }
        let folder = prepared.folder.clone();
        let names = prepared.case.bodies.iter().map(|body| body.name.clone()).collect();
        let interrupts = Interrupts::default();
        let line = Mutex::new(Some(begin(prepared, interrupts.clone())));
        Ok(Self { folder, names, interrupts, line })
    }

    /// Names of the bodies, in the order of the case.
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    /// The results folder.
    fn folder(&self) -> PathBuf {
        self.folder.clone()
    }

    /// How the run stands at its start.
    fn standing(&self, py: Python<'_>) -> PyResult<Standing> {
        self.next_exchange(py)
    }

    /// Goes on to a time [s] with commands by the number of the body, as JSON.
    fn step(&self, py: Python<'_>, until: f64, commands: &str) -> PyResult<Standing> {
        let commands: Vec<(usize, CommandCall)> = request(commands)?;
        let commands = commands.into_iter().map(|(body, call)| Ok((body, call.command()?)));
        self.wish(Wish::Until(until, commands.collect::<PyResult<_>>()?))?;
        self.next_exchange(py)
    }

    /// Heights of the ground [m] at places (x, y) [m]; not a number outside the grid.
    fn ground(&self, py: Python<'_>, places: Vec<[f64; 2]>) -> PyResult<Vec<f64>> {
        self.wish(Wish::Ground(places))?;
        let Said::Ground(heights) = self.hear(py)? else { return Err(internal()) };
        self.next_exchange(py)?;
        Ok(heights.into_iter().map(|height| height.unwrap_or(f64::NAN)).collect())
    }

    /// The state, from which `restore` goes on.
    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.wish(Wish::Save)?;
        let Said::Saved(state) = self.hear(py)? else { return Err(internal()) };
        self.next_exchange(py)?;
        Ok(PyBytes::new(py, &state))
    }

    /// Goes back, or on, to a state that was saved.
    fn restore(&self, py: Python<'_>, state: Vec<u8>) -> PyResult<Standing> {
        self.wish(Wish::Restore(state))?;
        self.next_exchange(py)
    }

    /// Ends the run, as one that has finished or that can be resumed: the results folder, how it ended
    /// (`finished`, `stopped` or `broken`), and of a broken one why.
    fn end(&self, py: Python<'_>, finishes: bool) -> PyResult<(PathBuf, &'static str, String)> {
        self.wish(if finishes { Wish::Finish } else { Wish::Stop })?;
        let Said::Ended(end) = self.hear(py)? else { return Err(internal()) };
        self.hang_up(py);
        match end {
            Ok(()) => Ok((self.folder.clone(), "finished", String::new())),
            Err(Failure::Stopped { .. }) => Ok((self.folder.clone(), "stopped", String::new())),
            Err(Failure::Physics(why)) => Ok((self.folder.clone(), "broken", why)),
            Err(failure) => Err(raised(&failure)),
        }
    }
}

impl Session {
    fn wish(&self, wish: Wish) -> PyResult<()> {
        let line = self.line.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let line = line.as_ref().ok_or_else(|| refused("the simulation has ended"))?;
        line.wish(wish);
        Ok(())
    }

    /// What the run says next, without the interpreter's lock meanwhile. Ctrl-C stops it at its next sample.
    fn hear(&self, py: Python<'_>) -> PyResult<Said<Result<(), Failure>>> {
        loop {
            let heard = py.detach(|| {
                let line = self.line.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                line.as_ref().map(|line| line.hear(PATIENCE))
            });
            match heard {
                None => return Err(refused("the simulation has ended")),
                Some(Ok(Some(said))) => return Ok(said),
                Some(Ok(None)) => {}
                Some(Err(_)) => return Err(internal()),
            }
            if let Err(error) = py.check_signals() {
                ask_to_stop(&self.interrupts);
                let _ = self.wish(Wish::Stop);
                self.hang_up(py);
                return Err(error);
            }
        }
    }

    /// Waits for the end of the run.
    fn hang_up(&self, py: Python<'_>) {
        let line = self.line.lock().unwrap_or_else(std::sync::PoisonError::into_inner).take();
        py.detach(|| drop(line));
    }

    fn next_exchange(&self, py: Python<'_>) -> PyResult<Standing> {
        match self.hear(py)? {
            Said::At(Exchange { time, time_step, reactions }) => {
                Ok((time, time_step, reactions.iter().map(numbers).collect()))
            }
            Said::Refused(why) => {
                // It asks for the next wish.
                self.hear(py)?;
                Err(refused(why))
            }
            Said::Saved(_) | Said::Ground(_) => Err(internal()),
            Said::Ended(end) => {
                self.hang_up(py);
                Err(end.err().map_or_else(|| refused("the simulation has ended"), |failure| raised(&failure)))
            }
        }
    }
}

/// Begins a run on a thread of its own.
fn begin(prepared: PreparedRun, interrupts: Interrupts) -> Line<Result<(), Failure>> {
    Line::begin(move |steerer| {
        prepared.run_steered(&interrupts, steerer).and_then(|summary| graded(&summary))
    })
}

fn numbers(reaction: &Reaction) -> Vec<f64> {
    let Reaction { soil, pose, twist, sinkage, work } = reaction;
    let vectors = |a: [f64; 3], b: [f64; 3]| [a, b].concat();
    let turned = pose.rotation;
    [
        vectors(soil.force.into(), soil.moment.into()),
        pose.position.to_array().to_vec(),
        vec![turned.w, turned.x, turned.y, turned.z],
        vectors(twist.linear.into(), twist.angular.into()),
        vec![*sinkage, *work],
    ]
    .concat()
}
