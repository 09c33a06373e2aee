//! Passive pressure of cohesionless soil on a plane face pushed into it.
//!
//! The face runs from its top edge O, at the ground line, down to its toe A. Its length is L [m] and its
//! inclination to the horizontal α: 90° is a vertical wall, less a face that overhangs the soil (the chord of
//! a disc), 0° a footing. The unit weight is γ [N/m³]; the ground in front rises at β. All coefficients in
//! this module are **normal** ones, K_n, for the normal thrust per unit width
//!
//! P_n = ½ γ L² K_n [N/m],  σ_n(r) = γ r K_n [Pa] at the distance r from O.
//!
//! The total thrust, inclined at the wall friction angle δ, is P_n / cos δ. δ is positive when the face
//! exerts a downward friction force on the soil (the classical passive case: the soil slides up), negative
//! when it drags the soil upwards and forwards (a sliding disc).

mod comparison;
mod coulomb;
mod eurocode;
mod face;
mod lancellotta;
mod log_spiral;
mod rankine;
mod sokolovskii;
mod table;

pub use comparison::{Comparison, compare};
pub use coulomb::{coulomb, coulomb_active, coulomb_total};
pub use eurocode::{eurocode, eurocode_surcharge};
pub use face::Face;
pub use lancellotta::{cohesion_coefficient, lancellotta, surcharge_coefficient};
pub use log_spiral::log_spiral;
pub use rankine::rankine;
pub use sokolovskii::{PassiveField, sokolovskii};
pub use table::{PressureTable, TableRange};
