//! Contact points of a body's surface, stored compactly, since most of them never touch soil.

use crate::model::{BodyModel, Model, RimBin};
use crate::state::Contact;
use geometry::{Rim, SurfacePoint, inset_in_frame};
use glam::{DMat3, DVec3};
use mechanics::Motion;
use std::collections::BTreeMap;

/// Surface points of a body. Normals and areas that several points have in common are stored once.
#[derive(Debug)]
pub(crate) struct Surface {
    /// Position in the body frame [m]; index into `kinds`, with the highest bit set where the next point is
    /// the mirror image in the body's mid-plane y = 0; and bin of the rim, or as many as there are bins on a
    /// flank.
    points: Vec<(DVec3, u32, u16)>,
    /// Normals; areas round the points, and what these represent [m²].
    kinds: Vec<(DVec3, [f64; 2])>,
    /// The bins of the rim.
    rim: Vec<RimBin>,
    /// Samples of the whole rim, up to its edges, stored like the points; their normals and areas.
    samples: Vec<(DVec3, u32, u16)>,
    sample_kinds: Vec<(DVec3, [f64; 2])>,
    /// Where the body's mid-plane is [m].
    middle: f64,
    /// Part of the body to which each point belongs; empty where there is only one.
    parts: Vec<u16>,
}

/// Width of the bins of the rim, in cell widths (chosen: below a cell nothing is resolved, but a body that
/// moves through the cells averages over them).
const RIM_BIN: f64 = 0.5;

/// Marks a point whose mirror image is the next.
const PAIRED: u32 = 1 << 31;

/// A point of a body's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactPoint {
    /// Position in the body frame [m].
    pub(crate) position: DVec3,
    /// Outward unit normal.
    pub(crate) normal: DVec3,
    /// Area of the surface round the point [m²].
    pub(crate) area: f64,
    /// Area of the surface round the point and its share of the margins along the edges of its face [m²].
    pub(crate) represents: f64,
    /// Side of the body's mid-plane y = 0: 0 and 1, or 2 on the plane.
    pub(crate) side: u8,
    /// Whether the next point is the mirror image of this one in the mid-plane.
    pub(crate) is_paired: bool,
}

/// Whether no motion of a body changes the coordinate of its points along an axis.
pub(crate) fn stays_across(body: &BodyModel, axis: usize) -> bool {
    let turns_only_about = |axle: DVec3| {
        let [yaw, tilt, spin] = [3, 4, 5].map(|n| body.motion[n].is_fixed());
        yaw && tilt && (spin || (body.start.rotation * DVec3::Y).dot(axle).abs() == 1.0)
    };
    body.motion[axis] == Motion::Fixed && turns_only_about(DVec3::AXES[axis])
}

/// Whether two points are mirror images about the plane y = `middle` [m]: to the bit about y = 0, otherwise
/// up to round-off.
fn are_mirrored(a: &SurfacePoint, b: &SurfacePoint, middle: f64) -> bool {
    let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
    if middle == 0.0 {
        return flip(a.position) == b.position && flip(a.normal) == b.normal;
    }
    let from = DVec3::new(0.0, middle, 0.0);
    let tolerance = ROUND_OFF * (a.position.length() + middle.abs());
    flip(a.position - from).distance(b.position - from) < tolerance
        && flip(a.normal).distance(b.normal) < ROUND_OFF
}

/// Round-off between mirror images about a plane other than y = 0, relative.
const ROUND_OFF: f64 = 1e-9;

/// Spacing of a body's contact points, and their inset from sharp edges along its own axes [m]. The cells
/// near the body are taken to be the narrowest along each axis.
pub(crate) fn layout(model: &Model, body: &BodyModel) -> (DVec3, DVec3) {
    let finest = DVec3::from_array(std::array::from_fn(|axis| model.grid.finest_along(axis)));
    let rotation = DMat3::from_quat(body.attitude(&body.start));
    let inset = body.edge_inset * inset_in_frame(finest, rotation);
    let spacing = model.method.point_spacing * model.grid.fine_cell();
    // Along the axes of a body that is rotated cells have no width of their own.
    let is_aligned = rotation == DMat3::IDENTITY;
    (if is_aligned { spacing } else { DVec3::splat(spacing.min_element()) }, inset)
}

/// Portion of a body's width along y that has contact points, where it passes through the grid from side to
/// side: the margins along its edges then lie outside. 1 elsewhere.
fn portion_with_points(model: &Model, body: &BodyModel, margin: f64) -> f64 {
    let (low, high) = body.bounds(&body.start);
    let [first, last] = model.grid.ends(1);
    let round_off = ROUND_OFF * (last - first);
    let passes = low.y + margin <= first + round_off && high.y - margin >= last - round_off;
    if passes { 1.0 - 2.0 * margin / (high.y - low.y) } else { 1.0 }
}

/// Takes margins off what the points represent, of faces that have such margins.
fn leave_out_margins(points: &mut [SurfacePoint], portion: f64) {
    for point in points.iter_mut().filter(|p| p.represents > (1.0 + ROUND_OFF) * p.area) {
        point.represents *= portion;
    }
}

/// The rim of a body, in bins.
pub(crate) fn rim(model: &Model, body: &BodyModel) -> Rim {
    Rim::of(body.shape.as_ref(), RIM_BIN * model.grid.finest())
}

/// The bins of a rim, without areas: the middle of each is that of its points, which need not lie evenly in
/// it.
fn bins(points: &[SurfacePoint], rim: &Rim) -> Vec<RimBin> {
    let mut bins: Vec<_> = rim.middles().into_iter().map(|middle| (middle, [0.0; 2])).collect();
    for point in points {
        if let Some((bin, arc)) = rim.bin_of(point.position, point.normal) {
            let sums = &mut bins[bin].1;
            *sums = [sums[0] + point.area, sums[1] + point.area * arc];
        }
    }
    let bin = |(middle, [area, moment]): (_, [f64; 2])| RimBin {
        middle: if area > 0.0 { rim.at(moment / area) } else { middle },
        area: 0.0,
    };
    bins.into_iter().map(bin).collect()
}

/// Points, and normals and areas of them, as [`Surface`] stores them.
type Compact = (Vec<(DVec3, u32, u16)>, Vec<(DVec3, [f64; 2])>);

/// Points in that form; `is_paired` says whether the mirror image of a point is the next.
fn compact(points: &[SurfacePoint], rim: &Rim, is_paired: impl Fn(usize) -> bool) -> Compact {
    let (mut indices, mut kinds) = (BTreeMap::new(), Vec::new());
    let flank = rim.middles().len();
    let kept = points.iter().enumerate().map(|(n, p)| {
        let areas = [p.area, p.represents];
        let key = [p.normal.x, p.normal.y, p.normal.z, areas[0], areas[1]].map(f64::to_bits);
        let index = *indices.entry(key).or_insert(kinds.len());
        if index == kinds.len() {
            kinds.push((p.normal, areas));
        }
        let bin = rim.bin_of(p.position, p.normal).map_or(flank, |(bin, _)| bin);
        (p.position, index as u32 | if is_paired(n) { PAIRED } else { 0 }, bin as u16)
    });
    let kept = kept.collect();
    kinds.shrink_to_fit();
    (kept, kinds)
}

impl Surface {
    /// Surface points of a body, without those that always stay outside the grid, such as beyond a symmetry
    /// plane.
    pub(crate) fn new(model: &Model, body: &BodyModel) -> Self {
        let (spacing, inset) = layout(model, body);
        let mut points = body.shape.surface_points(spacing, inset);
        if stays_across(body, 1) {
            let [low, high] = model.grid.ends(1);
            let (low, high) = (low - spacing.y, high + spacing.y);
            let across = |p: &SurfacePoint| body.start.position.y + body.rotated(&body.start, p.position).y;
            points.retain(|p| (low..=high).contains(&across(p)));
            leave_out_margins(&mut points, portion_with_points(model, body, inset.y));
        }
        let rim = rim(model, body);
        let mut surface = Self::of(&points, &rim, body.shape.mid_plane());
        surface.sample_rim(model, body, &rim, spacing);
        if body.shape.parts() > 1 {
            surface.parts = points.iter().map(|point| body.shape.part_of(point.position) as u16).collect();
        }
        surface
    }

    fn of(points: &[SurfacePoint], rim: &Rim, middle: f64) -> Self {
        let bins = bins(points, rim);
        let (mut points, kinds) = compact(points, rim, |n| {
            points.get(n + 1).is_some_and(|next| are_mirrored(&points[n], next, middle))
        });
        points.shrink_to_fit();
        let (samples, sample_kinds) = (Vec::new(), Vec::new());
        Self { points, kinds, rim: bins, samples, sample_kinds, middle, parts: Vec::new() }
    }

    /// Samples the rim, without what always stays outside the grid, and finds the areas of its bins.
    fn sample_rim(&mut self, model: &Model, body: &BodyModel, rim: &Rim, spacing: DVec3) {
        let held: Vec<usize> = (0..2).filter(|axis| stays_across(body, *axis)).collect();
        let is_modelled = |position: DVec3| {
            let at = body.start.position + body.rotated(&body.start, position);
            held.iter().all(|axis| {
                let [low, high] = model.grid.ends(*axis);
                (low..=high).contains(&at[*axis])
            })
        };
        let mut points = body.shape.surface_points(spacing, DVec3::ZERO);
        points.retain(|point| is_modelled(point.position));
        points.retain(|point| rim.bin_of(point.position, point.normal).is_some());
        self.rim = bins(&points, rim);
        (self.samples, self.sample_kinds) = compact(&points, rim, |_| false);
        for ((_, _, bin), point) in self.samples.iter().zip(&points) {
            self.rim[usize::from(*bin)].area += point.area;
        }
    }

    /// Samples of the whole rim: positions and normals in the body frame [m], areas [m²] and bins.
    pub(crate) fn samples(&self) -> impl ExactSizeIterator<Item = (DVec3, DVec3, f64, usize)> + '_ {
        self.samples.iter().map(|(position, kind, bin)| {
            let (normal, [area, _]) = self.sample_kinds[*kind as usize];
            (*position, normal, area, usize::from(*bin))
        })
    }

    /// What a contact point of the surface represents, as far as it has soil to act on [m²].
    pub(crate) fn represented(&self, c: &Contact) -> f64 {
        let point = self.point(c.point as usize);
        point.represents / point.area * c.area
    }

    /// The bins of the rim, in the order of their arcs.
    pub(crate) fn rim(&self) -> &[RimBin] {
        &self.rim
    }

    /// Bin of a point, from its number; as many as there are bins on a flank.
    pub(crate) fn bin_of(&self, point: u32) -> usize {
        self.points[point as usize].2.into()
    }

    /// Part of the body to which a point belongs, from its number; `None` where there is only one.
    pub(crate) fn part_of(&self, point: u32) -> Option<usize> {
        self.parts.get(point as usize).map(|part| usize::from(*part))
    }

    /// Number of points.
    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    /// A point, from its number.
    pub(crate) fn point(&self, point: usize) -> ContactPoint {
        let (position, kind, _) = self.points[point];
        let (normal, [area, represents]) = self.kinds[(kind & !PAIRED) as usize];
        let across = position.y - self.middle;
        let side = if across == 0.0 { 2 } else { u8::from(across < 0.0) };
        ContactPoint { position, normal, area, represents, side, is_paired: kind & PAIRED != 0 }
    }

    /// Memory in use [bytes].
    pub(crate) fn memory(&self) -> usize {
        size_of_val(self.points.as_slice())
            + size_of_val(self.kinds.as_slice())
            + size_of_val(self.rim.as_slice())
            + size_of_val(self.samples.as_slice())
            + size_of_val(self.sample_kinds.as_slice())
            + size_of_val(self.parts.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::{Disc, Shape};

    #[test]
    fn a_surface_returns_the_points_it_was_made_from() {
        let disc = Disc { diameter: 0.2, thickness: 0.05 };
        let points = disc.surface_points(DVec3::splat(0.004), DVec3::splat(0.002));
        let surface = Surface::of(&points, &Rim::of(&disc, 0.008), 0.0);
        let same = |a: &ContactPoint, b: &SurfacePoint| {
            (a.position, a.normal, a.area) == (b.position, b.normal, b.area)
        };
        let found: Vec<_> = (0..surface.len()).map(|n| surface.point(n)).collect();
        assert!(found.iter().zip(&points).all(|(a, b)| same(a, b)) && found.len() == points.len());
        assert_eq!(found.iter().filter(|p| p.is_paired).count(), points.len() / 2);
        assert!(surface.memory() < 2 * size_of_val(points.as_slice()) / 3);
    }
}
