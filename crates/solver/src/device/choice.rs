//! Which device a run asks for, and whether it can run a model.

#[cfg(feature = "gpu")]
use super::cuda;
use super::driver::{DeviceError, Driver};
use super::replay;
use crate::fields::HISTORY;
use crate::model::Model;
use crate::scalar::Scalar;
use ::kernels::launch::{MATERIALS, MEASURED, POWERS, PlaneSum, ROW_SUMS};
use ::kernels::sums::COEFFICIENTS;
use std::fmt;
use std::str::FromStr;

/// What strains the soil of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Device {
    /// The processor.
    #[default]
    Processor,
    /// A graphics card of NVIDIA, by its number.
    Gpu(u32),
    /// The processor in place of a graphics card, with its kernels: slow, for comparison.
    StandIn,
}

impl FromStr for Device {
    type Err = String;

    /// The device of this name: `cpu`, `gpu`, `gpu:1`, `stand-in`.
    fn from_str(name: &str) -> Result<Self, String> {
        let number = |name: &str| name.strip_prefix("gpu:")?.parse().ok();
        match name {
            "cpu" => Ok(Self::Processor),
            "gpu" => Ok(Self::Gpu(0)),
            "stand-in" => Ok(Self::StandIn),
            _ => number(name).map(Self::Gpu).ok_or_else(|| {
                format!("`{name}` is no device: cpu, gpu, gpu:N for the card of number N, or stand-in")
            }),
        }
    }
}

impl fmt::Display for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Processor => write!(f, "cpu"),
            Self::Gpu(0) => write!(f, "gpu"),
            Self::Gpu(number) => write!(f, "gpu:{number}"),
            Self::StandIn => write!(f, "stand-in"),
        }
    }
}

impl Device {
    /// Opens the device; `None` for the processor.
    ///
    /// # Errors
    /// [`DeviceError`] if there is no such device, or if the program was built without the feature `gpu`.
    pub fn open(self) -> Result<Option<Box<dyn Driver>>, DeviceError> {
        match self {
            Self::Processor => Ok(None),
            Self::StandIn => Ok(Some(Box::new(replay::Replay::default()))),
            #[cfg(feature = "gpu")]
            Self::Gpu(number) => Ok(Some(Box::new(cuda::Cuda::new(number)?))),
            #[cfg(not(feature = "gpu"))]
            Self::Gpu(_) => Err(DeviceError(
                "this program was built without graphics cards: cargo build --release --features gpu"
                    .to_owned(),
            )),
        }
    }
}

/// Fails if a device cannot hold the fields of a model, or a model needs what devices cannot do.
///
/// # Errors
/// [`DeviceError`] says which.
pub fn require<R: Scalar>(model: &Model, driver: &dyn Driver) -> Result<(), DeviceError> {
    if model.pore_water.is_some() {
        return Err(DeviceError("pore water flows on the processor alone".to_owned()));
    }
    if model.materials.len() > MATERIALS {
        return Err(DeviceError(format!("soils of more than {MATERIALS} materials need the processor")));
    }
    let needed = footprint::<R>(model);
    match driver.free_memory().filter(|free| needed > *free) {
        Some(free) => Err(DeviceError(format!(
            "the grid takes {:.1} GB, and {:.1} GB are free on {}",
            1e-9 * needed,
            1e-9 * free,
            driver.name()
        ))),
        None => Ok(()),
    }
}

/// Memory that a grid takes on a device [bytes], without what contact touches.
#[must_use]
pub fn footprint<R: Scalar>(model: &Model) -> f64 {
    let history = HISTORY.iter().filter(|variable| model.kinds().need(variable)).count();
    // Volume fraction, two masses, volume strain apart, stress, two velocities, displacement; of several
    // materials the masses of the cells and the portions of all but the first.
    let materials = if model.materials.len() > 1 { model.materials.len() } else { 0 };
    let reals = 4 + 6 + history + materials + 6 + 3 + COEFFICIENTS + POWERS + MEASURED;
    let per_entry = reals * size_of::<R>() + 2;
    let (rows, planes) = (model.grid.rows() * (model.grid.cells()[2] + 3), model.grid.cells()[2] + 2);
    let sums = rows * (ROW_SUMS * size_of::<f64>() + 2) + planes * ROW_SUMS * size_of::<PlaneSum>();
    (per_entry * model.grid.entries + sums) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_is_read_as_it_is_written() {
        for device in [Device::Processor, Device::Gpu(0), Device::Gpu(3), Device::StandIn] {
            assert_eq!(device.to_string().parse(), Ok(device));
        }
        assert!("gpu:".parse::<Device>().is_err() && "card".parse::<Device>().is_err());
    }
}
