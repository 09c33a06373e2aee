//! What to write, and how often.

use crate::key::allowed::{POSITIVE, POSITIVE_FRACTION};
use DefaultValue::{DurationOver, Number, Quantity};
use input::key::{DefaultValue, Key, KeyOf, Kind, Place, declared, numbers, read};
use input::problem::Problems;
use input::quantity::{FREQUENCY, TIME};
use input::typed::Section;
use serde::Serialize;

/// What to write.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Output {
    /// Time between lines of forces.csv [s]; the forces are averages over it.
    pub history_interval: f64,
    /// Time between field files [s]; infinite for only the first and the last.
    pub field_interval: f64,
    /// Time between checkpoints, in seconds of wall clock; infinite for none but at the end.
    pub checkpoint_interval: f64,
    /// Fraction of the run, at its end, over which steady averages are taken, 0 to 1.
    pub steady_fraction: f64,
    /// Cut-off frequency of the filtered forces [Hz].
    pub filter_cutoff: f64,
}

/// Keys of the output, and where their values lie.
type Field = KeyOf<Output>;

const FIELDS: &[Field] = &[
    Field::new(
        "history_interval",
        Kind::Quantity(TIME),
        Place::Number(|output| &mut output.history_interval),
    )
    .default(DurationOver(500.0))
    .within(POSITIVE)
    .means("Time between the lines of forces.csv."),
    Field::new("field_interval", Kind::Quantity(TIME), Place::Number(|output| &mut output.field_interval))
        .default(DurationOver(20.0))
        .within(POSITIVE)
        .means("Time between the field files of the soil."),
    Field::new(
        "filter_cutoff",
        Kind::Quantity(FREQUENCY),
        Place::Derived(|output| Some(&mut output.filter_cutoff)),
    )
    .derived("a 25th of the rate of the history")
    .within(POSITIVE)
    .means("Cut-off frequency of the filtered forces (filtered.csv): what is faster is smoothed away."),
    Field::new(
        "checkpoint_interval",
        Kind::Quantity(TIME),
        Place::Number(|output| &mut output.checkpoint_interval),
    )
    .default(Quantity("10 min"))
    .within(POSITIVE)
    .means("Wall-clock time between checkpoints."),
    Field::new("steady_fraction", Kind::Number, Place::Number(|output| &mut output.steady_fraction))
        .default(Number(0.3))
        .within(POSITIVE_FRACTION)
        .means("Fraction of the run, at its end, over which steady averages are taken."),
];

/// Largest number of lines of a history.
const MAX_LINES: f64 = 1e7;

/// Cut-off frequency of the filter over the rate of the history, unless given: a wave of 25 lines.
const FILTER: f64 = 0.04;

impl Output {
    pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    /// Least number of lines of forces.csv in the steady window of which a run has statistics.
    pub const FEWEST_SAMPLES: usize = 24;

    /// What a run of this duration [s] is to write; `None` with problems added.
    pub(crate) fn typed(section: &Section, duration: f64, problems: &mut Problems) -> Option<Self> {
        let interval =
            |name: &str| Self::KEYS.iter().find(|key| key.name == name)?.default.of_duration(duration);
        let start = Self {
            history_interval: interval("history_interval")?,
            field_interval: interval("field_interval")?,
            ..Self::default()
        };
        let mut output = read(FIELDS, start, section, problems)?;
        output.filter_cutoff = section.number_or("filter_cutoff", FILTER / output.history_interval)?;
        let before = problems.len();
        output.check(duration, problems);
        (problems.len() == before).then_some(output)
    }

    /// Reports what is wrong with the output of a run of this duration [s].
    pub(crate) fn check(&self, duration: f64, problems: &mut Problems) {
        for (key, number) in numbers(FIELDS, self) {
            let path = format!("output.{}", key.name);
            // An infinite interval means never.
            let is_never = number == f64::INFINITY && key.name.ends_with("_interval");
            let is_right = is_never || key.admits(&path, number, problems);
            let count = duration / number;
            let is_counted = ["history_interval", "field_interval"].contains(&key.name);
            if is_right && is_counted && count > MAX_LINES {
                let message = format!("{path} means {count:.1e} outputs in {duration} s");
                problems.add(path, message, "make the interval longer");
            }
        }
    }
}
