//! Cut-cell hourglass correction: the forces that one-point integration lacks in a cell cut by a body's
//! surface.
//!
//! With one-point integration the pressure p of the soil in a cell exerts p f V ∇N_a(centre) on node a, as if
//! the soil filled the cell evenly; exact would be p ∫ ∇N_a over the region of the cell that the soil fills.
//! The difference annihilates every linear velocity field: it consists of hourglass forces. Along a surface
//! that cuts cells obliquely it differs from cell to cell, does not cancel, and drives hourglass modes in
//! proportion to the pressure. The body supports this pressure, so the contact constraint applies the
//! difference, in proportion to its normal force.

use super::problem::side;
use crate::cpu::threads::Crew;
use crate::grid::Grid;
use crate::model::Model;
use crate::state::{Body, Contact};
use glam::DVec3;
use rustc_hash::FxHashMap;

/// Samples of a cell along each axis.
const SAMPLES: usize = 4;
/// Cells that a thread takes at once.
const AT_ONCE: usize = 8;
/// A surface has an edge in a cell where its contact points represent less than this fraction of its area
/// there.
const WHOLE: f64 = 0.75;

/// A body's surface in one cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellSurface {
    /// Area that the contact points in the cell represent [m²].
    sampled: f64,
    /// Area of the surface in the cell [m²].
    area: f64,
}

impl CellSurface {
    /// Whether the contact points represent most of the surface in the cell; at an edge they do not.
    pub(super) fn is_whole(&self) -> bool {
        // Three of four rows of points represent exactly this fraction: round-off must not decide.
        self.sampled > (WHOLE - 1e-6) * self.area
    }
}

/// The surfaces of the bodies in the cells that hold contact points, by body and cell.
pub(super) type CellSurfaces = FxHashMap<(u32, [u32; 3]), CellSurface>;

/// Finds the surfaces in the cells of the contact points.
pub(super) fn surfaces(
    model: &Model,
    bodies: &[Body],
    grid_position: DVec3,
    contacts: &[Contact],
    crew: Crew,
) -> CellSurfaces {
    // The two sides of the body's mid-plane are summed separately, so that mirroring in y changes no bit.
    type Sampled<'a> = (&'a Contact, [f64; 3]);
    let mut sampled: FxHashMap<_, Sampled> = FxHashMap::default();
    for c in contacts {
        sampled.entry((c.body, c.cell)).or_insert((c, [0.0; 3])).1[side(c)] += c.area;
    }
    let sampled: Vec<_> = sampled.into_iter().collect();
    let surface = |(key, (c, [left, right, middle])): &(_, Sampled)| {
        let area = Cell::new(model, bodies, grid_position, c).area(c.normal);
        (*key, CellSurface { sampled: left + right + middle, area })
    };
    let each =
        crew.collect(sampled.len(), AT_ONCE, |range| sampled[range].iter().map(surface).collect::<Vec<_>>());
    each.into_iter().flatten().collect()
}

/// What is known of the contact points for the corrections.
pub(super) struct Sampled<'a> {
    pub(super) contacts: &'a [Contact],
    /// Volume fraction in the cell of each contact point.
    pub(super) fraction: &'a [f64],
    pub(super) surfaces: &'a CellSurfaces,
}

/// For each constraint, given by its first contact point, the correction at the eight nodes of its cell per
/// unit normal force.
pub(super) fn corrections(
    model: &Model,
    bodies: &[Body],
    grid_position: DVec3,
    sampled: &Sampled,
    first: &[usize],
    crew: Crew,
) -> Vec<[DVec3; 8]> {
    let Sampled { contacts, fraction, surfaces } = *sampled;
    let correction = |n: &usize| {
        let (c, none) = (&contacts[*n], [DVec3::ZERO; 8]);
        let surface = &surfaces[&(c.body, c.cell)];
        // A face aligned with the grid cuts all cells alike: the corrections cancel, except at its edges.
        // There the inset of the contact points has this effect already.
        if is_aligned(c.normal) || !surface.is_whole() {
            return none;
        }
        let area = surface.sampled.max(surface.area);
        let cell = Cell::new(model, bodies, grid_position, c);
        cell.hourglass_correction(fraction[*n]).map(|force| force / area)
    };
    let each =
        crew.collect(first.len(), AT_ONCE, |range| first[range].iter().map(correction).collect::<Vec<_>>());
    each.into_iter().flatten().collect()
}

/// Whether a face with this normal is parallel to faces of the cells; on a body that is turned by 90° but for
/// round-off.
pub(super) fn is_aligned(normal: DVec3) -> bool {
    normal.abs().max_element() >= 1.0 - 4.0 * f64::EPSILON
}

/// A cell that a body occupies in part.
struct Cell<'a, D> {
    grid: &'a Grid,
    /// Layers in the whole grid.
    layers: [usize; 3],
    width: DVec3,
    /// Distance between samples along the normal of the surface [m].
    sample: f64,
    /// Signed distance from the body's surface [m].
    distance: D,
}

impl<'a> Cell<'a, ()> {
    fn new(
        model: &'a Model,
        bodies: &[Body],
        grid_position: DVec3,
        c: &Contact,
    ) -> Cell<'a, impl Fn(DVec3) -> f64 + 'a> {
        let (fixed, pose) = (&model.bodies[c.body as usize], &bodies[c.body as usize].searched_at);
        let rotation = fixed.attitude(pose).inverse();
        let layers = c.cell.map(|layer| layer as usize);
        let width = DVec3::from_array(std::array::from_fn(|axis| {
            let faces = &model.grid.whole[axis];
            faces[layers[axis] + 1] - faces[layers[axis]]
        }));
        let position = pose.position - grid_position;
        let distance = move |x: DVec3| fixed.shape.signed_distance(rotation * (x - position));
        let sample = model.grid.smallest_width(width) * model.grid.depth_along(c.normal) / SAMPLES as f64;
        Cell { grid: &model.grid, layers, width, sample, distance }
    }
}

impl<D: Fn(DVec3) -> f64> Cell<'_, D> {
    /// Coordinate a number of samples from the low face, interpolated from both faces so that mirroring in y
    /// changes no bit.
    fn at(&self, axis: usize, samples: f64) -> f64 {
        let (local, faces) = (samples / SAMPLES as f64, &self.grid.whole[axis]);
        faces[self.layers[axis]] * (1.0 - local) + faces[self.layers[axis] + 1] * local
    }

    /// 1 inside the body, 0 outside, with a linear transition near its surface.
    fn inside(&self, x: DVec3) -> f64 {
        (0.5 - (self.distance)(x) / self.sample).clamp(0.0, 1.0)
    }

    /// Area of the body's surface with this normal in the cell [m²]: of a face that is parallel to faces of
    /// the cell that of the whole cell, otherwise the magnitude of the area vector, from the areas of the
    /// cell's faces inside the body.
    fn area(&self, normal: DVec3) -> f64 {
        if is_aligned(normal) {
            return (DVec3::splat(self.width.element_product()) / self.width).dot(normal.abs());
        }
        let covered = |axis: usize, side: usize| {
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut layers = [0.0; SAMPLES];
            // Summed by layers in y, if the face extends along y.
            let (slow, fast) = if b == 1 { (b, c) } else { (c, b) };
            for (m, layer) in layers.iter_mut().enumerate() {
                for n in 0..SAMPLES {
                    let mut x = DVec3::ZERO;
                    x[axis] = self.at(axis, (side * SAMPLES) as f64);
                    x[slow] = self.at(slow, m as f64 + 0.5);
                    x[fast] = self.at(fast, n as f64 + 0.5);
                    *layer += self.inside(x);
                }
            }
            ((layers[0] + layers[3]) + (layers[1] + layers[2])) / SAMPLES.pow(2) as f64
                * (self.width[b] * self.width[c])
        };
        DVec3::from_array(std::array::from_fn(|axis| covered(axis, 0) - covered(axis, 1))).length()
    }

    /// The correction at the nodes at unit pressure [m²]: β V ∇N_a(centre) − ∫ ∇N_a over the body, where the
    /// body occupies the fraction β of the cell and soil the rest; reduced in proportion where the volume
    /// fraction is below 1 − β.
    fn hourglass_correction(&self, fraction: f64) -> [DVec3; 8] {
        // It follows from the means over the body of ξ, η, ζ, ξη, ηζ, ξζ, with ξ, η, ζ from −1 to 1. Per
        // layer in y:
        let mut layers = [[0.0; 4]; SAMPLES];
        let local = |n: usize| (n as f64 + 0.5) * 2.0 / SAMPLES as f64 - 1.0;
        for n in 0..SAMPLES.pow(3) {
            let [x, y, z] = [n % SAMPLES, n / SAMPLES % SAMPLES, n / SAMPLES / SAMPLES];
            let point = DVec3::new(
                self.at(0, x as f64 + 0.5),
                self.at(1, y as f64 + 0.5),
                self.at(2, z as f64 + 0.5),
            );
            let inside = self.inside(point);
            for (sum, term) in layers[y].iter_mut().zip([1.0, local(x), local(z), local(x) * local(z)]) {
                *sum += inside * term;
            }
        }
        // Layers are summed in pairs: mirroring in y changes no bit but the sign of the moments odd in η.
        let per = 1.0 / SAMPLES.pow(3) as f64;
        let even = |n: usize| per * ((layers[0][n] + layers[3][n]) + (layers[1][n] + layers[2][n]));
        let odd = |n: usize| {
            per * (local(3) * (layers[3][n] - layers[0][n]) + local(2) * (layers[2][n] - layers[1][n]))
        };
        let space = 1.0 - even(0);
        let filled = if space > 0.0 && fraction < space { fraction / space } else { 1.0 };
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
        let local = (DVec3::ONE - sign) * 0.5 + sign * x;
        sign * DVec3::new(local.y * local.z, local.x * local.z, local.x * local.y)
    }

    #[test]
    fn the_correction_is_the_gradient_at_the_centre_minus_its_mean_over_the_body() {
        let (normal, fine) = (DVec3::new(0.5, 0.3, 0.8).normalize(), 60);
        let distance = |x: DVec3| normal.dot(x) - 0.6;
        let grid = Grid::new(std::array::from_fn(|_| vec![0.0, 1.0]));
        let cell = Cell { grid: &grid, layers: [0; 3], width: DVec3::ONE, sample: 0.25, distance };
        let fraction = 0.1;
        let (full, thin) = (cell.hourglass_correction(1.0), cell.hourglass_correction(fraction));
        let points = || (0..fine * fine * fine).map(|n| [n % fine, n / fine % fine, n / fine / fine]);
        let inside = || {
            points()
                .map(|n| DVec3::from_array(n.map(|n| (f64::from(n) + 0.5) / f64::from(fine))))
                .filter(|x| distance(*x) < 0.0)
        };
        let per = f64::from(fine).powi(-3);
        let body_fraction = per * inside().count() as f64;
        for n in 0..8 {
            let mean = inside().fold(DVec3::ZERO, |sum, x| sum + per * gradient(n, x));
            let expected = body_fraction * gradient(n, DVec3::splat(0.5)) - mean;
            // Four midpoint samples underestimate a second moment by a sixteenth.
            assert!(
                (full[n] - expected).length() < 0.08 * expected.length(),
                "corner {n}: {} for {expected}",
                full[n]
            );
            let reduced = expected * fraction / (1.0 - body_fraction);
            assert!(
                (thin[n] - reduced).length() < 0.08 * reduced.length(),
                "corner {n}: {} for {reduced}",
                thin[n]
            );
        }
        assert!(full.iter().sum::<DVec3>().length() < 1e-15);
        // No soil, in a cell that the body fills.
        let filled =
            Cell { grid: &grid, layers: [0; 3], width: DVec3::ONE, sample: 0.25, distance: |_| -1.0 };
        assert!(filled.hourglass_correction(-1e-20).iter().all(|f| f.length() < 1e-15));
    }
}
