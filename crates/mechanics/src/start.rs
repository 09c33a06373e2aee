//! The state of a mechanism at the start.

use crate::mechanism::{JointState, Mechanism, MechanismState};
use crate::pose::Pose;
use crate::step::{Conditions, Step};
use crate::twist::Twist;

impl Mechanism {
    /// The state with the bodies at given poses and velocities, in their order; bodies that are not given
    /// rest at the origin.
    ///
    /// What fixed motions forbid is left out of the velocities; where they violate joints, these change them
    /// as in an inelastic impact. The poses must satisfy the joints.
    #[must_use]
    pub fn state(&self, start: &[(Pose, Twist)]) -> MechanismState {
        let given = |n: usize| start.get(n).copied().unwrap_or_default();
        let each = self.bodies().iter().enumerate();
        let mut state = MechanismState {
            bodies: each.map(|(n, body)| body.state(given(n).0, given(n).1)).collect(),
            joints: vec![JointState::default(); self.joints().len() + self.pairs().len()],
        };
        if !self.joints().is_empty() {
            let mut step = Step::default();
            self.begin(&state, &Conditions { dt: 1.0, ..Conditions::default() }, &mut step);
            self.join(&state, &mut step);
            for (now, moving) in state.bodies.iter_mut().zip(&step.bodies) {
                now.twist += moving.kick;
                now.momentum = moving.struck;
            }
        }
        state
    }
}
