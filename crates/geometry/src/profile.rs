//! Plane profiles of lines and circular arcs, from which solids are revolved or extruded.

use super::edge::{Edge, Foot};
use super::facets::SHARP;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The outline of a plane region of lines and circular arcs, counter-clockwise in the plane of u (to the
/// right) and v (upwards).
///
/// It is a closed curve, or begins and ends on the axis u = 0, which then bounds the region, all of it at u ≥
/// 0. It does not cross itself, and has no cusp that is pointed like a needle, with faces that touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    begin: DVec2,
    edges: Vec<Edge>,
    /// A box round each [`GROUP`] of the edges, so that the nearest edge of a long profile is found among
    /// few.
    boxes: Vec<Bounds>,
}

/// Number of edges that share a box.
const GROUP: usize = 8;

/// A box along the axes [m].
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bounds {
    low: DVec2,
    high: DVec2,
}

impl Bounds {
    fn distance_squared(&self, x: DVec2) -> f64 {
        (self.low - x).max(x - self.high).max(DVec2::ZERO).length_squared()
    }
}

impl Profile {
    /// The beginning of a profile [m].
    #[must_use]
    pub fn begin(u: f64, v: f64) -> Self {
        Self { begin: DVec2::new(u, v), edges: Vec::new(), boxes: Vec::new() }
    }

    fn push(&mut self, edge: Edge) {
        let (low, high) = edge.bounds();
        match self.boxes.last_mut() {
            Some(last) if !self.edges.len().is_multiple_of(GROUP) => {
                *last = Bounds { low: last.low.min(low), high: last.high.max(high) };
            }
            _ => self.boxes.push(Bounds { low, high }),
        }
        self.edges.push(edge);
    }

    /// Last point of the profile so far [m].
    fn end(&self) -> DVec2 {
        self.edges.last().map_or(self.begin, |edge| edge.to)
    }

    /// The profile with a line to a point [m]; none where it is there already.
    #[must_use]
    pub fn line_to(mut self, u: f64, v: f64) -> Self {
        let (from, to) = (self.end(), DVec2::new(u, v));
        if from != to {
            self.push(Edge::line(from, to));
        }
        self
    }

    /// The profile with an arc to a point [m] about a centre [m], counter-clockwise or clockwise.
    #[must_use]
    pub fn arc_to(mut self, [u, v]: [f64; 2], centre: [f64; 2], is_counter_clockwise: bool) -> Self {
        let (from, to, centre) = (self.end(), DVec2::new(u, v), DVec2::from(centre));
        let sense = if is_counter_clockwise { 1.0 } else { -1.0 };
        let turn = (sense * (from - centre).angle_to(to - centre)).rem_euclid(TAU);
        // Edges turn by less than π.
        let parts = (turn / FRAC_PI_2 * (1.0 - 1e-9)).ceil().max(1.0) as usize;
        let arm = from - centre;
        let part = sense * turn / parts as f64;
        for n in 1..=parts {
            let next = if n == parts { to } else { centre + DVec2::from_angle(part * n as f64).rotate(arm) };
            self.push(Edge::arc([self.end(), next], centre, part));
        }
        self
    }

    /// Image of the outline in v = 0.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let begin = self.end();
        let mut image = Self::begin(begin.x, -begin.y);
        self.edges.iter().rev().map(Edge::mirrored).for_each(|edge| image.push(edge));
        image
    }

    /// Edges of the outline, in order.
    pub(super) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Whether the profile is a closed curve.
    fn is_closed(&self) -> bool {
        self.end() == self.begin
    }

    /// Signed distance [m] to the outline, negative inside; at u ≥ 0 where the axis bounds the region.
    pub(super) fn signed_distance(&self, x: DVec2) -> f64 {
        let (distance, n, foot) = self.nearest(x);
        match foot {
            Foot::Within => distance,
            Foot::Start => distance.copysign(self.normal_before(n).dot(x - self.edges[n].from)),
            Foot::End => distance.copysign(self.normal_before(n + 1).dot(x - self.edges[n].to)),
        }
    }

    /// Distance [m] of the nearest edge as [`Edge::nearest`] gives it, its number, and where on it that is.
    fn nearest(&self, x: DVec2) -> (f64, usize, Foot) {
        let look_at = |group: usize, nearest: (f64, usize, Foot)| {
            let edges = self.edges.iter().enumerate().skip(GROUP * group).take(GROUP);
            edges.fold(nearest, |nearest, (n, edge)| {
                let (foot, distance) = edge.nearest(x);
                if distance.abs() < nearest.0.abs() { (distance, n, foot) } else { nearest }
            })
        };
        // From the group whose box is nearest, few of the others can still be nearer.
        let squared = |group: &usize| self.boxes[*group].distance_squared(x);
        let groups = 0..self.boxes.len();
        let by_box = |a: &usize, b: &usize| squared(a).total_cmp(&squared(b));
        let first = if groups.len() > 1 { groups.clone().min_by(by_box).unwrap_or(0) } else { 0 };
        let nearest = look_at(first, (f64::INFINITY, 0, Foot::Within));
        groups.filter(|group| *group != first).fold(nearest, |nearest, group| {
            if squared(&group) <= nearest.0 * nearest.0 { look_at(group, nearest) } else { nearest }
        })
    }

    /// A vector out of the region at the point where an edge begins, between the normals on both sides of it.
    /// On the axis the outline meets its mirror image.
    fn normal_before(&self, n: usize) -> DVec2 {
        let count = self.edges.len();
        let on_axis = |normal: DVec2| DVec2::new(0.0, normal.y);
        if self.is_closed() || (n > 0 && n < count) {
            self.edges[(n + count - 1) % count].normal(1.0) + self.edges[n % count].normal(0.0)
        } else if n == 0 {
            on_axis(self.edges[0].normal(0.0))
        } else {
            on_axis(self.edges[count - 1].normal(1.0))
        }
    }

    /// Largest coordinate along a vector of any length [m times its length].
    pub(super) fn support(&self, direction: DVec2) -> f64 {
        self.edges.iter().map(|edge| edge.support(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// ∮ f(u, v) dv: by Green's theorem the integral of ∂f/∂u over the region, if f = 0 on an axis that
    /// bounds it.
    pub(super) fn integral(&self, f: impl Fn(DVec2) -> f64) -> f64 {
        self.edges.iter().map(|edge| edge.integral(&f)).sum()
    }

    /// Points along the profile, with the arcs divided; of a closed curve without the last, which is the
    /// first.
    pub(super) fn points(&self) -> Vec<DVec2> {
        let mut points = vec![self.begin];
        for edge in &self.edges {
            let pieces = edge.pieces();
            points.extend((1..pieces).map(|n| edge.at(n as f64 / pieces as f64)));
            points.push(edge.to);
        }
        if self.is_closed() {
            points.pop();
        }
        points
    }

    /// How far the sharp convex corners before and after each edge are from its ends, along the outline [m];
    /// infinite where there is none. A corner that is rounded off counts as if it were not.
    pub(super) fn corners(&self) -> Vec<[f64; 2]> {
        let both = |n| [self.corner(n, false), self.corner(n, true)];
        (0..self.edges.len()).map(both).collect()
    }

    /// The distance of the next corner after the end of an edge, or before its beginning.
    fn corner(&self, n: usize, forwards: bool) -> f64 {
        let (count, mut distance) = (self.edges.len(), 0.0);
        for step in 0..count {
            // The edges on both sides of a point of the outline; where that meets the axis there is no
            // corner.
            let (before, after) =
                if forwards { (n + step, n + step + 1) } else { (n + count - step - 1, n + count - step) };
            if after == count && !self.is_closed() {
                return f64::INFINITY;
            }
            let (before, after) = (self.edges[before % count], self.edges[after % count]);
            let tangents = (before.tangent(1.0), after.tangent(0.0));
            if tangents.0.perp_dot(tangents.1) > 0.0 && tangents.0.dot(tangents.1) <= SHARP {
                return distance;
            }
            let next = if forwards { after } else { before };
            if let Some((_, short)) = next.rounding() {
                return distance + short;
            }
            distance += next.length();
        }
        f64::INFINITY
    }

    /// The part at v ≤ 0 of a profile that begins and ends on the axis, each edge with its distances from
    /// corners, if the part at v ≥ 0 is its mirror image.
    pub(super) fn lower_half(&self) -> Option<Vec<(Edge, [f64; 2])>> {
        let size = self.edges.iter().map(|edge| edge.to.length()).fold(self.begin.length(), f64::max);
        let count = self.edges.len();
        let is_image = |n: usize| self.edges[n].agrees(&self.edges[count - 1 - n].mirrored(), 1e-9 * size);
        if self.is_closed() || !(0..count).all(is_image) {
            return None;
        }
        let corners = self.corners();
        let mut half: Vec<_> = (0..count / 2).map(|n| (self.edges[n], corners[n])).collect();
        if count % 2 == 1 {
            let middle = count / 2;
            half.push((self.edges[middle].first_half(), [corners[middle][0], f64::INFINITY]));
        }
        Some(half)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of 2 with a round hole's quarter bitten out of its upper right corner.
    fn bitten() -> Profile {
        Profile::begin(-1.0, -1.0)
            .line_to(1.0, -1.0)
            .line_to(1.0, 0.0)
            .arc_to([0.0, 1.0], [1.0, 1.0], false)
            .line_to(-1.0, 1.0)
            .line_to(-1.0, -1.0)
    }

    #[test]
    fn distances_are_those_of_the_nearest_line_arc_or_corner() {
        let profile = bitten();
        let at = |u: f64, v: f64| profile.signed_distance(DVec2::new(u, v));
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
        close(at(0.0, -2.0), 1.0);
        close(at(-2.0, -2.0), 2_f64.sqrt());
        // In the bite, at its centre, and beyond it.
        close(at(0.8, 0.8), 1.0 - 0.08_f64.sqrt());
        close(at(1.0, 1.0), 1.0);
        close(at(1.3, 0.4), 0.5);
        // Inside, next to the bite and at its middle.
        close(at(0.0, 0.0), 1.0 - 2_f64.sqrt());
        close(at(-0.9, 0.0), -0.1);
    }

    #[test]
    fn a_long_profile_is_as_near_as_its_nearest_edge() {
        // A star of 60 edges, in eight groups.
        let at =
            |n: u32| 0.1 * f64::from(7 + 6 * (n % 2)) * DVec2::from_angle(TAU / 60.0 * f64::from(n % 60));
        let begin = Profile::begin(at(0).x, at(0).y);
        let star = (1..=60).fold(begin, |star, n| star.line_to(at(n).x, at(n).y));
        assert_eq!(star.boxes.len(), 8);
        for (u, v) in (0..400).map(|n| (0.13 * f64::from(n % 20 - 9), 0.17 * f64::from(n / 20 - 9))) {
            let x = DVec2::new(u, v);
            let nearest = star.edges.iter().map(|e| e.nearest(x).1.abs()).fold(f64::INFINITY, f64::min);
            assert_eq!(star.signed_distance(x).abs(), nearest);
        }
        assert!(star.signed_distance(DVec2::ZERO) < 0.0 && star.mirrored().boxes.len() == 8);
    }

    #[test]
    fn integrals_over_the_region_are_exact() {
        let profile = bitten();
        let quarter = 0.25 * std::f64::consts::PI;
        assert!((profile.integral(|x| x.x) - (4.0 - quarter)).abs() < 1e-14);
        // First moment of the bite: its centroid is 4/(3π) from its centre.
        let bite = quarter - 1.0 / 3.0;
        assert!((profile.integral(|x| 0.5 * x.x * x.x) + bite).abs() < 1e-14);
        assert!((profile.integral(|x| x.x * x.y) + bite).abs() < 1e-14);
    }

    #[test]
    fn corners_are_sharp_where_they_are_convex() {
        assert_eq!(bitten().corners(), [[0.0; 2]; 5]);
        let smooth = Profile::begin(0.0, -1.0).arc_to([0.0, 1.0], [0.0, 0.0], true);
        assert_eq!(smooth.lower_half().map(|half| half.len()), Some(1));
        // A cylinder, one edge rounded, the other cut off at an angle that is not sharp.
        let profile = Profile::begin(0.0, -1.0)
            .line_to(0.8, -1.0)
            .arc_to([1.0, -0.8], [0.8, -0.8], true)
            .line_to(1.0, 0.9)
            .line_to(0.98, 1.0)
            .line_to(0.0, 1.0);
        let none = f64::INFINITY;
        let cut = 0.02_f64.hypot(0.1);
        let expected = [[none, 0.2], [none, 1.7 + cut], [0.2, cut], [1.7 + 0.2, 0.0], [0.0, none]];
        for (found, expected) in profile.corners().as_flattened().iter().zip(expected.as_flattened()) {
            assert!(found == expected || (found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn the_farthest_point_may_lie_on_an_arc() {
        let half = Profile::begin(0.0, -1.0).arc_to([0.0, 1.0], [0.0, 0.0], true);
        for angle in [-1.2, 0.0, 0.7] {
            assert!((half.support(DVec2::from_angle(angle)) - 1.0).abs() < 1e-14);
        }
        assert!((half.support(DVec2::new(-1.0, -1.0)) - 1.0).abs() < 1e-14);
    }
}
