//! Sand whose strength and stiffness follow its density and pressure.

use super::soil_law::{Initial, SoilLaw, Strength};
use crate::key::allowed::{ACUTE, NOT_NEGATIVE, POSITIVE, RELATIVE_DENSITY};
use crate::key::usual::{CRITICAL_ANGLE, DRY_DENSITY};
use DefaultValue::{Number, Quantity};
use input::key::{DefaultValue, Key, KeyOf, Kind, Numbers, Place, declared, in_ranges, numbers, read};
use input::problem::Problems;
use input::quantity::{ANGLE, DENSITY, DENSITY_GRADIENT, LENGTH, STRESS, short, short_stress};
use input::readable::{degrees, digits};
use input::typed::Section;
use physics::elastic::{Elastic, Stiffening};
use physics::law::Law as ConstitutiveLaw;
use physics::sand::SandParameters;
use serde::Serialize;
use solver::material::Material;

/// Sand whose strength and stiffness follow its density and pressure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Sand {
    /// Friction angle of the critical state in triaxial compression φ_cv [rad].
    pub critical_friction_angle: f64,
    /// Dry density in the loosest state [kg/m³].
    pub minimum_density: f64,
    /// Dry density in the densest state [kg/m³].
    pub maximum_density: f64,
    /// Bolton's Q.
    pub bolton_q: f64,
    /// Bolton's R.
    pub bolton_r: f64,
    /// Plastic shear strain at which half of the strength is mobilised.
    pub reference_strain: f64,
    /// Bulk modulus of plastic compression at 100 kPa [Pa].
    pub compression_modulus: f64,
    /// Largest mean pressure that the soil has borne before [Pa].
    #[serde(skip_serializing_if = "is_zero")]
    pub preconsolidation: f64,
    /// Mean pressure beyond which the elastic moduli no longer grow [Pa].
    pub stiffness_limit: f64,
    /// Length over which the density that governs the strength is averaged [m].
    pub characteristic_length: Option<f64>,
    /// Growth of the relative density at the start with the depth below the top of the soil [1/m].
    #[serde(skip_serializing_if = "is_zero")]
    pub density_gradient: f64,
}

/// Whether a number is 0.
#[allow(clippy::trivially_copy_pass_by_ref)] // as serde calls it
fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

type Field = KeyOf<Sand>;

const RELATIVE: Field = Field::new("relative_density", Kind::RelativeDensity, Place::Elsewhere)
    .derived("from the density")
    .within(RELATIVE_DENSITY)
    .means(
        "Relative density I_D at the start, instead of `density` or `unit_weight`; below 0 for sand \
             looser than e_max (sand).",
    );

const FIELDS: &[Field] = &[
    Field::new(
        "critical_friction_angle",
        Kind::Quantity(ANGLE),
        Place::Number(|sand| &mut sand.critical_friction_angle),
    )
    .required_for("sand")
    .within(ACUTE)
    .usually(CRITICAL_ANGLE)
    .means(
        "Friction angle of the critical state in triaxial compression φ_cv; about the angle of repose \
             (sand).",
    ),
    Field::new("minimum_density", Kind::Quantity(DENSITY), Place::Number(|sand| &mut sand.minimum_density))
        .required_for("sand")
        .within(POSITIVE)
        .usually(DRY_DENSITY)
        .means("Dry density in the loosest state, at e_max (sand)."),
    Field::new("maximum_density", Kind::Quantity(DENSITY), Place::Number(|sand| &mut sand.maximum_density))
        .required_for("sand")
        .within(POSITIVE)
        .usually(DRY_DENSITY)
        .means("Dry density in the densest state, at e_min (sand)."),
    RELATIVE,
    Field::new(
        "relative_density_gradient",
        Kind::Quantity(DENSITY_GRADIENT),
        Place::Number(|sand| &mut sand.density_gradient),
    )
    .default(Quantity("0 1/m"))
    .within(NOT_NEGATIVE)
    .means(
        "Growth of the relative density with depth, from that at the top of the soil, or of its layer; \
             at its base it is at most 1 (sand).",
    ),
    Field::new("bolton_q", Kind::Number, Place::Number(|sand| &mut sand.bolton_q))
        .default(Number(10.0))
        .within(POSITIVE)
        .means("Bolton's Q: 10 for quartz and feldspar, 8 for limestone (sand)."),
    Field::new("bolton_r", Kind::Number, Place::Number(|sand| &mut sand.bolton_r))
        .default(Number(0.7))
        .within(NOT_NEGATIVE)
        .means("Bolton's R: relative density of the critical state at low pressure over 1/(Q − 5) (sand)."),
    Field::new("reference_strain", Kind::Number, Place::Number(|sand| &mut sand.reference_strain))
        .default(Number(0.0009))
        .within(POSITIVE)
        .means(
            "Plastic shear strain at which half of the strength is mobilised, at I_D = 0.5 and up to 20 kPa \
             (sand).",
        ),
    Field::new(
        "compression_modulus",
        Kind::Quantity(STRESS),
        Place::Number(|sand| &mut sand.compression_modulus),
    )
    .default(Quantity("20 MPa"))
    .within(POSITIVE)
    .means("Bulk modulus of plastic compression at I_D = 0.5 and 100 kPa (sand)."),
    Field::new(
        "preconsolidation_pressure",
        Kind::Quantity(STRESS),
        Place::Number(|sand| &mut sand.preconsolidation),
    )
    .default(Quantity("0 Pa"))
    .within(NOT_NEGATIVE)
    .means(
        "Largest mean pressure that the soil has borne before: of rolled, vibrated or once deeper \
             ground; up to it compression is elastic (sand).",
    ),
    Field::new("stiffness_limit", Kind::Quantity(STRESS), Place::Number(|sand| &mut sand.stiffness_limit))
        .default(Quantity("50 kPa"))
        .within(POSITIVE)
        .means("Mean pressure beyond which the elastic moduli no longer grow; it sets the time step (sand)."),
    Field::new(
        "characteristic_length",
        Kind::Quantity(LENGTH),
        Place::Optional(|sand| &mut sand.characteristic_length),
    )
    .derived("none")
    .within(POSITIVE)
    .means(
        "Length over which the density that governs strength and dilatancy is averaged, so that bands \
             of softening sand do not depend on the cells; at least two cells, some 15 grain sizes (sand).",
    ),
];

/// Mean pressure to which Young's modulus refers [Pa].
const STIFFNESS_PRESSURE: f64 = 1e5;

/// Mean pressure below which the elastic moduli are constant [Pa]: no test was made at less.
const CONSTANT_BELOW: f64 = 1e3;

impl Sand {
    pub(super) const WORD: &'static str = "sand";
    pub(super) const FIELDS: &'static [Field] = FIELDS;
    pub(super) const DECLARED: &'static [Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    pub(super) fn typed(section: &Section, problems: &mut Problems) -> Option<Self> {
        read(FIELDS, Self::default(), section, problems)
    }

    /// Density [kg/m³] at a relative density.
    pub(crate) fn density_at(&self, relative_density: f64) -> f64 {
        let range = self.maximum_density - self.minimum_density;
        self.minimum_density * self.maximum_density / (self.maximum_density - relative_density * range)
    }

    /// Relative density at a density [kg/m³].
    pub(crate) fn relative_density(&self, density: f64) -> f64 {
        let range = self.maximum_density - self.minimum_density;
        self.maximum_density * (density - self.minimum_density) / (density * range)
    }

    /// The solver's law of sand.
    fn law(&self, elastic: Elastic) -> physics::sand::Sand {
        let parameters = SandParameters {
            critical_friction: self.critical_friction_angle,
            limit_density: [self.minimum_density, self.maximum_density],
            bolton: [self.bolton_q, self.bolton_r],
            reference_strain: self.reference_strain,
            compression_modulus: self.compression_modulus,
        };
        let least = CONSTANT_BELOW.min(self.stiffness_limit);
        let stiffening = Stiffening { least, most: self.stiffness_limit };
        physics::sand::Sand::new(elastic, stiffening, &parameters)
    }

    /// The solver's law for soil of this sand, and its dilatancy index at the start, at low pressure.
    pub(crate) fn at_start(&self, soil: &Initial) -> (physics::sand::Sand, f64) {
        let law = self.law(soil.elastic);
        (law, law.dilatancy_index(self.relative_density(soil.density), 0.0))
    }
}

impl SoilLaw for Sand {
    fn numbers(&self) -> Numbers {
        numbers(FIELDS, self)
    }

    fn kind(&self) -> &'static str {
        "frictional (sand)"
    }

    fn contradictions(&self, path: &str, problems: &mut Problems) {
        let Self { minimum_density: loosest, maximum_density: densest, .. } = *self;
        if densest <= loosest {
            let message = format!(
                "the densest state, {densest:.1} kg/m³, is not denser than the loosest, {loosest:.1} kg/m³"
            );
            problems.add(format!("{path}.maximum_density"), message, "it must be above minimum_density");
        }
    }

    fn check_at(&self, density: f64, path: &str, problems: &mut Problems) {
        // It follows from the density: a limit that was typed comes back with a rounding error.
        let relative_density = (self.relative_density(density) * 1e9).round() / 1e9;
        in_ranges(path, &[(&RELATIVE.key, relative_density)], problems);
    }

    fn friction_angle(&self) -> Option<f64> {
        Some(self.critical_friction_angle)
    }

    fn cohesion(&self) -> Option<f64> {
        Some(0.0)
    }

    /// Whether the sand sustains these stresses: up to the critical state, since shear beyond it only hardens
    /// the sand up to its peak.
    fn sustains(&self, [most, _, least]: [f64; 3]) -> bool {
        most - least <= (most + least) * self.critical_friction_angle.sin()
    }

    fn changes_volume(&self) -> [bool; 2] {
        [true; 2]
    }

    fn volume_strain(&self, soil: &Initial) -> Option<f64> {
        // Zero dilatancy index, which is linear in I_D.
        let index = |relative| self.at_start(&Initial { density: self.density_at(relative), ..*soil }).1;
        let [at_0, at_1] = [0.0, 1.0].map(index);
        // With so small a Q no density is critical at low pressure.
        if at_1 <= at_0 {
            return None;
        }
        Some(soil.density / self.density_at(at_0 / (at_0 - at_1)) - 1.0)
    }

    fn stiffening(&self) -> f64 {
        (self.stiffness_limit / STIFFNESS_PRESSURE).sqrt()
    }

    fn yield_law(&self, elastic: Elastic) -> Option<ConstitutiveLaw> {
        Some(ConstitutiveLaw::Sand(self.law(elastic)))
    }

    fn complete(&self, material: &mut Material) {
        material.characteristic_length = self.characteristic_length;
        material.preconsolidation = self.preconsolidation;
    }

    fn summary(&self, density: f64) -> String {
        format!(
            "sand, φ_cv = {}, I_D = {}{}",
            degrees(self.critical_friction_angle),
            digits(self.relative_density(density)),
            match self.density_gradient {
                0.0 => String::new(),
                gradient => format!(" + {}/m × depth", digits(gradient)),
            }
        )
    }

    fn spelled_out(&self, density: f64) -> String {
        let growth = match self.density_gradient {
            0.0 => String::new(),
            gradient => format!(" + {}/m × depth", short(gradient)),
        };
        let borne = match self.preconsolidation {
            0.0 => String::new(),
            pressure => format!(" beyond {}", short_stress(pressure)),
        };
        let length = self.characteristic_length;
        let length =
            length.map_or(String::new(), |l| format!(",\n         characteristic length {} m", short(l)));
        format!(
            "sand, φ_cv = {}°, I_D = {}{growth} (ρ from {} to {} kg/m³), Q = {}, R = {},\n         \
             half of its strength at a strain of {}, compression modulus {}{borne}, stiffer up to {}{length}",
            short(self.critical_friction_angle.to_degrees()),
            short(self.relative_density(density)),
            short(self.minimum_density),
            short(self.maximum_density),
            self.bolton_q,
            self.bolton_r,
            self.reference_strain,
            short_stress(self.compression_modulus),
            short_stress(self.stiffness_limit),
        )
    }

    /// The strength for closed forms: with the peak friction angle at low pressure, and the dilation angle of
    /// φ = φ_cv + 0.8 ψ (Bolton 1986).
    fn for_closed_forms(&self, soil: &Initial, remarks: &mut Vec<String>) -> Result<Strength, String> {
        let (law, index) = self.at_start(soil);
        let ratio = law.peak_ratio(index);
        let friction_angle = (3.0 * ratio / (6.0 + ratio)).asin();
        let dilation_angle = ((friction_angle - self.critical_friction_angle) / 0.8).max(0.0);
        let [phi, psi, critical] =
            [friction_angle, dilation_angle, self.critical_friction_angle].map(f64::to_degrees);
        remarks.push(format!(
            "sand as Mohr-Coulomb soil with the strength that its density gives it: φ = {phi:.2}°, ψ = {psi:.2}° \
             (φ_cv = {critical:.2}°); it is not fully mobilised in loose sand, nor kept in dense sand"
        ));
        Ok(Strength { friction_angle, dilation_angle, ..Strength::default() })
    }
}
