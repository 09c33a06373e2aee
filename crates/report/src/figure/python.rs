//! A program that draws the figures of a folder from their data, in the same style: for authors who want to
//! change them.

use super::compose::ends;
use super::content::{Figure, FigureAxis, LegendPlace};
use super::drawing::Colour;
use super::label::{Piece, Script, capitalised, pieces};
use super::legend::entries;
use super::look::{Look, Mark, dashes, looks};
use input::printed::plain;

const PROGRAM: &str = include_str!("../../assets/figures.py");
/// What stands in the program in place of the figures.
const PLACE: &str = "FIGURES = []\n";

/// The program for these figures, in Python with matplotlib.
#[must_use]
pub fn script(figures: &[Figure]) -> String {
    let list: String = figures.iter().map(|figure| format!("    {},\n", described(figure))).collect();
    PROGRAM.replacen(PLACE, &format!("FIGURES = [\n{list}]\n"), 1)
}

/// A figure as a call of the program.
fn described(figure: &Figure) -> String {
    let style = &figure.style;
    let looks = looks(figure);
    let series = figure.series.iter().zip(&looks).map(|(series, look)| {
        format!(
            "            ({}, {}, {}): {},\n",
            word(series.kind.word()),
            word(&series.level),
            word(&series.source),
            drawn(look)
        )
    });
    let mut series: Vec<String> = series.collect();
    series.dedup();
    let shown = |look: &Option<Look>| look.as_ref().map_or_else(|| "None".to_owned(), drawn);
    let legend = entries(figure, &looks).into_iter().map(|entry| {
        let hollow = if entry.is_hollow { "True" } else { "False" };
        format!(
            "            ({}, {}, {}, {hollow}),\n",
            word(&formula(&entry.name)),
            shown(&entry.line),
            shown(&entry.mark)
        )
    });
    let legend: String = if figure.legend == LegendPlace::None { String::new() } else { legend.collect() };
    let [x, y] = ends(figure);
    let axes = [("x", &figure.x, x), ("y", &figure.y, y)]
        .map(|(name, axis, ends)| format!("        {name}={},\n", of_axis(axis, ends)));
    format!(
        "Figure(\n        {},\n        width={}, aspect={}, font_size={}, line_width={}, mark_size={},\n{}        \
         looks={{\n{}        }},\n        legend={},\n        names=[\n{legend}        ],\n    )",
        word(&figure.name),
        style.width,
        style.aspect,
        style.font_size,
        style.line_width,
        style.mark_size,
        axes.concat(),
        series.concat(),
        word(place(figure.legend))
    )
}

fn of_axis(axis: &FigureAxis, [low, high]: [f64; 2]) -> String {
    let words: Vec<String> = axis.words.iter().map(|text| word(text)).collect();
    format!(
        "Axis({}, range=({low:?}, {high:?}), logarithmic={}, words=[{}])",
        word(&formula(&pieces(&capitalised(&axis.label)))),
        if axis.logarithmic { "True" } else { "False" },
        words.join(", ")
    )
}

/// Where the legend stands, in the words of the program.
fn place(place: LegendPlace) -> &'static str {
    match place {
        LegendPlace::Automatic => "best",
        LegendPlace::Outside => "outside",
        LegendPlace::None => "none",
        LegendPlace::Inside([across, down]) => {
            const NAMES: [[&str; 3]; 3] = [
                ["upper left", "upper center", "upper right"],
                ["center left", "center", "center right"],
                ["lower left", "lower center", "lower right"],
            ];
            NAMES[down.min(2)][across.min(2)]
        }
    }
}

/// A look as a call of the program.
fn drawn(look: &Look) -> String {
    /// Marks of matplotlib, in the order of ours.
    const COMPUTED: [&str; 8] = ["o", "s", "^", "D", "v", "p", "<", ">"];
    const MEASURED: [&str; 4] = ["+", "x", "*", "1"];
    let mark = match look.mark {
        Some(Mark::Computed(number) | Mark::Dot(number)) => COMPUTED[number % COMPUTED.len()],
        Some(Mark::Measured(number)) => MEASURED[number % MEASURED.len()],
        None => "",
    };
    let pattern: Vec<String> =
        look.dash.map(dashes).unwrap_or_default().iter().map(|length| length.to_string()).collect();
    let [red, green, blue]: Colour = look.colour;
    let bold = if look.is_bold { ", bold=True" } else { "" };
    format!("Look(\"#{red:02x}{green:02x}{blue:02x}\", \"{mark}\", [{}]{bold})", pattern.join(", "))
}

/// Text of Python.
fn word(text: &str) -> String {
    // What JSON escapes means the same there.
    serde_json::Value::from(plain(text).as_ref()).to_string()
}

/// Pieces in the notation of formulas of matplotlib.
fn formula(pieces: &[Piece]) -> String {
    let mut text = String::new();
    let mut is_open = false;
    for piece in pieces {
        let is_formula = piece.is_italic || piece.script != Script::Line || piece.has_bar;
        if is_formula != is_open {
            text.push('$');
            is_open = is_formula;
        }
        if !is_formula {
            text.push_str(&piece.text.replace('\\', "\\\\").replace('$', "\\$"));
            continue;
        }
        let plain = piece.text.replace('\\', "").replace(['$', '{', '}', '_', '^', '%', '#'], "");
        let letters = if piece.is_italic { plain } else { format!("\\mathrm{{{plain}}}") };
        let letters = if piece.has_bar { format!("\\overline{{{letters}}}") } else { letters };
        text.push_str(&match piece.script {
            Script::Line => letters,
            Script::Low => format!("_{{{letters}}}"),
            Script::High => format!("^{{{letters}}}"),
        });
    }
    if is_open {
        text.push('$');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_formulas_of_matplotlib() {
        let of = |label: &str| formula(&pieces(label));
        assert_eq!(of("dimensionless drag F̄_H"), "dimensionless drag $\\overline{F}_{\\mathrm{H}}$");
        assert_eq!(of("φ = 30 deg"), "$φ$ = 30°");
        assert_eq!(of("unit weight γ [kN/m^3]"), "unit weight $γ$ (kN/m$^{\\mathrm{3}}$)");
        assert_eq!(of("5 $"), "5 \\$");
    }

    #[test]
    fn the_program_has_a_place_for_the_figures() {
        assert_eq!(PROGRAM.matches(PLACE).count(), 1);
        assert!(!script(&[Figure::default()]).contains(PLACE));
    }
}
