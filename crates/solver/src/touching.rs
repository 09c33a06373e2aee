//! Bodies that may touch each other.

use crate::model::{BodyModel, attitude};
use geometry::{Near, Place, Solids};
use mechanics::{Pair, Pose, Surfaces, Touch, Twist};

/// Gap, over the radius of the smaller body, up to which surfaces are watched beyond what they may close in a
/// step: a face then keeps its corners as it tips.
const WATCHED: f64 = 1e-3;

/// Two bodies that may touch.
#[derive(Debug)]
pub struct TouchingBodies {
    bodies: [usize; 2],
    solids: Solids,
    are_revolved: [bool; 2],
    surfaces: Surfaces,
}

impl TouchingBodies {
    /// Two bodies of a model, by their numbers; `None` if one of them has no surface.
    #[must_use]
    pub fn new(bodies: &[BodyModel], numbers: [usize; 2], surfaces: Surfaces) -> Option<Self> {
        let [first, second] = numbers.map(|n| bodies.get(n).map(|body| &*body.shape));
        let (first, second) = (first?, second?);
        Some(Self {
            bodies: numbers,
            solids: Solids::of([first, second])?,
            are_revolved: [first.is_revolved(), second.is_revolved()],
            surfaces,
        })
    }
}

impl Pair for TouchingBodies {
    fn bodies(&self) -> [usize; 2] {
        self.bodies
    }

    fn surfaces(&self) -> Surfaces {
        self.surfaces
    }

    fn touches(&self, poses: [&Pose; 2], twists: [&Twist; 2], dt: f64, found: &mut Vec<Touch>) {
        let [a, b] = [0, 1].map(|n| Place {
            position: poses[n].position,
            attitude: attitude(self.are_revolved[n], poses[n]),
        });
        let turning = |n: usize| self.solids.radii[n] * twists[n].angular.length();
        let speed = (twists[1].linear - twists[0].linear).length() + turning(0) + turning(1);
        let [first, second] = self.solids.radii;
        let reach = WATCHED * first.min(second) + 2.0 * dt * speed;
        let mut near = Vec::new();
        self.solids.near([&a, &b], reach, &mut near);
        found.extend(near.into_iter().map(|Near { arms, normal, gap }| Touch { arms, normal, gap }));
    }
}
