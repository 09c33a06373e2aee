//! The uncertainty of a forecast.

use super::{Spread, Uncertainty, propagate};
use crate::disc::Drive;
use crate::earth_pressure::{PressureTable, TableRange};
use crate::error::Answer;
use crate::forecast::{Candidate, Parameter, Towing, predict};

/// Which number of a prediction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Drag [N].
    Drag,
    /// Vertical force [N].
    Vertical,
    /// Sinkage [m].
    Sinkage,
}

/// Distribution of one quantity of one model as parameters of the case are spread.
///
/// Plasticity models use Davis' friction angle of each sample. A free disc on the wedge model looks its coefficient up in
/// a table made once over the sampled friction angles, 10⁵ evaluations take a few seconds; otherwise each evaluation of
/// the wedge solves its fields (milliseconds).
///
/// # Errors
/// If the case is out of range, and as [`propagate`].
pub fn propagate_towing(
    base: &Towing,
    spreads: &[(Parameter, Spread)],
    model: Candidate,
    quantity: Quantity,
    evaluations: usize,
    seed: u64,
) -> Answer<Uncertainty> {
    base.check()?;
    let table = table(base, spreads, model);
    let distributions: Vec<Spread> = spreads.iter().map(|(_, spread)| *spread).collect();
    propagate(&distributions, evaluations, seed, |values| {
        let set = |case: Towing, ((parameter, _), value): (&(Parameter, Spread), &f64)| {
            case.with(*parameter, *value)
        };
        let mut case = spreads.iter().zip(values).fold(base.clone(), set);
        if model.is_plastic() {
            case.soil = case.soil.operative().ok()?;
        }
        let found = predict(model, &case, table.as_ref()).ok()?;
        match quantity {
            Quantity::Drag => Some(found.drag),
            Quantity::Vertical => Some(found.vertical),
            Quantity::Sinkage => found.sinkage,
        }
    })
}

/// A table over every friction angle that the samples can meet, where a table can serve at all.
fn table(base: &Towing, spreads: &[(Parameter, Spread)], model: Candidate) -> Option<PressureTable> {
    let moves_wall =
        |p: &Parameter| matches!(p, Parameter::Slip | Parameter::BrakeTorque | Parameter::Backfill);
    let wedge = matches!(model, Candidate::Weaker | Candidate::Wedge | Candidate::PlaneStrain);
    if !wedge || base.drive != Drive::Free || spreads.iter().any(|(p, _)| moves_wall(p)) {
        return None;
    }
    let ends = |parameter: Parameter| {
        let spread = spreads.iter().find(|(p, _)| *p == parameter)?.1;
        Some((spread.quantile(0.0), spread.quantile(1.0)))
    };
    let (low, high) =
        ends(Parameter::FrictionAngle).unwrap_or((base.soil.friction_angle, base.soil.friction_angle));
    let case = |phi: f64, psi: Option<f64>| {
        let case = base.with(Parameter::FrictionAngle, phi.clamp(0.17, 0.88));
        let soil = psi.map_or(case.soil, |psi| case.with(Parameter::DilationAngle, psi).soil);
        soil.operative().map(|soil| soil.friction_angle).ok()
    };
    let dilation = ends(Parameter::DilationAngle);
    let (least, most) = (case(low, dilation.map(|d| d.0))?, case(high, dilation.map(|d| d.1))?);
    let limits = (10_f64.to_radians(), 50_f64.to_radians());
    PressureTable::new(TableRange {
        friction_angle: (least.max(limits.0), most.min(limits.1)),
        wall_friction_ratio: (0.0, 0.0),
        surface: (0.0, 1.36),
        backfill: base.backfill,
    })
    .ok()
}
