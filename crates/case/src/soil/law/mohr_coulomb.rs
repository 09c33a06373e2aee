//! Frictional soil with constant angles: Mohr–Coulomb.

use super::soil_law::{Initial, SoilLaw, Strength};
use crate::key::allowed::{ACUTE, ECCENTRICITY, NOT_NEGATIVE, POSITIVE};
use crate::key::usual::{COHESION, FRICTION_ANGLE};
use crate::key::words::POTENTIALS;
use DefaultValue::{Number, Quantity, Word};
use input::key::{DefaultValue, Key, KeyOf, Kind, Numbers, Place, declared, numbers, read};
use input::problem::Problems;
use input::quantity::{ANGLE, DENSITY, STRESS, short, short_stress};
use input::readable::{degrees, digits, stress};
use input::typed::Section;
use physics::elastic::Elastic;
use physics::law::Law as ConstitutiveLaw;
use physics::menetrey_willam::{Eccentricity, MenetreyWillam};
use serde::Serialize;
use solver::material::Material;

/// Mohr–Coulomb.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct MohrCoulomb {
    /// Friction angle φ [rad].
    pub friction_angle: f64,
    /// Dilation angle ψ [rad], 0 ≤ ψ ≤ φ.
    pub dilation_angle: f64,
    /// Cohesion c [Pa]; 0 is allowed.
    pub cohesion: f64,
    /// Tension cut-off: the largest tensile stress [Pa]; at most c cot φ.
    pub tension_cutoff: f64,
    /// Plastic flow potential.
    pub potential: Potential,
    /// Density below which the soil no longer dilates [kg/m³].
    pub critical_density: Option<f64>,
}

/// The flow potential of the frictional law.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Potential {
    /// A potential of the form of the yield surface, with ψ in place of φ.
    #[default]
    MohrCoulomb,
    /// Menétrey and Willam (1995).
    MenetreyWillam {
        /// Meridional eccentricity ε ≥ 0.
        meridional: f64,
        /// Deviatoric eccentricity e, ½ < e ≤ 1.
        deviatoric: f64,
    },
}

impl Potential {
    /// Meridional and deviatoric eccentricity of the smooth potential.
    fn eccentricities(&mut self) -> Option<[&mut f64; 2]> {
        match self {
            Self::MohrCoulomb => None,
            Self::MenetreyWillam { meridional, deviatoric } => Some([meridional, deviatoric]),
        }
    }
}

type Field = KeyOf<MohrCoulomb>;

const FIELDS: &[Field] = &[
    Field::new("friction_angle", Kind::Quantity(ANGLE), Place::Number(|soil| &mut soil.friction_angle))
        .required_for("mohr-coulomb")
        .within(ACUTE)
        .usually(FRICTION_ANGLE)
        .means("Friction angle φ."),
    Field::new("dilation_angle", Kind::Quantity(ANGLE), Place::Number(|soil| &mut soil.dilation_angle))
        .default(Quantity("0 deg"))
        .within(ACUTE)
        .means("Dilation angle ψ, at most φ (mohr-coulomb)."),
    Field::new("cohesion", Kind::Quantity(STRESS), Place::Number(|soil| &mut soil.cohesion))
        .default(Quantity("0 Pa"))
        .within(NOT_NEGATIVE)
        .usually(COHESION)
        .means("Cohesion c; may be exactly 0 (mohr-coulomb)."),
    Field::new("tension_cutoff", Kind::Quantity(STRESS), Place::Number(|soil| &mut soil.tension_cutoff))
        .default(Quantity("0 Pa"))
        .within(NOT_NEGATIVE)
        .means("Tension cut-off: the largest tensile stress, at most c cot φ (mohr-coulomb)."),
    Field::new(
        "flow_potential",
        Kind::Choice(&POTENTIALS),
        Place::Word(|soil, word| {
            if word == SMOOTH {
                let Eccentricity { meridional, deviatoric } = Eccentricity::usual(soil.friction_angle);
                soil.potential = Potential::MenetreyWillam { meridional, deviatoric };
            }
        }),
    )
    .default(Word("mohr-coulomb"))
    .means(
        "Plastic flow potential: the Mohr–Coulomb pyramid with ψ in place of φ, or the smooth potential \
             that Abaqus uses (mohr-coulomb).",
    ),
    Field::new(
        "meridional_eccentricity",
        Kind::Number,
        Place::Part(|soil| soil.potential.eccentricities().map(|[meridional, _]| meridional)),
    )
    .default(Number(0.1))
    .within(NOT_NEGATIVE)
    .means(
        "How fast the smooth potential approaches its asymptote; has no effect without cohesion \
             (menetrey-willam).",
    ),
    Field::new(
        "deviatoric_eccentricity",
        Kind::Number,
        Place::Part(|soil| soil.potential.eccentricities().map(|[_, deviatoric]| deviatoric)),
    )
    .derived("(3 − sin φ)/(3 + sin φ)")
    .within(ECCENTRICITY)
    .means("Shape of the smooth potential in the deviatoric plane; 1 is a circle (menetrey-willam)."),
    Field::new(
        "critical_density",
        Kind::Quantity(DENSITY),
        Place::Optional(|soil| &mut soil.critical_density),
    )
    .derived("0.8 of the density")
    .within(POSITIVE)
    .means("Density below which the soil no longer dilates (mohr-coulomb, with dilation_angle)."),
];

/// The word of the smooth potential, and the keys that only it has.
const SMOOTH: &str = "menetrey-willam";
const OF_SMOOTH: [&str; 2] = ["meridional_eccentricity", "deviatoric_eccentricity"];

/// Density at which soil with ψ > 0 ceases to dilate over that at the start, where no critical density is
/// given; chosen: from its densest to its loosest state sand expands by about a quarter. Without an end a
/// random case fell to a seventh of its density, too light for the time step.
const FULLY_DILATED: f64 = 0.8;

impl MohrCoulomb {
    pub(super) const WORD: &'static str = "mohr-coulomb";
    pub(super) const FIELDS: &'static [Field] = FIELDS;
    pub(super) const DECLARED: &'static [Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    pub(super) fn typed(section: &Section, problems: &mut Problems) -> Option<Self> {
        let soil = read(FIELDS, Self::default(), section, problems);
        let potential = section.number("friction_angle").and_then(|_| section.text("flow_potential"));
        if potential.is_some_and(|word| word != SMOOTH) {
            for key in OF_SMOOTH.iter().filter(|key| section.has(key)) {
                let message = format!("`{key}` applies only to the smooth potential");
                let cure = "remove it, or set  flow_potential = \"menetrey-willam\"";
                problems.add(section.at(key), message, cure);
            }
        }
        soil
    }
}

impl SoilLaw for MohrCoulomb {
    fn numbers(&self) -> Numbers {
        numbers(FIELDS, self)
    }

    fn kind(&self) -> &'static str {
        "frictional (mohr-coulomb)"
    }

    fn contradictions(&self, path: &str, problems: &mut Problems) {
        if self.dilation_angle > self.friction_angle {
            let message =
                "the dilation angle ψ is larger than the friction angle φ: plastic flow would create energy";
            let cure = "it must be from 0 deg to the friction angle";
            problems.add(format!("{path}.dilation_angle"), message, cure);
        }
        // The apex of the cone; for φ = 0 there is none.
        let apex =
            if self.friction_angle > 0.0 { self.cohesion / self.friction_angle.tan() } else { f64::INFINITY };
        if self.tension_cutoff > apex {
            let message =
                format!("the tension cut-off is beyond the apex of the yield cone, c cot φ = {apex:.4} Pa");
            problems.add(
                format!("{path}.tension_cutoff"),
                message,
                "lower it, or remove it for no tension at all",
            );
        }
        if self.dilation_angle == 0.0 && self.critical_density.is_some() {
            let message = "soil with a dilation angle of 0 does not dilate";
            problems.add(format!("{path}.critical_density"), message, "remove it, or set  dilation_angle");
        }
    }

    fn check_at(&self, density: f64, path: &str, problems: &mut Problems) {
        if self.critical_density.is_some_and(|critical| critical > density) {
            let message = format!(
                "the initial density of the soil, {:.1} kg/m³, is below its critical density",
                density
            );
            let cure = "it must be at most the density; dense sand dilates by some per cent";
            problems.add(format!("{path}.critical_density"), message, cure);
        }
    }

    fn friction_angle(&self) -> Option<f64> {
        Some(self.friction_angle)
    }

    fn dilation_angle(&self) -> f64 {
        self.dilation_angle
    }

    fn cohesion(&self) -> Option<f64> {
        Some(self.cohesion)
    }

    fn sustains(&self, [most, _, least]: [f64; 3]) -> bool {
        let (sin, cos) = self.friction_angle.sin_cos();
        most - least <= (most + least) * sin + 2.0 * self.cohesion * cos
    }

    fn volume_strain(&self, soil: &Initial) -> Option<f64> {
        Some(soil.density / self.critical_density? - 1.0)
    }

    fn yield_law(&self, elastic: Elastic) -> Option<ConstitutiveLaw> {
        let Self { friction_angle: phi, dilation_angle: psi, cohesion, tension_cutoff, .. } = *self;
        Some(match self.potential {
            Potential::MohrCoulomb => ConstitutiveLaw::MohrCoulomb(physics::mohr_coulomb::MohrCoulomb::new(
                elastic,
                phi,
                psi,
                cohesion,
                tension_cutoff,
            )),
            Potential::MenetreyWillam { meridional, deviatoric } => {
                let shape = Eccentricity { meridional, deviatoric };
                ConstitutiveLaw::MenetreyWillam(MenetreyWillam::new(
                    elastic,
                    phi,
                    psi,
                    cohesion,
                    tension_cutoff,
                    shape,
                ))
            }
        })
    }

    fn complete(&self, material: &mut Material) {
        let by_default = (self.dilation_angle > 0.0).then_some(FULLY_DILATED * material.density);
        material.critical_density = self.critical_density.or(by_default);
    }

    fn summary(&self, _density: f64) -> String {
        let limit = self.critical_density.map(|rho| format!(" down to {} kg/m³", digits(rho)));
        let smooth = match self.potential {
            Potential::MohrCoulomb => "",
            Potential::MenetreyWillam { .. } => ", potential of Menétrey and Willam",
        };
        format!(
            "Mohr–Coulomb, φ = {}, ψ = {}{}, c = {}{smooth}",
            degrees(self.friction_angle),
            degrees(self.dilation_angle),
            limit.unwrap_or_default(),
            stress(self.cohesion)
        )
    }

    fn spelled_out(&self, _density: f64) -> String {
        let smooth = match self.potential {
            Potential::MohrCoulomb => String::new(),
            Potential::MenetreyWillam { meridional, deviatoric } => {
                format!(", smooth potential (ε = {}, e = {})", short(meridional), short(deviatoric))
            }
        };
        format!(
            "mohr-coulomb, φ = {}°, ψ = {}°{}, c = {}, tension up to {}{smooth}",
            short(self.friction_angle.to_degrees()),
            short(self.dilation_angle.to_degrees()),
            self.critical_density.map_or(String::new(), |rho| format!(" down to {} kg/m³", short(rho))),
            short_stress(self.cohesion),
            short_stress(self.tension_cutoff),
        )
    }

    fn for_closed_forms(&self, _soil: &Initial, _remarks: &mut Vec<String>) -> Result<Strength, String> {
        let Self { friction_angle, dilation_angle, cohesion, .. } = *self;
        Ok(Strength { friction_angle, dilation_angle, cohesion, gradient: 0.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys;

    #[test]
    fn the_default_eccentricity_is_that_of_the_potential() {
        let default = keys::at("soil.meridional_eccentricity").unwrap().default.text();
        assert_eq!(default, Eccentricity::usual(0.5).meridional.to_string());
    }
}
