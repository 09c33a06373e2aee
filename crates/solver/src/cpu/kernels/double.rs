//! The kernels in double precision.

/// The precision of the soil's fields.
pub(crate) type Real = f64;

/// Numbers in the widest vector register.
pub(crate) const LANES: usize = 64 / size_of::<Real>();

/// A cell with more soil than this counts as full: no interface is reconstructed.
const FULL: f64 = 1.0 - 1e-9;

type State = crate::state::State<Real>;
type Soil = crate::state::Soil<Real>;
type Nodes = crate::state::Nodes<Real>;
type Workspace = crate::cpu::workspace::SoilWorkspace<Real>;
type PortionScratch = crate::cpu::workspace::PortionScratch<Real>;
type Coefficients = crate::cpu::workspace::Coefficients<Real>;
use physics::double as physics;

#[path = "cells.rs"]
pub(crate) mod cells;
#[path = "energy.rs"]
pub(crate) mod energy;
#[path = "flux.rs"]
mod flux;
#[path = "lagrange.rs"]
pub(crate) mod lagrange;
#[path = "lanes.rs"]
mod lanes;
#[path = "nodes.rs"]
mod nodes;
#[path = "nonlocal.rs"]
pub(crate) mod nonlocal;
#[path = "post_remap.rs"]
pub(crate) mod post_remap;
#[path = "return_mapping.rs"]
mod return_mapping;
#[path = "stress.rs"]
mod stress;
#[path = "sweep.rs"]
pub(crate) mod sweep;
#[path = "transport.rs"]
mod transport;
