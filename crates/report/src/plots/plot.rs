//! The plots of a body: forces, sinkage, rotation and torque.

use super::chart::Chart;
use super::curve::{Curve, Level, Stroke};
use input::readable::{Unit, digits, largest};
use results::history::BodySample;
use results::history::quantities::{NO_DRAG, Steady};
use results::history::reference::Reference;
use results::history::steady::{is_tow, moving_average};
use results::overlay::{Overlay, PlotKind};
use serde::Serialize;

/// Width of the moving average of the force curves, over the reference length d (chosen: suppresses
/// fluctuations with the grid spacing, preserves changes over more than a cell width of tow).
const SMOOTHING: f64 = 0.05;
/// First colour of overlays; those of the run come before it.
const OVERLAY_COLOUR: usize = 3;

/// A quantity of a history with its name.
type Entry = (&'static str, fn(&BodySample) -> f64);

/// A plot of a report: its name, the SVG text, and a caption.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plot {
    /// Name of the file.
    pub name: String,
    /// The picture as SVG text.
    pub svg: String,
    /// What the plot shows.
    pub caption: String,
}

/// In which units plots are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Units {
    /// Units in which the numbers are easy to read.
    #[default]
    Readable,
    /// Units of the body: lengths over d, forces over γ t d², torques over γ t d³.
    Dimensionless,
}

/// One body's history, with everything that its plots need.
#[derive(Clone, Copy, Debug)]
pub struct BodyHistory<'a> {
    /// The body's reference lengths and force.
    pub reference: &'a Reference,
    /// The samples.
    pub samples: &'a [BodySample],
    /// Averages over the steady window.
    pub steady: &'a Steady,
    /// Curves to overlay on the plots.
    pub overlays: &'a [Overlay],
    /// The units of the plots.
    pub units: Units,
}

/// The abscissa of a body's plots: displacement if it is towed, otherwise time.
struct Abscissa {
    values: Vec<f64>,
    label: String,
    unit: f64,
    window: Option<[f64; 2]>,
    /// Width of the moving average [s].
    smoothing: f64,
    is_tow: bool,
}

impl BodyHistory<'_> {
    /// All plots of the body that have something to show.
    #[must_use]
    pub fn plots(&self) -> Vec<Plot> {
        let mut plots = vec![self.forces()];
        // A body that is held at its depth has no course of it.
        if self.sinks() || self.overlays.iter().any(|overlay| overlay.plot == PlotKind::ForceSinkage) {
            plots.push(self.force_sinkage());
        }
        if self.sinks() || self.overlays.iter().any(|overlay| overlay.plot == PlotKind::SinkageDisplacement) {
            plots.push(self.sinkage());
        }
        if self.reference.turns || self.samples.iter().any(|s| s.rotation != 0.0) {
            plots.extend(self.reference.radius.map(|_| self.turn_ratio()));
            plots.push(self.rotation());
        }
        if self.reference.radius.is_some() {
            plots.push(self.axle_torque());
        }
        plots
    }

    /// Whether there is drag to be shown: of a body that is pressed straight down it is noise.
    fn has_drag(&self) -> bool {
        let most = |force: fn(&BodySample) -> f64| largest(self.samples.iter().map(force));
        self.reference.towed || most(|s| s.drag) > NO_DRAG * most(|s| s.vertical)
    }

    /// Whether the depth changes by more than a thousandth of the body (chosen).
    fn sinks(&self) -> bool {
        let depths = || self.samples.iter().map(|s| s.sinkage).filter(|z| z.is_finite());
        let span = depths().fold(f64::NEG_INFINITY, f64::max) - depths().fold(f64::INFINITY, f64::min);
        span > 1e-3 * self.reference.length
    }

    fn plot(&self, name: &str, chart: Chart, caption: &str) -> Plot {
        let caption = caption.to_owned();
        Plot { name: format!("{}_{name}", self.reference.name), svg: chart.svg(), caption }
    }

    fn abscissa(&self) -> Abscissa {
        let window = |from: Option<f64>, to: Option<f64>, unit: f64| Some([from? / unit, to? / unit]);
        if is_tow(self.samples, self.reference) {
            let metres: Vec<f64> = self.samples.iter().map(|s| s.displacement).collect();
            let unit = self.unit("m", largest(metres.iter().copied()));
            return Abscissa {
                window: window(self.steady.from_m, self.steady.to_m, unit.size),
                values: metres.iter().map(|u| u / unit.size).collect(),
                label: format!("displacement u [{}]", unit.name),
                unit: unit.size,
                smoothing: SMOOTHING * self.reference.length / largest(self.samples.iter().map(|s| s.speed)),
                is_tow: true,
            };
        }
        let values: Vec<f64> = self.samples.iter().map(|s| s.time).collect();
        let span = values.last().copied().unwrap_or(0.0) - values.first().copied().unwrap_or(0.0);
        Abscissa {
            window: window(self.steady.from_s, self.steady.to_s, 1.0),
            values,
            label: "time [s]".to_owned(),
            unit: 1.0,
            smoothing: 0.01 * span,
            is_tow: false,
        }
    }

    /// The unit of numbers up to `largest` of this SI unit. Weightless soil has no force of reference.
    fn unit(&self, si: &'static str, largest: f64) -> Unit {
        let name = match si {
            "N" => "γtd²",
            "N m" => "γtd³",
            _ => "d",
        };
        let size = self.reference.group(si, 1.0).filter(|_| self.units == Units::Dimensionless);
        size.map_or(Unit::of(si, largest), |size| Unit { name, size: size.recip() })
    }

    fn series(&self, along: &[f64], unit: f64, value: impl Fn(&BodySample) -> f64) -> Vec<[f64; 2]> {
        along.iter().zip(self.samples).map(|(x, s)| [*x, value(s) / unit]).collect()
    }

    /// Overlays of one plot as curves; a single point becomes a level across the plot.
    fn overlays(&self, plot: PlotKind, along: &[f64], units: [f64; 2]) -> Vec<Curve> {
        let belongs =
            |o: &&Overlay| o.plot == plot && o.body.as_ref().is_none_or(|name| *name == self.reference.name);
        let finite = || along.iter().copied().filter(|x| x.is_finite());
        let ends = [finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max)];
        let curve = |(n, overlay): (usize, &Overlay)| {
            let points = match overlay.points[..] {
                [[_, y]] => ends.map(|x| [x, y / units[1]]).to_vec(),
                _ => overlay.points.iter().map(|p| [p[0] / units[0], p[1] / units[1]]).collect(),
            };
            let stroke =
                if overlay.measured { Stroke::Marks(n) } else { Stroke::Marked { dash: 1 + n % 7, mark: n } };
            Curve { name: overlay.name.clone(), points, colour: OVERLAY_COLOUR + n, stroke }
        };
        self.overlays.iter().filter(belongs).enumerate().map(curve).collect()
    }

    /// Times of the samples [s]. Smoothing uses time, because the displacement is constant while a body
    /// settles before the tow.
    fn times(&self) -> Vec<f64> {
        self.samples.iter().map(|s| s.time).collect()
    }

    fn force_unit(&self) -> Unit {
        self.unit("N", largest(self.samples.iter().flat_map(|s| [s.drag, s.vertical])))
    }

    /// Raw and smoothed forces against `along`.
    fn force_curves(&self, along: &[f64], unit: f64, base: &Abscissa) -> Vec<Curve> {
        let forces: [Entry; 2] = [("drag F_H", |s| s.drag), ("vertical F_V", |s| s.vertical)];
        let shown = || forces.iter().enumerate().skip(usize::from(!self.has_drag()));
        let mut curves = Vec::new();
        for (colour, (_, force)) in shown() {
            let points = self.series(along, unit, force);
            curves.push(Curve { name: String::new(), points, colour, stroke: Stroke::Faint });
        }
        for (colour, (name, force)) in shown() {
            let raw: Vec<f64> = self.samples.iter().map(|s| force(s) / unit).collect();
            let smooth = moving_average(&self.times(), &raw, base.smoothing);
            let points = along.iter().zip(smooth).map(|(x, f)| [*x, f]).collect();
            curves.push(Curve::solid(name, colour, points));
        }
        curves
    }

    fn forces(&self) -> Plot {
        let base = self.abscissa();
        let unit = self.force_unit();
        let mut curves = self.force_curves(&base.values, unit.size, &base);
        if base.is_tow {
            curves.extend(self.overlays(PlotKind::ForceDisplacement, &base.values, [base.unit, unit.size]));
        }
        let means = [("F_H", self.steady.drag), ("F_V", self.steady.vertical)];
        let shown = means.iter().enumerate().skip(usize::from(!self.has_drag()));
        let levels = shown.filter_map(|(colour, (name, mean))| {
            let ([from, to], value) = (base.window?, mean.as_ref()? / unit.size);
            Some(Level {
                label: format!("mean {name} = {} {}", digits(value), unit.name),
                value,
                from,
                to,
                colour,
            })
        });
        let chart = Chart {
            title: format!("Forces on {}", self.reference.name),
            x_label: base.label.clone(),
            y_label: format!("force of the soil [{}]", unit.name),
            with_zero: true,
            levels: levels.collect(),
            shaded: base.window,
            curves,
            ..Chart::default()
        };
        let smoothing = if base.is_tow { "0.05 d of tow" } else { "one per cent of the time" };
        let caption = format!(
            "Drag F_H resists the tow, F_V supports the body. Thin: as recorded (impulse over each interval). Thick: \
             centred moving average over {smoothing} (no phase shift). Shaded: the steady window with its means; a force \
             that still rises there is not steady."
        );
        self.plot("forces", chart, &caption)
    }

    fn force_sinkage(&self) -> Plot {
        let base = self.abscissa();
        let unit = self.force_unit();
        let depth = self.unit("m", largest(self.samples.iter().map(|s| s.sinkage)));
        let along: Vec<f64> = self.samples.iter().map(|s| s.sinkage / depth.size).collect();
        let mut curves = self.force_curves(&along, unit.size, &base);
        curves.extend(self.overlays(PlotKind::ForceSinkage, &along, [depth.size, unit.size]));
        let chart = Chart {
            title: format!("Force against sinkage of {}", self.reference.name),
            x_label: format!("sinkage z [{}]", depth.name),
            y_label: format!("force of the soil [{}]", unit.name),
            with_zero: true,
            curves,
            ..Chart::default()
        };
        self.plot(
            "force_sinkage",
            chart,
            "The same forces against sinkage, as closed-form models predict them. A body that is free to sink comes to rest \
             where F_V balances its weight.",
        )
    }

    fn sinkage(&self) -> Plot {
        let base = self.abscissa();
        let unit = self.unit("m", largest(self.samples.iter().map(|s| s.sinkage)));
        let mut curves =
            vec![Curve::solid("sinkage z", 0, self.series(&base.values, unit.size, |s| s.sinkage))];
        if base.is_tow {
            curves.extend(self.overlays(PlotKind::SinkageDisplacement, &base.values, [base.unit, unit.size]));
        }
        let chart = Chart {
            title: format!("Sinkage of {}", self.reference.name),
            x_label: base.label,
            y_label: format!("sinkage z [{}]", unit.name),
            y_down: true,
            with_zero: true,
            shaded: base.window,
            curves,
            ..Chart::default()
        };
        self.plot(
            "sinkage",
            chart,
            "Depth of the lowest point below the undisturbed surface; deeper is lower in the plot.",
        )
    }

    fn turn_ratio(&self) -> Plot {
        let base = self.abscissa();
        // At the start of the tow the ratio of two small numbers is meaningless: it is shown only while the
        // body moves.
        let moving = 0.05 * largest(self.samples.iter().map(|s| s.speed));
        let ratio = |s: &BodySample| {
            let ratio = s.turn_ratio(self.reference).filter(|_| s.speed.abs() > moving);
            ratio.map_or(f64::NAN, |r| r.clamp(-3.0, 3.0))
        };
        let points = self.series(&base.values, 1.0, ratio);
        let ends = [base.values.first(), base.values.last()].map(|x| [x.copied().unwrap_or(0.0), 1.0]);
        let rolling = Curve {
            name: "rolls without slip".into(),
            points: ends.to_vec(),
            colour: 6,
            stroke: Stroke::Dashed,
        };
        let mut curves = vec![rolling, Curve::solid("turn ratio ω r / v", 2, points)];
        if base.is_tow {
            curves.extend(self.overlays(PlotKind::TurnRatio, &base.values, [base.unit, 1.0]));
        }
        let chart = Chart {
            title: format!("Turn ratio of {}", self.reference.name),
            x_label: base.label,
            y_label: "turn ratio ω r / v [–]".to_owned(),
            with_zero: true,
            shaded: base.window,
            curves,
            ..Chart::default()
        };
        self.plot(
            "turn_ratio",
            chart,
            "1: rolls without slip; 0: slides without rotation; above 1: driven. Values beyond ±3 are clipped.",
        )
    }

    fn rotation(&self) -> Plot {
        let base = self.abscissa();
        let mut curves =
            vec![Curve::solid("rotation Ω", 2, self.series(&base.values, 1f64.to_radians(), |s| s.rotation))];
        if let Some(radius) = self.reference.radius.filter(|_| base.is_tow) {
            let start = self.samples.first().map_or(0.0, |s| s.displacement);
            let points = self.series(&base.values, 1f64.to_radians(), |s| (s.displacement - start) / radius);
            curves.insert(0, Curve { name: "u / r".into(), points, colour: 6, stroke: Stroke::Dashed });
        }
        let chart = Chart {
            title: format!("Rotation of {}", self.reference.name),
            x_label: base.label,
            y_label: "rotation Ω [deg]".to_owned(),
            with_zero: true,
            shaded: base.window,
            curves,
            ..Chart::default()
        };
        self.plot("rotation", chart, "Rotation angle, forward positive. Dashed: rolling without slip.")
    }

    fn axle_torque(&self) -> Plot {
        let base = self.abscissa();
        let unit = self.unit("N m", largest(self.samples.iter().map(|s| s.axle_torque)));
        let raw: Vec<f64> = self.samples.iter().map(|s| s.axle_torque / unit.size).collect();
        let smooth = moving_average(&self.times(), &raw, base.smoothing);
        let pairs =
            |values: &[f64]| base.values.iter().zip(values).map(|(x, y)| [*x, *y]).collect::<Vec<_>>();
        let mut curves = vec![
            Curve { name: String::new(), points: pairs(&raw), colour: 1, stroke: Stroke::Faint },
            Curve::solid("axle torque M", 1, pairs(&smooth)),
        ];
        if base.is_tow {
            curves.extend(self.overlays(PlotKind::AxleTorque, &base.values, [base.unit, unit.size]));
        }
        let chart = Chart {
            title: format!("Axle torque on {}", self.reference.name),
            x_label: base.label,
            y_label: format!("torque of the soil M [{}]", unit.name),
            with_zero: true,
            shaded: base.window,
            curves,
            ..Chart::default()
        };
        self.plot("axle_torque", chart, "Torque of the soil about the axle, positive when it makes the body roll forward. It vanishes for a free body in a steady tow.")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plots_are_in_the_bodys_own_units_on_request() {
        let (length, width, unit_weight) = (0.2, 0.05, 16e3);
        let reference = Reference { length, width, unit_weight, towed: true, ..Reference::default() };
        let sample = |n: u32| {
            let u = 0.01 * f64::from(n);
            BodySample {
                time: u,
                displacement: u,
                drag: 32.0,
                speed: 1.0,
                sinkage: 0.2 * u,
                ..BodySample::default()
            }
        };
        let samples: Vec<BodySample> = (0..=40).map(sample).collect();
        let steady = Steady::default();
        let (reference, samples) = (&reference, samples.as_slice());
        let plots = |units| BodyHistory { reference, samples, steady: &steady, overlays: &[], units }.plots();
        let own = plots(Units::Dimensionless);
        assert!(own[0].svg.contains("[γtd²]") && own[0].svg.contains("displacement u [d]"), "{}", own[0].svg);
        assert!(own.iter().any(|plot| plot.svg.contains("sinkage z [d]")));
        assert!(plots(Units::Readable)[0].svg.contains("[N]"));
    }
}
