//! Soil that does not fail.

use super::soil_law::SoilLaw;
use input::key::Numbers;
use physics::elastic::Elastic as Moduli;
use physics::law::Law as ConstitutiveLaw;

/// Linear elastic soil; it has no parameters but those of every soil.
pub(super) struct Elastic;

impl Elastic {
    pub(super) const WORD: &'static str = "elastic";
}

impl SoilLaw for Elastic {
    fn numbers(&self) -> Numbers {
        Vec::new()
    }

    fn kind(&self) -> &'static str {
        "elastic"
    }

    fn cohesion(&self) -> Option<f64> {
        None
    }

    fn sustains(&self, _principal: [f64; 3]) -> bool {
        true
    }

    fn bears_effective_stress(&self) -> bool {
        true
    }

    fn yield_law(&self, _elastic: Moduli) -> Option<ConstitutiveLaw> {
        None
    }

    fn summary(&self, _density: f64) -> String {
        "linear elastic".to_owned()
    }

    fn spelled_out(&self, _density: f64) -> String {
        "elastic".to_owned()
    }
}
