//! Variations of a case, to see how far its results depend on what is a choice of the model: the cells, the
//! domain, the speed and the precision. Each variation is a case of its own, with a text of its own.

mod change;
mod domain;
mod plan;
mod source;
mod speed;

pub use domain::FARTHER;
pub use plan::{Asked, LeftOut, MESHES, Variation, VariationPlan, in_place_of, on_step, variations};
pub use source::ErrorSource;
pub use speed::LONGER;
