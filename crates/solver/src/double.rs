//! The time step in double precision.

/// The precision of the soil's fields.
pub type Real = f64;

/// Numbers in the widest vector.
pub const LANES: usize = 64 / size_of::<Real>();

/// A cell with more soil than this counts as full: no interface is looked for.
const FULL: f64 = 1.0 - 1e-9;
/// A difference of volume fractions below this is rounding.
const ROUNDING: f64 = 1e-12;

type State = crate::state::State<Real>;
type Soil = crate::state::Soil<Real>;
type Nodes = crate::state::Nodes<Real>;
use physics::double as physics;

#[path = "audit.rs"]
pub mod audit;
#[path = "cpu/contact/mod.rs"]
pub mod contact;
#[path = "cpu/energy.rs"]
pub mod energy;
#[path = "cpu/flux.rs"]
pub mod flux;
#[path = "cpu/footprint.rs"]
pub mod footprint;
#[path = "cpu/lagrange.rs"]
pub mod lagrange;
#[path = "cpu/nodes.rs"]
pub mod nodes;
#[path = "cpu/remap.rs"]
pub mod remap;
#[path = "cpu/returns.rs"]
pub mod returns;
#[path = "cpu/settle.rs"]
pub mod settle;
#[path = "start.rs"]
pub mod start;
#[path = "step.rs"]
pub mod step;
#[path = "cpu/stress.rs"]
pub mod stress;
#[path = "cpu/transport.rs"]
pub mod transport;
#[path = "cpu/workspace.rs"]
pub mod workspace;
