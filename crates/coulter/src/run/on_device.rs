//! What a case takes on a device, and whether that can run it.

use case::Case;
use case::model::model;
use case::resolved::Precision;
use solver::device::{self, DeviceError, Driver};
use solver::precision::Scalar;

/// Memory that a case takes on a device [bytes], without what contact touches.
#[must_use]
pub fn footprint(case: &Case) -> f64 {
    match case.numerics.precision {
        Precision::Double => device::footprint::<f64>(&model(case, f64::LANES)),
        Precision::Single => device::footprint::<f32>(&model(case, f32::LANES)),
    }
}

/// Fails if a device cannot hold a case, or the case needs what devices cannot do.
///
/// # Errors
/// [`DeviceError`] says which.
pub fn require(case: &Case, driver: &dyn Driver) -> Result<(), DeviceError> {
    match case.numerics.precision {
        Precision::Double => device::require::<f64>(&model(case, f64::LANES), driver),
        Precision::Single => device::require::<f32>(&model(case, f32::LANES), driver),
    }
}
