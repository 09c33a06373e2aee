//! Metal that hardens: von Mises with linear isotropic hardening.

use super::soil_law::{Initial, SoilLaw, Strength};
use crate::key::allowed::{NOT_NEGATIVE, POSITIVE};
use DefaultValue::Quantity;
use input::key::{DefaultValue, Key, KeyOf, Kind, Numbers, Place, declared, numbers, read};
use input::problem::Problems;
use input::quantity::{STRESS, short_stress};
use input::readable::stress;
use input::typed::Section;
use physics::elastic::Elastic;
use physics::law::Law as ConstitutiveLaw;
use serde::Serialize;

/// Von Mises with linear isotropic hardening.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct VonMises {
    /// Yield stress in plain tension σ_y [Pa].
    pub yield_stress: f64,
    /// Hardening modulus: its slope over the equivalent plastic strain, H ≥ 0 [Pa].
    pub hardening_modulus: f64,
}

type Field = KeyOf<VonMises>;

const FIELDS: &[Field] = &[
    Field::new("yield_stress", Kind::Quantity(STRESS), Place::Number(|metal| &mut metal.yield_stress))
        .required_for("von-mises")
        .within(POSITIVE)
        .means("Initial yield stress σ_y in uniaxial tension (von-mises)."),
    Field::new(
        "hardening_modulus",
        Kind::Quantity(STRESS),
        Place::Number(|metal| &mut metal.hardening_modulus),
    )
    .default(Quantity("0 Pa"))
    .within(NOT_NEGATIVE)
    .means("Hardening modulus H: slope of the yield stress over the equivalent plastic strain (von-mises)."),
];

impl VonMises {
    pub(super) const WORD: &'static str = "von-mises";
    pub(super) const FIELDS: &'static [Field] = FIELDS;
    pub(super) const DECLARED: &'static [Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    pub(super) fn typed(section: &Section, problems: &mut Problems) -> Option<Self> {
        read(FIELDS, Self::default(), section, problems)
    }
}

impl SoilLaw for VonMises {
    fn numbers(&self) -> Numbers {
        numbers(FIELDS, self)
    }

    fn kind(&self) -> &'static str {
        "metal (von-mises)"
    }

    fn cohesion(&self) -> Option<f64> {
        Some(0.5 * self.yield_stress)
    }

    fn sustains(&self, [most, _, least]: [f64; 3]) -> bool {
        most - least <= self.yield_stress
    }

    fn yield_law(&self, elastic: Elastic) -> Option<ConstitutiveLaw> {
        let law = physics::von_mises::VonMises::new(elastic, self.yield_stress, self.hardening_modulus);
        Some(ConstitutiveLaw::VonMises(law))
    }

    fn summary(&self, _density: f64) -> String {
        format!("von Mises, σ_y = {}, H = {}", stress(self.yield_stress), stress(self.hardening_modulus))
    }

    fn spelled_out(&self, _density: f64) -> String {
        let [yield_stress, hardening] = [self.yield_stress, self.hardening_modulus].map(short_stress);
        format!("von-mises, σ_y = {yield_stress}, H = {hardening}")
    }

    fn for_closed_forms(&self, _soil: &Initial, remarks: &mut Vec<String>) -> Result<Strength, String> {
        let cohesion = self.yield_stress / 3_f64.sqrt();
        remarks.push(format!(
            "von-mises as undrained clay of s_u = σ_y/√3 = {:.4} kPa, its strength in simple shear{}",
            1e-3 * cohesion,
            if self.hardening_modulus > 0.0 { "; it is taken not to harden" } else { "" }
        ));
        Ok(Strength { cohesion, ..Strength::default() })
    }
}
