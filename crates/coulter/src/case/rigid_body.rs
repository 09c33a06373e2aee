//! A rigid body of a case: its shape, mass and motion in SI units, and the space that it takes.

use super::shapes::Shape;
use glam::{DQuat, DVec3};
use mechanics::Motion;
use physics::shape::{Rotated, Shape as Solid};
use serde::Serialize;

/// A rigid body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Body {
    /// Its name in the file.
    pub name: String,
    /// Its shape.
    pub shape: Shape,
    /// Reference point at the start [m].
    pub position: DVec3,
    /// Attitude at the start.
    pub attitude: Attitude,
    /// Mass [kg] of the whole body.
    pub mass: f64,
    /// Moment of inertia about the axle [kg m²] of the whole body.
    pub axle_inertia: f64,
    /// Coefficient of friction μ of its surface against the soil; infinite for a rough (no-slip) one.
    pub friction: f64,
    /// Largest frictional traction [Pa], whatever the pressure: α s_u; infinite for no such limit.
    pub shear_limit: f64,
    /// Motion along x (tow), y (lateral), z (heave).
    pub translation: [Motion; 3],
    /// Yaw about the vertical, tilt about the axis that yaw carries, and spin about the axle.
    pub rotation: [Motion; 3],
    /// How joints make it move; `None` without a joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub guide: Option<Guide>,
}

/// How a body moves that joints guide, for estimates of its path: what its carrier prescribes, free where the joint leaves it free.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Guide {
    /// Along x, y, z.
    pub translation: [Motion; 3],
    /// Yaw and tilt.
    pub rotation: [Motion; 2],
}

impl Guide {
    /// The ground does not move.
    pub const GROUND: Self = Self { translation: [Motion::Fixed; 3], rotation: [Motion::Fixed; 2] };
}

/// Attitude of a body: it is rotated by `pitch` about its axle, y, then by `tilt` about x, then by `yaw` about z. Positive angles
/// follow the right-hand rule: pitch tips the top forwards, tilt lifts the left end of the axle, yaw turns the front to the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Attitude {
    /// Rotation about z [rad].
    pub yaw: f64,
    /// Rotation about the x axis that yaw carries [rad], −π/2 to π/2.
    pub tilt: f64,
    /// Rotation about the axle [rad].
    pub pitch: f64,
}

impl Attitude {
    /// The rotation by tilt and yaw, which carries the axle.
    #[must_use]
    pub fn of_axle(&self) -> DQuat {
        if self.axle_is_across() {
            DQuat::IDENTITY
        } else {
            DQuat::from_rotation_z(self.yaw) * DQuat::from_rotation_x(self.tilt)
        }
    }

    /// Whether the axle lies along y.
    #[must_use]
    pub fn axle_is_across(&self) -> bool {
        self.yaw == 0.0 && self.tilt == 0.0
    }
}

/// Keys of the motions of a body, in the order of [`Body::motions`].
pub const MOTIONS: [&str; 6] = ["forward", "lateral", "heave", "yaw_motion", "tilt_motion", "spin"];

impl Body {
    /// Rotation about the axle; positive when it rolls forward.
    #[must_use]
    pub fn spin(&self) -> Motion {
        self.rotation[2]
    }

    /// Its six degrees of freedom: along x, y, z; yaw, tilt, spin.
    #[must_use]
    pub fn motions(&self) -> [Motion; 6] {
        let ([x, y, z], [yaw, tilt, spin]) = (self.translation, self.rotation);
        [x, y, z, yaw, tilt, spin]
    }

    /// Diameter in which it rolls along the tow [m]; `None` for a body that cannot roll or whose axle is not level across it.
    #[must_use]
    pub fn rolling_diameter(&self) -> Option<f64> {
        self.shape.rolling_diameter().filter(|_| self.attitude.axle_is_across())
    }

    /// How it moves: its own motions, or what joints make of them.
    #[must_use]
    pub fn guided(&self) -> Guide {
        let [yaw, tilt, _] = self.rotation;
        self.guide.unwrap_or(Guide { translation: self.translation, rotation: [yaw, tilt] })
    }

    /// Whether its axle may leave the direction that it has at the start.
    #[must_use]
    pub fn steers(&self) -> bool {
        self.guided().rotation.iter().any(|motion| *motion != Motion::Fixed)
    }

    /// Its shape, rotated by its pitch, in the frame that tilt and yaw carry: axle along y.
    #[must_use]
    pub fn solid(&self) -> Box<dyn Solid> {
        let solid = self.shape.solid();
        if self.attitude.pitch == 0.0 || solid.is_revolved() {
            solid
        } else {
            Box::new(Rotated::new(solid, self.attitude.pitch))
        }
    }

    /// Low and high corner, from the reference point, of the box along x, y, z that encloses it at the start [m].
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let solid = self.solid();
        if self.attitude.axle_is_across() {
            return solid.bounds();
        }
        let frame = self.attitude.of_axle().inverse();
        let high = DVec3::AXES.map(|axis| solid.extent(frame * axis));
        let low = DVec3::AXES.map(|axis| -solid.extent(frame * -axis));
        (low.into(), high.into())
    }

    /// Edges of that box [m].
    #[must_use]
    pub fn size(&self) -> DVec3 {
        let (low, high) = self.bounds();
        high - low
    }

    /// The same for all attitudes that its yaw and tilt may take.
    #[must_use]
    pub fn reach(&self) -> (DVec3, DVec3) {
        let (low, high) = self.bounds();
        if !self.steers() {
            return (low, high);
        }
        let points = self.solid().mesh().points;
        let farthest = points.iter().map(|point| point.length()).fold(0.0, f64::max);
        let around = DVec3::splat(farthest);
        // Yaw alone changes no height.
        if self.guided().rotation[1] == Motion::Fixed {
            ((-around).with_z(low.z), around.with_z(high.z))
        } else {
            (-around, around)
        }
    }

    /// Force that presses the body into the ground once it is released [N]: its weight and the load on its heave, downwards;
    /// `None` for a body that does not heave freely.
    #[must_use]
    pub fn pressing_force(&self, gravity: f64) -> Option<f64> {
        match self.translation[2] {
            Motion::Free { load, .. } => Some(self.mass * gravity - load),
            _ => None,
        }
    }
}
