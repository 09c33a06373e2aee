//! The number type of the soil's fields.

use crate::model::Model;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// `f64` or `f32`.
pub trait Scalar:
    Copy + Default + PartialOrd + Debug + Into<f64> + Send + Sync + Serialize + DeserializeOwned + 'static
{
    /// Its name in case files and reports.
    const NAME: &'static str;
    /// Numbers in the widest vector.
    const LANES: usize;
    /// A difference of volume fractions below this is round-off.
    const ROUND_OFF: f64;
    /// What a kernel keeps of a block of cells while it works on it.
    type CellBlock: Send;

    /// The materials of a model, as the kernels need them.
    type Materials: Send + Sync;

    /// The nearest number of this type.
    fn cast(value: f64) -> Self;

    /// This number in double precision.
    fn to_f64(self) -> f64 {
        self.into()
    }

    /// The materials of a model, as the kernels need them.
    fn materials(model: &Model) -> Self::Materials;

    /// Working memory for a block of cells.
    fn cell_block() -> Box<Self::CellBlock>;
}
