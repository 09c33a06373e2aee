//! Parameters of the method.

use crate::key::allowed::{FRACTION, NOT_NEGATIVE, POSITIVE_FRACTION, SPACING, THREADS};
use crate::key::words::{CONTACTS, PRECISIONS};
use DefaultValue::{ByLaw, Number, Word};
use input::key::{DefaultValue, Key, KeyOf, Kind, Place, declared, in_ranges, numbers, read};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// Contact method between soil and bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Contact {
    /// Penalty method with a penetration history that follows the geometric gap.
    Penalty,
    /// Velocity impulses, iterated together with the motion of the body.
    #[default]
    Impulse,
}

/// Precision of the soil's fields and of the arithmetic on them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Precision {
    /// 64 bits.
    #[default]
    Double,
    /// 32 bits.
    Single,
}

/// Parameters of the method; change them to study it.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Numerics {
    /// Courant number of the time step.
    pub courant: f64,
    /// Displacement in cell widths at which a remap is due.
    pub remap_displacement: f64,
    /// Coefficient of hourglass viscosity.
    pub hourglass: f64,
    /// Fraction of the hourglass viscosity that acts in cells that yield.
    pub hourglass_yielding: f64,
    /// Linear coefficient of bulk viscosity b₁.
    pub bulk_viscosity_linear: f64,
    /// Quadratic coefficient of bulk viscosity b₂.
    pub bulk_viscosity_quadratic: f64,
    /// Contact method.
    pub contact: Contact,
    /// Distance of contact points from sharp edges, in cell widths.
    pub edge_inset: f64,
    /// Spacing of contact points, in cell widths.
    pub point_spacing: f64,
    /// Threads of each process; 0 for as many as [`machine::cores::threads_by_default`].
    pub threads: usize,
    /// Precision of the soil's fields.
    pub precision: Precision,
}

/// Keys of the method, and where their values lie.
type Field = KeyOf<Numerics>;

const FIELDS: &[Field] = &[
    Field::new("courant", Kind::Number, Place::Number(|numerics| &mut numerics.courant))
        .default(Number(0.5))
        .within(POSITIVE_FRACTION)
        .means("Courant number: time step over the time that a wave takes to cross the smallest cell."),
    Field::new(
        "remap_displacement",
        Kind::Number,
        Place::Number(|numerics| &mut numerics.remap_displacement),
    )
    .default(Number(0.1))
    .within(POSITIVE_FRACTION)
    .means("Displacement in cell widths at which the soil is remapped."),
    Field::new("hourglass", Kind::Number, Place::Number(|numerics| &mut numerics.hourglass))
        .default(Number(0.01))
        .within(NOT_NEGATIVE)
        .means("Coefficient of hourglass viscosity."),
    Field::new(
        "hourglass_yielding",
        Kind::Number,
        Place::Number(|numerics| &mut numerics.hourglass_yielding),
    )
    .default(Number(0.1))
    .within(FRACTION)
    .means("Fraction of the hourglass viscosity that acts in cells that yield."),
    Field::new(
        "bulk_viscosity_linear",
        Kind::Number,
        Place::Number(|numerics| &mut numerics.bulk_viscosity_linear),
    )
    .default(ByLaw { usual: 0.02, laws: &["tresca", "von-mises"], instead: 0.06 })
    .within(NOT_NEGATIVE)
    .means("Linear coefficient b₁ of bulk viscosity."),
    Field::new(
        "bulk_viscosity_quadratic",
        Kind::Number,
        Place::Number(|numerics| &mut numerics.bulk_viscosity_quadratic),
    )
    .default(Number(1.2))
    .within(NOT_NEGATIVE)
    .means("Quadratic coefficient b₂ of bulk viscosity."),
    Field::new(
        "contact",
        Kind::Choice(&CONTACTS),
        Place::Word(|numerics, word| {
            numerics.contact = if word == "penalty" { Contact::Penalty } else { Contact::Impulse };
        }),
    )
    .default(Word("impulse"))
    .means("Contact method."),
    Field::new("edge_inset", Kind::Number, Place::Number(|numerics| &mut numerics.edge_inset))
        .default(Number(0.5))
        .within(NOT_NEGATIVE)
        .means("Distance of contact points from sharp edges, in cell widths."),
    Field::new("point_spacing", Kind::Number, Place::Number(|numerics| &mut numerics.point_spacing))
        .default(Number(0.25))
        .within(SPACING)
        .means("Spacing of contact points, in cell widths."),
    Field::new("threads", Kind::Count, Place::Count(|numerics| &mut numerics.threads))
        .default(Number(0.0))
        .within(THREADS)
        .means(
            "Threads of each process; 0 for as many as SLURM_CPUS_PER_TASK says, or else OMP_NUM_THREADS, \
             or else one per core that it may use (processes on one machine share its cores).",
        ),
    Field::new(
        "precision",
        Kind::Choice(&PRECISIONS),
        Place::Word(|numerics, word| {
            numerics.precision = if word == "single" { Precision::Single } else { Precision::Double };
        }),
    )
    .default(Word("double"))
    .means("Precision of the soil's fields; single takes two thirds of the time and about half the memory."),
];

impl Numerics {
    pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    /// The parameters for the soil of a case as typed; `None` with problems added.
    pub(crate) fn typed(section: &Section, soil: &Section, problems: &mut Problems) -> Option<Self> {
        // Undrained soil tolerates and needs more viscosity: its contact pressure does not vanish at the
        // surface. So does metal.
        let law = soil.text("law").unwrap_or_default();
        let viscosity = Self::KEYS.iter().find_map(|key| key.default.for_law(&law))?;
        let start = Self { bulk_viscosity_linear: viscosity, ..Self::default() };
        read(FIELDS, start, section, problems)
    }

    /// Reports numbers that are out of range.
    pub(crate) fn check(&self, problems: &mut Problems) {
        in_ranges("numerics", &numbers(FIELDS, self), problems);
    }
}
