//! The keys of a study file, in the tables from which reading, the JSON schema and the documentation follow.

use coulter::case::keys::DefaultValue::{Derived, Flag, Number, Quantity, Required, Word};
use coulter::case::keys::{AllowedRange, Bound, Key, KeyTable, Kind, key, section};
use coulter::case::quantity::LENGTH;
use coulter::output::figure::LegendPlace;

/// Designs: which points a part of a study has.
pub const DESIGNS: [&str; 5] = ["grid", "list", "one-at-a-time", "latin-hypercube", "sobol"];
/// What is evaluated at every point.
pub const MODELS: [&str; 2] = ["closed-form", "solver"];
/// Which closed forms get a row of the table.
pub const CLOSED_FORMS: [&str; 2] = ["recommended", "all"];
/// Scales of a range.
pub const SCALES: [&str; 2] = ["linear", "logarithmic"];
/// Scales of a chart.
pub const CHART_SCALES: [&str; 3] = ["linear", "logarithmic", "logarithmic-x"];
/// Where the legend of a figure may stand.
pub const LEGENDS: [&str; 11] = LegendPlace::WORDS;
/// How levels differ in figures.
pub const COLOURS: [&str; 2] = ["colour", "black"];
/// Most points of one part.
pub const MOST_POINTS: f64 = 1e6;

const fn from(low: f64, high: f64) -> AllowedRange {
    AllowedRange { low: Bound::Inclusive(low), high: Bound::Inclusive(high), why: "" }
}

const TOP: &[Key] = &[
    key("format", Kind::Format, Required, "Version of the format of the file."),
    key(
        "case",
        Kind::Text,
        Required,
        "The case that is varied: a file, relative to the folder of the study.",
    ),
    key("title", Kind::Text, Derived("the name of the file"), "Heading of the page."),
    key(
        "responses",
        Kind::Names,
        Derived("`drag`, `vertical` and `sinkage`"),
        "Responses whose effects are analysed: columns of the table such as `F_H_bar`, `Z`, `slip`.",
    ),
    key(
        "closed_forms",
        Kind::Choice(&CLOSED_FORMS),
        Word("recommended"),
        "Which closed forms get a row of the table: the recommended one, without which a case counts as refused, or all that apply.",
    ),
];

const DESIGN: Key = key(
    "design",
    Kind::Choice(&DESIGNS),
    Word("grid"),
    "Which points: every combination of the levels (grid); the first levels of all factors, the second ones, and so on (list); the \
     case itself and every level of every factor alone (one-at-a-time); a Latin hypercube or a Sobol sequence over the ranges.",
);

const PART: &[Key] = &[
    key(
        "case",
        Kind::Text,
        Derived("that at the top of the file"),
        "The case that is varied, instead of that at the top of the file. `set` and `derived` of the top, which belong to that one, do \
         not hold for the part then.",
    ),
    key(
        "models",
        Kind::Choices(&MODELS),
        Derived("`closed-form`"),
        "What is evaluated at every point: the closed forms, the solver, or both.",
    ),
    DESIGN,
    key(
        "points",
        Kind::Count,
        Derived("required by `latin-hypercube` and `sobol`"),
        "Number of points of a design that fills the space of the factors.",
    )
    .within(from(2.0, MOST_POINTS)),
    key("seed", Kind::Count, Number(1.0), "Start of the random numbers of `latin-hypercube` and `sobol`.")
        .within(from(0.0, 4_294_967_295.0)),
    key(
        "factors",
        Kind::Names,
        Derived("all"),
        "Names of the factors that are varied; `[]` for the case alone.",
    ),
    key(
        "intervals",
        Kind::Flag,
        Flag(false),
        "Whether every figure gets its interval (5 to 95 %): of a closed form from uncertain inputs and the error of the model, as \
         `coulter forecast` states it, of a run from the case on other meshes, as `coulter run --meshes`.",
    ),
    key("meshes", Kind::Count, Number(3.0), "With `intervals`: meshes on which the solver runs every point.")
        .within(from(2.0, 6.0)),
    key("quick", Kind::Flag, Flag(true), "Whether the part is evaluated with `--quick`, too."),
    key(
        "set",
        Kind::Assignments,
        Derived("nothing"),
        "Keys of the case and their values at all points, as with `--set`: `{ \"grid.cell\" = \"20 mm\" }`.",
    ),
    key(
        "derived",
        Kind::Assignments,
        Derived("nothing"),
        "Keys of the case that follow from factors and from other keys of the case, as formulas: \
         `{ \"body.disc.thickness\" = \"t_bar * body.disc.diameter\" }`.",
    ),
];

const FACTOR: &[Key] = &[
    key(
        "key",
        Kind::Text,
        Derived("none: the factor is used in formulas only"),
        "The key of the case that is varied, such as `soil.friction_angle`.",
    ),
    key("values", Kind::Values, Derived("levels over the range"), "The levels, each as the key wants it."),
    key(
        "quick",
        Kind::Values,
        Derived("all levels"),
        "The levels with `--quick`: fewer, or, in formulas, those of a cheaper run.",
    ),
    key("range", Kind::Values, Derived("from the lowest to the highest level"), "Low and high end."),
    key("levels", Kind::Count, Derived("those in `values`"), "Number of levels over the range.")
        .within(from(2.0, 1000.0)),
    key("scale", Kind::Choice(&SCALES), Word("linear"), "How levels and points are spread over the range."),
    key(
        "label",
        Kind::Text,
        Derived("the name of the factor"),
        "Its name in charts, such as `friction angle φ`.",
    ),
];

const CHART: &[Key] = &[
    key("x", Kind::Text, Required, "Column of the table along the x axis: a factor or a response."),
    key("y", Kind::Text, Required, "Column along the y axis."),
    key("family", Kind::Text, Derived("none"), "Factor of which every level gets a curve of its own."),
    key("part", Kind::Text, Derived("all"), "The part of the study that is shown."),
    key(
        "scale",
        Kind::Choice(&CHART_SCALES),
        Word("linear"),
        "Scale of both axes; `logarithmic-x` that of the x axis alone.",
    ),
    key("collapse", Kind::Flag, Flag(false), "All points, and how well they fall onto one curve."),
    key(
        "history",
        Kind::Flag,
        Flag(false),
        "Curves of single runs of the solver instead of the table: `x` and `y` are columns of `forces.csv`, such as `time`, `rotation`, \
         `drag`, `u_bar`, `F_H_bar`, `Z`.",
    ),
    key(
        "measured",
        Kind::Names,
        Derived("none"),
        "Tables of measured points, relative to the study file: CSV whose header names the columns as the chart does, `Z [-],F_H_bar [-]`; \
         columns `F_H_bar_low` and `F_H_bar_high` are the ends of intervals.",
    ),
    key(
        "measured_labels",
        Kind::Names,
        Derived("the names of the files"),
        "What the measured tables are called in the legend.",
    ),
    key("columns", Kind::Count, Number(1.0), "Width of the figure: one column of a journal, or two.")
        .within(from(1.0, 2.0)),
    key(
        "legend",
        Kind::Choice(&LEGENDS),
        Word("automatic"),
        "Where the legend stands: where it hides nothing, at a side of the axes, above them (outside), or nowhere.",
    ),
    key(
        "x_range",
        Kind::Interval,
        Derived("that of the points"),
        "Ends of the x axis, in the unit of the column.",
    ),
    key("y_range", Kind::Interval, Derived("that of the points"), "Ends of the y axis."),
    key(
        "x_label",
        Kind::Text,
        Derived("that of the column"),
        "Label of the x axis: words, symbol, unit in square brackets, `drag F_H [N]`; `F̄_H` has a bar.",
    ),
    key("y_label", Kind::Text, Derived("that of the column"), "Label of the y axis."),
];

const STYLE: &[Key] = &[
    key("width_one", Kind::Quantity(LENGTH), Quantity("90 mm"), "Width of figures of one column.")
        .within(from(0.03, 0.5)),
    key("width_two", Kind::Quantity(LENGTH), Quantity("190 mm"), "Width of figures of two columns.")
        .within(from(0.03, 0.5)),
    key("aspect", Kind::Number, Derived("0.75; of two columns 0.45"), "Height of a figure over its width.")
        .within(from(0.2, 3.0)),
    key("font_size", Kind::Number, Number(8.0), "Size of text [pt].").within(from(4.0, 20.0)),
    key("line_width", Kind::Number, Number(0.9), "Width of lines [pt].").within(from(0.1, 5.0)),
    key("mark_size", Kind::Number, Number(4.5), "Size of marks [pt].").within(from(1.0, 20.0)),
    key(
        "colour",
        Kind::Choice(&COLOURS),
        Word("colour"),
        "Whether levels differ by colour, too; marks and dashes tell them apart anyway.",
    ),
];

const POOL: &[Key] = &[
    key(
        "workers",
        Kind::Count,
        Derived("as many as cores and memory allow"),
        "Cases that run at the same time.",
    )
    .within(from(1.0, 1024.0)),
    key("threads", Kind::Count, Number(1.0), "Threads of each run of the solver.").within(from(1.0, 64.0)),
];

/// All sections of a study file.
pub const SECTIONS: [KeyTable; 6] = [
    section("", "At the top of the file, before any section. Besides these every key of a part.", TOP),
    section(
        "part",
        "A part of the study with a design of its own, `[part.NAME]`; any number of them. What stands at the top of the file holds for \
         every part that does not say otherwise; `set` and `derived` add up. Without any, the study is one part.",
        PART,
    ),
    section(
        "factor",
        "What is varied, `[factor.NAME]`; the name is that of its column in the table.",
        FACTOR,
    ),
    section(
        "chart",
        "A chart of the table, `[chart.NAME]`: a figure for print. A part gets the charts that name it, or, where none does, those that every study gets.",
        CHART,
    ),
    section("style", "What figures for print look like.", STYLE),
    section("pool", "How cases are run on this machine. It changes no result.", POOL),
];

/// The table of a section.
#[must_use]
pub fn table(name: &str) -> KeyTable {
    let found = SECTIONS.iter().find(|section| section.name == name).copied();
    found.unwrap_or(KeyTable { name: "", meaning: "", keys: &[] })
}
