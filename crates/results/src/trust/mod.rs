//! Whether the results of a run can be trusted: a verdict for every check, and an overall one.
//!
//! The checks use histories and a few facts about the case ([`Setting`]), so that a killed run, a finished
//! one and one that is still running are graded by the same rules. Their limits are in one table, [`limits`].

pub mod body;
mod check;
mod contact;
pub mod documentation;
pub mod energy;
mod forces;
pub mod limits;
mod setting;
pub mod steadiness;
mod verdict;

use crate::history::History;
use crate::history::reference::Reference;
use crate::history::steady::SteadyPart;
pub use check::Check;
use limits::Limit;
use serde::{Deserialize, Serialize};
pub use setting::{BodySetting, Setting};
pub use verdict::Verdict;

/// The grade of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Trust {
    /// The worst verdict of all checks.
    pub verdict: Verdict,
    /// The checks, in the order of the table of limits.
    pub checks: Vec<Check>,
}

/// The doubts about the values of a case, if there are any.
fn unusual(setting: &Setting) -> Option<Check> {
    let count = setting.unusual.len();
    (count > 0).then(|| Check {
        advice: setting.unusual.join(" "),
        ..Check::of(&limits::UNUSUAL, None, count as f64)
    })
}

impl Trust {
    /// Grades a run by its history; `part` is what averages are taken over, `failure` says why the run broke
    /// down, if it did.
    #[must_use]
    pub fn grade(
        setting: &Setting,
        history: &History,
        references: &[Reference],
        part: impl Into<SteadyPart>,
        failure: Option<&str>,
    ) -> Self {
        let part = part.into();
        let mut checks = Vec::new();
        if let Some(why) = failure {
            checks.push(Check { advice: why.to_owned(), ..Check::of(&limits::COMPLETED, None, 1.0) });
        }
        checks.extend(energy::checks(setting, history));
        checks.extend(energy::exchanged(history));
        checks.extend(contact::of_motion(setting, history));
        for (n, reference) in references.iter().enumerate() {
            if let (Some(body), Some(samples)) = (setting.bodies.get(n), history.bodies.get(n)) {
                let is_steered = history.exchange.steered.contains(&n);
                let body_checks =
                    body::BodyChecks { setting, body, is_steered, reference, samples, history, part };
                checks.extend(body_checks.checks());
            }
        }
        checks.extend(energy::boundary_checks(setting, history));
        checks.extend(energy::pumped(setting, history));
        checks.extend(unusual(setting));
        checks.push(Check::of(&limits::STEP_SIZE, None, setting.courant));
        let verdict = checks.iter().map(|c| c.verdict).max().unwrap_or_default();
        Self { verdict, checks }
    }

    /// Puts the checks of the variations of the case in place of those of earlier ones, and grades the run
    /// anew.
    pub fn set_confidence_checks(&mut self, checks: Vec<Check>) {
        self.replace(&limits::OF_CONFIDENCE, checks);
    }

    /// The worst verdict of all checks but those of variations.
    #[must_use]
    pub fn verdict_without_confidence(&self) -> Verdict {
        let is_of_run = |check: &&Check| limits::OF_CONFIDENCE.iter().all(|limit| limit.name != check.name);
        self.checks.iter().filter(is_of_run).map(|check| check.verdict).max().unwrap_or_default()
    }

    fn replace(&mut self, of: &[&Limit], checks: Vec<Check>) {
        self.checks.retain(|check| of.iter().all(|limit| limit.name != check.name));
        self.checks.extend(checks);
        self.verdict = self.checks.iter().map(|c| c.verdict).max().unwrap_or_default();
    }

    /// The checks that are not good, the worst first.
    #[must_use]
    pub fn concerns(&self) -> Vec<&Check> {
        let mut concerns: Vec<&Check> = self.checks.iter().filter(|c| c.verdict > Verdict::Good).collect();
        concerns.sort_by_key(|c| std::cmp::Reverse(c.verdict));
        concerns
    }

    /// Whether the towed body of this name is in a steady state; `None` where this was not checked.
    #[must_use]
    pub fn is_steady(&self, body: &str) -> Option<bool> {
        let steady = |limit: &Limit| {
            let check = self.checks.iter().find(|c| c.name == limit.name && c.body.as_deref() == Some(body));
            check.map(|c| c.verdict == Verdict::Good)
        };
        Some(steady(&limits::STEADY_DRAG)? && steady(&limits::STEADY_SINKAGE).unwrap_or(true))
    }
}
