//! Bearing capacity of a footing: factors of a strip, corrected for shape, depth and load inclination.
//!
//! q = c N_c s_c d_c i_c + q₀ N_q s_q d_q i_q + ½ γ B N_γ s_γ d_γ i_γ [Pa]; of undrained clay q = s_u N_c s_c
//! d_c i_c + q₀.

mod corrections;
mod davis;
mod factors;
mod growing;
mod undrained;

pub use corrections::{Corrections, Footing, Method, corrections};
pub use davis::davis_friction_angle;
pub use factors::{
    cohesion_factor, surcharge_factor, weight_factor_exact_smooth, weight_factor_hansen,
    weight_factor_lyamin, weight_factor_martin_rough, weight_factor_meyerhof, weight_factor_vesic,
};
pub use growing::growth_of_factor;
pub(crate) use undrained::round_over_square;
pub use undrained::{undrained_factor, undrained_friction_limit, undrained_pressure};
