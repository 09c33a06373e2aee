//! The uncertainty of a forecast.

use super::{Spread, Uncertainty, propagate};
use crate::disc::Drive;
use crate::earth_pressure::{PressureTable, TableRange};
use crate::error::Answer;
use crate::forecast::{Block, Body, Candidate, Parameter, Towing, predict};
use std::f64::consts::{FRAC_PI_2, PI};

/// Distributions of one model's answer.
#[derive(Clone, Debug, PartialEq)]
pub struct TowingUncertainty {
    /// Of the drag [N].
    pub drag: Uncertainty,
    /// Of the vertical force [N].
    pub vertical: Uncertainty,
    /// Of the sinkage [m], where the model knows it.
    pub sinkage: Option<Uncertainty>,
}

/// Distributions of the answer of one model as parameters of the case are spread.
///
/// Plasticity models use Davis' friction angle of each sample. `table`, made once for all models by [`sweep_table`],
/// saves them from solving a stress field in each evaluation: 10⁵ of them take a few seconds.
///
/// # Errors
/// If the case is out of range or the model has no answer to it, and as [`propagate`].
pub fn propagate_towing(
    base: &Towing,
    spreads: &[(Parameter, Spread)],
    model: Candidate,
    evaluations: usize,
    seed: u64,
    table: Option<&PressureTable>,
) -> Answer<TowingUncertainty> {
    base.check()?;
    let answer = |mut case: Towing| {
        if model.is_plastic() {
            case.soil = case.soil.operative()?;
        }
        predict(model, &case, table)
    };
    let knows_sinkage = answer(base.clone())?.sinkage.is_some();
    let distributions: Vec<Spread> = spreads.iter().map(|(_, spread)| *spread).collect();
    let [drag, vertical, sinkage] = propagate(&distributions, evaluations, seed, |values| {
        let set = |case: Towing, ((parameter, _), value): (&(Parameter, Spread), &f64)| {
            case.with(*parameter, *value)
        };
        let found = answer(spreads.iter().zip(values).fold(base.clone(), set)).ok()?;
        let sinkage = if knows_sinkage { found.sinkage? } else { 0.0 };
        Some([found.drag, found.vertical, sinkage])
    })?;
    Ok(TowingUncertainty { drag, vertical, sinkage: knows_sinkage.then_some(sinkage) })
}

/// A table of the wedge's coefficient over every friction angle and wall friction that the samples can meet; none if the
/// ground before the disc is spread, or where the field does not exist in the whole of it.
#[must_use]
pub fn sweep_table(base: &Towing, spreads: &[(Parameter, Spread)]) -> Option<PressureTable> {
    if spreads.iter().any(|(parameter, _)| *parameter == Parameter::Backfill) {
        return None;
    }
    let corners = corners(base, spreads);
    if let Body::Block(block) = &base.body {
        return block_table(block, base.backfill, &corners, spreads);
    }
    let (friction_angle, (_, steepest)) = frictions(&corners);
    let most = steepest.min(2.0 / 3.0);
    let sliding = |drive: Drive| match drive {
        Drive::Free => (0.0, 0.0),
        Drive::Locked | Drive::Braked(_) => (-most, 0.0),
        Drive::Driven(_) => (0.0, steepest.min(1.0)),
        Drive::Slip(_) => (-most, steepest.min(1.0)),
    };
    let (first, last) = extent(corners.iter().flat_map(|case| {
        let (first, last) = sliding(case.drive);
        [first, last]
    }));
    // Steep chords with the friction of a sliding disc have no field: the table ends before them.
    [1.36, 1.2, 1.0, 0.8].into_iter().find_map(|steepest| {
        PressureTable::new(TableRange {
            friction_angle,
            wall_friction_ratio: (first, last),
            surface: (0.0, steepest),
            backfill: base.backfill,
        })
        .ok()
    })
}

/// [`sweep_table`] of the front of a block, which keeps its inclination; none where that is spread, too.
fn block_table(
    block: &Block,
    backfill: f64,
    corners: &[Towing],
    spreads: &[(Parameter, Spread)],
) -> Option<PressureTable> {
    let surface = PI - block.front().rake;
    if surface > FRAC_PI_2 + 1e-9 || spreads.iter().any(|(parameter, _)| *parameter == Parameter::Orientation)
    {
        return None;
    }
    let (friction_angle, wall_friction_ratio) = frictions(corners);
    let surface = surface.min(FRAC_PI_2);
    let range = TableRange { friction_angle, wall_friction_ratio, surface: (surface, surface), backfill };
    PressureTable::new(range).ok()
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

/// Least and largest friction angle [rad], and wall friction as a fraction of it, of the soils as limit analysis sees
/// them.
fn frictions(cases: &[Towing]) -> ((f64, f64), (f64, f64)) {
    let soils: Vec<_> = cases.iter().filter_map(|case| case.soil.operative().ok()).collect();
    let (low, high) = extent(soils.iter().map(|soil| soil.friction_angle));
    let ratios = extent(soils.iter().map(|soil| soil.shared_friction().atan() / soil.friction_angle));
    ((low.max(10_f64.to_radians()), high.min(50_f64.to_radians())), ratios)
}

/// The cases with every combination of the spreads' ends.
fn corners(base: &Towing, spreads: &[(Parameter, Spread)]) -> Vec<Towing> {
    let mut cases = vec![base.clone()];
    for (parameter, spread) in spreads {
        let ends = [spread.quantile(0.0), spread.quantile(1.0)];
        cases = cases.iter().flat_map(|case| ends.map(|end| case.with(*parameter, end))).collect();
    }
    cases
}
