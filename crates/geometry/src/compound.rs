//! Several solids that are one rigid body, such as discs welded to an axle. They may share faces.

use super::{Disc, MassProperties, Mesh, Shape, SurfacePoint, inset_in_frame, paired_about};
use glam::{DMat3, DVec3};
use std::sync::Arc;

/// How far a point is moved along its normal before it counts as covered by another solid, over the spacing
/// of the points.
const BEYOND: f64 = 1e-6;
/// Gap between two discs, over their size, below which they share a face.
const SHARED_FACE: f64 = 1e-9;

/// A solid in the frame of the body that it is a part of.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Shape of the part in a frame of its own.
    pub shape: Arc<dyn Shape>,
    /// Origin of that frame in the body frame [m].
    pub position: DVec3,
    /// Rotation of that frame to the body frame.
    pub rotation: DMat3,
}

/// A solid with a sphere round it, beyond which the solid need not be looked at.
#[derive(Debug)]
struct Bounded {
    solid: Placed,
    /// Centre of the sphere in the body frame [m].
    centre: DVec3,
    /// Radius of the sphere round the part [m].
    radius: f64,
}

impl Bounded {
    fn new(solid: Placed) -> Self {
        let (low, high) = solid.shape.bounds();
        let centre = solid.position + solid.rotation * (0.5 * (low + high));
        let radius = 0.5 * (high - low).length();
        Self { solid, centre, radius }
    }

    /// The solid is at least so far from a point [m].
    fn least_distance(&self, x: DVec3) -> f64 {
        x.distance(self.centre) - self.radius
    }
}

/// Several solids that are one rigid body.
#[derive(Debug)]
pub struct Compound {
    /// The solids as they were given, for which forces are accounted.
    parts: Vec<Bounded>,
    /// The solids that bound the body: its parts, and discs that stand for several of them.
    solids: Vec<Bounded>,
}

impl Compound {
    /// A body of solids that do not overlap; solids without a surface are none of its parts. Discs of one
    /// diameter on one axle that share faces are one disc, without edges in between.
    #[must_use]
    pub fn new(parts: Vec<Placed>) -> Self {
        let merged = merge(&parts);
        let is_merged = |n: usize| merged.iter().any(|(_, numbers)| numbers.contains(&n));
        let others = parts.iter().enumerate().filter(|(n, part)| !is_merged(*n) && part.shape.has_surface());
        let solids = merged.iter().map(|(disc, _)| disc.clone()).chain(others.map(|(_, part)| part.clone()));
        let solids = solids.map(Bounded::new).collect();
        Self { parts: parts.into_iter().map(Bounded::new).collect(), solids }
    }

    /// The solids that bound the body.
    fn solids(&self) -> impl Iterator<Item = &Placed> {
        self.solids.iter().map(|bounded| &bounded.solid)
    }
}

impl Placed {
    fn own(&self, x: DVec3) -> DVec3 {
        self.rotation.transpose() * (x - self.position)
    }

    fn distance(&self, x: DVec3) -> f64 {
        self.shape.signed_distance(self.own(x))
    }

    /// A disc whose axle is the body's own.
    fn as_disc_on_the_axle(&self) -> Option<Disc> {
        let is_on_the_axle =
            self.rotation.y_axis == DVec3::Y && self.position.x == 0.0 && self.position.z == 0.0;
        let disc = |[diameter, thickness]: [f64; 2]| Disc { diameter, thickness };
        self.shape.as_disc().filter(|_| is_on_the_axle).map(disc)
    }
}

/// Discs on the axle that share faces, as one disc each, with the numbers of the parts.
fn merge(parts: &[Placed]) -> Vec<(Placed, Vec<usize>)> {
    let mut discs: Vec<(usize, Disc, f64)> = parts
        .iter()
        .enumerate()
        .filter_map(|(n, part)| Some((n, part.as_disc_on_the_axle()?, part.position.y)))
        .collect();
    discs.sort_by(|a, b| a.2.total_cmp(&b.2));
    let mut merged: Vec<(Disc, [f64; 2], Vec<usize>)> = Vec::new();
    for (number, disc, y) in discs {
        let [low, high] = [y - 0.5 * disc.thickness, y + 0.5 * disc.thickness];
        if let Some((whole, ends, numbers)) = merged.last_mut()
            && (whole.diameter - disc.diameter).abs() <= SHARED_FACE * disc.diameter
            && (low - ends[1]).abs() <= SHARED_FACE * disc.diameter
        {
            ends[1] = high;
            numbers.push(number);
        } else {
            merged.push((disc, [low, high], vec![number]));
        }
    }
    let several = merged.into_iter().filter(|(_, _, numbers)| numbers.len() > 1);
    let whole = |(disc, [low, high], numbers): (Disc, [f64; 2], Vec<usize>)| {
        let shape = Arc::new(Disc { thickness: high - low, ..disc });
        let position = DVec3::new(0.0, 0.5 * (low + high), 0.0);
        (Placed { shape, position, rotation: DMat3::IDENTITY }, numbers)
    };
    several.map(whole).collect()
}

impl Shape for Compound {
    /// Exact outside; inside at most the depth, since faces that solids share lie inside.
    fn signed_distance(&self, x: DVec3) -> f64 {
        self.solids.iter().fold(f64::MAX, |nearest, bounded| {
            if bounded.least_distance(x) < nearest { nearest.min(bounded.solid.distance(x)) } else { nearest }
        })
    }

    fn coverage(&self, x: DVec3, width: f64) -> f64 {
        let near = self.solids.iter().filter(|bounded| bounded.least_distance(x) < width);
        near.map(|bounded| bounded.solid.shape.coverage(bounded.solid.own(x), width)).sum::<f64>().min(1.0)
    }

    fn boxes(&self) -> Vec<(DVec3, DVec3)> {
        let around = |solid: &Placed| {
            let frame = solid.rotation.transpose();
            let along = |axis: DVec3| solid.position.dot(axis) + solid.shape.extent(frame * axis);
            let high = DVec3::from_array(DVec3::AXES.map(along));
            let low = DVec3::from_array(DVec3::AXES.map(|axis| -along(-axis)));
            (low, high)
        };
        self.solids().map(around).collect()
    }

    fn extent(&self, direction: DVec3) -> f64 {
        let along = |solid: &Placed| {
            solid.position.dot(direction) + solid.shape.extent(solid.rotation.transpose() * direction)
        };
        self.solids().map(along).fold(f64::NEG_INFINITY, f64::max)
    }

    fn mass_properties(&self) -> MassProperties {
        let own =
            |solid: &Placed| solid.shape.mass_properties().rotated(solid.rotation).moved(solid.position);
        MassProperties::sum(self.solids().map(own))
    }

    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let beyond = BEYOND * spacing.min_element();
        let mut points = Vec::new();
        for solid in self.solids() {
            let is_aligned = solid.rotation == DMat3::IDENTITY;
            let own_spacing = if is_aligned { spacing } else { DVec3::splat(spacing.min_element()) };
            let own = solid.shape.surface_points(own_spacing, inset_in_frame(inset, solid.rotation));
            points.extend(own.into_iter().map(|point| SurfacePoint {
                position: solid.position + solid.rotation * point.position,
                normal: solid.rotation * point.normal,
                ..point
            }));
        }
        // A point on a shared face lies inside the solid on the other side.
        points.retain(|point| {
            let outside = point.position + beyond * point.normal;
            let mut near = self.solids.iter().filter(|bounded| bounded.least_distance(outside) < 0.0);
            near.all(|bounded| bounded.solid.distance(outside) >= 0.0)
        });
        // One solid has its own points in pairs already.
        if self.solids.len() > 1 { paired_about(points, self.mid_plane()) } else { points }
    }

    fn mid_plane(&self) -> f64 {
        0.5 * (self.extent(DVec3::Y) - self.extent(DVec3::NEG_Y))
    }

    fn surface_point_count(&self, spacing: DVec3, inset: DVec3) -> f64 {
        let own =
            |solid: &Placed| solid.shape.surface_point_count(spacing, inset_in_frame(inset, solid.rotation));
        self.solids().map(own).sum()
    }

    fn is_revolved(&self) -> bool {
        self.solids().all(|solid| {
            let on_the_axle = solid.position.x == 0.0 && solid.position.z == 0.0;
            solid.shape.is_revolved() && solid.rotation.y_axis == DVec3::Y && on_the_axle
        })
    }

    fn has_surface(&self) -> bool {
        !self.solids.is_empty()
    }

    fn parts(&self) -> usize {
        self.parts.len()
    }

    fn part_of(&self, x: DVec3) -> usize {
        let mut nearest = (0, f64::MAX);
        for (n, part) in self.parts.iter().enumerate() {
            if part.least_distance(x) < nearest.1 {
                let distance = part.solid.distance(x);
                if distance < nearest.1 {
                    nearest = (n, distance);
                }
            }
        }
        nearest.0
    }

    fn mesh(&self) -> Mesh {
        let mut whole = Mesh { points: Vec::new(), triangles: Vec::new() };
        for solid in self.solids() {
            let (first, own) = (whole.points.len() as u32, solid.shape.mesh());
            whole.points.extend(own.points.iter().map(|x| solid.position + solid.rotation * *x));
            whole.triangles.extend(own.triangles.iter().map(|triangle| triangle.map(|n| first + n)));
        }
        whole
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Block;

    fn disc_at(y: f64, thickness: f64) -> Placed {
        let shape = Arc::new(Disc { diameter: 0.2, thickness });
        Placed { shape, position: DVec3::new(0.0, y, 0.0), rotation: DMat3::IDENTITY }
    }

    #[test]
    fn two_half_discs_are_one_disc() {
        let whole = Disc { diameter: 0.2, thickness: 0.05 };
        let halves = Compound::new(vec![disc_at(0.0125, 0.025), disc_at(-0.0125, 0.025)]);
        let (spacing, inset) = (DVec3::splat(0.003), DVec3::splat(0.006));
        assert_eq!(halves.surface_points(spacing, inset), whole.surface_points(spacing, inset));
        assert!(halves.is_revolved());
        for point in whole.surface_points(spacing, inset) {
            assert_eq!(halves.part_of(point.position), usize::from(point.position.y < 0.0), "{point:?}");
        }
        let (a, b) = (halves.mass_properties(), whole.mass_properties());
        assert!(
            (a.volume - b.volume).abs() < 1e-15 && (a.inertia.y_axis - b.inertia.y_axis).length() < 1e-15
        );
    }

    #[test]
    fn a_shared_face_bears_no_points_and_is_no_gap() {
        let block = |x: f64| Placed {
            shape: Arc::new(Block { size: DVec3::new(0.1, 0.1, 0.1) }),
            position: DVec3::new(x, 0.0, 0.0),
            rotation: DMat3::IDENTITY,
        };
        let pair = Compound::new(vec![block(-0.05), block(0.05)]);
        let whole = Block { size: DVec3::new(0.2, 0.1, 0.1) };
        let points = pair.surface_points(DVec3::splat(0.01), DVec3::ZERO);
        assert!(points.iter().all(|p| p.position.x.abs() > 1e-9));
        let area: f64 = points.iter().map(|p| p.area).sum();
        assert!((area - 0.1).abs() < 1e-12, "{area}");
        for x in [0.0, 0.0004, -0.001, 0.02] {
            assert_eq!(pair.coverage(DVec3::new(x, 0.01, 0.0), 0.003), 1.0, "at {x}");
        }
        let (a, b) = (pair.mass_properties(), whole.mass_properties());
        assert!((a.inertia - b.inertia).to_cols_array().iter().all(|e| e.abs() < 1e-15));
        assert_eq!(pair.extent(DVec3::X), 0.1);
    }
}
