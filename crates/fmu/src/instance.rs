//! An instance of an FMU as an importer drives it, without the pointers of the interface.

use crate::fmu::{Ended, Fmu};
use crate::variables::{Causality, FIRST_NUMBER, FIRST_TEXT, OUTPUT, SET, TEXTS, TIME, Variable};
use crate::variables::{command, numbers};
use coulter::session::{Said, Session};
use coulter::simulation::{Command, Exchange, Wish};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Where an instance is between its beginning and its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Phase {
    Instantiated,
    Initializing,
    Stepping,
    Terminated,
    /// The run has failed; a reset or an earlier state helps.
    Failed,
}

/// How bad it is that a call was not fulfilled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Nothing has happened; another step may be tried.
    Discard,
    /// The instance must be reset, or set back to an earlier state.
    Error,
}

/// Why a call was not fulfilled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// How bad it is.
    pub severity: Severity,
    /// For whoever reads the log.
    pub message: String,
}

impl Refusal {
    /// An error.
    pub fn error(message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, message: message.into() }
    }
}

/// The state of an instance, to which it can be set back.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Saved {
    token: String,
    phase: Phase,
    texts: [String; TEXTS.len()],
    numbers: Vec<f64>,
    time: f64,
    stop_time: Option<f64>,
    /// That of the run, once it has begun.
    state: Option<Vec<u8>>,
}

/// An instance of an FMU.
#[derive(Debug)]
pub struct Instance {
    fmu: Fmu,
    phase: Phase,
    texts: [String; TEXTS.len()],
    variables: Vec<Variable>,
    numbers: Vec<f64>,
    time: f64,
    /// Longest step of the solver [s].
    time_step: f64,
    stop_time: Option<f64>,
    session: Option<Session<Ended>>,
    /// What whoever reads the log may want to know.
    pub notes: Vec<String>,
}

impl Instance {
    /// An instance of an FMU whose description has this token.
    ///
    /// # Errors
    /// An FMU that is not that of the description, or that cannot be simulated.
    pub fn new(fmu: Fmu, token: &str) -> Result<Self, Refusal> {
        if token != fmu.token() {
            let own = fmu.token();
            let message = format!("the description is that of another FMU: {token} is not {own}");
            return Err(Refusal::error(message));
        }
        let start = fmu.at_start().map_err(|error| Refusal::error(error.to_string()))?;
        let variables = fmu.variables(&start);
        Ok(Self {
            phase: Phase::Instantiated,
            texts: Default::default(),
            numbers: variables.iter().map(|variable| variable.start).collect(),
            variables,
            time: 0.0,
            time_step: start.time_step,
            stop_time: None,
            session: None,
            notes: Vec::new(),
            fmu,
        })
    }

    /// The value of a number.
    ///
    /// # Errors
    /// There is no such number, or the case with the keys that were set is wrong.
    pub fn number(&mut self, reference: u32) -> Result<f64, Refusal> {
        if self.phase == Phase::Initializing {
            self.begin()?;
        }
        if reference == TIME {
            return Ok(self.time);
        }
        let number = reference.checked_sub(FIRST_NUMBER).and_then(|n| self.numbers.get(n as usize));
        number.copied().ok_or_else(|| Refusal::error(format!("there is no number {reference}")))
    }

    /// Sets an input.
    ///
    /// # Errors
    /// There is no such input, or the value is none.
    pub fn set_number(&mut self, reference: u32, value: f64) -> Result<(), Refusal> {
        let n = reference.checked_sub(FIRST_NUMBER).map(|n| n as usize);
        match n.and_then(|n| self.variables.get(n).zip(self.numbers.get_mut(n))) {
            Some((variable, number)) if variable.causality == Causality::Input => {
                if !value.is_finite() {
                    return Err(Refusal::error(format!("{} = {value}", variable.name)));
                }
                *number = value;
                Ok(())
            }
            _ => Err(Refusal::error(format!("there is no input {reference}"))),
        }
    }

    /// The value of a text.
    ///
    /// # Errors
    /// There is no such text.
    pub fn text(&self, reference: u32) -> Result<&str, Refusal> {
        let text = reference.checked_sub(FIRST_TEXT).and_then(|n| self.texts.get(n as usize));
        text.map(String::as_str).ok_or_else(|| Refusal::error(format!("there is no text {reference}")))
    }

    /// Sets a text, as long as the run has not begun.
    ///
    /// # Errors
    /// There is no such text, or the run has begun.
    pub fn set_text(&mut self, reference: u32, value: &str) -> Result<(), Refusal> {
        if self.session.is_some() || !matches!(self.phase, Phase::Instantiated | Phase::Initializing) {
            return Err(Refusal::error("parameters can be set before the end of initialisation only"));
        }
        let text = reference.checked_sub(FIRST_TEXT).and_then(|n| self.texts.get_mut(n as usize));
        value.clone_into(text.ok_or_else(|| Refusal::error(format!("there is no text {reference}")))?);
        Ok(())
    }

    /// Begins initialisation.
    ///
    /// # Errors
    /// A run that does not begin at 0, or a call out of turn.
    pub fn enter_initialization(&mut self, start_time: f64, stop_time: Option<f64>) -> Result<(), Refusal> {
        self.require(Phase::Instantiated)?;
        if start_time != 0.0 {
            return Err(Refusal::error(format!("a case begins at 0 s, not at {start_time} s")));
        }
        self.stop_time = stop_time;
        self.phase = Phase::Initializing;
        Ok(())
    }

    /// Ends initialisation: the run begins.
    ///
    /// # Errors
    /// The case with the keys that were set is wrong, its folder cannot be written, or a call out of turn.
    pub fn exit_initialization(&mut self) -> Result<(), Refusal> {
        self.require(Phase::Initializing)?;
        self.begin()?;
        self.phase = Phase::Stepping;
        Ok(())
    }

    /// Goes on from a time by a step [s].
    ///
    /// # Errors
    /// [`Severity::Discard`] where the step cannot be taken, and the instance stands as before.
    pub fn step(&mut self, from: f64, step: f64) -> Result<(), Refusal> {
        self.require(Phase::Stepping)?;
        if (from - self.time).abs() > 1e-3 * self.time_step {
            return Err(Refusal::error(format!("the instance is at {} s, not at {from} s", self.time)));
        }
        let commands = self.commands().map_err(discarded)?;
        self.wish(Wish::Until(from + step, commands))?;
        // Without the round-off of the steps on the way.
        self.time = from + step;
        Ok(())
    }

    /// Ends the run: its results are those of a finished one.
    ///
    /// # Errors
    /// Results that must not be used or could not be written, or a call out of turn.
    pub fn terminate(&mut self) -> Result<(), Refusal> {
        if !matches!(self.phase, Phase::Initializing | Phase::Stepping) {
            return Err(self.out_of_turn());
        }
        self.phase = Phase::Terminated;
        if self.session.is_none() {
            return Ok(());
        }
        self.wish(Wish::Finish)
    }

    /// Back to the beginning.
    pub fn reset(&mut self) {
        self.session = None;
        self.phase = Phase::Instantiated;
        self.texts = Default::default();
        self.numbers = self.variables.iter().map(|variable| variable.start).collect();
        (self.time, self.stop_time) = (0.0, None);
    }

    /// The state, to which [`Instance::restore`] goes back.
    ///
    /// # Errors
    /// A run that has failed.
    pub fn save(&mut self) -> Result<Saved, Refusal> {
        let state = match &self.session {
            None => None,
            Some(session) => {
                session.wish(Wish::Save);
                let Ok(Said::Saved(state)) = session.wait() else {
                    return Err(self.failed("the run has ended"));
                };
                // Where it stands has not changed.
                let time = self.time;
                self.hear()?;
                self.time = time;
                Some(state)
            }
        };
        Ok(Saved {
            token: self.fmu.token(),
            phase: self.phase,
            texts: self.texts.clone(),
            numbers: self.numbers.clone(),
            time: self.time,
            stop_time: self.stop_time,
            state,
        })
    }

    /// Goes back, or on, to a state that was saved.
    ///
    /// # Errors
    /// A state of another FMU, or one that was damaged.
    pub fn restore(&mut self, saved: &Saved) -> Result<(), Refusal> {
        let lacks_run = saved.phase == Phase::Stepping && saved.state.is_none();
        if saved.token != self.fmu.token() || saved.numbers.len() != self.numbers.len() || lacks_run {
            return Err(Refusal::error("this is no state of this FMU"));
        }
        if saved.state.is_none() || self.texts != saved.texts {
            self.session = None;
        }
        self.texts.clone_from(&saved.texts);
        (self.time, self.stop_time) = (saved.time, saved.stop_time);
        if let Some(state) = &saved.state {
            self.begin()?;
            self.wish(Wish::Restore(state.clone()))?;
        }
        self.phase = saved.phase;
        self.time = saved.time;
        self.numbers.clone_from(&saved.numbers);
        Ok(())
    }

    /// Begins the run, if it has not begun.
    fn begin(&mut self) -> Result<(), Refusal> {
        if self.session.is_some() {
            return Ok(());
        }
        let mut fmu = self.fmu.with(&self.texts[SET]).map_err(Refusal::error)?;
        if let Some(stop_time) = self.stop_time {
            // The importer says how long it goes on.
            fmu.case.duration = fmu.case.duration.max(stop_time);
        }
        let output = Some(&self.texts[OUTPUT]).filter(|folder| !folder.is_empty()).map(PathBuf::from);
        self.session = Some(fmu.begin(output));
        self.hear()
    }

    /// What the inputs command.
    fn commands(&self) -> Result<Vec<(usize, Command)>, String> {
        let mut first = 0;
        let mut commands = Vec::new();
        for (n, steered) in self.fmu.steered.iter().enumerate() {
            let inputs = first..first + steered.number();
            first = inputs.end + self.outputs_of_each();
            let own = command(*steered, &self.numbers[inputs]);
            commands.push((n, own.map_err(|why| format!("body {}: {why}", self.fmu.case.bodies[n].name))?));
        }
        Ok(commands)
    }

    fn outputs_of_each(&self) -> usize {
        let outputs = self.variables.iter().filter(|variable| variable.causality == Causality::Output);
        outputs.count() / self.fmu.steered.len()
    }

    /// Says what is wished for, and hears what has become of it.
    fn wish(&mut self, wish: Wish) -> Result<(), Refusal> {
        if let Some(session) = &self.session {
            session.wish(wish);
        }
        self.hear()
    }

    /// Hears where the run stands; a wish that it refuses has changed nothing.
    fn hear(&mut self) -> Result<(), Refusal> {
        let mut refused = None;
        loop {
            match self.session.as_ref().map(Session::wait) {
                Some(Ok(Said::At(exchange))) => {
                    if let Some(why) = refused {
                        return Err(discarded(why));
                    }
                    self.stand(&exchange);
                    return Ok(());
                }
                Some(Ok(Said::Refused(why))) => refused = Some(why),
                Some(Ok(Said::Saved(_) | Said::Ground(_))) => {}
                Some(Ok(Said::Ended(Ok(verdict)))) if self.phase == Phase::Terminated => {
                    self.session = None;
                    self.notes.extend(Some(verdict).filter(|verdict| !verdict.is_empty()));
                    return Ok(());
                }
                Some(Ok(Said::Ended(Ok(_)))) | None => return Err(self.failed("the run is not on")),
                Some(Ok(Said::Ended(Err(why)))) => return Err(self.failed(why)),
                Some(Err(gone)) => return Err(self.failed(gone.to_string())),
            }
        }
    }

    /// The outputs at an exchange.
    fn stand(&mut self, exchange: &Exchange) {
        (self.time, self.time_step) = (exchange.time, exchange.time_step);
        let values = exchange.reactions.iter().flat_map(numbers);
        let outputs = self.variables.iter().zip(&mut self.numbers);
        let outputs = outputs.filter(|(variable, _)| variable.causality == Causality::Output);
        outputs.zip(values).for_each(|((_, number), value)| *number = value);
    }

    fn failed(&mut self, why: impl Into<String>) -> Refusal {
        (self.phase, self.session) = (Phase::Failed, None);
        Refusal::error(why)
    }

    fn require(&self, phase: Phase) -> Result<(), Refusal> {
        if self.phase == phase { Ok(()) } else { Err(self.out_of_turn()) }
    }

    fn out_of_turn(&self) -> Refusal {
        Refusal::error(format!("a call out of turn: the instance is {:?}", self.phase).to_lowercase())
    }
}

fn discarded(message: String) -> Refusal {
    Refusal { severity: Severity::Discard, message }
}
