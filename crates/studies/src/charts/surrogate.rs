//! How well a surrogate predicts: predicted values over computed ones.

use super::effects::titled;
use super::label::{axis_label, plain_label, shown};
use super::named::{NamedChart, file_name};
use crate::statistics::gaussian_process::{GaussianProcess, LEAST_PREDICTIVITY};
use crate::table::Column;
use coulter::output::plots::{Chart, Curve, Stroke};

/// Each computed value of a response, predicted by the surrogate from all other points.
#[must_use]
pub fn surrogate_chart(response: &Column, model: &str, surrogate: &GaussianProcess) -> NamedChart {
    let title = titled("surrogate", response, model);
    let computed = surrogate.values();
    let pairs = || computed.iter().zip(surrogate.left_out());
    let (low, high) = computed
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(*y), high.max(*y)));
    let bars = pairs().flat_map(|(y, p)| {
        [[*y, p.mean - 2.0 * p.deviation], [*y, p.mean + 2.0 * p.deviation], [f64::NAN; 2]]
    });
    let equal = vec![[low, low], [high, high]];
    let chart = Chart {
        title: title.clone(),
        x_label: format!("computed {}", axis_label(response)),
        y_label: format!("predicted {}", axis_label(response)),
        height: 400.0,
        curves: vec![
            Curve { name: String::new(), points: bars.collect(), colour: 0, stroke: Stroke::Faint },
            Curve { name: "equal".into(), points: equal, colour: 6, stroke: Stroke::Dashed },
            Curve {
                name: "point left out".into(),
                points: pairs().map(|(y, p)| [*y, p.mean]).collect(),
                colour: 0,
                stroke: Stroke::Dots,
            },
        ],
        ..Chart::default()
    };
    let verdict = if surrogate.trusted().is_ok() {
        String::new()
    } else {
        format!(" That is below {LEAST_PREDICTIVITY}: the surrogate is not used.")
    };
    let caption = format!(
        "Each value of {} predicted from all other points, with two standard deviations. Predictivity Q² = {:.3}; noise {}.{verdict}",
        plain_label(response),
        surrogate.predictivity(),
        shown(response, surrogate.noise())
    );
    NamedChart { name: file_name(&["surrogate", &response.name, model]), title, caption, svg: chart.svg() }
}

#[cfg(test)]
mod tests {
    use super::super::samples::grid;
    use super::*;
    use crate::statistics::design::sobol;
    use crate::statistics::gaussian_process::fit;

    #[test]
    fn predictivity_is_stated() {
        let design = sobol(40, 2, 1).unwrap();
        let values: Vec<f64> = design.iter().map(|x| x[0] * x[0] + x[1]).collect();
        let chart =
            surrogate_chart(grid().column("drag").unwrap(), "solver", &fit(&design, &values).unwrap());
        assert!(
            chart.caption.contains("Q² = 1.000") || chart.caption.contains("Q² = 0.99"),
            "{}",
            chart.caption
        );
        assert!(chart.svg.contains("computed drag [N]") && chart.title.contains("solver"));
    }
}
