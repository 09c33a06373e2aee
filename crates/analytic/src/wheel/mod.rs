//! Rolling resistance and sinkage of a wheel by models from the literature.

mod bekker;
mod hetherington;
mod mobility;
mod terrains;
mod wong_reece;

pub use bekker::{PressureSinkage, RollingResistance, bekker_at_depth, bekker_towed, janosi_shear};
pub use hetherington::{ARC_PREFACTOR, hetherington_littleton, hetherington_littleton_at_depth, shallow_arc};
pub use mobility::{MobilityGroup, brixius_towed, wismer_luth_towed};
pub use terrains::{CMU_SAND, TERRAINS, Terrain};
pub use wong_reece::{WheelState, wong_reece_at_depth, wong_reece_towed};
