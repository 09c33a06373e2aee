//! Pictures of the verification: errors over tolerances, and what the runs behind them did.

use crate::row::{Row, Tolerance};
use crate::run_balances::RunBalances;
use crate::table::figure;
use crate::trace::Trace;
use coulter::output::plots::{Chart, Curve};
use std::fmt::Write as _;

/// Runs of a benchmark in one picture at most; more could not be distinguished.
const MOST_RUNS: usize = 8;
/// Layout of the picture of the figures [pixels].
const WIDTH: f64 = 860.0;
const LINE: f64 = 18.0;
const LEFT: f64 = 570.0;
const RIGHT: f64 = 44.0;
/// Errors beyond this many tolerances are drawn at the edge.
const EDGE: f64 = 2.0;

/// Curves of the runs of a benchmark, as SVG; `None` if nothing of it can be drawn.
#[must_use]
pub fn runs(title: &str, balances: &[&RunBalances]) -> Option<String> {
    let curves = |pick: fn(&Trace) -> Option<&Vec<[f64; 2]>>| -> Vec<Curve> {
        let all = balances.iter().filter_map(|run| Some((run, pick(&run.trace)?)));
        let drawn = all.take(MOST_RUNS).enumerate();
        drawn.map(|(n, (run, points))| Curve::solid(&run.case, n, points.clone())).collect()
    };
    let forces =
        curves(|trace| if let Trace::Force(points) = trace { Some(points).filter(moves) } else { None });
    let heaps = curves(|trace| if let Trace::Heap(points) = trace { Some(points) } else { None });
    let (x_label, y_label, curves) = if forces.is_empty() {
        ("x [m]", "thickness of the soil at the end [m]", heaps)
    } else {
        (
            "displacement of the body [m]",
            "force [N; plane strain: N/m]",
            forces.into_iter().map(from_start).collect(),
        )
    };
    if curves.is_empty() {
        return None;
    }
    let chart = Chart {
        title: title.to_owned(),
        x_label: x_label.to_owned(),
        y_label: y_label.to_owned(),
        with_zero: true,
        curves,
        ..Chart::default()
    };
    Some(on_paper(&chart.svg()))
}

/// Whether a body moves at all; the force on one that is held has no abscissa.
fn moves(points: &&Vec<[f64; 2]>) -> bool {
    points.iter().any(|p| p[0] != points[0][0])
}

/// The curve with displacements counted from its first point.
fn from_start(mut curve: Curve) -> Curve {
    let start = curve.points.first().map_or(0.0, |p| p[0]);
    curve.points.iter_mut().for_each(|p| p[0] -= start);
    curve
}

/// The errors of the judged figures of a benchmark over their tolerances, as SVG; `None` if none is judged.
#[must_use]
pub fn figures(rows: &[Row]) -> Option<String> {
    let judged: Vec<(&Row, f64, bool)> =
        rows.iter().filter_map(|r| Some((r, over_tolerance(r)?, r.passes()?))).collect();
    if judged.is_empty() {
        return None;
    }
    let height = LINE * judged.len() as f64 + 46.0;
    let x_at = |ratio: f64| LEFT + (WIDTH - LEFT - RIGHT) * (ratio.clamp(-EDGE, EDGE) + EDGE) / (2.0 * EDGE);
    let bottom = height - 30.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"errors over \
         tolerances\" font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"12\" fill=\"currentColor\">\n\
         <rect x=\"{:.1}\" y=\"8\" width=\"{:.1}\" height=\"{:.1}\" fill=\"#2a9d5c\" fill-opacity=\"0.15\"/>\n",
        x_at(-1.0),
        x_at(1.0) - x_at(-1.0),
        bottom - 8.0
    );
    for tick in [-EDGE, -1.0, 0.0, 1.0, EDGE] {
        let x = x_at(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} 8V{bottom:.1}\" stroke=\"currentColor\" stroke-opacity=\"0.2\"/><text x=\"{x:.1}\" y=\"{:.1}\" \
             text-anchor=\"middle\" opacity=\"0.8\">{}</text>",
            bottom + 16.0,
            if tick.abs() == EDGE { format!("beyond {tick}") } else { format!("{tick}") }
        );
    }
    for (n, (row, ratio, passes)) in judged.iter().enumerate() {
        let y = 8.0 + LINE * (n as f64 + 0.5);
        let colour = if *passes { "#1d7a45" } else { "#c0392b" };
        let text = escaped(&format!("{} · {}: {}", row.case, row.quantity, figure(row.obtained)));
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" font-size=\"11\">{text}</text><circle cx=\"{:.1}\" cy=\"{y:.1}\" \
             r=\"4\" fill=\"{colour}\"/>",
            LEFT - 8.0,
            y + 4.0,
            x_at(*ratio)
        );
    }
    svg.push_str("</svg>\n");
    Some(on_paper(&svg))
}

/// The error of a judged row in units of its tolerance.
pub(crate) fn over_tolerance(row: &Row) -> Option<f64> {
    let (Tolerance::Relative(limit) | Tolerance::Absolute(limit)) = row.tolerance else { return None };
    let error = row.error()?;
    Some(match () {
        () if error.is_nan() => EDGE,
        () if error == 0.0 => 0.0,
        () if limit == 0.0 => EDGE.copysign(error),
        () => error / limit,
    })
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A picture with a white background and dark text: an image cannot inherit the text colour of its page.
fn on_paper(svg: &str) -> String {
    let paper = "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    match svg.split_once(">\n") {
        Some((head, rest)) => format!("{head} color=\"#222\">\n{paper}{rest}"),
        None => svg.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_show_the_judged_rows_and_nothing_invalid() {
        let row = |obtained| Row::info("X1", "a < b", "N & c", obtained).within(5.0, 0.02, "");
        let svg = figures(&[row(5.05), row(f64::NAN), row(-1e9), Row::info("X1", "", "info", 1.0)]).unwrap();
        assert_eq!(svg.matches("<circle").count(), 3);
        assert!(svg.contains("a &lt; b · N &amp; c") && !svg.contains("cx=\"NaN"));
        assert_eq!(figures(&[Row::info("X1", "", "info", 1.0)]), None);
        assert_eq!(runs("X1", &[]), None);
    }
}
