//! Every coefficient of one face side by side.

use super::{Face, PassiveField, coulomb, eurocode, lancellotta, log_spiral, rankine, sokolovskii};
use crate::error::Answer;

/// Normal passive coefficients K_n of one face by every method, or the reason why a method has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Rankine: vertical faces only, knows no wall friction.
    pub rankine: Answer<f64>,
    /// Coulomb: plane wedge; unsafe (too large) for δ > 0.
    pub coulomb: Answer<f64>,
    /// Lancellotta: level ground, a lower bound.
    pub lancellotta: Answer<f64>,
    /// EN 1997-1 Annex C: a lower bound on level ground.
    pub en1997: Answer<f64>,
    /// Sokolovskii: the exact field, with the distance to which the ground breaks.
    pub sokolovskii: Answer<PassiveField>,
    /// Rotating log-spiral block: an upper bound.
    pub log_spiral: Answer<f64>,
}

/// Evaluates every method for `face`; see each for its source and range.
#[must_use]
pub fn compare(face: &Face) -> Comparison {
    Comparison {
        rankine: rankine(face),
        coulomb: coulomb(face),
        lancellotta: lancellotta(face),
        en1997: eurocode(face),
        sokolovskii: sokolovskii(face),
        log_spiral: log_spiral(face),
    }
}
