//! Effective masses of the constraints, and the impulses that follow from them.

use super::constraint::Constraint;
use super::problem::{ContactJacobian, ContactProblem, over_corners};
use glam::DVec3;

/// Effective masses and limits of a constraint, constant during the sweeps of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct EffectiveMass {
    /// Normal effective mass: inverse of the diagonal of the Delassus operator along the normal [kg].
    normal_mass: f64,
    /// Tangential effective mass: the same along the axis in which it is least [kg].
    tangential_mass: f64,
    /// Coefficient of friction; infinite for a rough body.
    friction: f64,
    /// Largest frictional impulse in a step [N s].
    shear_limit: f64,
}

impl EffectiveMass {
    /// The effective mass of a constraint with this point among its active ones. `None` where neither soil
    /// nor body can move along the normal: there is nothing to solve for.
    pub(super) fn new(problem: &ContactProblem, constraint: &Constraint, point: usize) -> Option<Self> {
        let (jacobian, normal) = (&constraint.jacobian, constraint.jacobian.normal);
        let delassus_diagonal = delassus_diagonal(problem, jacobian);
        let soil = |n: usize| {
            let impulse = jacobian.on_node(n, normal);
            (impulse * impulse).dot(problem.inverse_mass[jacobian.nodes[n] as usize])
        };
        let normal_mass = over_corners(std::array::from_fn(soil))
            + delassus_of_body(problem, jacobian).dot(normal * normal);
        (normal_mass > 0.0).then(|| Self {
            normal_mass: 1.0 / normal_mass,
            tangential_mass: 1.0 / delassus_diagonal.max_element(),
            friction: problem.model.bodies[constraint.jacobian.body].friction,
            // All points of a constraint lie in one cell.
            shear_limit: problem.contacts[point].shear_limit * constraint.area * problem.dt,
        })
    }

    /// The impulse on a constraint with this normal and impulse after one relaxation from this relative
    /// velocity, projected on the Coulomb cone.
    #[inline(always)]
    pub(super) fn projected_impulse(
        &self,
        relative: DVec3,
        (along, impulse): (DVec3, DVec3),
        relaxation: f64,
    ) -> DVec3 {
        let closing = relative.dot(along);
        let old_normal = impulse.dot(along);
        let new_normal = (old_normal + relaxation * closing * self.normal_mass).max(0.0);
        // Several constraints share the pressure on a face as they like: where friction does not depend on
        // it, those without pressure bear their share of friction all the same.
        let sticks = self.friction.is_infinite() && self.shear_limit.is_finite();
        if !sticks && new_normal == 0.0 && old_normal == 0.0 {
            return DVec3::ZERO;
        }
        let old_friction = impulse - old_normal * along;
        let sliding = relative - closing * along;
        let of_pressure = if sticks { f64::INFINITY } else { self.friction.min(1e6) * new_normal };
        let limit = of_pressure.min(self.shear_limit);
        let friction = (old_friction + relaxation * sliding * self.tangential_mass).clamp_length_max(limit);
        new_normal * along + friction
    }
}

/// Coupling of two constraints: velocity that an impulse at one causes at the other, over that at its own; 0
/// to 1.
pub(super) fn coupling(
    problem: &ContactProblem,
    a: &Constraint,
    mass_a: &EffectiveMass,
    b: &Constraint,
    mass_b: &EffectiveMass,
) -> f64 {
    let shared = |n: usize| {
        let node = a.jacobian.nodes[n];
        let other = b.jacobian.nodes.iter().position(|m| *m == node);
        other.map_or(0.0, |m| {
            let both = a.jacobian.on_node(n, a.jacobian.normal) * b.jacobian.on_node(m, b.jacobian.normal);
            both.abs().dot(problem.inverse_mass[node as usize])
        })
    };
    let through_soil = over_corners(std::array::from_fn(shared));
    let through_body =
        0.5 * (delassus_of_body(problem, &a.jacobian) + delassus_of_body(problem, &b.jacobian));
    let size = through_soil + through_body.dot((a.jacobian.normal * b.jacobian.normal).abs());
    (size * mass_a.normal_mass.max(mass_b.normal_mass)).clamp(0.0, 1.0)
}

/// Diagonal of the Delassus operator: velocity per impulse along x, y, z, of soil and body together [1/kg].
fn delassus_diagonal(problem: &ContactProblem, jacobian: &ContactJacobian) -> DVec3 {
    let soil =
        |n: usize| jacobian.weight[n] * jacobian.weight[n] * problem.inverse_mass[jacobian.nodes[n] as usize];
    over_corners(std::array::from_fn(soil)) + delassus_of_body(problem, jacobian)
}

/// Contribution of the body to the diagonal of the Delassus operator [1/kg].
fn delassus_of_body(problem: &ContactProblem, jacobian: &ContactJacobian) -> DVec3 {
    problem.moving.inverse_mass_diagonal(jacobian.body, jacobian.arm)
}
