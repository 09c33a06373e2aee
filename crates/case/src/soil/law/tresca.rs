//! Undrained clay: Tresca, with a strength that may grow with depth, fall with remoulding and grow with the
//! rate of shear.

use super::soil_law::{Initial, SoilLaw, Strength};
use crate::key::allowed::{AT_LEAST_ONE, NOT_NEGATIVE, POSITIVE};
use crate::key::usual::{GROWTH_OF_STRENGTH, UNDRAINED_STRENGTH};
use DefaultValue::{Number, Quantity};
use input::key::{DefaultValue, Key, KeyOf, Kind, Numbers, Place, declared, numbers, read};
use input::problem::Problems;
use input::quantity::{FREQUENCY, STRENGTH_GRADIENT, STRESS, short, short_stress};
use input::readable::{digits, stress};
use input::typed::Section;
use physics::clay::{Clay, ClayParameters};
use physics::elastic::Elastic;
use physics::law::Law as ConstitutiveLaw;
use physics::mohr_coulomb::MohrCoulomb;
use serde::Serialize;
use solver::material::{Material, StrengthProfile};

/// Tresca: undrained shear strength s_u [Pa].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Tresca {
    /// Undrained shear strength s_u of the intact soil, at the top of its layer [Pa].
    pub shear_strength: f64,
    /// Growth of the strength with depth k [Pa/m].
    pub gradient: f64,
    /// What remoulding and rate of shear do to the strength; `None` for nothing.
    pub softening: Option<ClaySoftening>,
}

/// What remoulding and rate of shear do to the strength of undrained clay (Einav & Randolph 2005).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ClaySoftening {
    /// Sensitivity S_t ≥ 1: strength of the intact clay over that of the remoulded one.
    pub sensitivity: f64,
    /// Plastic shear strain at which 95 % of the loss has happened, ξ₉₅.
    pub remoulding_strain: f64,
    /// Gain of strength per tenfold rate of shear, μ ≥ 0.
    pub rate_strengthening: f64,
    /// Rate of shear up to which the strength does not grow [1/s].
    pub reference_rate: f64,
}

type Field = KeyOf<Tresca>;

const FIELDS: &[Field] = &[
    Field::new("shear_strength", Kind::Quantity(STRESS), Place::Number(|clay| &mut clay.shear_strength))
        .required_for("tresca")
        .within(NOT_NEGATIVE)
        .usually(UNDRAINED_STRENGTH)
        .means(
            "Undrained shear strength s_u at the top of the soil, or of its layer; 0 only if it grows with \
             depth (tresca).",
        ),
    Field::new(
        "strength_gradient",
        Kind::Quantity(STRENGTH_GRADIENT),
        Place::Number(|clay| &mut clay.gradient),
    )
    .default(Quantity("0 kPa/m"))
    .within(NOT_NEGATIVE)
    .usually(GROWTH_OF_STRENGTH)
    .means("Growth of the undrained shear strength with depth k: s_u + k z (tresca)."),
    Field::new(
        "sensitivity",
        Kind::Number,
        Place::Part(|clay| Some(&mut clay.softening.as_mut()?.sensitivity)),
    )
    .default(Number(1.0))
    .within(AT_LEAST_ONE)
    .means(
        "Sensitivity S_t: strength of the intact clay over that of the remoulded one; 1 for clay that \
             keeps its strength (tresca).",
    ),
    Field::new(
        "remoulding_strain",
        Kind::Number,
        Place::Part(|clay| Some(&mut clay.softening.as_mut()?.remoulding_strain)),
    )
    .default(Number(20.0))
    .within(POSITIVE)
    .means("Plastic shear strain at which 95 % of the loss has happened ξ₉₅ (tresca with sensitivity)."),
    Field::new(
        "rate_strengthening",
        Kind::Number,
        Place::Part(|clay| Some(&mut clay.softening.as_mut()?.rate_strengthening)),
    )
    .default(Number(0.0))
    .within(NOT_NEGATIVE)
    .means("Gain of strength per tenfold rate of shear μ; 0.05 to 0.2 is usual (tresca)."),
    Field::new(
        "reference_rate",
        Kind::Quantity(FREQUENCY),
        Place::Part(|clay| Some(&mut clay.softening.as_mut()?.reference_rate)),
    )
    .default(Quantity("1e-5 Hz"))
    .within(POSITIVE)
    .means(
        "Rate of shear, per second, at which the strength was measured (tresca with \
             rate_strengthening).",
    ),
];

/// Softening of clay that keeps its strength.
const INSENSITIVE: ClaySoftening =
    ClaySoftening { sensitivity: 1.0, remoulding_strain: 1.0, rate_strengthening: 0.0, reference_rate: 1.0 };

impl Tresca {
    pub(super) const WORD: &'static str = "tresca";
    pub(super) const FIELDS: &'static [Field] = FIELDS;
    pub(super) const DECLARED: &'static [Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    pub(super) fn typed(section: &Section, problems: &mut Problems) -> Option<Self> {
        let start = Self { softening: Some(INSENSITIVE), ..Self::default() };
        let clay = read(FIELDS, start, section, problems);
        let idle = [
            ("remoulding_strain", "sensitivity", section.number("sensitivity") == Some(1.0)),
            ("reference_rate", "rate_strengthening", section.number("rate_strengthening") == Some(0.0)),
        ];
        let are_right = idle
            .iter()
            .all(|(key, needs, _)| [key, needs].into_iter().all(|key| section.number(key).is_some()));
        for (key, needs, is_idle) in idle {
            if are_right && is_idle && section.has(key) {
                let message = format!("`{key}` has no effect without `{needs}`");
                problems.add(section.at(key), message, format!("remove it, or give `{needs}`"));
            }
        }
        let matters = |it: &ClaySoftening| it.sensitivity != 1.0 || it.rate_strengthening != 0.0;
        clay.map(|clay| Self { softening: clay.softening.filter(matters), ..clay })
    }

    /// The clay at a depth below the top of its layer [m].
    pub(crate) fn at_depth(self, depth: f64) -> Self {
        Self { shear_strength: self.shear_strength + self.gradient * depth, ..self }
    }

    /// Whether the clay is stronger the faster it is sheared.
    #[must_use]
    pub fn depends_on_rate(&self) -> bool {
        self.softening.is_some_and(|softening| softening.rate_strengthening > 0.0)
    }
}

impl SoilLaw for Tresca {
    fn numbers(&self) -> Numbers {
        numbers(FIELDS, self)
    }

    fn kind(&self) -> &'static str {
        "undrained (tresca)"
    }

    fn contradictions(&self, path: &str, problems: &mut Problems) {
        if self.shear_strength == 0.0 && self.gradient == 0.0 {
            let message = "the soil has no strength at any depth";
            let cure = "it must be above 0, or grow with depth: strength_gradient = \"1.5 kPa/m\"";
            problems.add(format!("{path}.shear_strength"), message, cure);
        }
    }

    fn cohesion(&self) -> Option<f64> {
        Some(self.shear_strength)
    }

    fn sustains(&self, [most, _, least]: [f64; 3]) -> bool {
        most - least <= 2.0 * self.shear_strength
    }

    fn yield_law(&self, elastic: Elastic) -> Option<ConstitutiveLaw> {
        if self.gradient == 0.0 && self.softening.is_none() {
            return Some(ConstitutiveLaw::MohrCoulomb(MohrCoulomb::tresca(elastic, self.shear_strength)));
        }
        let ClaySoftening { sensitivity, remoulding_strain, rate_strengthening, reference_rate } =
            self.softening.unwrap_or(INSENSITIVE);
        let parameters =
            ClayParameters { sensitivity, remoulding_strain, rate_strengthening, reference_rate };
        Some(ConstitutiveLaw::Clay(Clay::new(elastic, &parameters)))
    }

    fn complete(&self, material: &mut Material) {
        material.strength =
            Some(StrengthProfile { top: 0.0, at_top: self.shear_strength, gradient: self.gradient });
    }

    fn summary(&self, _density: f64) -> String {
        let mut text = format!("Tresca, sᵤ = {}", stress(self.shear_strength));
        if self.gradient > 0.0 {
            text += &format!(" + {} kPa/m × depth", digits(1e-3 * self.gradient));
        }
        let softening = self.softening.unwrap_or(INSENSITIVE);
        if softening.sensitivity > 1.0 {
            text += &format!(", sensitivity {}", digits(softening.sensitivity));
        }
        if softening.rate_strengthening > 0.0 {
            text += &format!(", {} % more per tenfold rate", digits(100.0 * softening.rate_strengthening));
        }
        text
    }

    fn spelled_out(&self, _density: f64) -> String {
        let mut text = format!("tresca, s_u = {}", short_stress(self.shear_strength));
        if self.gradient > 0.0 {
            text += &format!(" + {}/m × depth", short_stress(self.gradient));
        }
        if let Some(ClaySoftening { sensitivity, remoulding_strain, rate_strengthening, reference_rate }) =
            self.softening
        {
            text += &format!(
                ",\n         S_t = {sensitivity} (95 % lost at a strain of {remoulding_strain}), {} % more per \
                 tenfold rate above {reference_rate} 1/s",
                short(100.0 * rate_strengthening)
            );
        }
        text
    }

    fn for_closed_forms(&self, _soil: &Initial, remarks: &mut Vec<String>) -> Result<Strength, String> {
        if self.softening.is_some() {
            remarks.push("clay with the strength of the intact soil at the reference rate".into());
        }
        Ok(Strength { cohesion: self.shear_strength, gradient: self.gradient, ..Strength::default() })
    }
}
