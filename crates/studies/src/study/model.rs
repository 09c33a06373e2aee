//! A study as its file says, with everything that can be checked without running a case.

use super::measured_points::MeasuredPoints;
use super::{Design, Factor, ModelKind};
use crate::expression::Expression;
use coulter::output::figure::{FigureStyle, LegendPlace};
use serde::{Deserialize, Serialize};

/// A study.
#[derive(Clone, Debug)]
pub struct Study {
    /// Name of the study, that of its file.
    pub name: String,
    /// Heading of the page of the study.
    pub title: String,
    /// Whether this is the quick version of the study.
    pub is_quick: bool,
    /// The cases that are varied: that of the file, and those that parts have of their own.
    pub cases: Vec<BaseCase>,
    /// Whether every closed form that applies gets a row of the table.
    pub all_closed_forms: bool,
    /// Responses whose effects are analysed; empty for the usual ones.
    pub responses: Vec<String>,
    /// The factors, in the order of the file.
    pub factors: Vec<Factor>,
    /// The parts, in the order of the file; one at least.
    pub parts: Vec<Part>,
    /// The charts, in the order of the file.
    pub charts: Vec<ChartWish>,
    /// What figures look like.
    pub style: StudyStyle,
    /// How cases are run on this machine.
    pub pool: Pool,
}

/// A case that is varied.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BaseCase {
    /// Path of the file of the case.
    pub path: String,
    /// The text of that file.
    #[serde(skip)]
    pub text: String,
}

/// What the figures of a study look like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StudyStyle {
    /// Widths of one and of two columns [mm].
    pub widths: [f64; 2],
    /// Height over width; `None` for what is usual.
    pub aspect: Option<f64>,
    /// Text, lines and marks.
    pub figure: FigureStyle,
}

impl StudyStyle {
    /// Heights over widths of figures of one and of two columns (chosen).
    const ASPECTS: [f64; 2] = [0.75, 0.45];

    /// The style of a figure of one or two columns.
    #[must_use]
    pub fn of(&self, columns: usize) -> FigureStyle {
        let number = columns.clamp(1, 2) - 1;
        let aspect = self.aspect.unwrap_or(Self::ASPECTS[number]);
        FigureStyle { width: self.widths[number], aspect, ..self.figure }
    }
}

/// A part of a study.
#[derive(Clone, Debug)]
pub struct Part {
    /// Name of the part; empty of a study that has only one.
    pub name: String,
    /// The case that is varied: its number in the list of the study.
    pub case: usize,
    /// What is evaluated at every point.
    pub models: Vec<ModelKind>,
    /// Meshes from which the intervals of a run follow; `None` without intervals.
    pub meshes: Option<usize>,
    /// Design of the points of the part.
    pub design: Design,
    /// Number of points of a design that fills space; 0 of the others.
    pub points: usize,
    /// Start of the random numbers.
    pub seed: u64,
    /// Factors of the part: numbers in the list of the study.
    pub factors: Vec<usize>,
    /// Keys of the case and their values at all points, as TOML.
    pub set: Vec<(String, String)>,
    /// Keys of the case that follow from others.
    pub derived: Vec<(String, Expression)>,
    /// Whether the part is evaluated in the quick version of the study, too.
    pub in_quick: bool,
}

impl Part {
    /// Whether a formula of the part uses a factor by its name.
    #[must_use]
    pub fn uses(&self, factor: &str) -> bool {
        self.derived.iter().any(|(_, formula)| formula.names().contains(&factor))
    }
}

impl Study {
    /// The parts that are evaluated in this version of the study.
    pub fn evaluated_parts(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().filter(|part| part.in_quick || !self.is_quick)
    }

    /// The case that a part varies.
    #[must_use]
    pub fn case_of(&self, part: &Part) -> &BaseCase {
        &self.cases[part.case]
    }
}

/// A chart that the file asks for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChartWish {
    /// Name of the chart.
    pub name: String,
    /// Column along the x axis.
    pub x: String,
    /// Column along the y axis.
    pub y: String,
    /// Factor of which every level gets a curve.
    pub family: Option<String>,
    /// The part that is shown; all without.
    pub part: Option<String>,
    /// Whether both axes are logarithmic.
    pub logarithmic: bool,
    /// Whether the x axis alone is logarithmic.
    pub logarithmic_x: bool,
    /// Whether the chart shows how well all points fall onto one curve.
    pub collapse: bool,
    /// Whether the chart shows curves of single runs over their history.
    pub history: bool,
    /// Measured points.
    pub measured: Vec<MeasuredPoints>,
    /// Width in columns of a journal, 1 or 2.
    pub columns: usize,
    /// Where the legend stands.
    pub legend: LegendPlace,
    /// Ends of the x and the y axis, in the units of the columns.
    pub ranges: [Option<[f64; 2]>; 2],
    /// Labels of the x and the y axis, in place of those of the columns.
    pub labels: [Option<String>; 2],
}

/// How cases are run on this machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pool {
    /// Cases that run at the same time; `None` for as many as cores and memory allow.
    pub workers: Option<usize>,
    /// Threads of each run of the solver.
    pub threads: usize,
}
