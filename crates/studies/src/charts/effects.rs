//! Main effects and tornado of a response.

use super::label::{axis_label, plain_label, short, shown, shown_range};
use super::named::{NamedChart, file_name};
use crate::statistics::effects::LevelMean;
use crate::statistics::tornado::{SwingSource, Tornado};
use crate::table::Column;
use coulter::output::plots::{Bar, BarGroup, Bars, Chart, Curve, Stroke};

/// The main effect of a factor.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorEffect<'a> {
    /// The factor.
    pub factor: &'a Column,
    /// Words of the factor, in the order of their numbers from 0 on; empty for a factor of numbers.
    pub words: &'a [String],
    /// Mean response by level.
    pub levels: Vec<LevelMean>,
}

/// The main effects of all factors on a response: means over the range of each factor, with their standard
/// errors.
#[must_use]
pub fn main_effects_chart(response: &Column, model: &str, effects: &[FactorEffect<'_>]) -> NamedChart {
    let title = titled("main effects", response, model);
    let mut curves = Vec::new();
    // A single factor of numbers has its own axis.
    let own = effects.first().filter(|effect| effects.len() == 1 && effect.words.is_empty());
    let is_own = own.is_some();
    for (colour, effect) in effects.iter().enumerate() {
        let Some((first, last)) = effect.levels.first().zip(effect.levels.last()) else { continue };
        let range = [first.level, last.level];
        let place = |level: f64| if is_own { level } else { (level - range[0]) / (range[1] - range[0]) };
        let mut bars = Vec::new();
        for level in &effect.levels {
            if let Some(error) = level.error {
                let x = place(level.level);
                bars.extend([[x, level.mean - error], [x, level.mean + error], [f64::NAN, f64::NAN]]);
            }
        }
        let points: Vec<[f64; 2]> =
            effect.levels.iter().map(|level| [place(level.level), level.mean]).collect();
        let name =
            format!("{}: {}", plain_label(effect.factor), range_text(effect.factor, effect.words, range));
        curves.push(Curve { name: String::new(), points: bars, colour, stroke: Stroke::Faint });
        curves.push(Curve { name, points, colour, stroke: Stroke::Marked { dash: colour, mark: colour } });
    }
    let chart = Chart {
        title: title.clone(),
        x_label: own
            .map_or("place in the range of the factor [–]".into(), |effect| axis_label(effect.factor)),
        y_label: format!("mean {}", axis_label(response)),
        height: 340.0,
        curves,
        ..Chart::default()
    };
    let caption = format!(
        "Mean {} at each level of a factor, or in bins of it, over all other factors; thin lines: ± its standard error.",
        plain_label(response)
    );
    NamedChart { name: file_name(&["main_effects", &response.name, model]), title, caption, svg: chart.svg() }
}

/// The tornado of a response; `factors` are those of the numbers in it, each with its words (empty for
/// numbers).
#[must_use]
pub fn tornado_chart(
    response: &Column,
    model: &str,
    tornado: &Tornado,
    factors: &[(&Column, &[String])],
) -> NamedChart {
    let title = titled("tornado", response, model);
    let mut groups = Vec::new();
    for swing in &tornado.swings {
        let Some((factor, words)) = factors.get(swing.factor) else { continue };
        let bar = |end: usize| Bar {
            value: swing.responses[end],
            colour: end,
            note: end_text(words, swing.ends[end]),
            ..Bar::default()
        };
        // Where both ends lie on one side, the shorter bar would hide below the longer one.
        let mut bars = vec![bar(0), bar(1)];
        bars.sort_by(|a, b| (b.value - tornado.base).abs().total_cmp(&(a.value - tornado.base).abs()));
        if (bars[0].value - tornado.base) * (bars[1].value - tornado.base) > 0.0 {
            bars[1].note.clear();
        }
        groups.push(BarGroup { label: axis_label(factor), bars });
    }
    let chart = Bars {
        title: title.clone(),
        x_label: axis_label(response),
        base: tornado.base,
        shared: true,
        names: vec![("low end".into(), 0), ("high end".into(), 1)],
        groups,
    };
    let from = match tornado.source {
        SwingSource::OneAtATime => "from points that differ from the base point in this factor only",
        SwingSource::Surrogate => "from the surrogate, the other factors at their means",
        SwingSource::MainEffects => "from the means over all other factors at the ends of the factor",
    };
    let caption = format!(
        "{} at the low and the high end of each factor, {from}; base {}.",
        plain_label(response),
        shown(response, tornado.base)
    );
    NamedChart { name: file_name(&["tornado", &response.name, model]), title, caption, svg: chart.svg() }
}

/// `Drag F_H: tornado (solver)`.
pub(super) fn titled(what: &str, response: &Column, model: &str) -> String {
    let of = if model.is_empty() { String::new() } else { format!(" ({})", model.replace('_', " ")) };
    format!("{}: {what}{of}", plain_label(response))
}

/// The word of a number, or the number.
fn end_text(words: &[String], level: f64) -> String {
    match words.get(level.round().max(0.0) as usize) {
        Some(word) => word.replace('_', " "),
        None => short(level),
    }
}

fn range_text(factor: &Column, words: &[String], range: [f64; 2]) -> String {
    if words.is_empty() {
        return shown_range(factor, range);
    }
    format!("{} to {}", end_text(words, range[0]), end_text(words, range[1]))
}

#[cfg(test)]
mod tests {
    use super::super::samples::grid;
    use super::*;
    use crate::statistics::effects::main_effect;
    use crate::statistics::tornado::tornado;

    #[test]
    fn effects_and_tornado_name_factors_ends_and_units() {
        let table = grid();
        let angle: Vec<f64> = table.numbers("angle").unwrap().iter().flatten().copied().collect();
        let drag: Vec<f64> = angle.iter().map(|a| 3.0 * a).collect();
        let levels = main_effect(&angle, &drag).unwrap();
        let effect = FactorEffect { factor: table.column("angle").unwrap(), words: &[], levels };
        let response = table.column("drag").unwrap();
        let chart = main_effects_chart(response, "plain_model", &[effect]);
        assert!(
            chart.svg.contains("angle: 25 to 45 deg")
                && chart.svg.contains("mean drag [N]")
                && chart.svg.contains(">angle [deg]<"),
            "{}",
            chart.svg
        );
        assert_eq!(
            (chart.name.as_str(), chart.title.as_str()),
            ("main_effects_drag_plain_model", "drag: main effects (plain model)")
        );
        let inputs: Vec<Vec<f64>> = angle.iter().map(|a| vec![*a]).collect();
        let found = tornado(&inputs, &drag, None).unwrap();
        let chart = tornado_chart(response, "", &found, &[(table.column("angle").unwrap(), &[])]);
        assert!(chart.svg.contains("angle [deg]") && chart.svg.contains(">45<"), "{}", chart.svg);
        assert!(chart.caption.contains("base 105 N"), "{}", chart.caption);
    }
}
