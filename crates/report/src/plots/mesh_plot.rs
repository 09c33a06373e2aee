//! A figure against the cell width, with its interval.

use super::chart::Chart;
use super::curve::{Curve, Stroke};
use super::plot::Plot;
use results::mesh_study::Convergence;

/// Points of the curve of the observed order.
const POINTS: usize = 40;

/// A figure on several meshes.
#[derive(Clone, Debug)]
pub(crate) struct MeshPlot<'a> {
    /// Name of the file.
    pub(crate) name: String,
    /// Title of the plot.
    pub(crate) title: String,
    /// Label of the y axis.
    pub(crate) label: String,
    /// Unit of the y axis in SI units.
    pub(crate) unit: f64,
    /// Representative cell width [m] and value on each mesh, from coarse to fine.
    pub(crate) values: &'a [[f64; 2]],
    /// The interval.
    pub(crate) interval: [f64; 2],
    /// How the figure converges.
    pub(crate) convergence: &'a Convergence,
}

impl MeshPlot<'_> {
    /// The plot: the values as dots, the interval from the finest mesh to h = 0, and the curve of the order,
    /// where one was observed.
    pub(crate) fn plot(&self) -> Plot {
        let point = |h: f64, value: f64| [1e3 * h, value / self.unit];
        let dots = self.values.iter().map(|[h, value]| point(*h, *value)).collect();
        let finest = self.values.last().map_or(0.0, |[h, _]| *h);
        let [low, high] = self.interval;
        let bracket = vec![point(0.0, low), point(finest, low), point(finest, high), point(0.0, high)];
        let mut curves = vec![
            Curve { name: "interval".to_owned(), points: bracket, colour: 1, stroke: Stroke::Solid },
            Curve { name: "steady mean".to_owned(), points: dots, colour: 0, stroke: Stroke::Dots },
        ];
        curves.extend(self.order_curve());
        let chart = Chart {
            title: self.title.clone(),
            x_label: "cell width h [mm]".to_owned(),
            y_label: self.label.clone(),
            curves,
            ..Chart::default()
        };
        let caption = "The steady mean on each mesh against the representative cell width, and the interval that holds the value for \
                       h = 0 and a long tow."
            .to_owned();
        Plot { name: self.name.clone(), svg: chart.svg(), caption }
    }

    /// f₀ + (f₁ − f₀)(h/h₁)^p over the widths.
    fn order_curve(&self) -> Option<Curve> {
        let (limit, order) = (self.convergence.extrapolated?, self.convergence.order);
        let ([coarsest, _], [finest, value]) = (self.values.first()?, self.values.last()?);
        let at = |n: usize| {
            let h = coarsest * n as f64 / POINTS as f64;
            [1e3 * h, (limit + (value - limit) * (h / finest).powf(order)) / self.unit]
        };
        let points = (0..=POINTS).map(at).collect();
        Some(Curve { name: format!("order {order:.2}"), points, colour: 0, stroke: Stroke::Dashed })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_interval_and_order_are_drawn() {
        let values = [[0.0225, 15.0], [0.015, 14.5], [0.01, 14.2]];
        let order = Convergence { extrapolated: Some(13.8), order: 1.3, ..Convergence::default() };
        for (convergence, curves) in [(order, 2), (Convergence::default(), 1)] {
            let plot = MeshPlot {
                name: "disc_meshes_drag".into(),
                title: "Drag".into(),
                label: "F_H [N]".into(),
                unit: 1.0,
                values: &values,
                interval: [13.0, 15.4],
                convergence: &convergence,
            };
            let svg = plot.plot().svg;
            assert_eq!(svg.matches("stroke-linejoin=\"round\"").count(), curves);
            // Three dots.
            assert_eq!(svg.matches("h0").count(), 3);
            assert!(!svg.contains("NaN"));
        }
    }
}
