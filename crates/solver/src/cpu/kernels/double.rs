//! The kernels in double precision.

/// The precision of the soil's fields.
pub(crate) type Real = f64;

pub(crate) use ::kernels::double::LANES;

type State = crate::state::State<Real>;
type Soil = crate::state::Soil<Real>;
type Nodes = crate::state::Nodes<Real>;
type Workspace = crate::cpu::workspace::SoilWorkspace<Real>;
type PortionScratch = crate::cpu::workspace::PortionScratch<Real>;
type Coefficients = crate::cpu::workspace::Coefficients<Real>;
use ::kernels::double::{
    self as rows, cells, device, device_arrays, device_remap, device_run, flux, nodes, remap, return_mapping,
    stress, transport,
};
use physics::double as physics;

#[path = "addresses.rs"]
mod addresses;
#[path = "constants.rs"]
pub(crate) mod constants;
#[path = "energy.rs"]
pub(crate) mod energy;
#[path = "lagrange.rs"]
pub(crate) mod lagrange;
#[path = "listed.rs"]
mod listed;
#[path = "nonlocal.rs"]
pub(crate) mod nonlocal;
#[path = "on_device.rs"]
pub(crate) mod on_device;
#[path = "post_remap.rs"]
pub(crate) mod post_remap;
#[path = "remap_on_device.rs"]
mod remap_on_device;
#[path = "strain.rs"]
mod strain;
#[path = "sweep.rs"]
pub(crate) mod sweep;
