//! Model PW: a passive wedge before the chord; the soil fails forwards.

use super::{Contact, Disc, RimPressure};
use crate::earth_pressure::{Face, PassiveField, PressureTable, cohesion_coefficient, sokolovskii};
use crate::error::Answer;
use crate::soil::Soil;
use std::f64::consts::FRAC_PI_2;

/// Where the passive coefficient comes from.
#[derive(Clone, Copy, Debug, Default)]
pub enum Passive<'a> {
    /// Solve the field each time (a quarter of a millisecond).
    #[default]
    Solve,
    /// Look it up (a microsecond), for sweeps; a face outside the table is solved.
    Table(&'a PressureTable),
}

impl Passive<'_> {
    /// The field of one face.
    ///
    /// # Errors
    /// Where the field does not exist.
    pub fn field(&self, face: &Face) -> Answer<PassiveField> {
        match self {
            Self::Solve => sokolovskii(face),
            Self::Table(table) => table.field(face).or_else(|_| sokolovskii(face)),
        }
    }
}

/// Factor S by which the ends of a wedge of width t [m] and reach r_f [m] add to its force: 1 + (2/3) r_f / t.
///
/// Side crescents by Pappus' rule, as in McKyes & Ali (1977), with the reach of the curved field. It diverges for a thin
/// body, where the soil escapes sideways instead (model BC).
#[must_use]
pub fn end_factor(reach: f64, width: f64) -> f64 {
    1.0 + 2.0 / 3.0 * reach / width
}

/// Pressure on the rim from the exact passive thrust on its chord, laid radially on the arc.
///
/// σ = S (γ K_n r + c K_c), K_n(φ, δ, α, β) exact (see [`sokolovskii`]), δ = −atan μ_m, S = 1 + (2/3) r_f/t or 1 in
/// plane strain. Without friction: F_V = γ R² K_n (sin²α cos α + α sin α) S t, F_H = γ R² K_n (sin α + sin³α − α cos α) S t.
/// Source: derived for this project from the nomenclature of the source paper; K_c = (K_q − 1) cot φ after Caquot, on
/// level ground (superposed, on the safe side). Ignores failure backwards into the rut.
/// Valid for 10° ≤ φ ≤ 50°, atan μ_m ≤ ⅔φ, and where the field exists (δ < 0 not on a steep chord).
///
/// # Errors
/// Where the field does not exist or the soil is out of range.
pub fn wedge(
    soil: &Soil,
    disc: &Disc,
    contact: &Contact,
    mobilised_friction: f64,
    backfill: f64,
    ends: bool,
    passive: Passive<'_>,
) -> Answer<RimPressure> {
    let surface = contact.inclination.min(FRAC_PI_2);
    let wall_friction = -mobilised_friction.atan();
    let face = Face { friction_angle: soil.friction_angle, wall_friction, surface, backfill };
    let field = passive.field(&face)?;
    let ends = if ends { end_factor(field.rupture_ratio * contact.chord, disc.thickness) } else { 1.0 };
    let mut rim = RimPressure::on(contact, disc.diameter, disc.thickness * ends);
    rim.along_chord = soil.unit_weight * field.coefficient;
    if soil.cohesion > 0.0 {
        rim.base = soil.cohesion * cohesion_coefficient(&Face { backfill: 0.0, ..face })?;
    }
    Ok(rim)
}
