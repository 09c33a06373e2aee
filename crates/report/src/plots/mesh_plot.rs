//! A figure against the cell width, with its interval.

use super::chart::Chart;
use super::curve::{Curve, Stroke};
use super::plot::Plot;
use results::confidence::Convergence;

/// Points of the curve of the trend.
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
    /// What infinitely small cells would give.
    pub(crate) convergence: &'a Convergence,
}

impl MeshPlot<'_> {
    /// The plot: the values as dots, the interval from the finest mesh to h = 0, and the curve of the order,
    /// where one was observed.
    pub(crate) fn plot(&self) -> Plot {
        let point = |h: f64, value: f64| [1e3 * h, value / self.unit];
        let dots = self.values.iter().map(|[h, value]| point(*h, *value)).collect();
        let Convergence { extrapolated, half_width, .. } = *self.convergence;
        let limit = [-1.0, 1.0].map(|side| point(0.0, extrapolated + side * half_width));
        let mut curves = vec![
            Curve {
                name: "90 % of h = 0".to_owned(),
                points: limit.to_vec(),
                colour: 1,
                stroke: Stroke::Solid,
            },
            Curve { name: "steady mean".to_owned(), points: dots, colour: 0, stroke: Stroke::Dots },
        ];
        curves.extend(self.trend());
        let chart = Chart {
            title: self.title.clone(),
            x_label: "cell width h [mm]".to_owned(),
            y_label: self.label.clone(),
            curves,
            ..Chart::default()
        };
        let caption = "The steady mean on each mesh against the representative cell width, what is expected in between, and the interval (90 %) of \
                       what infinitely small cells would give."
            .to_owned();
        Plot { name: self.name.clone(), svg: chart.svg(), caption }
    }

    /// The trend over the widths.
    fn trend(&self) -> Option<Curve> {
        let ([coarsest, _], [finest, _]) = (self.values.first()?, self.values.last()?);
        let at = |n: usize| {
            let h = coarsest * n as f64 / POINTS as f64;
            [1e3 * h, self.convergence.at(h / finest) / self.unit]
        };
        let points = (0..=POINTS).map(at).collect();
        Some(Curve { name: "expected".to_owned(), points, colour: 0, stroke: Stroke::Dashed })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_interval_and_order_are_drawn() {
        let values = [[0.0225, 15.0], [0.015, 14.5], [0.01, 14.2]];
        let convergence = Convergence {
            extrapolated: 13.8,
            half_width: 1.2,
            error: 0.4,
            order: 1.3,
            ..Convergence::default()
        };
        let plot = MeshPlot {
            name: "disc_meshes_drag".into(),
            title: "Drag".into(),
            label: "F_H [N]".into(),
            unit: 1.0,
            values: &values,
            convergence: &convergence,
        };
        let svg = plot.plot().svg;
        assert_eq!(svg.matches("stroke-linejoin=\"round\"").count(), 2);
        // Three dots.
        assert_eq!(svg.matches("h0").count(), 3);
        assert!(!svg.contains("NaN"));
    }
}
