//! Everything that changes during a run. A checkpoint is this. The fields of the soil are `f64` or `f32`; all else is `f64`.

pub use crate::fields::{Nodes, STRESS_NAMES, Soil};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Where a body is and how it moves. The whole body, also when only half of it is modelled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Reference point (of a disc: the middle of its axle) [m].
    pub position: DVec3,
    /// Angle turned about the axle [rad], positive when it rolls forward.
    pub angle: f64,
    /// Velocity of the reference point [m/s].
    pub velocity: DVec3,
    /// Rate of turning about the axle [rad/s], positive when it rolls forward.
    pub spin: f64,
    /// What the soil has given to the body since the start.
    pub received: Received,
    /// Soil found inside the body at the last remap [m³].
    pub leaked_volume: f64,
    /// Volume of the body below the undisturbed surface at the last remap [m³].
    pub embedded_volume: f64,
    /// Position [m] and angle [rad] at which its contact points were last located.
    pub located: (DVec3, f64),
}

/// Impulses that the soil has given to a body since the start. Differences over an interval, divided by its length, are
/// mean forces, so no force is lost between two samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Received {
    /// By pressure normal to the surface [N s].
    pub normal: DVec3,
    /// By friction [N s].
    pub friction: DVec3,
    /// About the axle [N m s], positive when it makes the body roll forward.
    pub axle: f64,
}

/// A point of a body's surface in the grid with soil to act on: what it remembers, and where it sits until the next remap.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Which body.
    pub body: usize,
    /// Which of its surface points.
    pub point: usize,
    /// Which material it touches.
    pub material: usize,
    /// Place of the cell's low node.
    pub base: usize,
    /// Weights of the cell's eight nodes.
    pub weight: [f64; 8],
    /// Normal out of the body.
    pub normal: DVec3,
    /// From the body's reference point to the point [m].
    pub arm: DVec3,
    /// Area that the point stands for [m²].
    pub area: f64,
    /// Smallest width of its cell [m].
    pub width: f64,
    /// Penetration (penalty) [m].
    pub penetration: f64,
    /// Elastic slip (penalty) [m].
    pub slip: DVec3,
    /// Impulse of the last step, to start the next from (impulses) [N s].
    pub impulse: DVec3,
    /// Position at the last remap [m].
    pub anchor: DVec3,
}

/// Where the energy went since the start, and what was lost on the way. Of the part that is modelled [J].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Work of loads and drives on the bodies, and of gravity on the soil.
    pub external: f64,
    /// Plastic dissipation.
    pub plastic: f64,
    /// Dissipation by bulk viscosity.
    pub viscous: f64,
    /// Dissipation by hourglass viscosity.
    pub hourglass: f64,
    /// Dissipation by friction on bodies.
    pub friction: f64,
    /// What the contact method itself stores, takes or gives: springs, damping, corrections of the penetration.
    pub contact: f64,
    /// Kinetic and elastic energy lost in remaps.
    pub remap: f64,
    /// Elastic energy of the soil at the start.
    pub elastic_start: f64,
    /// Kinetic energy of soil and bodies at the start.
    pub kinetic_start: f64,
    /// Soil volume at the start [m³].
    pub volume_start: f64,
    /// Volume of the crumbs that remaps took out [m³].
    pub crumbs_volume: f64,
    /// Their mass [kg].
    pub crumbs_mass: f64,
}

/// Everything that changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State<R = f64> {
    /// Time since the start [s].
    pub time: f64,
    /// Number of steps taken.
    pub step: u64,
    /// The cells.
    pub soil: Soil<R>,
    /// The nodes.
    pub nodes: Nodes<R>,
    /// The bodies, in the order of the model's.
    pub bodies: Vec<Body>,
    /// The contact points that have soil to act on, body by body, in the order of their points.
    pub contacts: Vec<Contact>,
    /// Number of remaps done.
    pub remaps: u64,
    /// Energy and mass.
    pub ledger: Ledger,
}

impl<R> State<R> {
    /// Memory that it takes up [bytes].
    #[must_use]
    pub fn memory(&self) -> usize {
        let fields = self.soil.arrays().chain(self.nodes.arrays());
        fields.map(|field| size_of_val(field.as_slice())).sum::<usize>()
            + size_of_val(self.contacts.as_slice())
    }
}

impl<R: Copy + Into<f64>> State<R> {
    /// The same with its fields in double precision.
    #[must_use]
    pub fn to_f64(&self) -> State {
        State {
            soil: self.soil.to_f64(),
            nodes: self.nodes.to_f64(),
            bodies: self.bodies.clone(),
            contacts: self.contacts.clone(),
            time: self.time,
            step: self.step,
            remaps: self.remaps,
            ledger: self.ledger,
        }
    }
}
