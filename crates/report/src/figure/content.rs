//! What a figure for print shows.

/// A figure: series over two axes, and how it is laid out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Name of the files of the figure, without ending.
    pub name: String,
    /// The x axis.
    pub x: FigureAxis,
    /// The y axis.
    pub y: FigureAxis,
    /// The series, the first one at the back.
    pub series: Vec<FigureSeries>,
    /// Where the legend stands.
    pub legend: LegendPlace,
    /// Size, text and lines.
    pub style: FigureStyle,
}

/// An axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureAxis {
    /// Words, symbol and unit: `drag F_H [N]`, `dimensionless drag F̄_H`.
    pub label: String,
    /// Name of the column in files.
    pub name: String,
    /// Unit of the axis in files; `-` for a plain number, empty for words.
    pub unit: String,
    /// Ends of the axis; by default those of what is shown, with a margin.
    pub range: Option<[f64; 2]>,
    /// Whether the axis is logarithmic: values that are not positive are left out.
    pub logarithmic: bool,
    /// Words at 0, 1, 2, … of an axis of words; empty of one of numbers.
    pub words: Vec<String>,
}

impl FigureAxis {
    /// Position of a value along the axis, from which the picture is scaled; not-a-number where it has none.
    pub(super) fn position(&self, value: f64) -> f64 {
        if !self.logarithmic {
            value
        } else if value > 0.0 {
            value.log10()
        } else {
            f64::NAN
        }
    }
}

/// Points of one source at one level of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureSeries {
    /// How the points are drawn.
    pub kind: SeriesKind,
    /// The level of the family, such as `φ = 30 deg`; empty without one.
    pub level: String,
    /// Where the points come from: a model, a file.
    pub source: String,
    /// The points, in the order of the line.
    pub points: Vec<FigurePoint>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SeriesKind {
    /// Marks, hollow where a run is doubtful: runs of the solver.
    Computed,
    /// A line: a closed form, a history.
    Line,
    /// Small dots: a closed form at points without an order.
    Dots,
    /// Crosses in black: measurements.
    Measured,
}

impl SeriesKind {
    /// The word for the kind of series in files.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Computed => "computed",
            Self::Line => "line",
            Self::Dots => "dots",
            Self::Measured => "measured",
        }
    }
}

/// A point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigurePoint {
    /// Values on both axes.
    pub at: [f64; 2],
    /// Low and high end of the interval of x.
    pub x_ends: Option<[f64; 2]>,
    /// Low and high end of the interval of y.
    pub y_ends: Option<[f64; 2]>,
    /// Grade of the run: `good`, `doubtful`, or empty.
    pub grade: String,
}

impl FigurePoint {
    /// Whether the run is doubtful.
    pub(super) fn is_doubtful(&self) -> bool {
        self.grade == "doubtful"
    }
}

/// Where the legend stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LegendPlace {
    /// Where it hides no data: inside, or above the axes where there is no room.
    #[default]
    Automatic,
    /// Inside: from left, middle or right, and top, middle or bottom, 0 to 2 each.
    Inside([usize; 2]),
    /// Above the axes.
    Outside,
    /// Nowhere.
    None,
}

impl LegendPlace {
    /// The words for the places.
    pub const WORDS: [&str; 11] = [
        "automatic",
        "top left",
        "top",
        "top right",
        "left",
        "right",
        "bottom left",
        "bottom",
        "bottom right",
        "outside",
        "none",
    ];

    /// The place of a word; automatic of any other.
    #[must_use]
    pub fn of_word(word: &str) -> Self {
        match word {
            "top left" => Self::Inside([0, 0]),
            "top" => Self::Inside([1, 0]),
            "top right" => Self::Inside([2, 0]),
            "left" => Self::Inside([0, 1]),
            "right" => Self::Inside([2, 1]),
            "bottom left" => Self::Inside([0, 2]),
            "bottom" => Self::Inside([1, 2]),
            "bottom right" => Self::Inside([2, 2]),
            "outside" => Self::Outside,
            "none" => Self::None,
            _ => Self::Automatic,
        }
    }
}

/// Size, text and lines of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigureStyle {
    /// Width [mm].
    pub width: f64,
    /// Height over width.
    pub aspect: f64,
    /// Size of text [pt].
    pub font_size: f64,
    /// Width of lines [pt].
    pub line_width: f64,
    /// Size of marks [pt].
    pub mark_size: f64,
    /// Whether levels differ by colour, too; without, everything is black.
    pub is_coloured: bool,
}

impl Default for FigureStyle {
    fn default() -> Self {
        Self { width: 90.0, aspect: 0.75, font_size: 8.0, line_width: 0.9, mark_size: 4.5, is_coloured: true }
    }
}
