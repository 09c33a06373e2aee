//! What is told while a study runs: a line for every case that has ended, wherever the output goes, and a bar
//! on a terminal.

use crate::common::{say, tell};
use coulter::case::quantity::short;
use indicatif::{ProgressBar, ProgressStyle};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use studies::study::ModelKind;
use studies::sweep::evaluate::{Shared, Unended};
use studies::sweep::line::CaseLine;
use studies::sweep::outcome::{Ending, Outcome};
use studies::sweep::pool::Watcher;

/// Closed forms that are told one by one; of more, that many lines at even distances, and every one that has
/// no answer (chosen).
const TOLD: usize = 100;

/// Tells of every case that ends.
pub(super) struct Teller {
    bar: ProgressBar,
    /// Whether standard output is for something else.
    quiet: bool,
    /// Cases of each model, and of all.
    cases: BTreeMap<&'static str, usize>,
    all: usize,
    state: Mutex<State>,
}

/// How far the study is.
struct State {
    ended: BTreeMap<&'static str, usize>,
    /// Cases that had ended before.
    before: BTreeMap<&'static str, usize>,
    broken: usize,
    /// When the first case of a model was waited for.
    began: BTreeMap<&'static str, Instant>,
}

impl Teller {
    /// A teller of the cases of a study, some of which may have an outcome already.
    pub(super) fn of(shared: &Shared, lines: &[CaseLine], quiet: bool) -> Self {
        let had = shared.store.with_outcome().unwrap_or_default();
        let mut seen = BTreeSet::new();
        let (mut cases, mut before) = (BTreeMap::new(), BTreeMap::new());
        for line in lines.iter().filter(|line| seen.insert(line.id.as_str())) {
            *cases.entry(word(line)).or_default() += 1;
            *before.entry(word(line)).or_default() += usize::from(had.contains(line.id.as_str()));
        }
        let (all, done) = (cases.values().sum::<usize>(), before.values().sum::<usize>());
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(all as u64) };
        let style = ProgressStyle::with_template("{bar:30} {pos}/{len} cases, {elapsed} gone");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.set_position(done as u64);
        bar.enable_steady_tick(Duration::from_millis(500));
        let began = BTreeMap::from([(CLOSED, Instant::now())]);
        let state = State { ended: before.clone(), before, broken: 0, began };
        Self { bar, quiet, cases, all, state: Mutex::new(state) }
    }

    /// Takes the bar away.
    pub(super) fn end(&self) {
        self.bar.finish_and_clear();
    }

    /// Counts a case that has ended; what is to be said of it, if anything.
    fn counted(&self, line: &CaseLine, outcome: &Result<Outcome, Unended>) -> Option<String> {
        let model = word(line);
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let is_done = outcome.as_ref().is_ok_and(has_results);
        if outcome.is_ok() {
            *state.ended.entry(model).or_default() += 1;
            self.bar.inc(1);
        }
        state.broken += usize::from(!is_done);
        let (ended, of) =
            (state.ended.get(model).copied().unwrap_or(0), self.cases.get(model).copied().unwrap_or(0));
        let every = if model == CLOSED { of.div_ceil(TOLD).max(1) } else { 1 };
        if is_done && !ended.is_multiple_of(every) && ended < of {
            return None;
        }
        let all: usize = state.ended.values().sum();
        let not_used =
            if state.broken > 0 { format!(", {} without results", state.broken) } else { String::new() };
        let width = self.all.to_string().len();
        let what = told(line, outcome);
        Some(format!("[{all:>width$}/{}{not_used}] {what}{}", self.all, state.left(model, of)))
    }

    /// Prints a line on standard output, or on standard error where that is for something else.
    fn print(&self, text: &str) {
        self.bar.suspend(|| {
            // Where no one reads the output any more the study goes on.
            if self.quiet {
                tell(text);
            } else {
                let _ = say(&format!("{text}\n"));
            }
        });
    }
}

impl State {
    /// Time gone and left, by the cases of this model that have ended since the study was begun or resumed.
    fn left(&mut self, model: &'static str, of: usize) -> String {
        let (ended, before) =
            [&self.ended, &self.before].map(|list| list.get(model).copied().unwrap_or(0)).into();
        let gone = self.began.get(model).map_or(0.0, |began| began.elapsed().as_secs_f64());
        let left = of.saturating_sub(ended);
        if left == 0 || ended == before {
            return format!("; {} gone", clock(gone));
        }
        let expected = gone * left as f64 / (ended - before) as f64;
        format!("; {} gone, about {} left", clock(gone), clock(expected))
    }
}

impl Watcher for Teller {
    fn begun(&self, line: &CaseLine) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.began.entry(word(line)).or_insert_with(Instant::now);
    }

    fn ended(&self, line: &CaseLine, outcome: &Result<Outcome, Unended>) {
        // Whoever stopped the study knows.
        if matches!(outcome, Err(Unended::Stopped(_))) {
            return;
        }
        if let Some(text) = self.counted(line, outcome) {
            self.print(&text);
        }
    }
}

const CLOSED: &str = "closed form";

fn word(line: &CaseLine) -> &'static str {
    match line.model {
        ModelKind::ClosedForm => CLOSED,
        ModelKind::Solver => "solver",
    }
}

/// Which case, how it ended, and its main figures or why it has none.
pub(super) fn told(line: &CaseLine, outcome: &Result<Outcome, Unended>) -> String {
    let part = if line.part.is_empty() { String::new() } else { format!(" of {}", line.part) };
    // A level that a range was cut into has more digits than anybody reads.
    let shown = |text: &str| text.parse().map_or(text.to_owned(), short);
    let varied = line.factors.iter().filter(|level| level.is_varied);
    let levels: String = varied.map(|level| format!(", {} = {}", level.name, shown(&level.shown))).collect();
    let end = match outcome {
        Ok(outcome) if has_results(outcome) => figures(outcome),
        Ok(outcome) if outcome.ending == Ending::Done => format!("REFUSED: {}", outcome.reason),
        Ok(outcome) => {
            format!("{}: {}{}", outcome.ending.word().to_uppercase(), outcome.reason, kept(outcome))
        }
        Err(why) => format!("FAILED: {why}"),
    };
    format!("point {}{part}, {}{levels}: {end}", line.point, word(line))
}

/// Whether a case is done; one to which no closed form applies has nothing to show for it.
fn has_results(outcome: &Outcome) -> bool {
    outcome.ending == Ending::Done && !outcome.rows.is_empty()
}

/// What a broken run gave, which is in the table all the same.
fn kept(outcome: &Outcome) -> String {
    if outcome.rows.is_empty() { String::new() } else { format!(" (it gave {})", figures(outcome)) }
}

fn figures(outcome: &Outcome) -> String {
    let Some(row) = outcome.rows.iter().find(|row| row.recommended).or(outcome.rows.first()) else {
        return String::new();
    };
    let figure = |name: &str, value: Option<f64>, unit: &str| {
        value.filter(|value| value.is_finite()).map(|value| format!("{name} {} {unit}", short(value)))
    };
    let grade = row.grade.clone().filter(|_| outcome.ending == Ending::Done);
    let list = [
        grade,
        figure("F_H", row.get("drag"), "N"),
        figure("F_V", row.get("vertical"), "N"),
        figure("z", row.get("sinkage").map(|z| 1e3 * z), "mm"),
    ];
    list.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// A time [s] as people read it.
fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{whole} s"),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole / 60 % 60),
    }
}
