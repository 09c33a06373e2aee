//! One check of a run: a figure, its limits and the verdict.

use super::limits::Limit;
use super::verdict::Verdict;
use serde::{Deserialize, Serialize};

/// One check of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Check {
    /// Name of the check, as in the table of limits.
    pub name: String,
    /// The body that the check concerns, if it concerns one.
    pub body: Option<String>,
    /// The figure, in the unit of the table of limits; `None` where it is not available.
    pub value: Option<f64>,
    /// Unit of value and limits.
    pub unit: String,
    /// Limits of good and of doubtful (`None`: never broken).
    pub limits: [Option<f64>; 2],
    /// The verdict.
    pub verdict: Verdict,
    /// What to do if it is not good; otherwise empty.
    pub advice: String,
}

impl Check {
    /// Compares a figure with its limit.
    #[must_use]
    pub fn of(limit: &'static Limit, body: Option<&str>, value: f64) -> Self {
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

    /// A figure that is not available, for a reason: doubtful.
    #[must_use]
    pub fn unavailable(limit: &'static Limit, body: Option<&str>, why: &str) -> Self {
        Self { verdict: Verdict::Doubtful, advice: why.to_owned(), ..Self::of(limit, body, f64::INFINITY) }
    }

    /// One line of text: the check, its figure and its limits.
    #[must_use]
    pub fn line(&self) -> String {
        let body = self.body.as_ref().map_or(String::new(), |body| format!(" ({body})"));
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let value = self.value.map_or("not available".to_owned(), |v| format!("{}{unit}", short(v)));
        let [good, doubtful] = self.limits.map(|l| l.map(short));
        let limits = match (good, doubtful) {
            (Some(good), Some(doubtful)) => format!("good to {good}{unit}, doubtful to {doubtful}{unit}"),
            (Some(good), None) => format!("good to {good}{unit}"),
            _ => String::new(),
        };
        format!("{}{body}: {value} ({limits})", self.name)
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
