//! An interpolant of the exact coefficient, for millions of evaluations.

use super::{Face, PassiveField, sokolovskii};
use crate::error::{ModelResult, undefined, within};
use std::f64::consts::PI;

/// Range of faces covered by a [`PressureTable`], with a single backfill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableRange {
    /// Smallest and largest friction angle [rad].
    pub friction_angle: (f64, f64),
    /// Smallest and largest wall friction angle relative to the friction angle.
    pub wall_friction_ratio: (f64, f64),
    /// Smallest and largest face inclination [rad].
    pub surface: (f64, f64),
    /// Slope of the ground [rad].
    pub backfill: f64,
}

const NODES: (usize, usize, usize) = (9, 7, 9);

/// Chebyshev interpolant of ln K_n and ln(r_f/L) over (φ, δ/φ, α); relative error below 1e-4 for 25° ≤ φ ≤
/// 45°,
/// |δ| ≤ ½φ.
#[derive(Clone, Debug)]
pub struct PressureTable {
    range: TableRange,
    nodes: [usize; 3],
    values: Vec<[f64; 2]>,
}

impl PressureTable {
    /// Solves the field at every node of the range; half a second for the largest range.
    ///
    /// # Errors
    /// If the field does not exist at some node: choose a smaller range (δ < 0 needs faces that are not too
    /// steep).
    pub fn new(range: TableRange) -> ModelResult<Self> {
        let count = |(low, high): (f64, f64), n: usize| if high > low { n } else { 1 };
        let nodes = [
            count(range.friction_angle, NODES.0),
            count(range.wall_friction_ratio, NODES.1),
            count(range.surface, NODES.2),
        ];
        let mut values = Vec::with_capacity(nodes.iter().product());
        for i in 0..nodes[0] {
            let friction_angle = node(range.friction_angle, nodes[0], i);
            for j in 0..nodes[1] {
                let wall_friction = friction_angle * node(range.wall_friction_ratio, nodes[1], j);
                for l in 0..nodes[2] {
                    let surface = node(range.surface, nodes[2], l);
                    let field = sokolovskii(&Face {
                        friction_angle,
                        wall_friction,
                        surface,
                        backfill: range.backfill,
                    })?;
                    values.push([field.coefficient.ln(), field.rupture_ratio.ln()]);
                }
            }
        }
        Ok(Self { range, nodes, values })
    }

    /// The interpolated field of `face`.
    ///
    /// # Errors
    /// If the face lies outside the range of the table.
    pub fn field(&self, face: &Face) -> ModelResult<PassiveField> {
        let range = &self.range;
        let phi = within(
            "friction angle [rad]",
            face.friction_angle,
            range.friction_angle.0,
            range.friction_angle.1,
        )?;
        let bounds = range.wall_friction_ratio;
        let ratio = within("wall friction ratio", face.wall_friction / phi, bounds.0, bounds.1)?;
        let alpha = within("surface inclination [rad]", face.surface, range.surface.0, range.surface.1)?;
        if (face.backfill - range.backfill).abs() > 1e-12 {
            return undefined("the tabulated coefficient", "the table is for another backfill");
        }
        let weights = [
            weights(range.friction_angle, self.nodes[0], phi),
            weights(range.wall_friction_ratio, self.nodes[1], ratio),
            weights(range.surface, self.nodes[2], alpha),
        ];
        let [coefficient, rupture] = self.combine(&weights);
        Ok(PassiveField { coefficient: coefficient.exp(), rupture_ratio: rupture.exp() })
    }

    fn combine(&self, weights: &[[f64; 9]; 3]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        let mut values = self.values.iter();
        for first in &weights[0][..self.nodes[0]] {
            for second in &weights[1][..self.nodes[1]] {
                for (third, value) in weights[2][..self.nodes[2]].iter().zip(&mut values) {
                    let weight = first * second * third;
                    sum[0] += weight * value[0];
                    sum[1] += weight * value[1];
                }
            }
        }
        sum
    }
}

/// Chebyshev–Lobatto node `i` of `count` on an interval.
fn node((low, high): (f64, f64), count: usize, i: usize) -> f64 {
    if count == 1 {
        return low;
    }
    0.5 * (low + high) - 0.5 * (high - low) * (PI * i as f64 / (count - 1) as f64).cos()
}

/// Barycentric weights of the nodes at `x` (Berrut & Trefethen 2004, SIAM Review 46, eq. 5.4), summing to 1.
fn weights(range: (f64, f64), count: usize, x: f64) -> [f64; 9] {
    let mut weights = [0.0; 9];
    let mut total = 0.0;
    for i in 0..count {
        let distance = x - node(range, count, i);
        if distance.abs() < 1e-13 || count == 1 {
            weights = [0.0; 9];
            weights[i] = 1.0;
            return weights;
        }
        let end = if i == 0 || i == count - 1 { 0.5 } else { 1.0 };
        weights[i] = if i % 2 == 0 { end / distance } else { -end / distance };
        total += weights[i];
    }
    weights.map(|w| w / total)
}
