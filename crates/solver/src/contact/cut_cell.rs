//! What contact makes up for in a cell that a body's surface cuts.
//!
//! The pressure p of the soil acts on the nodes of its cell as if the soil were spread evenly over it: the force on node a is
//! p f V ∇N_a at the cell's middle, where p ∫ ∇N_a over the soil's own part of the cell would be right. What is missing neither
//! pushes, turns nor stretches the cell as a whole: it is hourglass forces. Along a surface that cuts cells askew they differ from
//! cell to cell, do not cancel, and stir the soil the more the higher the pressure. It is the body that holds this
//! pressure, so contact gives to the nodes what is missing, in proportion to the pressure on the patch.

use super::scene::side;
use crate::grid::Grid;
use crate::model::Model;
use crate::state::{Body, Contact};
use glam::DVec3;
use std::collections::HashMap;

/// Samples of a cell along each axis.
const SAMPLES: usize = 4;
/// A surface has an edge in a cell where its points stand for less than this share of it.
const WHOLE: f64 = 0.75;

/// For each patch the forces that are missing at the eight nodes of its cell, over the force on the patch.
pub(super) fn corrections(
    model: &Model,
    bodies: &[Body],
    (contacts, fraction): (&[Contact], &[f64]),
    (patch, patches): (&[usize], usize),
) -> Vec<[DVec3; 8]> {
    // The two sides of the body's middle are added up apart: a mirror in y then changes no bit of the sum.
    let mut area: HashMap<(usize, [u32; 3]), [f64; 3]> = HashMap::new();
    for c in contacts {
        area.entry((c.body, c.cell)).or_default()[side(c)] += c.area;
    }
    let mut corrections = vec![None; patches];
    for ((c, fraction), number) in contacts.iter().zip(fraction).zip(patch) {
        corrections[*number].get_or_insert_with(|| {
            let none = [DVec3::ZERO; 8];
            // Along a face that lies in the grid all cells are cut alike: what is missing cancels but at the face's edges.
            if c.normal.abs().max_element() == 1.0 {
                return none;
            }
            let cell = Cell::new(model, bodies, c);
            let [left, right, middle] = area[&(c.body, c.cell)];
            let (touched, whole) = (left + right + middle, cell.area());
            // Edges are what the inset of the points takes care of.
            if touched < WHOLE * whole {
                return none;
            }
            cell.missing(*fraction).map(|force| force / touched.max(whole))
        });
    }
    corrections.into_iter().map(Option::unwrap_or_default).collect()
}

/// A cell with a body in it.
struct Cell<'a, D> {
    grid: &'a Grid,
    place: [usize; 3],
    width: DVec3,
    /// Signed distance from the body's surface [m].
    distance: D,
}

impl<'a> Cell<'a, ()> {
    fn new(model: &'a Model, bodies: &[Body], c: &Contact) -> Cell<'a, impl Fn(DVec3) -> f64 + 'a> {
        let (fixed, (position, angle)) = (&model.bodies[c.body], bodies[c.body].located);
        let turn = glam::DQuat::from_rotation_y(if fixed.shape.is_revolved() { 0.0 } else { -angle });
        let place = c.cell.map(|layer| layer as usize);
        let width = DVec3::from_array(std::array::from_fn(|axis| {
            let faces = &model.grid.whole[axis];
            faces[place[axis] + 1] - faces[place[axis]]
        }));
        let distance = move |x: DVec3| fixed.shape.signed_distance(turn * (x - position));
        Cell { grid: &model.grid, place, width, distance }
    }
}

impl<D: Fn(DVec3) -> f64> Cell<'_, D> {
    /// Coordinate that lies so many samples from the low face, found from both faces: a mirror in y changes no bit.
    fn at(&self, axis: usize, samples: f64) -> f64 {
        let (part, faces) = (samples / SAMPLES as f64, &self.grid.whole[axis]);
        faces[self.place[axis]] * (1.0 - part) + faces[self.place[axis] + 1] * part
    }

    /// 1 inside the body, 0 outside, in part near its surface.
    fn inside(&self, place: DVec3) -> f64 {
        let sample = self.width.min_element() / SAMPLES as f64;
        (0.5 - (self.distance)(place) / sample).clamp(0.0, 1.0)
    }

    /// Size of the area vector of the body's surface in the cell [m²]: that of the open parts of the cell's faces.
    fn area(&self) -> f64 {
        let open = |axis: usize, side: usize| {
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut layers = [0.0; SAMPLES];
            // Along y in layers, if the face has any.
            let (slow, fast) = if b == 1 { (b, c) } else { (c, b) };
            for (m, layer) in layers.iter_mut().enumerate() {
                for n in 0..SAMPLES {
                    let mut place = DVec3::ZERO;
                    place[axis] = self.at(axis, (side * SAMPLES) as f64);
                    place[slow] = self.at(slow, m as f64 + 0.5);
                    place[fast] = self.at(fast, n as f64 + 0.5);
                    *layer += self.inside(place);
                }
            }
            ((layers[0] + layers[3]) + (layers[1] + layers[2])) / SAMPLES.pow(2) as f64
                * (self.width[b] * self.width[c])
        };
        DVec3::from_array(std::array::from_fn(|axis| open(axis, 0) - open(axis, 1))).length()
    }

    /// What is missing at the nodes at unit pressure [m²]. With soil in all of the cell but the share β that the body takes up
    /// it is β V ∇N_a at the middle, less ∫ ∇N_a over the body's part; with less soil, a volume fraction below 1 − β, as
    /// much less.
    fn missing(&self, fraction: f64) -> [DVec3; 8] {
        // With ξ, η, ζ from −1 to 1 it is made of the body's means of ξ, η, ζ, ξη, ηζ, ξζ over the cell. Per layer in y:
        let mut layers = [[0.0; 4]; SAMPLES];
        let local = |n: usize| (n as f64 + 0.5) * 2.0 / SAMPLES as f64 - 1.0;
        for n in 0..SAMPLES.pow(3) {
            let [x, y, z] = [n % SAMPLES, n / SAMPLES % SAMPLES, n / SAMPLES / SAMPLES];
            let place = DVec3::new(
                self.at(0, x as f64 + 0.5),
                self.at(1, y as f64 + 0.5),
                self.at(2, z as f64 + 0.5),
            );
            let inside = self.inside(place);
            for (sum, part) in layers[y].iter_mut().zip([1.0, local(x), local(z), local(x) * local(z)]) {
                *sum += inside * part;
            }
        }
        // Layers are added up in pairs: a mirror in y changes no bit but the sign of what is odd in η.
        let per = 1.0 / SAMPLES.pow(3) as f64;
        let even = |n: usize| per * ((layers[0][n] + layers[3][n]) + (layers[1][n] + layers[2][n]));
        let odd = |n: usize| {
            per * (local(3) * (layers[3][n] - layers[0][n]) + local(2) * (layers[2][n] - layers[1][n]))
        };
        let room = 1.0 - even(0);
        let filled = if room > 0.0 && fraction < room { fraction / room } else { 1.0 };
        let ([x, z, xz], [y, xy, yz]) = ([1, 2, 3].map(even), [0, 1, 2].map(odd));
        let volume = self.width.x * self.width.y * self.width.z;
        std::array::from_fn(|n| {
            let [sx, sy, sz] = [0, 1, 2].map(|axis| if n >> axis & 1 == 1 { 1.0 } else { -1.0 });
            let shape = DVec3::new(
                sx * (sy * y + sz * z + sy * sz * yz),
                sy * (sx * x + sz * z + sx * sz * xz),
                sz * (sx * x + sy * y + sx * sy * xy),
            );
            -0.25 * filled * volume * shape / self.width
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∇N of corner `n` of a unit cube at `x`.
    fn gradient(n: usize, x: DVec3) -> DVec3 {
        let sign = DVec3::from_array([0, 1, 2].map(|axis| if n >> axis & 1 == 1 { 1.0 } else { -1.0 }));
        let part = (DVec3::ONE - sign) * 0.5 + sign * x;
        sign * DVec3::new(part.y * part.z, part.x * part.z, part.x * part.y)
    }

    #[test]
    fn what_is_missing_is_the_middle_s_gradient_less_the_mean_one() {
        let (normal, fine) = (DVec3::new(0.5, 0.3, 0.8).normalize(), 60);
        let distance = |x: DVec3| normal.dot(x) - 0.6;
        let grid = Grid::new(std::array::from_fn(|_| vec![0.0, 1.0]));
        let cell = Cell { grid: &grid, place: [0; 3], width: DVec3::ONE, distance };
        let room = 0.1;
        let (full, thin) = (cell.missing(1.0), cell.missing(room));
        let points = || (0..fine * fine * fine).map(|n| [n % fine, n / fine % fine, n / fine / fine]);
        let inside = || {
            points()
                .map(|n| DVec3::from_array(n.map(|n| (f64::from(n) + 0.5) / f64::from(fine))))
                .filter(|x| distance(*x) < 0.0)
        };
        let per = f64::from(fine).powi(-3);
        let share = per * inside().count() as f64;
        for n in 0..8 {
            let mean = inside().fold(DVec3::ZERO, |sum, x| sum + per * gradient(n, x));
            let right = share * gradient(n, DVec3::splat(0.5)) - mean;
            // Samples in the middles of four parts see a sixteenth of a second moment too little.
            assert!(
                (full[n] - right).length() < 0.08 * right.length(),
                "corner {n}: {} for {right}",
                full[n]
            );
            let less = right * room / (1.0 - share);
            assert!((thin[n] - less).length() < 0.08 * less.length(), "corner {n}: {} for {less}", thin[n]);
        }
        assert!(full.iter().sum::<DVec3>().length() < 1e-15);
        // No soil at all, and a cell that the body fills.
        let filled = Cell { grid: &grid, place: [0; 3], width: DVec3::ONE, distance: |_| -1.0 };
        assert!(filled.missing(-1e-20).iter().all(|f| f.length() < 1e-15));
    }
}
