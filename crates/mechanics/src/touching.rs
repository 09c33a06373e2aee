//! A touch during one step: non-penetration and Coulomb friction at the velocity level (Moreau 1988, Jean
//! 1999), as of soil and bodies.

use crate::joint::CLOSURE;
use crate::moving::MovingBody;
use crate::touch::{Pair, Surfaces, Touch};
use crate::wrench::Wrench;
use glam::DVec2;

/// A touch during one step. The first row is along the normal, the others along two tangents.
#[derive(Clone, Debug)]
pub(crate) struct MovingTouch {
    /// Number of the pair.
    pub(crate) pair: usize,
    pub(crate) bodies: [usize; 2],
    /// Wrench on each body per unit impulse.
    rows: [[Wrench; 2]; 3],
    /// Effective masses along the normal and along the tangents [kg]; 0 where nothing can move.
    pub(crate) masses: [f64; 2],
    pub(crate) surfaces: Surfaces,
    pub(crate) gap: f64,
    /// Least velocity of separation [m/s].
    pub(crate) least: f64,
    pub(crate) impulse: [f64; 3],
}

impl MovingTouch {
    pub(crate) fn new(number: usize, pair: &dyn Pair, touch: &Touch, bodies: &[MovingBody], dt: f64) -> Self {
        let (u, v) = touch.normal.any_orthonormal_pair();
        let rows = [touch.normal, u, v]
            .map(|along| [Wrench::at(touch.arms[0], -along), Wrench::at(touch.arms[1], along)]);
        let numbers = pair.bodies();
        let yields = rows.map(|row| {
            let response = |n: usize| row[n].dot(&bodies[numbers[n]].mobility.response(&row[n]));
            response(0) + response(1)
        });
        let mass = |yields: f64| if yields > 0.0 { 1.0 / yields } else { 0.0 };
        // What overlaps comes apart gently.
        let least = if touch.gap < 0.0 { -CLOSURE * touch.gap / dt } else { -touch.gap / dt };
        Self {
            pair: number,
            bodies: numbers,
            rows,
            masses: [mass(yields[0]), mass(yields[1].max(yields[2]))],
            surfaces: pair.surfaces(),
            gap: touch.gap,
            least,
            impulse: [0.0; 3],
        }
    }

    /// Relative velocity along a row [m/s].
    pub(crate) fn velocity(&self, row: usize, bodies: &[MovingBody]) -> f64 {
        let of = |n: usize| self.rows[row][n].dot(&bodies[self.bodies[n]].twist);
        of(0) + of(1)
    }

    /// Changes the twists of both bodies by the impulse that it needs, were it alone.
    pub(crate) fn relax(&mut self, bodies: &mut [MovingBody]) {
        let [normal_mass, tangential_mass] = self.masses;
        let [normal, u, v] = self.impulse;
        if normal_mass > 0.0 {
            let normal = normal + normal_mass * (self.least - self.velocity(0, bodies));
            let sliding = DVec2::new(self.velocity(1, bodies), self.velocity(2, bodies));
            self.exert(normal, DVec2::new(u, v) - tangential_mass * sliding, bodies);
        }
    }

    /// Exerts the nearest impulse that surfaces can exert on each other: they do not pull, and rub by
    /// Coulomb's law.
    pub(crate) fn exert(&mut self, normal: f64, friction: DVec2, bodies: &mut [MovingBody]) {
        let normal = normal.max(0.0);
        let friction = friction.clamp_length_max(self.surfaces.friction.min(1e6) * normal);
        let new = [normal, friction.x, friction.y];
        let change = std::array::from_fn(|k| new[k] - self.impulse[k]);
        self.impulse = new;
        for (n, number) in self.bodies.into_iter().enumerate() {
            let body = &mut bodies[number];
            body.twist += body.mobility.response(&self.wrench(n, &change));
        }
    }

    /// Wrench of an impulse on one of the bodies.
    pub(crate) fn wrench(&self, side: usize, impulse: &[f64; 3]) -> Wrench {
        let each = self.rows.iter().zip(impulse);
        each.fold(Wrench::ZERO, |sum, (row, impulse)| sum + *impulse * row[side])
    }
}
