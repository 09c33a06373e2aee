//! Whether a run can be believed: a verdict per check, and of all of them.
//!
//! The checks look at histories and at a few facts about the case ([`Setting`]), so a killed run, a finished one and one
//! that is still going are graded by the same rules. What they are held against stands in [`limits`], in one table.

pub mod body;
pub mod boundary;
mod check;
pub mod documentation;
pub(crate) mod energy;
pub mod limits;
mod setting;
pub mod steadiness;
mod verdict;

use crate::history::History;
use crate::history::reference::Reference;
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

impl Trust {
    /// Grades what a run has seen. `outcome` is why it broke down, if it did.
    #[must_use]
    pub fn grade(
        setting: &Setting,
        history: &History,
        references: &[Reference],
        share: f64,
        failure: Option<&str>,
    ) -> Self {
        let mut checks = Vec::new();
        if let Some(why) = failure {
            checks.push(Check { advice: why.to_owned(), ..Check::of(&limits::COMPLETED, None, 1.0) });
        }
        checks.extend(energy::checks(setting, history));
        for (n, reference) in references.iter().enumerate() {
            if let (Some(body), Some(samples)) = (setting.bodies.get(n), history.bodies.get(n)) {
                let scene = body::Scene { setting, body, reference, samples, history, share };
                checks.extend(scene.checks());
            }
        }
        checks.extend(energy::boundary_checks(setting, history));
        checks.push(Check::of(&limits::STEP_SIZE, None, setting.courant));
        let verdict = checks.iter().map(|c| c.verdict).max().unwrap_or_default();
        Self { verdict, checks }
    }

    /// The checks that are not good, the worst first.
    #[must_use]
    pub fn doubts(&self) -> Vec<&Check> {
        let mut doubts: Vec<&Check> = self.checks.iter().filter(|c| c.verdict > Verdict::Good).collect();
        doubts.sort_by_key(|c| std::cmp::Reverse(c.verdict));
        doubts
    }

    /// Whether the towed body of this name is in a steady state; `None` where that was not tested.
    #[must_use]
    pub fn is_steady(&self, body: &str) -> Option<bool> {
        let steady = |limit: &Limit| {
            let check = self.checks.iter().find(|c| c.name == limit.name && c.body.as_deref() == Some(body));
            check.map(|c| c.verdict == Verdict::Good)
        };
        Some(steady(&limits::STEADY_DRAG)? && steady(&limits::STEADY_SINKAGE).unwrap_or(true))
    }
}
