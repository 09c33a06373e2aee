//! Everything that changes during a run: the content of a checkpoint. The fields of the soil are `f64` or
//! `f32`, all else is `f64`.

pub use crate::fields::{Known, Nodes, STRESS_NAMES, Soil};
use crate::grid::Grid;
use glam::DVec3;
pub use mechanics::{MechanismState, Pose, Twist};
use serde::{Deserialize, Serialize};

/// What the soil does to a body, and what contact remembers of it. Quantities are those of the whole body,
/// also when only half of it is modelled. Pose and twist are in [`State::mechanism`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Contact impulse of the soil on the body since the start.
    pub contact_impulse: ContactImpulse,
    /// Contact impulse on each of the body's parts; empty where there is only one.
    pub parts: Vec<ContactImpulse>,
    /// Rotation of the body about its axle since the start [rad], positive when it rolls forward.
    pub rotation: f64,
    /// Soil found inside the body at the last remap [m³].
    pub leaked_volume: f64,
    /// Volume of the body below the undisturbed surface at the last remap [m³].
    pub embedded_volume: f64,
    /// Pose at the last contact search.
    pub searched_at: Pose,
    /// What the soil has done since the start to each bin of the rim, and last to the flanks; of the modelled
    /// portion.
    pub rim: Vec<RimSums>,
}

/// Impulse and angular impulse of the soil on a body. Of cumulative impulses, the difference over an interval
/// divided by its length is the mean force, so that no force is lost between two samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ContactImpulse {
    /// Impulse of the pressure normal to the surface [N s].
    pub normal: DVec3,
    /// Impulse of friction [N s].
    pub friction: DVec3,
    /// Angular impulse about the reference point [N m s].
    pub moment: DVec3,
    /// The portion of `normal` that excess pore pressure has exerted [N s].
    pub pore: DVec3,
}

/// What the soil has done to a part of a body's surface since the start. Vectors along the surface have three
/// components: along the outline, positive towards the front where it is below; along the axle; and along the
/// axle away from the body's mid-plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimSums {
    /// Area in contact times its duration [m² s].
    pub contact: f64,
    /// Normal impulse [N s].
    pub normal: f64,
    /// Magnitude of the frictional impulse, whatever its direction [N s].
    pub friction: f64,
    /// The largest frictional impulse that Coulomb's law and the adhesion would have admitted [N s].
    pub friction_limit: f64,
    /// Frictional impulse on the body along the surface [N s].
    pub shear: [f64; 3],
    /// Slip velocity of the body relative to the soil along the surface, times area and duration of the
    /// contact [m³].
    pub slip: [f64; 3],
    /// Impulse of the soil on the body [N s].
    pub impulse: DVec3,
}

impl RimSums {
    /// What has been added since `then`.
    #[must_use]
    pub fn since(&self, then: &Self) -> Self {
        let less = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|n| a[n] - b[n]);
        Self {
            contact: self.contact - then.contact,
            normal: self.normal - then.normal,
            friction: self.friction - then.friction,
            friction_limit: self.friction_limit - then.friction_limit,
            shear: less(self.shear, then.shear),
            slip: less(self.slip, then.slip),
            impulse: self.impulse - then.impulse,
        }
    }
}

/// A contact point with soil to act on: its history, and its cell and weights until the next contact search.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Index of the body.
    pub body: u32,
    /// Index among the body's surface points.
    pub point: u32,
    /// Number of the material in the cell of the point.
    pub material: u32,
    /// Largest frictional force, whatever the pressure, over `area` [Pa]: with what the point represents of
    /// the margins along edges; infinite for no such limit.
    pub shear_limit: f64,
    /// Side of the body's mid-plane on which the point lies: 0 and 1, or 2 on the plane.
    pub side: u8,
    /// Whether the body's next point is the mirror image of this one in the mid-plane.
    pub is_paired: bool,
    /// Cell `(i, j, k)` in the whole grid.
    pub cell: [u32; 3],
    /// Octant of the cell, numbered like its nodes.
    pub octant: u8,
    /// Weights of the cell's eight nodes.
    pub weight: [f64; 8],
    /// Outward unit normal of the body.
    pub normal: DVec3,
    /// Arm from the body's reference point to the point [m].
    pub arm: DVec3,
    /// Area of the surface round the point [m²].
    pub area: f64,
    /// Smallest width of the cell of the point [m].
    pub width: f64,
    /// Penetration, negative for a gap [m].
    pub penetration: f64,
    /// Elastic slip (penalty method) [m].
    pub slip: DVec3,
    /// Impulse of the last step, from which the next is warm-started (impulse method) [N s].
    pub impulse: DVec3,
    /// Position at the last contact search [m].
    pub anchor: DVec3,
}

impl Contact {
    /// All numbers of the contact except the indices of body and point.
    pub(crate) fn to_array(self) -> [f64; 34] {
        let mut values = [0.0; 34];
        let [i, j, k] = self.cell.map(f64::from);
        let scalars = [f64::from(self.material), i, j, k, self.area, self.width, self.penetration];
        let vectors = [self.normal, self.arm, self.slip, self.impulse, self.anchor];
        let all =
            scalars.into_iter().chain(self.weight).chain(vectors.into_iter().flat_map(|v| v.to_array()));
        values.iter_mut().zip(all).for_each(|(value, new)| *value = new);
        (values[30], values[31], values[32]) = (self.side.into(), self.is_paired.into(), self.octant.into());
        values[33] = self.shear_limit;
        values
    }

    /// The inverse of [`Contact::to_array`].
    pub(crate) fn of([body, point]: [usize; 2], values: [f64; 34]) -> Self {
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
            side: values[30] as u8,
            is_paired: values[31] != 0.0,
            octant: values[32] as u8,
            shear_limit: values[33],
        }
    }
}

/// Terms of the energy balance since the start, for the modelled portion of the domain [J].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyBalance {
    /// Work of loads and drives on the bodies, and of gravity on the soil.
    pub external: f64,
    /// Plastic dissipation.
    pub plastic: f64,
    /// Dissipation by bulk viscosity.
    pub viscous: f64,
    /// Dissipation by hourglass viscosity.
    pub hourglass: f64,
    /// Dissipation by pore water that seeps through the soil.
    pub seepage: f64,
    /// Frictional dissipation on bodies.
    pub friction: f64,
    /// Energy stored, dissipated or added by the contact method: springs, damping, corrections of the
    /// penetration.
    pub contact: f64,
    /// Kinetic and elastic energy lost in remaps.
    pub remap: f64,
    /// Elastic energy of the soil at the start.
    pub elastic_start: f64,
    /// Kinetic energy of soil and bodies at the start.
    pub kinetic_start: f64,
    /// Soil volume at the start [m³].
    pub volume_start: f64,
    /// Volume of the VOF debris that remaps have removed [m³].
    pub debris_volume: f64,
    /// Mass of the VOF debris that remaps have removed [kg].
    pub debris_mass: f64,
    /// Elastic energy of the soil that entered through open boundaries, less that of what left.
    pub inflow_elastic: f64,
    /// Volume of the soil that entered through open boundaries, less that of what left [m³].
    pub inflow_volume: f64,
    /// Mass of the soil that entered through open boundaries, less that of what left [kg].
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
    /// Poses, twists and momenta of the bodies; impulses of the joints.
    pub mechanism: MechanismState,
    /// Contact points with soil to act on, in the order of bodies and points.
    pub contacts: Vec<Contact>,
    /// Number of remaps since the start.
    pub remaps: u64,
    /// Energy balance, and the mass removed by remaps.
    pub energy_balance: EnergyBalance,
}

impl<R> State<R> {
    /// Pose of a body.
    #[must_use]
    pub fn pose(&self, body: usize) -> &Pose {
        &self.mechanism.bodies[body].pose
    }

    /// Twist of a body.
    #[must_use]
    pub fn twist(&self, body: usize) -> &Twist {
        &self.mechanism.bodies[body].twist
    }

    /// Axis of tilt of a body: the level unit vector across its axle.
    #[must_use]
    pub fn tilt_axis(&self, body: usize) -> DVec3 {
        self.mechanism.bodies[body].tilt_axis()
    }

    /// Memory in use [bytes].
    #[must_use]
    pub fn memory(&self) -> usize {
        let fields = self.soil.arrays().chain(self.nodes.arrays());
        fields.map(|field| size_of_val(field.as_slice())).sum::<usize>()
            + size_of_val(self.contacts.as_slice())
    }
}

impl<R: Copy + Default> State<R> {
    /// The portion of a state of the `whole` grid held by a `block` with its ghost layers. Bodies, contacts
    /// and energy balance are the same in every block.
    #[must_use]
    pub fn of_block(&self, whole: &Grid, block: &Grid) -> Self {
        let mut own = self.without_soil(block);
        own.take_over(block, self, whole);
        own
    }

    /// The bodies, contacts and energy balance in another block, which holds nothing yet.
    #[must_use]
    pub fn without_soil(&self, block: &Grid) -> Self {
        Self {
            soil: Soil::empty(block, self.soil.composition.len() + 1, self.soil.kinds()),
            nodes: Nodes::at_rest(block),
            bodies: self.bodies.clone(),
            mechanism: self.mechanism.clone(),
            contacts: self.contacts.clone(),
            ..*self
        }
    }

    /// The bodies, contacts and energy balance, and arrays of soil and nodes with one entry where they are
    /// needed, otherwise with none.
    #[must_use]
    pub fn without_fields(&self) -> Self {
        let mut own = self.without_soil(&Grid::new(std::array::from_fn(|_| vec![0.0, 1.0])));
        let arrays = own.soil.arrays_mut();
        arrays.for_each(|field| field.truncate(1));
        own.nodes.arrays_mut().for_each(|field| field.truncate(1));
        own
    }

    /// Takes over what another block of the same grid accounts for and this block holds.
    pub fn take_over(&mut self, block: &Grid, other: &Self, of: &Grid) {
        self.put(block, &other.portion(of, [0, 1, 2].map(|axis| of.accounted(axis))));
    }
}

impl<R: Copy + Into<f64>> State<R> {
    /// The state with fields in double precision.
    #[must_use]
    pub fn to_f64(&self) -> State {
        State {
            soil: self.soil.to_f64(),
            nodes: self.nodes.to_f64(),
            bodies: self.bodies.clone(),
            mechanism: self.mechanism.clone(),
            contacts: self.contacts.clone(),
            time: self.time,
            step: self.step,
            grid_position: self.grid_position,
            remaps: self.remaps,
            energy_balance: self.energy_balance,
        }
    }
}
