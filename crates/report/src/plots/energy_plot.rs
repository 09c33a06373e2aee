//! The plots of the energy balance and of its error.

use super::chart::Chart;
use super::curve::{Curve, Stroke};
use super::plot::Plot;
use input::readable::{Unit, largest};
use results::history::EnergySample;
use results::trust::Setting;

/// An entry of the energy balance with its name.
type Entry = (&'static str, fn(&EnergySample) -> f64);

/// The energy balance against time.
#[must_use]
pub fn energy_plot(energy: &[EnergySample]) -> Plot {
    let entries: [Entry; 10] = [
        ("external work", |e| e.external),
        ("plastic", |e| e.plastic),
        ("friction", |e| e.friction),
        ("contact method", |e| e.contact),
        ("kinetic", |e| e.kinetic),
        ("elastic", |e| e.elastic),
        ("viscous", |e| e.viscous),
        ("hourglass", |e| e.hourglass),
        ("remap loss", |e| e.remap_loss),
        ("seepage", |e| e.seepage),
    ];
    let unit = Unit::energy(largest(energy.iter().flat_map(|e| entries.map(|(_, value)| value(e)))));
    let curve = |(n, (name, value)): (usize, &Entry)| Curve {
        name: (*name).to_owned(),
        points: energy.iter().map(|e| [e.time, value(e) / unit.size]).collect(),
        // Seven colours, ten entries: the last three are dashed.
        colour: n,
        stroke: if n >= 7 { Stroke::Dashed } else { Stroke::Solid },
    };
    let mut curves: Vec<Curve> = entries.iter().enumerate().map(curve).collect();
    let explained = energy.iter().map(|e| [e.time, (e.external - e.unexplained()) / unit.size]).collect();
    curves.insert(
        1,
        Curve {
            name: "sum of the other entries".into(),
            points: explained,
            colour: 6,
            stroke: Stroke::Dashed,
        },
    );
    let chart = Chart {
        title: "Energy balance".to_owned(),
        x_label: "time [s]".to_owned(),
        y_label: format!("energy since the start [{}]", unit.name),
        with_zero: true,
        height: 380.0,
        curves,
        ..Chart::default()
    };
    let caption = "External work, and how it is stored and dissipated. The sum of the other entries should coincide with the external work; \
                   the difference is the error of the balance."
        .to_owned();
    Plot { name: "energy".to_owned(), svg: chart.svg(), caption }
}

/// The errors of the energy and volume balances against time, in percent.
#[must_use]
pub fn closure_plot(setting: &Setting, energy: &[EnergySample]) -> Plot {
    let points = energy.iter().map(|e| [e.time, 100.0 * setting.closure(e)]).collect();
    let volume = energy.iter().map(|e| [e.time, 100.0 * (e.volume_ratio - 1.0)]).collect();
    let chart = Chart {
        title: "Errors of the balances".to_owned(),
        x_label: "time [s]".to_owned(),
        y_label: "error [%]".to_owned(),
        with_zero: true,
        height: 380.0,
        curves: vec![
            Curve::solid("energy: unexplained / external", 1, points),
            Curve::solid("soil volume: change", 0, volume),
        ],
        ..Chart::default()
    };
    let caption = "Energy that no entry of the balance explains, over the external work; and the change of the soil's volume (which \
                   includes dilation and elastic compression)."
        .to_owned();
    Plot { name: "closure".to_owned(), svg: chart.svg(), caption }
}
