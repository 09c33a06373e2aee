//! Bearing capacity of a strip, and what shape, depth and inclination make of it.
//!
//! q = c N_c s_c d_c i_c + q₀ N_q s_q d_q i_q + ½ γ B N_γ s_γ d_γ i_γ [Pa].

mod corrections;
mod factors;
mod flow;

pub use corrections::{Corrections, Footing, Method, corrections};
pub use factors::{
    cohesion_factor, surcharge_factor, weight_factor_exact_smooth, weight_factor_hansen,
    weight_factor_lyamin, weight_factor_martin_rough, weight_factor_meyerhof, weight_factor_vesic,
};
pub use flow::davis_friction_angle;
