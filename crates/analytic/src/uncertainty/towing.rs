//! Uncertainty of a forecast.

use super::{Distribution, Uncertainty, propagate};
use crate::disc::Drive;
use crate::earth_pressure::{PressureTable, TableRange};
use crate::error::ModelResult;
use crate::forecast::{Block, Body, Candidate, Parameter, Strength, Towing, predict};
use std::f64::consts::{FRAC_PI_2, PI};

/// Distributions of the prediction of one model.
#[derive(Clone, Debug, PartialEq)]
pub struct TowingUncertainty {
    /// Drag [N].
    pub drag: Uncertainty,
    /// Vertical force [N].
    pub vertical: Uncertainty,
    /// Sinkage [m], if the model gives it.
    pub sinkage: Option<Uncertainty>,
}

/// Distributions of the prediction of one model for uncertain parameters of the case.
///
/// Plasticity models use the recommended strength of each sample. `table`, made once for all models by
/// [`sweep_table`], replaces the solution of a stress field in each evaluation, so that 10⁵ of them take a
/// few seconds.
///
/// # Errors
/// If the case is out of range or the model has no result for it, and as [`propagate`].
pub fn propagate_towing(
    base: &Towing,
    inputs: &[(Parameter, Distribution)],
    model: Candidate,
    evaluations: usize,
    seed: u64,
    table: Option<&PressureTable>,
) -> ModelResult<TowingUncertainty> {
    base.check()?;
    let evaluate = |case: Towing| {
        let case = if model.is_plastic() { Strength::recommended(&case).applied(&case)? } else { case };
        predict(model, &case, table)
    };
    let gives_sinkage = evaluate(base.clone())?.sinkage.is_some();
    let distributions: Vec<Distribution> = inputs.iter().map(|(_, distribution)| *distribution).collect();
    let [drag, vertical, sinkage] = propagate(&distributions, evaluations, seed, |values| {
        let set = |case: Towing, ((parameter, _), value): (&(Parameter, Distribution), &f64)| {
            case.with(*parameter, *value)
        };
        let found = evaluate(inputs.iter().zip(values).fold(base.clone(), set)).ok()?;
        let sinkage = if gives_sinkage { found.sinkage? } else { 0.0 };
        Some([found.drag, found.vertical, sinkage])
    })?;
    Ok(TowingUncertainty { drag, vertical, sinkage: gives_sinkage.then_some(sinkage) })
}

/// A table of the passive coefficient for all friction angles and wall friction angles of the samples; `None`
/// if the backfill is uncertain, where no model uses it, or where the field does not exist in the whole
/// range.
#[must_use]
pub fn sweep_table(base: &Towing, inputs: &[(Parameter, Distribution)]) -> Option<PressureTable> {
    if inputs.iter().any(|(parameter, _)| *parameter == Parameter::Backfill) {
        return None;
    }
    if base.pressed || base.soil.is_undrained() {
        return None;
    }
    let corners = corners(base, inputs);
    if let Body::Block(block) = &base.body {
        return block_table(block, base.backfill, &corners, inputs);
    }
    let (friction_angle, (_, steepest)) = frictions(&corners);
    let needs_friction = corners.iter().any(|case| matches!(case.drive, Drive::Driven(_) | Drive::Slip(_)));
    let last = if needs_friction { steepest.min(1.0) } else { 0.0 };
    // Where the ground falls, the field does not exist for steep chords: take the largest range that does.
    [1.36, 1.2, 1.0, 0.8].into_iter().find_map(|steepest| {
        PressureTable::new(TableRange {
            friction_angle,
            wall_friction_ratio: (0.0, last),
            surface: (0.0, steepest),
            backfill: base.backfill,
        })
        .ok()
    })
}

/// [`sweep_table`] of the front of a block at its inclination; `None` if that is uncertain.
fn block_table(
    block: &Block,
    backfill: f64,
    corners: &[Towing],
    inputs: &[(Parameter, Distribution)],
) -> Option<PressureTable> {
    let surface = PI - block.front().rake;
    if surface > FRAC_PI_2 + 1e-9 || inputs.iter().any(|(parameter, _)| *parameter == Parameter::Orientation)
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

/// Range of the friction angle of the plasticity models [rad] and of the wall friction angle relative to it.
fn frictions(cases: &[Towing]) -> ((f64, f64), (f64, f64)) {
    let applied = |case: &Towing| Strength::recommended(case).applied(case).ok().map(|case| case.soil);
    let soils: Vec<_> = cases.iter().filter_map(applied).collect();
    let (low, high) = extent(soils.iter().map(|soil| soil.friction_angle));
    let ratios = extent(soils.iter().map(|soil| soil.interface_friction().atan() / soil.friction_angle));
    ((low.max(10_f64.to_radians()), high.min(50_f64.to_radians())), ratios)
}

/// The cases at the corners of the range of the inputs.
fn corners(base: &Towing, inputs: &[(Parameter, Distribution)]) -> Vec<Towing> {
    let mut cases = vec![base.clone()];
    for (parameter, distribution) in inputs {
        let ends = [distribution.quantile(0.0), distribution.quantile(1.0)];
        cases = cases.iter().flat_map(|case| ends.map(|end| case.with(*parameter, end))).collect();
    }
    cases
}
