//! The coefficients of all methods for one face.

use super::{Face, PassiveField, coulomb, eurocode, lancellotta, log_spiral, rankine, sokolovskii};
use crate::error::ModelResult;

/// Normal passive coefficients K_n of a face by every method, or why a method has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Rankine: vertical faces only, without wall friction.
    pub rankine: ModelResult<f64>,
    /// Coulomb: plane wedge; unsafe (an overestimate) for δ > 0.
    pub coulomb: ModelResult<f64>,
    /// Lancellotta: level ground, a lower bound.
    pub lancellotta: ModelResult<f64>,
    /// EN 1997-1 Annex C: a lower bound on level ground.
    pub en1997: ModelResult<f64>,
    /// Sokolovskii: the exact field, with its rupture distance.
    pub sokolovskii: ModelResult<PassiveField>,
    /// Rotating log-spiral block: an upper bound.
    pub log_spiral: ModelResult<f64>,
}

/// Evaluates every method for `face`; each function states its source and range.
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
