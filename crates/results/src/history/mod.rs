//! The history of a run: samples of bodies, of stress and slip along their rims, of energy and boundaries,
//! and the ground that it has left behind.

pub mod blocks;

pub mod columns;
pub mod filter;
mod ground;
pub mod probes;
pub mod quantities;
pub mod reference;
pub mod rim;
pub mod steady;

pub use crate::ground_column::GroundColumn;
pub use ground::{RutSection, SurfacePoint};
use mechanics::Motion;
pub use quantities::BodySample;
use rim::RimHistory;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// One line of the history of a joint, or of a part of a body. Forces are those of the first body on the
/// second through the joint, or of the soil on the part, averaged over the interval that ends at `time`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ForceSample {
    /// Time [s].
    pub time: f64,
    /// Force along x [N].
    pub force_x: f64,
    /// Along y [N].
    pub force_y: f64,
    /// Along z [N].
    pub force_z: f64,
    /// Moment about x [N m], through the joint's point of the second body, or through the reference point of
    /// the part.
    pub moment_x: f64,
    /// Moment about y [N m], through the same point as that about x.
    pub moment_y: f64,
    /// Moment about z [N m], through the same point as that about x.
    pub moment_z: f64,
    /// Distance between the joint's points of the two bodies [m]: the length of a spring or a cable, the
    /// displacement of a slider; 0 of a part.
    pub distance: f64,
}

impl ForceSample {
    /// Magnitude of the force [N]; of a cable its tension.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force_x.hypot(self.force_y).hypot(self.force_z)
    }
}

/// The largest of some values that are not negative, 0 without any; one that is not a number, if there is
/// one.
#[must_use]
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    // `max` would drop what is not a number.
    values.into_iter().fold(0.0, |most: f64, v| if v > most || v.is_nan() { v } else { most })
}

/// The energy balance at one time: work and energy since the start, of the whole case [J].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergySample {
    /// Time [s].
    pub time: f64,
    /// Work of loads, prescribed motions and gravity, and the initial kinetic energy.
    pub external: f64,
    /// Kinetic energy of soil and bodies.
    pub kinetic: f64,
    /// Elastic energy of the soil, less that at the start.
    pub elastic: f64,
    /// Plastic dissipation.
    pub plastic: f64,
    /// Dissipation by friction on the bodies.
    pub friction: f64,
    /// Energy that the contact method itself stores, dissipates or adds; should be small.
    pub contact: f64,
    /// Dissipation by bulk viscosity.
    pub viscous: f64,
    /// Dissipation by hourglass viscosity.
    pub hourglass: f64,
    /// Dissipation by pore water that seeps through the soil.
    pub seepage: f64,
    /// Kinetic and elastic energy lost in remaps.
    pub remap_loss: f64,
    /// Soil volume over the volume at the start.
    pub volume_ratio: f64,
    /// Volume by which the pressure compresses the soil elastically, over the volume at the start; not of
    /// sand, whose law changes its volume in other ways, too.
    pub compression: f64,
    /// Portion of the soil's mass that is denser than it can be.
    pub overdense: f64,
    /// Volume of voids under soil at rest that neither a body nor cohesion carries, over that of disturbed
    /// soil.
    pub void: f64,
}

impl EnergySample {
    /// The error of the energy balance: energy that no entry explains [J].
    #[must_use]
    pub fn unexplained(&self) -> f64 {
        let explained = self.kinetic
            + self.elastic
            + self.plastic
            + self.friction
            + self.contact
            + self.viscous
            + self.hourglass
            + self.seepage
            + self.remap_loss;
        self.external - explained
    }

    /// Reference energy for relative figures [J]: the largest of external work, plastic dissipation and
    /// kinetic energy.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.external.abs().max(self.plastic.abs()).max(self.kinetic.abs())
    }

    /// Relative error of the energy balance: [`Self::unexplained`] over [`Self::scale`].
    #[must_use]
    pub fn closure(&self) -> f64 {
        let scale = self.scale();
        if scale > 0.0 { self.unexplained() / scale } else { 0.0 }
    }
}

/// The soil at the faces of the box at one time; of the whole case, not only of the modelled half or quarter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BoundarySample {
    /// Time [s].
    pub time: f64,
    /// Area of the lid that soil has reached [m²]; 0 where the soil reaches up to the lid from the start.
    pub lid_area: f64,
    /// Force of the soil on that area [N].
    pub lid_force: f64,
    /// Area of the side walls that soil has reached and that was bare at the start [m²].
    pub wall_area: f64,
    /// Largest rise of the normal pressure on floor and side walls above that at rest [Pa].
    pub stress_rise: f64,
}

/// The beginning of a stage of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StageStart {
    /// When the stage began [s].
    pub time: f64,
    /// The motions of each body from then on.
    pub motions: Vec<[Motion; 6]>,
}

/// All samples of a run so far.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Names of the bodies.
    pub names: Vec<String>,
    /// Samples of each body, in the order of `names`.
    pub bodies: Vec<Vec<BodySample>>,
    /// The rim of each body.
    pub rims: Vec<RimHistory>,
    /// Names of the parts of bodies that consist of several.
    pub part_names: Vec<String>,
    /// Samples of each part, in the order of `part_names`.
    pub parts: Vec<Vec<ForceSample>>,
    /// Names of the joints.
    pub joint_names: Vec<String>,
    /// Samples of each joint, in the order of `joint_names`.
    pub joints: Vec<Vec<ForceSample>>,
    /// The stages that have begun.
    pub stages: Vec<StageStart>,
    /// When the last stage ended [s].
    pub stages_ended: Option<f64>,
    /// The energy balance.
    pub energy: Vec<EnergySample>,
    /// The energy that passed to and from another program that steers bodies.
    pub exchange: ExchangeBalance,
    /// The faces of the box.
    pub boundaries: Vec<BoundarySample>,
    /// The surface that a grid that travels has left behind, in lines across its way; empty where the grid
    /// stands still.
    pub ground_left: Vec<SurfacePoint>,
}

/// The energy that passed to and from another program that steers bodies.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ExchangeBalance {
    /// Numbers of the bodies that it has steered.
    pub steered: BTreeSet<usize>,
    /// Sum of the magnitudes of the work of the soil on the bodies between two exchanges [J].
    pub work: f64,
    /// Sum of what the mean force between two exchanges makes of that work, less the work itself [J].
    pub difference: f64,
}

impl History {
    /// When a stage began and when it ended, by its number [s]; the end of one that is not over is the last
    /// sample.
    #[must_use]
    pub fn stage_times(&self, number: usize) -> Option<[f64; 2]> {
        let from = self.stages.get(number)?.time;
        let next = self.stages.get(number + 1).map(|next| next.time).or(self.stages_ended);
        let last = self.energy.last().map_or(from, |sample| sample.time);
        Some([from, next.unwrap_or(last)])
    }
}
