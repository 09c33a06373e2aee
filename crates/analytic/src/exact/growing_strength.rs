//! The smooth strip footing on undrained soil whose strength grows with depth, by the method of
//! characteristics.
//!
//! Along the α lines, at ψ − π/4 to the x axis, dp = 2 s dψ − k dx, along the β lines, at ψ + π/4, dp = −2 s
//! dψ + k dx: ψ is the angle of the major principal stress to x, p the mean stress in the plane, s = s_u0 + k
//! z (Davis & Booker 1973, who solved these equations so). The free surface is the passive zone with ψ = 0
//! and p = s, the edge of the footing a fan up to ψ = π/2, and below the footing ψ = π/2 and q = p + s_u0.

use crate::error::{ModelError, ModelResult, within};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A point of the net; lengths in widths of the footing, stresses over s_u0.
#[derive(Clone, Copy)]
struct Node {
    x: f64,
    z: f64,
    mean: f64,
    angle: f64,
}

/// α lines in the passive zone, and β lines in the fan. With half of either the factors differ by less than
/// 1e-4 up to k B/s_u0 = 8.
const LINES: [usize; 2] = [200, 60];
/// Corrections of a node with the means along its two lines.
const CORRECTIONS: usize = 6;

/// Mean pressure under a smooth strip of width B over the strength at the surface s_u0, from k B/s_u0: 2 + π
/// for k = 0.
///
/// Source: Davis & Booker (1973), Géotechnique 23, 551–563 (their equations, solved here; the figures of the
/// paper were not read).
///
/// # Errors
/// If the ratio is negative or above 8, where the net is too coarse.
pub fn strip_on_growing_strength(ratio: f64) -> ModelResult<f64> {
    /// Reach of the passive zone [widths]: beyond half a width under the footing for every ratio.
    const REACH: f64 = 0.7;
    let growth = within("k B/s_u0", ratio, 0.0, 8.0)?;
    let [lines, rays] = LINES;
    let turned = |ray: usize| FRAC_PI_2 * ray as f64 / rays as f64;
    let edge = |ray: usize| Node { x: 0.0, z: 0.0, mean: 1.0 + 2.0 * turned(ray), angle: turned(ray) };
    let mut before: Vec<Node> = (0..=rays).map(edge).collect();
    let mut from_base: Vec<Node> = Vec::new();
    // Position from the edge inwards, and pressure there.
    let mut last = (0.0, 2.0 + PI);
    let mut load = 0.0;
    for line in 1..=lines {
        let depth = REACH * line as f64 / lines as f64;
        let mut own = vec![Node { x: depth, z: depth, mean: 1.0 + growth * depth, angle: 0.0 }];
        for ray in &before[1..] {
            own.push(crossing(own[own.len() - 1], *ray, growth));
        }
        let mut node = own[own.len() - 1];
        for ray in &mut from_base {
            node = crossing(node, *ray, growth);
            *ray = node;
        }
        let base = at_base(node, growth);
        from_base.push(base);
        let next = (-base.x, base.mean + 1.0);
        if next.0 >= 0.5 {
            let slope = (next.1 - last.1) / (next.0 - last.0);
            let width = 0.5 - last.0;
            return Ok(2.0 * (load + width * (last.1 + 0.5 * slope * width)));
        }
        load += 0.5 * (last.1 + next.1) * (next.0 - last.0);
        (last, before) = (next, own);
    }
    let why = "the characteristics end before the middle of the footing".to_owned();
    Err(ModelError::DoesNotExist { what: "bearing capacity", why })
}

/// Strength at a depth over that at the surface, halfway between two nodes.
fn strength(a: f64, b: f64, growth: f64) -> f64 {
    1.0 + 0.5 * growth * (a + b)
}

/// Where the α line through one node crosses the β line through another.
fn crossing(alpha: Node, beta: Node, growth: f64) -> Node {
    let mut node = Node {
        x: 0.5 * (alpha.x + beta.x),
        z: 0.5 * (alpha.z + beta.z),
        mean: 0.5 * (alpha.mean + beta.mean),
        angle: 0.5 * (alpha.angle + beta.angle),
    };
    for _ in 0..CORRECTIONS {
        let (sin_a, cos_a) = (0.5 * (alpha.angle + node.angle) - FRAC_PI_4).sin_cos();
        let (sin_b, cos_b) = (0.5 * (beta.angle + node.angle) + FRAC_PI_4).sin_cos();
        let along_a = sin_a * alpha.x - cos_a * alpha.z;
        let along_b = sin_b * beta.x - cos_b * beta.z;
        let determinant = cos_a * sin_b - sin_a * cos_b;
        node.x = (cos_a * along_b - cos_b * along_a) / determinant;
        node.z = (sin_a * along_b - sin_b * along_a) / determinant;
        let (of_a, of_b) = (strength(alpha.z, node.z, growth), strength(beta.z, node.z, growth));
        let moved = growth * (2.0 * node.x - alpha.x - beta.x);
        node.angle = (beta.mean - alpha.mean + 2.0 * (of_a * alpha.angle + of_b * beta.angle) + moved)
            / (2.0 * (of_a + of_b));
        node.mean = alpha.mean + 2.0 * of_a * (node.angle - alpha.angle) - growth * (node.x - alpha.x);
    }
    node
}

/// Where the α line through a node reaches the smooth base.
fn at_base(node: Node, growth: f64) -> Node {
    let slope = (0.5 * (node.angle + FRAC_PI_2) - FRAC_PI_4).tan();
    let x = node.x - node.z / slope;
    let turned = 2.0 * strength(node.z, 0.0, growth) * (FRAC_PI_2 - node.angle);
    Node { x, z: 0.0, mean: node.mean + turned - growth * (x - node.x), angle: FRAC_PI_2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strip_bears_more_where_strength_grows() {
        let factor = |ratio: f64| strip_on_growing_strength(ratio).unwrap();
        assert!((factor(0.0) - (2.0 + PI)).abs() < 1e-9, "{}", factor(0.0));
        // Twice as fine: 5.9818, 7.8187, 9.7812.
        for (ratio, expected) in [(1.0, 5.982), (4.0, 7.819), (8.0, 9.781)] {
            assert!((factor(ratio) - expected).abs() < 1e-3, "{ratio}: {}", factor(ratio));
        }
        assert!(strip_on_growing_strength(-1.0).is_err() && strip_on_growing_strength(9.0).is_err());
    }
}
