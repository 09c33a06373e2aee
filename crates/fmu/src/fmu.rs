//! What an FMU is made of: a case, and how its bodies are steered; and the run that it begins.

use crate::variables::{Steered, Variable, variables};
use coulter::case::{self, Case, resolved::Precision};
use coulter::interrupts::Interrupts;
use coulter::run::{self, End, RunOptions, Start};
use coulter::session::Session;
use coulter::simulation::{Exchange, Simulation, Steerer, Stop, Wish};
use coulter::trust::Verdict;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::xxh3_64;

/// Why a case cannot be that of an FMU.
#[derive(Debug, thiserror::Error)]
pub enum FmuError {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] coulter::case::CaseError),
    /// Another body than those of the case.
    #[error("the case has no body \"{0}\", but {1}")]
    NoBody(String, String),
    /// It cannot be steered.
    #[error("a case with stages moves its bodies itself and cannot be steered: leave out the stages")]
    Stages,
    /// It cannot be built.
    #[error("{0}")]
    Unbuildable(String),
}

/// How a run has ended: with the lines of its verdict, or why not.
pub(crate) type Ended = Result<String, String>;

/// A case, and how an importer steers its bodies.
#[derive(Clone, Debug)]
pub struct Fmu {
    /// The case.
    pub case: Case,
    /// The text of the case, with what was set in it.
    pub typed: String,
    /// Path of the case, beside which its files lie.
    pub source_name: String,
    /// How each body is steered, in their order.
    pub steered: Vec<Steered>,
}

impl Fmu {
    /// Reads a case file with overrides such as `soil.friction_angle=38 deg`; `steered` says how bodies are
    /// steered, by their names; others move as the case says.
    ///
    /// # Errors
    /// [`FmuError`].
    pub fn of_file(
        path: &Path,
        overrides: &[String],
        steered: &BTreeMap<String, Steered>,
    ) -> Result<Self, FmuError> {
        let (text, source_name) = (case::text(path)?, path.display().to_string());
        let case = case::parse(&text, &source_name, overrides)?;
        // By itself a case has the name of its file, which is another in an FMU.
        let named = [overrides, &[format!("name={}", case.name)]].concat();
        let typed = case::overridden(&text, &source_name, &named)?;
        if !case.stages.is_empty() {
            return Err(FmuError::Stages);
        }
        let names: Vec<&str> = case.bodies.iter().map(|body| body.name.as_str()).collect();
        if let Some(other) = steered.keys().find(|name| !names.contains(&name.as_str())) {
            return Err(FmuError::NoBody(other.clone(), names.join(", ")));
        }
        let of = |name: &str| steered.get(name).copied().unwrap_or_default();
        let steered = names.into_iter().map(of).collect();
        Ok(Self { case, typed, source_name, steered })
    }

    /// The names of the bodies that are steered, and how.
    pub(crate) fn steered_by_name(&self) -> BTreeMap<&str, Steered> {
        let names = self.case.bodies.iter().map(|body| body.name.as_str());
        names.zip(self.steered.iter().copied()).filter(|(_, how)| *how != Steered::Own).collect()
    }

    /// What an FMU and its description must agree about: the text of the case, the steering, and the version
    /// of this program.
    #[must_use]
    pub fn token(&self) -> String {
        let text = format!("{} {:?}", self.typed, self.steered);
        format!("{{coulter-{}-{:016x}}}", env!("CARGO_PKG_VERSION"), xxh3_64(text.as_bytes()))
    }

    /// The case with further keys set, one in a line.
    ///
    /// # Errors
    /// A case that is wrong then, or that has other bodies.
    pub(crate) fn with(&self, set: &str) -> Result<Self, String> {
        let lines = set.lines().map(str::trim).filter(|line| !line.is_empty());
        let overrides: Vec<String> = lines.map(str::to_owned).collect();
        if overrides.is_empty() {
            return Ok(self.clone());
        }
        let refused = |error: case::CaseError| said(&error);
        let case = case::parse(&self.typed, &self.source_name, &overrides).map_err(refused)?;
        let typed = case::overridden(&self.typed, &self.source_name, &overrides).map_err(refused)?;
        let names = |case: &Case| case.bodies.iter().map(|body| body.name.clone()).collect::<Vec<_>>();
        if names(&case) != names(&self.case) || !case.stages.is_empty() {
            return Err("what is set must leave the bodies what they are, and add no stages".to_owned());
        }
        Ok(Self { case, typed, ..self.clone() })
    }

    /// How the simulation stands at its start.
    ///
    /// # Errors
    /// A case that cannot be simulated.
    pub(crate) fn at_start(&self) -> Result<Exchange, FmuError> {
        let mut first = First(None);
        silently(&self.case, &mut first).map_err(FmuError::Unbuildable)?;
        first.0.ok_or_else(|| FmuError::Unbuildable("the case does not begin".to_owned()))
    }

    /// The numbers of the FMU.
    pub(crate) fn variables(&self, at_start: &Exchange) -> Vec<Variable> {
        let bodies = self.case.bodies.iter().zip(&self.steered).zip(&at_start.reactions);
        variables(bodies.map(|((body, steered), standing)| (body.name.as_str(), *steered, standing)))
    }

    /// Begins a run, which writes its results to a folder if there is one.
    pub(crate) fn begin(self, output: Option<PathBuf>) -> Session<Ended> {
        Session::begin(move |steerer| match output {
            None => silently(&self.case, steerer),
            Some(folder) => self.kept_in(&folder, steerer),
        })
    }

    fn kept_in(&self, folder: &Path, steerer: &mut dyn Steerer) -> Ended {
        let interrupts = Interrupts::default();
        let options = RunOptions::quiet(folder, Start::Replace, &self.typed, &self.source_name, &interrupts);
        match run::run_steered(&self.case, &options, steerer) {
            Ok(End::Stopped(..)) => Ok(String::new()),
            Ok(End::Finished(summary)) => {
                let lines = run::verdict(&summary).join("\n");
                if summary.trust.verdict == Verdict::Broken { Err(lines) } else { Ok(lines) }
            }
            Err(error) => Err(error.to_string()),
        }
    }
}

/// A steerer that looks at the first exchange only.
struct First(Option<Exchange>);

impl Steerer for First {
    fn next(&mut self, exchange: Exchange) -> Wish {
        self.0 = Some(exchange);
        Wish::Stop
    }

    fn refused(&mut self, _: String) {}

    fn ground(&mut self, _: Vec<Option<f64>>) {}

    fn saved(&mut self, _: Vec<u8>) {}
}

/// A run without files.
fn silently(case: &Case, steerer: &mut dyn Steerer) -> Ended {
    let stop = match case.numerics.precision {
        Precision::Double => {
            Simulation::<f64>::checked(case).map(|mut own| own.run_steered(&mut [], steerer))
        }
        Precision::Single => {
            Simulation::<f32>::checked(case).map(|mut own| own.run_steered(&mut [], steerer))
        }
    };
    match stop.map_err(|error| said(&error))?.map_err(|error| error.to_string())? {
        Stop::BrokenDown(cause) => Err(cause.to_string()),
        Stop::Finished | Stop::Asked(_) => Ok(String::new()),
    }
}

/// Everything that is wrong with a case, a line for each.
fn said(error: &case::CaseError) -> String {
    let each = error.problems.iter().map(ToString::to_string);
    each.collect::<Vec<_>>().join("\n")
}
