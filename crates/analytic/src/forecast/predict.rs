//! One model's answer.

use super::{Body, Candidate, Load, Towing};
use super::{blade, rivals};
use crate::disc::{
    Disc, DiscForces, Drive, Equilibrium, Mechanism, Model, Passive, Setting, assembly_forces, disc_forces,
    equilibrium_of, vertical_force,
};
use crate::earth_pressure::{PressureTable, TableRange};
use crate::error::{Answer, Refusal, none};

/// What one model predicts; a model leaves out what it does not know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// Drag F_H [N].
    pub drag: f64,
    /// Vertical force F_V [N].
    pub vertical: f64,
    /// Sinkage z [m].
    pub sinkage: Option<f64>,
    /// Contact angle θ_f [rad].
    pub contact_angle: Option<f64>,
    /// Inclination η of the force to the vertical [rad].
    pub force_inclination: f64,
    /// Its [`crate::slip`]: −1 locked, 0 rolling, above 0 driven.
    pub slip: Option<f64>,
    /// How the soil fails under more than half of the thrust, where the model says.
    pub mechanism: Option<Mechanism>,
    /// Share of the thrust under which it escapes sideways, 0 to 1, where the model says.
    pub sideways_share: Option<f64>,
}

/// One model's entry in a forecast.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelForecast {
    /// Which model.
    pub model: Candidate,
    /// Its name.
    pub name: &'static str,
    /// Whether its answer is meant for a case like this one.
    pub applicable: bool,
    /// Its answer, where it has one; shown even where it does not apply.
    pub prediction: Option<Prediction>,
    /// Why it does not apply, or what to keep in mind.
    pub note: String,
}

impl ModelForecast {
    pub(super) fn of(model: Candidate, answer: Answer<Prediction>) -> Self {
        let (prediction, note) = match answer {
            Ok(prediction) => (Some(prediction), String::new()),
            Err(Refusal::DoesNotExist { why, .. }) => (None, why),
            Err(why) => (None, why.to_string()),
        };
        Self { model, name: model.name(), applicable: prediction.is_some(), prediction, note }
    }

    pub(super) fn exclude(&mut self, why: &str) {
        if self.applicable {
            self.applicable = false;
            self.note = why.into();
        }
    }
}

/// Why a ball has resistive force theory only.
const ROUND: &str = "it is for a plane front or that of a disc across the tow";

/// The answer of one model, with the soil's friction angle as it is; `table` speeds up the wedge where it covers the case.
///
/// # Errors
/// If the model does not apply to the case or has no answer.
pub fn predict(model: Candidate, towing: &Towing, table: Option<&PressureTable>) -> Answer<Prediction> {
    towing.check()?;
    let found = match (&towing.body, model) {
        (_, Candidate::SpatialResistive | Candidate::PlanarResistive) => rivals::predict(model, towing),
        (Body::Block(block), _) => blade::predict(model, towing, block, table),
        (Body::Round(_), _) => none(model.name(), ROUND),
        (Body::Disc(body), _) => match model {
            Candidate::Weaker => disc(Model::Weaker, towing, body, table),
            Candidate::Bearing => disc(Model::Bearing, towing, body, table),
            Candidate::Wedge => disc(Model::Wedge, towing, body, table),
            Candidate::PlaneStrain => disc(Model::PlaneStrain, towing, body, table),
            _ => rivals::predict(model, towing),
        },
    }?;
    if found.drag.is_finite() && found.vertical.is_finite() {
        Ok(found)
    } else {
        none("the force", "the numbers overflow for this input")
    }
}

/// A table of the smooth level wedge for the friction angle of `towing`, where its drive needs no other.
pub(super) fn level_table(towing: &Towing) -> Option<PressureTable> {
    let phi = towing.soil.friction_angle;
    let range = TableRange {
        friction_angle: (phi, phi),
        wall_friction_ratio: (0.0, 0.0),
        surface: (0.0, 1.36),
        backfill: towing.backfill,
    };
    if towing.drive == Drive::Free { PressureTable::new(range).ok() } else { None }
}

fn disc(model: Model, towing: &Towing, disc: &Disc, table: Option<&PressureTable>) -> Answer<Prediction> {
    let setting = Setting {
        soil: towing.soil,
        disc: *disc,
        drive: towing.drive,
        heap_fraction: towing.heap_fraction,
        backfill: towing.backfill,
        method: towing.method,
        passive: table.map_or(Passive::Solve, Passive::Table),
    };
    let at = |z: f64| match &towing.assembly {
        Some(assembly) => assembly_forces(model, &setting, assembly, z),
        None => disc_forces(model, &setting, z),
    };
    let carried = |z: f64| match &towing.assembly {
        Some(_) => Ok(at(z)?.vertical),
        None => vertical_force(model, &setting, z),
    };
    match towing.load {
        Load::Sinkage(z) => Ok(prediction(&at(z)?, z)),
        Load::Weight(weight) => match equilibrium_of(disc, weight, carried, at)? {
            Equilibrium::At { sinkage, forces } => Ok(prediction(&forces, sinkage)),
            Equilibrium::None { largest_weight, .. } => none(
                "the equilibrium sinkage",
                format!("no equilibrium: the soil carries at most {largest_weight:.3} N, the disc digs in"),
            ),
        },
    }
}

fn prediction(forces: &DiscForces, sinkage: f64) -> Prediction {
    Prediction {
        drag: forces.drag,
        vertical: forces.vertical,
        sinkage: Some(sinkage),
        contact_angle: Some(forces.contact_angle),
        force_inclination: forces.force_inclination,
        slip: Some(forces.slip),
        mechanism: Some(forces.mechanism),
        sideways_share: Some(forces.sideways_share),
    }
}
