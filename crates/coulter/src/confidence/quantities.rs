//! The figures of a body that have intervals.

use crate::history::BodySample;
use crate::history::blocks::{BLOCKS, block_averages};
use crate::history::reference::Reference;
use crate::history::steady::Steady;
use crate::trust::BodySetting;

/// Part of the whole force on a body below which a component is not worth an interval (chosen).
const MEANINGFUL: f64 = 0.01;
/// Part of the whole force with which a smaller component is compared, as in a mesh study.
const LEAST_SCALE: f64 = 0.1;

/// A figure of a body.
pub(super) struct Quantity {
    /// Its key in `summary.json`.
    pub(super) key: &'static str,
    /// Its name in words.
    name: &'static str,
    kind: Kind,
}

enum Kind {
    Force(fn(&Steady) -> Option<f64>, fn(&BodySample) -> f64),
    Sinkage,
    TurnRatio,
}

/// All of them.
pub(super) const QUANTITIES: [Quantity; 5] = [
    Quantity { key: "drag_N", name: "drag", kind: Kind::Force(|s| s.drag, |s| s.drag) },
    Quantity { key: "vertical_N", name: "vertical force", kind: Kind::Force(|s| s.vertical, |s| s.vertical) },
    Quantity { key: "lateral_N", name: "lateral force", kind: Kind::Force(|s| s.lateral, |s| s.lateral) },
    Quantity { key: "sinkage_m", name: "sinkage", kind: Kind::Sinkage },
    Quantity { key: "turn_ratio", name: "turn ratio", kind: Kind::TurnRatio },
];

/// The name in words of a figure by its key.
#[must_use]
pub fn name_of(key: &str) -> &str {
    QUANTITIES.iter().find(|quantity| quantity.key == key).map_or(key, |quantity| quantity.name)
}

impl Quantity {
    /// Its steady mean, in its unit.
    pub(super) fn mean(&self, steady: &Steady) -> Option<f64> {
        match self.kind {
            Kind::Force(mean, _) => mean(steady),
            Kind::Sinkage => steady.sinkage,
            Kind::TurnRatio => steady.turn_ratio,
        }
    }

    /// Its averages over the blocks of a window; `None` if there are too few samples.
    pub(super) fn blocks(&self, inside: &[BodySample], reference: &Reference) -> Option<[f64; BLOCKS]> {
        let averages = |value: fn(&BodySample) -> f64| {
            let values: Vec<f64> = inside.iter().map(value).collect();
            block_averages(&values)
        };
        match self.kind {
            Kind::Force(_, sample) => averages(sample),
            Kind::Sinkage => averages(|s| s.sinkage),
            Kind::TurnRatio => {
                let (spin, speed) = (averages(|s| s.spin)?, averages(|s| s.rolling_speed)?);
                let mut ratios = [0.0; BLOCKS];
                for (ratio, (spin, speed)) in ratios.iter_mut().zip(spin.into_iter().zip(speed)) {
                    *ratio = reference.turn_ratio(spin, speed)?;
                }
                Some(ratios)
            }
        }
    }

    /// What half-widths are compared with; `None` where the figure has no meaning for this body.
    pub(super) fn scale(&self, steady: &Steady, setting: Option<&BodySetting>) -> Option<f64> {
        match self.kind {
            Kind::Force(mean, _) => {
                let components =
                    [steady.drag, steady.vertical, steady.lateral].map(Option::unwrap_or_default);
                let whole = components.iter().map(|f| f * f).sum::<f64>().sqrt();
                let size = mean(steady)?.abs();
                (size > MEANINGFUL * whole).then(|| size.max(LEAST_SCALE * whole))
            }
            // Where it is prescribed, it is known.
            Kind::Sinkage => {
                setting.filter(|setting| setting.heaves_freely).and(steady.sinkage.map(f64::abs))
            }
            Kind::TurnRatio => steady.turn_ratio.map(|_| 1.0),
        }
    }
}
