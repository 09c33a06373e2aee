//! Passive pressure of cohesionless soil on a plane face pushed into it.
//!
//! The face runs from its top edge O, at the ground line, down to its toe A. Its length is L [m] and its surface makes
//! the angle α with the horizontal: 90° is a vertical wall, less is a face that overhangs the soil it pushes (the
//! chord of a disc), 0° is a footing. The soil weighs γ [N/m³]; the ground in front rises at β. Every coefficient in
//! this module is the **normal** one, K_n, for the normal thrust per unit width
//!
//! P_n = ½ γ L² K_n [N/m],  σ_n(r) = γ r K_n [Pa] at the distance r from O.
//!
//! The total thrust, inclined at the wall friction δ, is P_n / cos δ. δ is positive when the face pushes the soil down
//! along itself (the classical passive case, the soil slides up), negative when it drags the soil upwards and forwards
//! (a sliding disc).

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
