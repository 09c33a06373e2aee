//! The plots of a body's rim: stress, slip and friction along the outline.

use super::chart::Chart;
use super::curve::{Curve, Stroke};
use super::plot::Plot;
use crate::history::reference::Reference;
use crate::history::rim::RimLine;
use crate::output::units::{Unit, digits, largest};

/// Width of the running mean along the rim, in cells (chosen). Contact points lie half a cell apart, and nodes share their forces among
/// them: from one to the next stress may be all or nothing, over whole cells it is what the soil bears.
const CELLS: f64 = 2.0;

/// A quantity along the rim with its name, and what weighs it in a mean.
type Entry = (&'static str, fn(&RimLine) -> f64, fn(&RimLine) -> f64);

/// The plots of a rim, running means over two cells of this width [m]: against the polar angle where the body can roll, otherwise against
/// the arc; none without contact.
#[must_use]
pub fn rim_plots(reference: &Reference, lines: &[RimLine], cell: f64) -> Vec<Plot> {
    let touches = |l: &RimLine| l.contact > 0.0;
    let Some((first, last)) = lines.iter().position(touches).zip(lines.iter().rposition(touches)) else {
        return Vec::new();
    };
    let rim = Rim { reference, lines: &lines[first..=last], width: CELLS * cell };
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
    /// Width of the running mean [m].
    width: f64,
}

impl Rim<'_> {
    fn stresses(&self) -> Plot {
        let area = |l: &RimLine| l.area;
        let entries: [Entry; 3] = [
            ("normal stress σ", |l| l.normal_stress, area),
            ("shear stress τ, along", |l| l.shear_along, area),
            ("outward", |l| l.shear_outward, area),
        ];
        let unit = Unit::stress(largest(running_mean(self.lines, self.width, &entries[0]).into_iter()));
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
        let contact = |l: &RimLine| l.area * l.contact;
        let entries: [Entry; 2] =
            [("along", |l| l.slip_along, contact), ("outward", |l| l.slip_outward, contact)];
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
        let load = |l: &RimLine| l.area * l.normal_stress;
        let entries: [Entry; 2] = [
            ("whatever its direction", |l| l.mobilised, load),
            ("along the rim", |l| l.mobilised_along, load),
        ];
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
        let mean = format!("mean over {} cells, {} {}", CELLS, digits(self.width / length.size), length.name);
        let curve = |(number, entry): (usize, &Entry)| {
            let values = running_mean(self.lines, self.width, entry);
            let points = self.lines.iter().zip(values).map(|(l, value)| [at(l), value / unit]).collect();
            let name = if number == 0 { format!("{} ({mean})", entry.0) } else { entry.0.to_owned() };
            Curve { name, points, colour: number, stroke: STROKES[number] }
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
            caption: format!(
                "{caption} Running mean over {CELLS} cells along the outline: between the points of a cell the grid tells \
                 nothing apart. rim.csv has each point."
            ),
        }
    }
}

const STROKES: [Stroke; 3] = [Stroke::Solid, Stroke::Dashed, Stroke::Dotted];

/// The mean of a quantity over a width [m] of the outline about the middle of each line, within the portion in contact; not-a-number where
/// nothing weighs.
fn running_mean(lines: &[RimLine], width: f64, (_, value, weight): &Entry) -> Vec<f64> {
    // Between two lines the outline belongs half to either.
    let edge =
        |n: usize| match (n.checked_sub(1).map(|before| lines[before].arc), lines.get(n).map(|l| l.arc)) {
            (Some(a), Some(b)) => 0.5 * (a + b),
            (Some(a), None) => a + 0.5 * (a - lines[n.saturating_sub(2)].arc),
            (None, Some(b)) => b - 0.5 * (lines[1.min(lines.len() - 1)].arc - b),
            (None, None) => 0.0,
        };
    let edges: Vec<f64> = (0..=lines.len()).map(edge).collect();
    let mean = |middle: f64| {
        let [from, to] = [middle - 0.5 * width, middle + 0.5 * width];
        let (mut sum, mut whole) = (0.0, 0.0);
        for (n, line) in lines.iter().enumerate() {
            let long = edges[n + 1] - edges[n];
            let inside =
                if long > 0.0 { (to.min(edges[n + 1]) - from.max(edges[n])).max(0.0) / long } else { 1.0 };
            let part = inside * weight(line);
            if part > 0.0 && value(line).is_finite() {
                sum += part * value(line);
                whole += part;
            }
        }
        sum / whole
    };
    // A line with nothing near it stays as it is.
    let of =
        |line: &RimLine| Some(mean(line.arc)).filter(|mean| mean.is_finite()).unwrap_or_else(|| value(line));
    lines.iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points half a cell of 0.1 m apart that bear all or nothing in turn.
    fn saw() -> Vec<RimLine> {
        let line = |n: u32| RimLine {
            arc: 0.05 * f64::from(n),
            area: 1.0,
            contact: 1.0,
            normal_stress: if n.is_multiple_of(2) { 10e3 } else { 0.0 },
            slip_along: f64::NAN,
            ..RimLine::default()
        };
        (0..20).map(line).collect()
    }

    #[test]
    fn stress_that_alternates_from_point_to_point_is_shown_as_its_mean() {
        let entry: Entry = ("σ", |l| l.normal_stress, |l| l.area);
        let means = running_mean(&saw(), 0.2, &entry);
        // At the ends there is less to average.
        assert!(means[2..18].iter().all(|mean| (mean - 5e3).abs() < 1e-9), "{means:?}");
        assert!(means.iter().all(|mean| (mean - 5e3).abs() < 1.7e3), "{means:?}");
        let none: Entry = ("slip", |l| l.slip_along, |l| l.area);
        assert!(running_mean(&saw(), 0.2, &none).iter().all(|mean| mean.is_nan()));
        assert_eq!(running_mean(&saw()[..1], 0.2, &entry), [10e3]);
    }

    #[test]
    fn the_legend_states_the_mean() {
        let reference = Reference { name: "footing".into(), ..Reference::default() };
        let plots = rim_plots(&reference, &saw(), 0.1);
        assert!(plots[0].svg.contains("normal stress σ (mean over 2 cells, 200 mm)"), "{}", plots[0].svg);
        assert!(plots[0].caption.contains("rim.csv"));
    }
}
