//! Progress of a run: a bar on a terminal, occasional lines elsewhere.

use crate::history::reference::Reference;
use crate::history::{BodySample, History};
use case::Case;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use input::printed::plain;
use input::readable::{Unit, digits};
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

/// Resolution of the bar.
const TICKS: u64 = 10_000;
/// Fraction of the run between two lines.
const LINE_FRACTION: f64 = 0.05;
/// Least time between two lines.
const LINE_PAUSE: Duration = Duration::from_secs(2);

/// Shows the progress of a run on the standard error stream.
#[derive(Debug)]
pub struct Progress {
    start: f64,
    end: f64,
    references: Vec<Reference>,
    began: Instant,
    display: Display,
    label: String,
}

#[derive(Debug)]
enum Display {
    Nothing,
    Bar(ProgressBar),
    Lines { last_fraction: f64, last_time: Instant },
}

impl Progress {
    /// Starts at `time` [s] of a case (0, or that of the checkpoint it resumes from); `quiet` shows nothing.
    #[must_use]
    pub fn start(case: &Case, time: f64, quiet: bool) -> Self {
        let display = if quiet {
            Display::Nothing
        } else if std::io::stderr().is_terminal() && !is_plain() {
            Display::Bar(bar())
        } else {
            Display::Lines { last_fraction: -1.0, last_time: Instant::now() }
        };
        Self {
            start: time,
            end: case.duration,
            references: Reference::all(case),
            began: Instant::now(),
            display,
            label: String::new(),
        }
    }

    /// The progress with a label before every line: which of several runs this is; empty for none.
    #[must_use]
    pub fn labelled(mut self, label: &str) -> Self {
        self.label = if label.is_empty() { String::new() } else { format!("{label}  ") };
        if let Display::Bar(bar) = &self.display {
            bar.set_prefix(plain(&self.label).into_owned());
        }
        self
    }

    /// Updates the display at `time` [s]; cheap enough to be called for every sample.
    pub fn update(&mut self, time: f64, history: &History) {
        let fraction = self.fraction(time);
        match &mut self.display {
            Display::Nothing => {}
            Display::Bar(bar) => {
                bar.set_position((fraction * TICKS as f64) as u64);
                bar.set_message(plain(&live(history, &self.references)).into_owned());
            }
            Display::Lines { last_fraction, last_time } => {
                let due = fraction - *last_fraction >= LINE_FRACTION && last_time.elapsed() >= LINE_PAUSE;
                if due || *last_fraction < 0.0 {
                    (*last_fraction, *last_time) = (fraction, Instant::now());
                    print_line(&self.line(time, fraction, history));
                }
            }
        }
    }

    /// Ends the display with a message.
    pub fn finish(&mut self, message: &str) {
        match std::mem::replace(&mut self.display, Display::Nothing) {
            Display::Nothing => {}
            Display::Bar(bar) => {
                bar.finish_and_clear();
                print_line(message);
            }
            Display::Lines { .. } => print_line(message),
        }
    }

    /// Completed fraction of the run since its start or restart.
    fn fraction(&self, time: f64) -> f64 {
        let duration = self.end - self.start;
        if duration > 0.0 { ((time - self.start) / duration).clamp(0.0, 1.0) } else { 1.0 }
    }

    fn line(&self, time: f64, fraction: f64, history: &History) -> String {
        let elapsed = self.began.elapsed().as_secs_f64();
        let left =
            if fraction > 0.01 { clock(elapsed * (1.0 - fraction) / fraction) } else { "?".to_owned() };
        let live = live(history, &self.references);
        let label = &self.label;
        format!(
            "{label}{:3.0} %  t = {} s  {}  left {left}  {live}",
            100.0 * fraction,
            digits(time),
            clock(elapsed)
        )
    }
}

/// Tells something at the end of a run that needs no display, unless it is to be `quiet`.
pub fn tell(message: &str, quiet: bool) {
    if !quiet {
        print_line(message);
    }
}

/// Prints a line on standard error. Where that cannot be written (a closed pipe, a lost terminal) the run
/// continues.
fn print_line(line: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", plain(line));
}

/// Whether the terminal or its user wants plain lines, without colours and animation.
fn is_plain() -> bool {
    std::env::var_os("TERM").is_some_and(|name| name == "dumb")
        || std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(TICKS), ProgressDrawTarget::stderr_with_hz(5));
    let style = ProgressStyle::with_template("{prefix}{percent:>3} % {bar:28} {elapsed} left {eta}  {msg}");
    // The template is valid; otherwise the default style is used.
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

/// The latest forces, sinkage and turn ratio of each body.
fn live(history: &History, references: &[Reference]) -> String {
    let touching = references.iter().filter(|reference| reference.has_surface()).count();
    let one = |(samples, reference): (&Vec<BodySample>, &Reference)| {
        let s = samples.last()?;
        let force = |f: f64| {
            let unit = Unit::force(f.abs());
            format!("{} {}", digits(f / unit.size), unit.name)
        };
        let name = if touching > 1 { format!("{}: ", reference.name) } else { String::new() };
        let turn = s.turn_ratio(reference).map_or(String::new(), |r| format!("  ωr/v {r:.2}"));
        let forces = format!("F_H {}  F_V {}", force(s.drag), force(s.vertical));
        Some(format!("{name}{forces}  z {} mm{turn}", digits(1e3 * s.sinkage)))
    };
    let bodies = history.bodies.iter().zip(references).filter(|(_, reference)| reference.has_surface());
    bodies.filter_map(one).collect::<Vec<_>>().join("   ")
}

/// A length of time as h:mm:ss or m:ss.
fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0).round() as u64;
    let (hours, minutes, seconds) = (whole / 3600, whole / 60 % 60, whole % 60);
    if hours > 0 { format!("{hours}:{minutes:02}:{seconds:02}") } else { format!("{minutes}:{seconds:02}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_formatted_as_clocks() {
        assert_eq!(clock(59.4), "0:59");
        assert_eq!(clock(3723.0), "1:02:03");
        assert_eq!(clock(f64::NAN), "0:00");
    }
}
