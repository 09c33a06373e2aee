//! Whether a run can be believed: a verdict per check, and of all of them.
//!
//! The checks look at histories and at a few facts about the case ([`Setting`]), so a killed run, a finished one and one
//! that is still going are graded by the same rules. What they are held against stands in [`limits`], in one table.

pub mod body;
pub mod boundary;
pub mod documentation;
mod energy;
pub mod limits;
mod setting;
pub mod steadiness;
pub mod watch;

use crate::output::record::History;
use crate::output::reference::Reference;
use limits::Limit;
use serde::{Deserialize, Serialize};
pub use setting::{BodySetting, Setting};

/// How far a number can be trusted, from best to worst.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within the limit that an experienced user would set.
    #[default]
    Good,
    /// Usable with care: the advice says what limits it.
    Doubtful,
    /// Not to be used.
    Broken,
}

impl Verdict {
    /// As it is written in tables and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Doubtful => "doubtful",
            Self::Broken => "broken",
        }
    }
}

/// One check of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Check {
    /// Its name, as in the table of limits.
    pub name: String,
    /// The body that it is about, if it is about one.
    pub body: Option<String>,
    /// The figure, in the unit of the table of limits; `None` where it is not a number.
    pub value: Option<f64>,
    /// Unit of value and limits.
    pub unit: String,
    /// Up to where it is good, and up to where it is doubtful (`None`: never broken).
    pub limits: [Option<f64>; 2],
    /// What follows.
    pub verdict: Verdict,
    /// What to do about it; empty where it is good.
    pub advice: String,
}

impl Check {
    /// Holds a figure against its limit.
    fn of(limit: &'static Limit, body: Option<&str>, value: f64) -> Self {
        let verdict = limit.verdict(value);
        Self {
            name: limit.name.to_owned(),
            body: body.map(str::to_owned),
            value: value.is_finite().then_some(value),
            unit: limit.unit.to_owned(),
            limits: [limit.good, limit.doubtful].map(|l| l.is_finite().then_some(l)),
            verdict,
            advice: if verdict == Verdict::Good { String::new() } else { limit.advice.to_owned() },
        }
    }

    /// One line for people: what, how much, and what was wanted.
    #[must_use]
    pub fn line(&self) -> String {
        let body = self.body.as_ref().map_or(String::new(), |body| format!(" ({body})"));
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let value = self.value.map_or("no figure".to_owned(), |v| format!("{}{unit}", short(v)));
        let [good, doubtful] = self.limits.map(|l| l.map(short));
        let wanted = match (good, doubtful) {
            (Some(good), Some(doubtful)) => format!("good to {good}{unit}, doubtful to {doubtful}{unit}"),
            (Some(good), None) => format!("good to {good}{unit}"),
            _ => String::new(),
        };
        format!("{}{body}: {value} ({wanted})", self.name)
    }
}

/// Three significant digits.
fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

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
