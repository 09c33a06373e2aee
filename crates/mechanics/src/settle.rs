//! The impulses of all touches in a step: impacts, and then what keeps bodies apart.

use crate::mechanism::{Mechanism, MechanismState};
use crate::step::Step;
use crate::touching::MovingTouch;
use crate::wrench::Wrench;
use glam::DVec2;

/// Most rounds of sweeps through touches and joints.
const ROUNDS: usize = 400;
/// Change of the impulses in a round, relative to them, below which they have been found.
const SETTLED: f64 = 1e-12;
/// Most impacts in a step, for each pair: of some closed loops of elastic bodies there is no end.
const IMPACTS: usize = 64;
/// Velocity of approach below which there is no rebound, over that which gravity gives in a step; chosen:
/// bodies at rest on each other approach by 1/2.
const RESTING: f64 = 4.0;

/// Square of the length of a list of impulses.
fn square(impulses: &[[f64; 3]]) -> f64 {
    impulses.as_flattened().iter().map(|part| part * part).sum()
}

impl Step {
    /// Finds where the bodies touch or may touch in this step.
    pub(crate) fn find_touches(&mut self, mechanism: &Mechanism, state: &MechanismState) {
        let (mut found, dt) = (Vec::new(), self.conditions.dt);
        self.touches.clear();
        for (number, pair) in mechanism.pairs().iter().enumerate() {
            let poses = pair.bodies().map(|n| &state.bodies[n].pose);
            let twists = pair.bodies().map(|n| &self.bodies[n].twist);
            found.clear();
            pair.touches(poses, twists, dt, &mut found);
            let own = found.iter();
            self.touches
                .extend(own.map(|touch| MovingTouch::new(number, pair.as_ref(), touch, &self.bodies, dt)));
        }
    }

    /// Impacts, one pair after the other, that which approaches fastest first, until none approaches: so a
    /// row of equal balls passes an impact on to its end (Newton's restitution, pair by pair).
    pub(crate) fn collide(&mut self) {
        let resting = RESTING * self.conditions.dt * self.conditions.gravity.length();
        let most = IMPACTS * self.touches.iter().map(|touch| touch.pair + 1).max().unwrap_or(0);
        for _ in 0..most {
            let closing = |touch: &&MovingTouch| {
                let velocity = touch.velocity(0, &self.bodies);
                let is_fast = -velocity > resting && velocity < touch.least;
                is_fast && touch.surfaces.restitution > 0.0 && touch.masses[0] > 0.0
            };
            let by_velocity = |a: &&MovingTouch, b: &&MovingTouch| {
                a.velocity(0, &self.bodies).total_cmp(&b.velocity(0, &self.bodies))
            };
            let Some(fastest) = self.touches.iter().filter(closing).min_by(by_velocity) else { break };
            let pair = fastest.pair;
            self.rebound(pair);
        }
        for touch in &mut self.touches {
            if touch.impulse[0] > 0.0 {
                let left = -touch.gap / self.conditions.dt;
                touch.least = touch.velocity(0, &self.bodies).max(left.min(touch.least));
            }
        }
    }

    /// The impact of one pair, in all its touches at once, with what joints answer.
    fn rebound(&mut self, pair: usize) {
        for touch in self.touches.iter_mut().filter(|touch| touch.pair == pair) {
            let velocity = touch.velocity(0, &self.bodies);
            let least = -touch.gap / self.conditions.dt;
            touch.least = least.max(-touch.surfaces.restitution * velocity);
        }
        self.settle_touches(|touch| touch.pair == pair);
    }

    /// Finds the impulses where bodies touch, and of joints, for the twists that contact with the soil has
    /// left.
    pub fn settle(&mut self) {
        if self.touches.is_empty() {
            self.relax_joints();
        } else {
            self.settle_touches(|_| true);
        }
    }

    /// Symmetric projected Gauss–Seidel sweeps, each followed by a step along a conjugate direction
    /// (Silcowitz, Niebe & Erleben 2010). Without that a stack of five creeps by 9 µm/s after 400 rounds.
    fn settle_touches(&mut self, is_asked: impl Fn(&MovingTouch) -> bool) {
        let Self { touches, .. } = &*self;
        let asked: Vec<usize> = (0..touches.len()).filter(|n| is_asked(&touches[*n])).collect();
        let impulses = |step: &Self| asked.iter().map(|n| step.touches[*n].impulse).collect::<Vec<_>>();
        let mut direction = vec![[0.0; 3]; asked.len()];
        let mut last = f64::INFINITY;
        for _ in 0..ROUNDS {
            let before = impulses(self);
            for n in asked.iter().chain(asked.iter().rev()) {
                self.touches[*n].relax(&mut self.bodies);
            }
            self.relax_joints();
            let after = impulses(self);
            let descent: Vec<[f64; 3]> =
                after.iter().zip(&before).map(|(a, b)| std::array::from_fn(|k| a[k] - b[k])).collect();
            let size = square(&descent);
            if size <= SETTLED * SETTLED * square(&after) {
                break;
            }
            let share = size / last;
            last = size;
            if share > 1.0 {
                direction.fill([0.0; 3]);
                continue;
            }
            for (own, descent) in direction.iter_mut().zip(&descent) {
                *own = std::array::from_fn(|k| share * own[k] + descent[k]);
            }
            for ((n, own), descent) in asked.iter().zip(&direction).zip(&descent) {
                let touch = &mut self.touches[*n];
                // The descent is in the impulses already.
                let [normal, u, v] = std::array::from_fn(|k| touch.impulse[k] + own[k] - descent[k]);
                touch.exert(normal, DVec2::new(u, v), &mut self.bodies);
            }
        }
    }

    /// Hands the impulses of the touches to the bodies.
    pub(crate) fn take_touches(&mut self) {
        for body in &mut self.bodies {
            body.impulses.touch = Wrench::ZERO;
        }
        for touch in &self.touches {
            for (n, number) in touch.bodies.into_iter().enumerate() {
                self.bodies[number].impulses.touch += touch.wrench(n, &touch.impulse);
            }
        }
    }

    /// Impulse of a pair on its second body, about the reference point.
    pub(crate) fn of_pair(&self, pair: usize) -> Wrench {
        let own = self.touches.iter().filter(|touch| touch.pair == pair);
        own.fold(Wrench::ZERO, |sum, touch| sum + touch.wrench(1, &touch.impulse))
    }
}
