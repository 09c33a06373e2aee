//! A rigid body of a case: its shape, mass and motion in SI units, and the space that it takes.

mod check;
mod keys;
mod motion;
mod read;
mod weld;

pub(crate) use check::{MIN_CELLS_ACROSS, check, shape as check_shape};
pub(crate) use keys::KEYS;
pub(crate) use motion::{KEYS as MOTION, Rolling, check as check_motion, freedom, of_body, spin};
pub(crate) use read::{Others, body};
pub(crate) use weld::{joined, roots, sections};

use super::shapes::Shape;
use super::water::Water;
use geometry::{Compound, Placed, Rotated, Shape as Solid};
use glam::{DMat3, DQuat, DVec3};
use mechanics::Motion;
use serde::Serialize;

/// A rigid body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Body {
    /// Name of the body in the file.
    pub name: String,
    /// Shape of the body.
    pub shape: Shape,
    /// Reference point at the start [m].
    pub position: DVec3,
    /// Attitude at the start.
    pub attitude: Attitude,
    /// Mass [kg] of the whole body.
    pub mass: f64,
    /// Moment of inertia about the axle [kg m²] of the whole body.
    pub axle_inertia: f64,
    /// Coefficient of friction μ of the surface against the soil; infinite for a rough (no-slip) one.
    pub friction: f64,
    /// Adhesion factor α: the largest frictional traction over the undrained shear strength s_u, whatever the
    /// pressure; infinite for no such limit.
    pub adhesion_factor: f64,
    /// Motion along x (tow), y (lateral), z (heave).
    pub translation: [Motion; 3],
    /// Yaw about the vertical, tilt about the axis that yaw carries, and spin about the axle.
    pub rotation: [Motion; 3],
    /// Bodies that are welded to this one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Part>,
    /// How joints make the body move; `None` without a joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub guide: Option<Guide>,
    /// How the body moves in a run of several stages.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub staged: Option<Staged>,
}

/// How a body moves in a run of several stages, for estimates of its path.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Staged {
    /// Motions in the stage over which averages are taken; free where they are so in any stage.
    pub motions: [Motion; 6],
    /// Least and largest displacement along x, y and z that is prescribed [m].
    pub bounds: [[f64; 2]; 3],
    /// Whether it is known before the run how deep the body is in that stage: not where a force ends the
    /// stage that presses it.
    pub depth_is_known: bool,
}

/// A body that is welded to another: they move as one rigid body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Part {
    /// Name of the part in the file.
    pub name: String,
    /// Shape of the part.
    pub shape: Shape,
    /// Reference point of the part, from that of the body that it belongs to, in the axes of that body [m].
    pub offset: DVec3,
    /// Rotation of the part's frame to the frame of that body; the axle lies along y in the part's own frame.
    pub rotation: DQuat,
    /// Rotation of the part about its axle [rad].
    pub pitch: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia of the part about its axle [kg m²].
    pub axle_inertia: f64,
}

impl Part {
    /// Solid of the part in the part's own frame.
    #[must_use]
    pub fn solid(&self) -> Box<dyn Solid> {
        pitched(&self.shape, self.pitch)
    }

    /// Whether the axes of the part are those of the body.
    #[must_use]
    pub fn is_aligned(&self) -> bool {
        self.rotation == DQuat::IDENTITY
    }

    fn placed(&self) -> Placed {
        Placed {
            shape: self.solid().into(),
            position: self.offset,
            rotation: DMat3::from_quat(self.rotation),
        }
    }
}

/// The solid of a shape that is rotated by a pitch [rad].
pub(super) fn pitched(shape: &Shape, pitch: f64) -> Box<dyn Solid> {
    let solid = shape.solid();
    if pitch == 0.0 || solid.is_revolved() { solid } else { Box::new(Rotated::new(solid, pitch)) }
}

/// How a body moves that joints guide, for estimates of its path: what its carrier prescribes, free where the
/// joint leaves it free.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Guide {
    /// Along x, y, z.
    pub translation: [Motion; 3],
    /// Yaw and tilt.
    pub rotation: [Motion; 2],
    /// Least and largest prescribed displacement in a run of several stages [m].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bounds: Option<[[f64; 2]; 3]>,
}

impl Guide {
    /// The ground does not move.
    pub const GROUND: Self = Self {
        translation: [const { Motion::Fixed }; 3],
        rotation: [const { Motion::Fixed }; 2],
        bounds: None,
    };
}

/// Attitude of a body: it is rotated by `pitch` about its axle, y, then by `tilt` about x, then by `yaw`
/// about z. Positive angles follow the right-hand rule: pitch tips the top forwards, tilt lifts the left end
/// of the axle, yaw turns the front to the left.
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

/// Whether planes forbid a motion, by its number in [`MOTIONS`]: a plane of symmetry or of strain across y,
/// one of symmetry across x.
pub(super) fn planes_forbid(across_y: bool, across_x: bool, motion: usize) -> bool {
    across_y && [1, 3, 4].contains(&motion) || across_x && [0, 3, 5].contains(&motion)
}

impl Body {
    /// Rotation about the axle; positive when it rolls forward.
    #[must_use]
    pub fn spin(&self) -> &Motion {
        self.staged.as_ref().map_or(&self.rotation[2], |staged| &staged.motions[5])
    }

    /// The six degrees of freedom of the body at the start: along x, y, z; yaw, tilt, spin.
    #[must_use]
    pub fn motions(&self) -> [Motion; 6] {
        let ([x, y, z], [yaw, tilt, spin]) = (self.translation.clone(), self.rotation.clone());
        [x, y, z, yaw, tilt, spin]
    }

    /// The shape that results of the body refer to: its own, or that of the first part with a surface.
    #[must_use]
    pub fn main_shape(&self) -> &Shape {
        let parts = self.parts.iter().map(|part| &part.shape);
        std::iter::once(&self.shape).chain(parts).find(|shape| shape.has_surface()).unwrap_or(&self.shape)
    }

    /// Whether the body has a surface that the soil can touch.
    #[must_use]
    pub fn has_surface(&self) -> bool {
        self.main_shape().has_surface()
    }

    /// Least length that the shape is given along its own y [m], such as the thickness of a dished disc;
    /// infinite without one, or where it has several parts.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        let sizes = if self.parts.is_empty() { self.shape.sizes() } else { Vec::new() };
        sizes.iter().filter(|size| size.axis == Some(1)).map(|size| size.length).fold(f64::INFINITY, f64::min)
    }

    /// Diameter on which the body rolls about its axle [m]; `None` for a body that cannot roll.
    #[must_use]
    pub fn wheel_diameter(&self) -> Option<f64> {
        let on_the_axle = |part: &&Part| part.is_aligned() && part.offset.x == 0.0 && part.offset.z == 0.0;
        let parts = self.parts.iter().filter(on_the_axle).map(|part| &part.shape);
        std::iter::once(&self.shape)
            .chain(parts)
            .find(|shape| shape.has_surface())
            .and_then(|shape| shape.rolling_diameter())
    }

    /// Diameter on which the body rolls along the tow [m]; `None` for a body that cannot roll or whose axle
    /// is not level across it.
    #[must_use]
    pub fn rolling_diameter(&self) -> Option<f64> {
        self.wheel_diameter().filter(|_| self.attitude.axle_is_across())
    }

    /// How the body moves: its own motions, or what joints make of them.
    #[must_use]
    pub fn guided(&self) -> Guide {
        self.guide.clone().unwrap_or_else(|| self.own_guide())
    }

    /// How the body moves without its joints.
    #[must_use]
    pub fn own_guide(&self) -> Guide {
        let bounds = self.staged.as_ref().map(|staged| staged.bounds);
        let motions = self.staged.as_ref().map_or_else(|| self.motions(), |staged| staged.motions.clone());
        let [x, y, z, yaw, tilt, _] = motions;
        Guide { translation: [x, y, z], rotation: [yaw, tilt], bounds }
    }

    /// Whether nothing moves the body in the whole run.
    #[must_use]
    pub fn is_still(&self) -> bool {
        let Guide { translation, rotation, .. } = self.guided();
        let mut motions = translation.iter().chain(&rotation).chain([self.spin()]);
        self.staged.is_none() && motions.all(|motion| !motion.may_move())
    }

    /// Whether the axle of the body may leave the direction that it has at the start.
    #[must_use]
    pub fn steers(&self) -> bool {
        self.guided().rotation.iter().any(|motion| *motion != Motion::Fixed)
    }

    /// Shape of the body, rotated by its pitch, in the frame that tilt and yaw carry: axle along y.
    #[must_use]
    pub fn solid(&self) -> Box<dyn Solid> {
        let own = self.own_solid();
        if self.parts.is_empty() {
            return own;
        }
        let own = Placed { shape: own.into(), position: DVec3::ZERO, rotation: DMat3::IDENTITY };
        Box::new(Compound::new(std::iter::once(own).chain(self.parts.iter().map(Part::placed)).collect()))
    }

    /// Shape of the body without what is welded to it, rotated by its pitch.
    #[must_use]
    pub fn own_solid(&self) -> Box<dyn Solid> {
        pitched(&self.shape, self.attitude.pitch)
    }

    /// The body and its parts as bodies of their own, those with a surface.
    #[must_use]
    pub fn surfaces(&self) -> Vec<Self> {
        let own = Self { parts: Vec::new(), ..self.clone() };
        let frame = self.attitude.of_axle();
        let part = |part: &Part| {
            let axle = frame * part.rotation * DVec3::Y;
            Self {
                name: part.name.clone(),
                shape: part.shape.clone(),
                position: self.position + frame * part.offset,
                attitude: Attitude {
                    yaw: (-axle.x).atan2(axle.y) + 0.0,
                    tilt: axle.z.clamp(-1.0, 1.0).asin(),
                    pitch: part.pitch,
                },
                ..own.clone()
            }
        };
        let parts = self.parts.iter().map(part);
        std::iter::once(own.clone()).chain(parts).filter(|body| body.shape.has_surface()).collect()
    }

    /// Points of the surface of each of its solids, its own and those of its parts, in the body frame [m].
    #[must_use]
    pub fn outlines(&self) -> Vec<Vec<DVec3>> {
        let part = |part: &Part| {
            let points = part.solid().mesh().points;
            points.into_iter().map(|point| part.offset + part.rotation * point).collect()
        };
        let all = std::iter::once(self.own_solid().mesh().points).chain(self.parts.iter().map(part));
        all.filter(|points: &Vec<DVec3>| !points.is_empty()).collect()
    }

    /// Whether a joint or a weld connects it with others, or with the ground.
    #[must_use]
    pub fn is_connected(&self) -> bool {
        self.guide.is_some() || !self.parts.is_empty()
    }

    /// Mass of the body with all its parts [kg].
    #[must_use]
    pub fn whole_mass(&self) -> f64 {
        self.parts.iter().map(|part| part.mass).fold(self.mass, |sum, mass| sum + mass)
    }

    /// Mass of the water that the body displaces with its parts [kg], and the centre of its volume from the
    /// reference point [m].
    #[must_use]
    pub(crate) fn displaced(&self, water: &Water, plane_strain: bool) -> (f64, DVec3) {
        let parts = self.parts.iter().map(|part| {
            let (mass, centre) = water.displaced_by(part.solid().as_ref(), plane_strain);
            (mass, part.offset + part.rotation * centre)
        });
        let own = std::iter::once(water.displaced_by(self.own_solid().as_ref(), plane_strain));
        let (mass, moment) = own
            .chain(parts)
            .fold((0.0, DVec3::ZERO), |(sum, moment), (mass, centre)| (sum + mass, moment + mass * centre));
        (mass, if mass > 0.0 { moment / mass } else { DVec3::ZERO })
    }

    /// Low and high corner, from the reference point, of the box along x, y, z that encloses it at the start
    /// [m].
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

    /// Low and high corner of the body for all attitudes that its yaw and tilt may take.
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

    /// Force that presses the body into the ground once it is released [N]: its weight normal to the surface
    /// (less buoyancy) and the load on its heave, downwards; `None` for a body that does not heave freely.
    #[must_use]
    pub fn pressing_force(&self, weight: f64) -> Option<f64> {
        match self.own_guide().translation[2] {
            Motion::Free { load, .. } => Some(weight - load),
            _ => None,
        }
    }
}
