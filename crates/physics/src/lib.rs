//! What happens at one point of soil, or on the skin of one body.
//!
//! Nothing here knows a grid, a file, a thread or the heap of a running simulation: every function takes the numbers
//! of one point and returns the numbers of one point. SI units, radians, tension positive.

pub mod brick;
pub mod elastic;
pub mod interface;
pub mod limiter;
pub mod menetrey_willam;
pub mod mohr_coulomb;
pub mod rigid;
pub mod shape;
pub mod strength;
pub mod tensor;
pub mod viscosity;
pub mod von_mises;
