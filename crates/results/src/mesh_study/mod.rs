//! One case on several meshes: how its figures converge, and intervals that hold what an infinitely fine mesh
//! and a long tow would give.
//!
//! It is calculated from histories and grades alone; `run` makes them, `output` reads them.

mod checks;
mod convergence;
mod evaluate;
mod figures;

pub use convergence::{
    ASSUMED_ORDER, Convergence, LARGEST_ORDER, LEAST_ORDER, OnMesh, SAFETY_CONVERGING, SAFETY_OTHERWISE,
    extrapolated, observed_order,
};
pub use evaluate::millimetres;
pub use evaluate::{MeshRun, evaluate};
pub use figures::{BodyOnMesh, BodyStudy, MeshInterval, MeshResult, MeshStudy};
