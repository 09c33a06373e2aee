//! How thin a solid is where it is thinnest: walls, fins, tines, grousers.
//!
//! From points spread over the surface a ray goes inwards to the face on the other side. Where that is
//! parallel, the solid is a sheet there. Edges and tips, whose faces are not parallel, are no walls; nor is
//! what stands out by less than half a cell from something thicker: the solid there is what the sphere that
//! fits into it says (Hildebrand & Rüegsegger 1997, local thickness).

use super::polyhedron::Polyhedron;
use super::triangle::{area_vector, meets};
use super::{Mesh, Shape};
use glam::DVec3;

/// A thin place of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thin {
    /// Thickness over the width of a cell along it.
    pub cells: f64,
    /// Thickness [m].
    pub thickness: f64,
    /// Place of the thickness on the surface, in the body frame [m].
    pub place: DVec3,
}

/// Which thin places are looked for.
pub struct ThinSearch<'a> {
    /// Width of the widest cells [m].
    pub cell: f64,
    /// Cells to a metre along a direction of the body frame [1/m].
    pub cells: &'a dyn Fn(DVec3) -> f64,
    /// Whether a place of the surface, in the body frame [m], counts.
    pub counts: &'a dyn Fn(DVec3) -> bool,
    /// Places with fewer cells across are thin.
    pub fewer_than: f64,
}

/// Cosine beyond which two faces are parallel: 10°. The faces of a wedge, an edge or a cone of more are not
/// (chosen: less than a usual point, more than the draft of a casting).
const PARALLEL: f64 = 0.985;
/// Area of thin places that counts, over the square of a cell, and how many of them (chosen: a bolt's head or
/// a bead is no wall).
const LEAST_AREA: f64 = 1.0;
const LEAST_PLACES: usize = 3;
/// Distance between the rays over the width of a cell, and most rays.
const SPACING: f64 = 0.5;
const MOST_RAYS: f64 = 50_000.0;
/// Most places that are compared with what is thicker near them.
const MOST_COMPARED: usize = 3000;
/// Thickness over that of a place beyond which something near it is thicker (chosen: more than where two
/// walls meet).
const THICKER: f64 = 1.5;
/// Distance over the width of a cell up to which something is near.
const NEAR: f64 = 0.5;
/// Distance over the size of the solid that is rounding.
const ROUNDING: f64 = 1e-6;

impl Polyhedron {
    /// The thinnest place; `None` where there is none.
    #[must_use]
    pub fn thinnest(&self, search: &ThinSearch) -> Option<Thin> {
        let &ThinSearch { cell, cells, counts, fewer_than } = search;
        let (low, high) = self.bounds();
        let rounding = ROUNDING * (high - low).max_element();
        let (rays, area) = rays(self.surface(), SPACING * cell);
        let mut places: Vec<(Thin, DVec3)> = rays
            .into_iter()
            .filter(|(place, _)| counts(*place))
            .filter_map(|(place, normal)| {
                let thickness = self.across((place, normal), rounding)?;
                Some((Thin { cells: thickness * cells(normal), thickness, place }, normal))
            })
            .filter(|(thin, _)| thin.cells < fewer_than)
            .collect();
        places.sort_by(|a, b| a.0.cells.total_cmp(&b.0.cells));
        let mut first = None;
        let mut found = 0;
        for (thin, normal) in places.into_iter().take(MOST_COMPARED) {
            if self.is_part_of_thicker(&thin, normal, cell) {
                continue;
            }
            found += 1;
            let first = *first.get_or_insert(thin);
            if found >= LEAST_PLACES && f64::from(found as u32) * area >= LEAST_AREA * cell * cell {
                return Some(first);
            }
        }
        None
    }

    /// Distance from a point of the surface, whose normal is given, to the face on the other side [m], if
    /// that is parallel.
    fn across(&self, (place, normal): (DVec3, DVec3), rounding: f64) -> Option<f64> {
        let corners = &self.hierarchy().corners;
        let mut nearest = (f64::INFINITY, 0);
        self.hierarchy().first_along(place, -normal, |triangle| {
            if let Some(at) = meets(place, -normal, &corners[triangle])
                && at > rounding
                && at < nearest.0
            {
                nearest = (at, triangle);
            }
            nearest.0
        });
        let beyond = area_vector(corners.get(nearest.1)?).normalize_or_zero();
        (nearest.0.is_finite() && beyond.dot(-normal) > PARALLEL).then_some(nearest.0)
    }

    /// Whether a sphere so much wider than the solid is thick at a place fits into it nearby.
    fn is_part_of_thicker(&self, thin: &Thin, normal: DVec3, cell: f64) -> bool {
        const DIRECTIONS: usize = 12;
        let radius = 0.5 * THICKER * thin.thickness;
        let middle = thin.place - 0.5 * thin.thickness * normal;
        let (across, along) = normal.any_orthonormal_pair();
        (1..=4).any(|step| {
            let arm = radius + 0.25 * f64::from(step) * NEAR * cell;
            (0..DIRECTIONS).any(|n| {
                let (sin, cos) = (std::f64::consts::TAU * n as f64 / DIRECTIONS as f64).sin_cos();
                let centre = middle + arm * (cos * across + sin * along);
                let depth = -self.signed_distance(centre);
                depth >= radius && centre.distance(thin.place) <= depth + NEAR * cell
            })
        })
    }
}

/// Points spread over a surface, with their normals, and the area for each [m²].
fn rays(surface: &Mesh, spacing: f64) -> (Vec<(DVec3, DVec3)>, f64) {
    // The R₂ sequence (Roberts 2018).
    const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];
    let corners = |triangle: &[u32; 3]| triangle.map(|n| surface.points[n as usize]);
    let whole: f64 = surface.triangles.iter().map(|t| 0.5 * area_vector(&corners(t)).length()).sum();
    let area = (spacing * spacing).max(whole / MOST_RAYS);
    let (mut rays, mut owed, mut count) = (Vec::new(), 0.5, 0_u32);
    for [a, b, c] in surface.triangles.iter().map(corners) {
        let normal = area_vector(&[a, b, c]);
        owed += 0.5 * normal.length() / area;
        while owed >= 1.0 {
            owed -= 1.0;
            count += 1;
            let [u, v] = STEPS.map(|step| (f64::from(count) * step).fract());
            let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
            rays.push((a + u * (b - a) + v * (c - a), normal.normalize()));
        }
    }
    (rays, area)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, Cylinder, Disc};
    use crate::{Bevel, Block, Extruded, Grousers, Revolved, Sphere, blade, cone, wheel};

    fn search(
        shape: &dyn Shape,
        cells: &dyn Fn(DVec3) -> f64,
        counts: &dyn Fn(DVec3) -> bool,
    ) -> Option<Thin> {
        let solid = Polyhedron::new(shape.mesh());
        solid.thinnest(&ThinSearch { cell: 0.01, cells, counts, fewer_than: 4.0 })
    }

    /// Cells of 10 mm across the thinnest place below four.
    fn cells(shape: &dyn Shape) -> Option<f64> {
        search(shape, &|n| 100.0 * n.length(), &|_| true).map(|thin| thin.cells)
    }

    #[track_caller]
    fn close(shape: &dyn Shape, expected: f64) {
        let found = cells(shape).unwrap_or(f64::INFINITY);
        assert!((found / expected - 1.0).abs() < 0.02, "{found}, not {expected}");
    }

    #[test]
    fn sheets_rods_and_grousers_are_as_thick_as_they_are() {
        close(&Block { size: DVec3::new(0.2, 0.004, 0.1) }, 0.4);
        close(&Block { size: DVec3::new(0.02, 0.02, 0.3) }, 2.0);
        close(&Cylinder { diameter: 0.03, length: 0.3, axis: Axis::Z }, 3.0);
        close(&Sphere { diameter: 0.03 }, 3.0);
        close(&Disc { diameter: 0.3, thickness: 0.005 }, 0.5);
        let grousers = |thickness| Grousers { number: 12, height: 0.025, thickness };
        let grousered = |thickness| Extruded::new(wheel(0.35, grousers(thickness)).unwrap(), 0.15);
        close(&grousered(0.025), 2.5);
        close(&grousered(0.006), 0.6);
    }

    #[test]
    fn tips_edges_and_small_features_are_no_walls() {
        assert_eq!(cells(&Block { size: DVec3::splat(0.1) }), None);
        assert_eq!(cells(&Revolved::new(cone(0.08, 0.5, 0.08, 0.4).unwrap(), Axis::Z)), None);
        let knife = Extruded::new(blade([0.05, 0.2], Some((0.35, 0.0, Bevel::Low))).unwrap(), 0.3);
        assert_eq!(cells(&knife), None);
        // Ribs that stand out by 0.3 of a cell are none; by two cells they are.
        let low = Grousers { number: 12, height: 0.003, thickness: 0.003 };
        assert_eq!(cells(&Extruded::new(wheel(0.35, low).unwrap(), 0.15)), None);
        close(&Extruded::new(wheel(0.35, Grousers { height: 0.02, ..low }).unwrap(), 0.15), 0.3);
    }

    #[test]
    fn flat_cells_count_along_their_widths() {
        let plate = Block { size: DVec3::new(0.2, 0.2, 0.02) };
        let widths = DVec3::new(0.02, 0.02, 0.01);
        let thin = search(&plate, &|n| (n / widths).length(), &|_| true).unwrap();
        assert!((thin.cells - 2.0).abs() < 1e-9 && (thin.thickness - 0.02).abs() < 1e-9, "{thin:?}");
        let beside = search(&plate, &|n| (n / widths).length(), &|x| x.x > 0.05).unwrap();
        assert!(beside.place.x > 0.05, "{beside:?}");
        assert_eq!(search(&plate, &|n| (n / widths).length(), &|x| x.x > 1.0), None);
    }
}
