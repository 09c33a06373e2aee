//! The plots of the ledgers: where the work went, and what nobody can account for.

use super::chart::Chart;
use super::curve::{Curve, Stroke};
use super::plot::Plot;
use super::scale::{Unit, largest};
use crate::history::EnergySample;

/// An entry of the ledger with its name.
type Entry = (&'static str, fn(&EnergySample) -> f64);

/// The energy ledger against time: where the work went.
#[must_use]
pub fn energy_plot(energy: &[EnergySample]) -> Plot {
    let entries: [Entry; 9] = [
        ("external work", |e| e.external),
        ("plastic", |e| e.plastic),
        ("friction", |e| e.friction),
        ("contact method", |e| e.contact),
        ("kinetic", |e| e.kinetic),
        ("elastic", |e| e.elastic),
        ("viscous", |e| e.viscous),
        ("hourglass", |e| e.hourglass),
        ("remap loss", |e| e.remap_loss),
    ];
    let unit = Unit::energy(largest(energy.iter().flat_map(|e| entries.map(|(_, value)| value(e)))));
    let curve = |(n, (name, value)): (usize, &Entry)| Curve {
        name: (*name).to_owned(),
        points: energy.iter().map(|e| [e.time, value(e) / unit.size]).collect(),
        // Seven colours, nine entries: the last two are told apart by their dashes.
        colour: n,
        stroke: if n >= 7 { Stroke::Dashed } else { Stroke::Solid },
    };
    let mut curves: Vec<Curve> = entries.iter().enumerate().map(curve).collect();
    let explained = energy.iter().map(|e| [e.time, (e.external - e.unexplained()) / unit.size]).collect();
    curves.insert(
        1,
        Curve { name: "sum of the rest".into(), points: explained, colour: 6, stroke: Stroke::Dashed },
    );
    let chart = Chart {
        title: "Energy ledger".to_owned(),
        x_label: "time [s]".to_owned(),
        y_label: format!("energy since the start [{}]", unit.name),
        with_zero: true,
        height: 380.0,
        curves,
        ..Chart::default()
    };
    let caption = "Work put in, and where it went. The sum of the rest should lie on the external work; what lies between \
                   them is the closure error."
        .to_owned();
    Plot { name: "energy".to_owned(), svg: chart.svg(), caption }
}

/// The closure of the energy ledger against time, in percent.
#[must_use]
pub fn closure_plot(energy: &[EnergySample]) -> Plot {
    let points = energy.iter().map(|e| [e.time, 100.0 * e.closure()]).collect();
    let volume = energy.iter().map(|e| [e.time, 100.0 * (e.volume_ratio - 1.0)]).collect();
    let chart = Chart {
        title: "Closure of the ledgers".to_owned(),
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
    let caption = "Energy that no ledger entry explains, over the external work; and the change of the soil's volume (dilation \
                   and elastic compression belong to it)."
        .to_owned();
    Plot { name: "closure".to_owned(), svg: chart.svg(), caption }
}
