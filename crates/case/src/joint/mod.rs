//! A joint of a case, in SI units.

mod check;
mod keys;
mod read;

pub(crate) use check::joints as check;
pub(crate) use keys::KEYS;
pub(crate) use read::{between_wholes, carried, guide_all, typed};

use super::body::Body;
use glam::DVec3;
use mechanics::joint::{self, Ball, Hinge, Slider, Spring};
use mechanics::{Pose, Surfaces};
use serde::Serialize;
use solver::model::BodyModel;
use solver::touching::TouchingBodies;
use std::sync::Arc;

/// What joints call the ground.
pub const GROUND: &str = "ground";

/// A joint between two bodies, or between the ground and a body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Joint {
    /// Name of the joint in the file.
    pub name: String,
    /// The first body, by number; `None` for the ground.
    pub first: Option<usize>,
    /// The second body, by number.
    pub second: usize,
    /// Where the joint is at the start; of a spring its end at the second body [m].
    pub position: DVec3,
    /// What motion the joint allows.
    pub kind: JointKind,
}

/// What a joint allows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum JointKind {
    /// Rotation about an axis.
    Hinge {
        /// Direction of the axis at the start.
        axis: DVec3,
        /// Torque of friction in the bearing [N m].
        friction_torque: f64,
        /// Torque of a drive on the second body about the axis [N m].
        drive_torque: f64,
    },
    /// Rotation about a point.
    Ball,
    /// Translation along an axis.
    Slider {
        /// Direction of the axis at the start.
        axis: DVec3,
    },
    /// Any motion, against a spring with a damper.
    Spring {
        /// End of the spring at the first body, at the start [m].
        from: DVec3,
        /// Force per extension [N/m].
        stiffness: f64,
        /// Force per rate of extension [N s/m].
        damping: f64,
        /// Length without force [m].
        length: f64,
        /// Whether the spring only pulls: a cable.
        is_cable: bool,
    },
    /// Any motion, but not into each other: contact of two bodies.
    Contact {
        /// Coefficient of friction.
        friction: f64,
        /// Coefficient of restitution.
        restitution: f64,
    },
}

impl JointKind {
    /// Whether the first body carries the second: its motion then follows from that of the first.
    #[must_use]
    pub fn carries(&self) -> bool {
        !matches!(self, Self::Spring { .. } | Self::Contact { .. })
    }

    /// Word of the joint in a case file.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Hinge { .. } => "hinge",
            Self::Ball => "ball",
            Self::Slider { .. } => "slider",
            Self::Spring { is_cable: true, .. } => "cable",
            Self::Spring { .. } => "spring",
            Self::Contact { .. } => "contact",
        }
    }
}

impl Joint {
    /// Path of the joint's section.
    pub(crate) fn path(&self) -> String {
        format!("joint.{}", self.name)
    }

    /// Whether it is contact of two surfaces; such joints come after all others.
    #[must_use]
    pub fn is_contact(&self) -> bool {
        matches!(self.kind, JointKind::Contact { .. })
    }

    /// The bodies that may touch and their surfaces, if the joint is contact.
    #[must_use]
    pub fn touching(&self, bodies: &[BodyModel]) -> Option<TouchingBodies> {
        let JointKind::Contact { friction, restitution } = self.kind else { return None };
        TouchingBodies::new(bodies, [self.first?, self.second], Surfaces { friction, restitution })
    }

    /// The joint of a mechanism of these bodies; `None` where it is contact.
    #[must_use]
    pub fn mechanical(&self, bodies: &[Body]) -> Option<Arc<dyn joint::Joint>> {
        let pose = |body: Option<usize>| {
            body.and_then(|n| bodies.get(n)).map_or(Pose::IDENTITY, |body| Pose {
                position: body.position,
                rotation: body.attitude.of_axle(),
            })
        };
        let (first, second) = (pose(self.first), pose(Some(self.second)));
        let (ends, poses) = ([self.first, Some(self.second)], [&first, &second]);
        Some(match self.kind {
            JointKind::Contact { .. } => return None,
            JointKind::Hinge { axis, friction_torque, drive_torque } => Arc::new(
                Hinge::at(self.position, axis, ends, poses)
                    .with_friction(friction_torque)
                    .with_drive(drive_torque),
            ),
            JointKind::Ball => Arc::new(Ball::at(self.position, ends, poses)),
            JointKind::Slider { axis } => Arc::new(Slider::at(self.position, axis, ends, poses)),
            JointKind::Spring { from, stiffness, damping, length, is_cable } => Arc::new(Spring {
                damping,
                length,
                is_cable,
                ..Spring::between([from, self.position], ends, poses, stiffness)
            }),
        })
    }
}
