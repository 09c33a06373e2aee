//! The kernels in double precision.

/// The precision of the soil's fields.
pub(crate) type Real = f64;

pub(crate) use ::kernels::double::LANES;

/// A cell with more soil than this counts as full: no interface is reconstructed.
const FULL: f64 = 1.0 - 1e-9;

type State = crate::state::State<Real>;
type Soil = crate::state::Soil<Real>;
type Nodes = crate::state::Nodes<Real>;
type Workspace = crate::cpu::workspace::SoilWorkspace<Real>;
type PortionScratch = crate::cpu::workspace::PortionScratch<Real>;
type Coefficients = crate::cpu::workspace::Coefficients<Real>;
use ::kernels::double::{cells, device, nodes, return_mapping, stress};
use physics::double as physics;

#[path = "constants.rs"]
pub(crate) mod constants;
#[path = "energy.rs"]
pub(crate) mod energy;
#[path = "flux.rs"]
mod flux;
#[path = "lagrange.rs"]
pub(crate) mod lagrange;
#[path = "nonlocal.rs"]
pub(crate) mod nonlocal;
#[path = "on_device.rs"]
pub(crate) mod on_device;
#[path = "post_remap.rs"]
pub(crate) mod post_remap;
#[path = "strain.rs"]
mod strain;
#[path = "sweep.rs"]
pub(crate) mod sweep;
#[path = "transport.rs"]
mod transport;
