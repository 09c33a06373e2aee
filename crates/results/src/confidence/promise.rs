//! What intervals promise on other cells.

use super::figures::ConfidenceInterval;
use crate::confidence::variations::ErrorSource;

impl ConfidenceInterval {
    /// The half-width over the value that is to be expected once cells `ratio` times as wide are known as
    /// well; `None` where it cannot be told.
    #[must_use]
    pub fn predicted(&self, ratio: f64) -> Option<f64> {
        let relative = self.relative_half_width?;
        if self.half_width == 0.0 {
            return Some(0.0);
        }
        let scale = self.half_width / relative;
        let squares = self.contributions.iter().map(|part| {
            let half = match &part.convergence {
                Some(convergence) => convergence.half_width_with(ratio),
                None => 0.5 * (part.below + part.above),
            };
            half * half
        });
        Some(squares.sum::<f64>().sqrt() / scale)
    }

    /// What would make the half-width over the value as small as wanted.
    #[must_use]
    pub fn what_helps(&self, wanted: f64) -> String {
        let without_cells = self.predicted(0.1).unwrap_or(f64::INFINITY);
        if without_cells > wanted {
            let why = match self.dominated_by {
                Some(ErrorSource::Statistics) => {
                    "the mean over the window scatters; a longer run narrows that"
                }
                Some(ErrorSource::Domain) => {
                    "the faces of the domain have an effect; a larger domain narrows that, --without domain leaves out real walls"
                }
                Some(ErrorSource::Speed) => {
                    "the speed has an effect; a slower motion narrows that, --without speed leaves out one that is meant"
                }
                _ => {
                    "figures scatter from mesh to mesh by more than that; a longer run averages over more of it"
                }
            };
            return why.to_owned();
        }
        let enough = (1..=40)
            .map(|n| 0.95_f64.powi(n))
            .find(|ratio| self.predicted(*ratio).is_some_and(|half| half <= wanted));
        match enough {
            Some(ratio) => format!(
                "cells {ratio:.2} times as wide are expected to reach it, in {:.2} times the time of this run; give more with --budget",
                ratio.powi(-4)
            ),
            None => "cells of a tenth of the width would not be enough".to_owned(),
        }
    }
}
