//! Soil-cutting models of blades: narrow ones in three dimensions, wide ones in saturated sand; and the tow
//! force of a plough.
//!
//! None of them covers a face that overhangs the soil (the front of a disc): their rake is at most 90°.

mod godwin_spoor;
mod hansen;
mod mckyes_ali;
mod plough;
mod saturated;
mod seepage;

pub use godwin_spoor::{effective_width, godwin_spoor};
pub use hansen::hansen_end_factor;
pub use mckyes_ali::{CuttingFactors, mckyes_ali, mckyes_ali_factors};
pub use plough::{PloughCoefficients, PloughForce};
pub use saturated::{SaturatedCut, SaturatedSand};
pub use seepage::{MeanSuction, Seepage};

use crate::error::{ModelResult, positive, within};
use crate::soil::Soil;
use std::f64::consts::FRAC_PI_2;

/// A flat blade cutting soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blade {
    /// Width w across the tow [m].
    pub width: f64,
    /// Working depth [m].
    pub depth: f64,
    /// Rake angle of the blade to the horizontal, forwards [rad]: 90° is upright, less undercuts the soil.
    pub rake: f64,
    /// Surcharge on the ground q [Pa].
    pub surcharge: f64,
}

/// Soil reaction on a blade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuttingForce {
    /// Draught H [N].
    pub drag: f64,
    /// Vertical force [N]; positive when the soil pushes the blade up.
    pub vertical: f64,
    /// Rupture distance: from the blade to where the slip surface reaches the ground surface [m].
    pub reach: f64,
}

impl Blade {
    /// Checks that the blade lies in the range of the models.
    ///
    /// # Errors
    /// Unless w > 0, depth > 0, 10° ≤ rake ≤ 90° and q ≥ 0.
    pub fn check(&self) -> ModelResult<()> {
        positive("blade width [m]", self.width)?;
        positive("blade depth [m]", self.depth)?;
        within("blade rake [rad]", self.rake, 10_f64.to_radians(), FRAC_PI_2)?;
        within("surcharge [Pa]", self.surcharge, 0.0, f64::MAX)?;
        Ok(())
    }
}

/// The wall friction δ of a soil on a blade [rad].
fn wall_friction(soil: &Soil) -> f64 {
    soil.interface_friction().atan()
}
