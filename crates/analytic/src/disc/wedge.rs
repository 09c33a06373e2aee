//! Model PW: a passive wedge before the chord, for soil that fails forwards.

use super::{Contact, Disc, RimPressure};
use crate::earth_pressure::{Face, PassiveField, PressureTable, cohesion_coefficient, sokolovskii};
use crate::error::ModelResult;
use crate::soil::Soil;
use std::f64::consts::FRAC_PI_2;

/// How the passive coefficient is evaluated.
#[derive(Clone, Copy, Debug, Default)]
pub enum Passive<'a> {
    /// By solving the stress field (a quarter of a millisecond).
    #[default]
    Solve,
    /// By interpolation in a table (a microsecond); faces outside the table are solved.
    Table(&'a PressureTable),
}

impl Passive<'_> {
    /// The passive field of a face.
    ///
    /// # Errors
    /// If the field does not exist.
    pub fn field(&self, face: &Face) -> ModelResult<PassiveField> {
        match self {
            Self::Solve => sokolovskii(face),
            Self::Table(table) => table.field(face).or_else(|_| sokolovskii(face)),
        }
    }
}

/// What the sides of the wedge add to its force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Nothing: plane strain.
    PlaneStrain,
    /// Side crescents, see [`end_factor`].
    Crescents,
}

/// The wedge before the chord, besides soil, disc and friction.
#[derive(Clone, Copy, Debug)]
pub struct WedgeFace<'a> {
    /// Slope β of the ground before the disc [rad], rising forwards.
    pub backfill: f64,
    /// The sides of the wedge.
    pub ends: Ends,
    /// How the passive coefficient is evaluated.
    pub passive: Passive<'a>,
}

/// End factor S of a wedge of width t [m] and rupture distance r_f [m]: 1 + (2/3) r_f / t.
///
/// Side crescents by Pappus' theorem, as in McKyes & Ali (1977), with the rupture distance of the curved
/// field. It diverges for a thin body, where the soil fails sideways instead (model BC).
#[must_use]
pub fn end_factor(rupture_distance: f64, width: f64) -> f64 {
    1.0 + 2.0 / 3.0 * rupture_distance / width
}

/// Pressure on the rim from the exact passive thrust on its chord, applied radially on the arc.
///
/// σ = S (γ K_n r + c K_c), K_n(φ, δ, α, β) exact (see [`sokolovskii`]), δ = −atan μ_m but not below 0, S =
/// 1 + (2/3) r_f/t or 1 in plane strain. Without friction: F_V = γ R² K_n (sin²α cos α + α sin α) S t, F_H =
/// γ R² K_n (sin α + sin³α − α cos α) S t. Source: derived for this project from the nomenclature of the
/// source paper; K_c = (K_q − 1) cot φ after Caquot, on level ground (superposed, on the safe side). Backward
/// failure into the rut is neglected. A wall friction angle δ < 0, soil that is dragged along by the face,
/// does not go with this mechanism. Soil that fails forwards rises; its velocity normal to the chord is that
/// of the disc, so along the chord it is faster, by v_z/sin α where it rises at v_z, even than the chord of a
/// locked disc. It cannot be dragged, and a wedge before a sliding disc is taken as smooth. Valid for 10° ≤
/// φ ≤ 50°, |μ_m| ≤ tan φ, and where the field exists (not where the ground falls before a steep chord).
///
/// # Errors
/// If the field does not exist or the soil is out of range.
pub fn wedge(
    soil: &Soil,
    disc: &Disc,
    contact: &Contact,
    mobilised_friction: f64,
    wedge: &WedgeFace<'_>,
) -> ModelResult<RimPressure> {
    let surface = contact.inclination.min(FRAC_PI_2);
    let wall_friction = -mobilised_friction.min(0.0).atan();
    let face = Face { friction_angle: soil.friction_angle, wall_friction, surface, backfill: wedge.backfill };
    let field = wedge.passive.field(&face)?;
    let ends = match wedge.ends {
        Ends::PlaneStrain => 1.0,
        Ends::Crescents => end_factor(field.rupture_ratio * contact.chord, disc.thickness),
    };
    let mut rim = RimPressure::on(contact, disc.diameter, disc.thickness * ends);
    rim.along_chord = soil.unit_weight * field.coefficient;
    if soil.cohesion > 0.0 {
        rim.base = soil.cohesion * cohesion_coefficient(&Face { backfill: 0.0, ..face })?;
    }
    Ok(rim)
}
