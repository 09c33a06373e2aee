//! The number type of the soil's fields.

use crate::model::Model;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// `f64` or `f32`.
pub trait Scalar:
    Copy + Default + PartialOrd + Debug + Into<f64> + Send + Sync + Serialize + DeserializeOwned + 'static
{
    /// Name of the precision in case files and reports.
    const NAME: &'static str;
    /// Numbers in the widest vector register.
    const LANES: usize;
    /// A difference of volume fractions below this is round-off.
    const ROUND_OFF: f64;
    /// Scratch memory of a kernel for a block of cells.
    type CellBlock: Send;

    /// Constants of the materials of a model, in this precision.
    type Materials: Send + Sync;

    /// A device with fields of this type.
    type OnDevice: Send + Sync + Debug;

    /// The nearest number of this type.
    fn cast(value: f64) -> Self;

    /// The number in double precision.
    fn to_f64(self) -> f64 {
        self.into()
    }

    /// Constants of the materials of a model, in this precision.
    fn materials(model: &Model) -> Self::Materials;

    /// Scratch memory for a block of cells.
    fn cell_block() -> Box<Self::CellBlock>;
}
