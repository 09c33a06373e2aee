// Modules of the material point, compiled once for each precision.

#[path = "brick.rs"]
pub mod brick;
#[path = "clay.rs"]
pub mod clay;
#[path = "elastic.rs"]
pub mod elastic;
#[path = "law.rs"]
pub mod law;
#[path = "limiter.rs"]
pub mod limiter;
#[path = "menetrey_willam.rs"]
pub mod menetrey_willam;
#[path = "mohr_coulomb.rs"]
pub mod mohr_coulomb;
#[path = "sand.rs"]
pub mod sand;
#[path = "tensor.rs"]
pub mod tensor;
#[path = "viscosity.rs"]
pub mod viscosity;
#[path = "von_mises.rs"]
pub mod von_mises;
#[path = "yield_law.rs"]
pub mod yield_law;
