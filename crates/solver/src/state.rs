//! Everything that changes during a run. A checkpoint is this. The fields of the soil are `f64` or `f32`; all else is `f64`.

pub use crate::fields::{Nodes, STRESS_NAMES, Soil};
use crate::grid::Grid;
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
    pub body: u32,
    /// Which of its surface points.
    pub point: u32,
    /// Which material it touches.
    pub material: u32,
    /// Layers of its cell in the whole grid.
    pub cell: [u32; 3],
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

impl Contact {
    /// Its numbers but for those of body and point.
    pub(crate) fn to_array(self) -> [f64; 30] {
        let mut values = [0.0; 30];
        let [i, j, k] = self.cell.map(f64::from);
        let scalars = [f64::from(self.material), i, j, k, self.area, self.width, self.penetration];
        let vectors = [self.normal, self.arm, self.slip, self.impulse, self.anchor];
        let all =
            scalars.into_iter().chain(self.weight).chain(vectors.into_iter().flat_map(|v| v.to_array()));
        values.iter_mut().zip(all).for_each(|(value, new)| *value = new);
        values
    }

    /// The contact of a body and point with these numbers.
    pub(crate) fn of([body, point]: [usize; 2], values: [f64; 30]) -> Self {
        let [material, i, j, k, area, width, penetration, ..] = values;
        let vector = |n: usize| DVec3::from_slice(&values[15 + 3 * n..]);
        Self {
            body: body as u32,
            point: point as u32,
            material: material as u32,
            cell: [i, j, k].map(|layer| layer as u32),
            weight: std::array::from_fn(|n| values[7 + n]),
            normal: vector(0),
            arm: vector(1),
            area,
            width,
            penetration,
            slip: vector(2),
            impulse: vector(3),
            anchor: vector(4),
        }
    }
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
    /// Elastic energy of the soil that entered through open boundaries, less that of what left.
    pub inflow_elastic: f64,
    /// Its volume [m³].
    pub inflow_volume: f64,
    /// Its mass [kg].
    pub inflow_mass: f64,
}

/// Everything that changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State<R = f64> {
    /// Time since the start [s].
    pub time: f64,
    /// Number of steps taken.
    pub step: u64,
    /// How far the grid has moved since the start [m].
    pub grid_position: DVec3,
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

impl<R: Copy + Default> State<R> {
    /// The part of a state of the `whole` grid that a `block` and its ghost layers hold; bodies, contacts and energy balance
    /// every block knows.
    #[must_use]
    pub fn of_block(&self, whole: &Grid, block: &Grid) -> Self {
        let mut part = Self {
            soil: Soil::empty(block, self.soil.composition.len() + 1),
            nodes: Nodes::at_rest(block),
            bodies: self.bodies.clone(),
            contacts: self.contacts.clone(),
            ..*self
        };
        let copy = |from: &Vec<R>, to: &mut Vec<R>, beyond: usize| {
            let [nx, ny, nz] = block.cells().map(|n| n + beyond);
            for (j, k) in (0..nz).flat_map(|k| (0..ny).map(move |j| (j, k))) {
                let [i, there_j, there_k] = block.in_whole([0, j, k]);
                let (here, there) = (block.index(0, j, k), whole.index(i, there_j, there_k));
                to[here..here + nx].copy_from_slice(&from[there..there + nx]);
            }
        };
        self.soil.arrays().zip(part.soil.arrays_mut()).for_each(|(from, to)| copy(from, to, 0));
        self.nodes.arrays().zip(part.nodes.arrays_mut()).for_each(|(from, to)| copy(from, to, 1));
        part
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
            grid_position: self.grid_position,
            remaps: self.remaps,
            ledger: self.ledger,
        }
    }
}
