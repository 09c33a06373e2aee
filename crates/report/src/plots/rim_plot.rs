//! The plots of a body's rim: stress, slip and friction along the outline.

use super::chart::Chart;
use super::curve::{Curve, Stroke};
use super::plot::Plot;
use input::readable::{Unit, largest};
use results::history::reference::Reference;
use results::history::rim::RimLine;

/// A quantity along the rim with its name.
type Entry = (&'static str, fn(&RimLine) -> f64);

/// The plots of a rim: against the polar angle where the body can roll, otherwise against the arc; none
/// without contact.
#[must_use]
pub fn rim_plots(reference: &Reference, lines: &[RimLine]) -> Vec<Plot> {
    let touches = |l: &RimLine| l.contact > 0.0;
    let Some((first, last)) = lines.iter().position(touches).zip(lines.iter().rposition(touches)) else {
        return Vec::new();
    };
    let rim = Rim { reference, lines: &lines[first..=last] };
    let mut plots = vec![rim.stresses(), rim.slip()];
    // A body without friction has no limit of it.
    if rim.lines.iter().any(|line| line.mobilised.is_finite()) {
        plots.push(rim.friction());
    }
    plots
}

/// The portion of a rim that is in contact.
struct Rim<'a> {
    reference: &'a Reference,
    lines: &'a [RimLine],
}

impl Rim<'_> {
    fn stresses(&self) -> Plot {
        let entries: [Entry; 3] = [
            ("normal stress σ", |l| l.normal_stress),
            ("shear stress τ, along", |l| l.shear_along),
            ("outward", |l| l.shear_outward),
        ];
        let unit = Unit::stress(largest(self.lines.iter().map(entries[0].1)));
        let caption = "Mean stress of the soil on the rim in the steady window. Along: along the outline, below the body \
                       positive forwards; outward: along the axle, away from the mid-plane.";
        self.plot(
            "rim_stress",
            "Stress on the rim",
            &format!("stress [{}]", unit.name),
            (&entries, unit.size, caption),
        )
    }

    fn slip(&self) -> Plot {
        let speed = |l: &RimLine| l.slip_along.abs().max(l.slip_outward.abs());
        let unit = Unit::speed(largest(self.lines.iter().map(speed)));
        let entries: [Entry; 2] = [("along", |l| l.slip_along), ("outward", |l| l.slip_outward)];
        let caption = "Mean velocity of the body's surface relative to the soil while in contact. Where the slip along the \
                       rim changes its sign, two zones of flow meet.";
        self.plot(
            "rim_slip",
            "Slip along the rim",
            &format!("slip velocity [{}]", unit.name),
            (&entries, unit.size, caption),
        )
    }

    fn friction(&self) -> Plot {
        let entries: [Entry; 2] =
            [("whatever its direction", |l| l.mobilised), ("along the rim", |l| l.mobilised_along)];
        let caption = "Friction over its limit, μσ or the adhesion: 1 where all of it is mobilised. Along the rim its mean has \
                       a sign, and is less where the direction of the friction varies.";
        self.plot(
            "rim_friction",
            "Mobilised friction",
            "friction over its limit [–]",
            (&entries, 1.0, caption),
        )
    }

    /// A plot of some quantities in one unit.
    fn plot(
        &self,
        name: &str,
        title: &str,
        y_label: &str,
        (entries, unit, caption): (&[Entry], f64, &str),
    ) -> Plot {
        let rolls = self.reference.radius.is_some();
        let length = Unit::length(largest(self.lines.iter().map(|l| l.arc)));
        let at = |l: &RimLine| if rolls { l.angle.to_degrees() } else { l.arc / length.size };
        let x_label = if rolls {
            "angle from straight below, front positive [deg]".to_owned()
        } else {
            format!("arc along the outline from straight below, front positive [{}]", length.name)
        };
        let curve = |(number, entry): (usize, &Entry)| {
            let points = self.lines.iter().map(|l| [at(l), entry.1(l) / unit]).collect();
            Curve { name: entry.0.to_owned(), points, colour: number, stroke: STROKES[number] }
        };
        let chart = Chart {
            title: format!("{title} of {}", self.reference.name),
            x_label,
            y_label: y_label.to_owned(),
            with_zero: true,
            curves: entries.iter().enumerate().map(curve).collect(),
            ..Chart::default()
        };
        Plot {
            name: format!("{}_{name}", self.reference.name),
            svg: chart.svg(),
            caption: format!("{caption} By way of the nodes: nothing below a cell is resolved."),
        }
    }
}

const STROKES: [Stroke; 3] = [Stroke::Solid, Stroke::Dashed, Stroke::Dotted];
