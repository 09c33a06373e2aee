//! An edge of a profile: a straight line or a circular arc.

use super::facets::SHARP;
use glam::DVec2;
use std::f64::consts::TAU;

/// Largest turn of a piece into which an arc is divided for a mesh or an integral [rad]: 96 pieces to a
/// circle.
pub(super) const PIECE: f64 = TAU / 96.0;

/// An edge; what it bounds lies to its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    /// First point [m].
    pub(super) from: DVec2,
    /// Last point [m].
    pub(super) to: DVec2,
    /// The circle that the edge follows; `None` if it is straight.
    arc: Option<Arc>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Arc {
    centre: DVec2,
    radius: f64,
    /// Polar angle of the first point [rad].
    start: f64,
    /// Angle from the first to the last point [rad], positive counter-clockwise; less than π.
    turn: f64,
}

/// Where an edge is nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Foot {
    /// At the first point of the edge.
    Start,
    /// Between the ends of the edge.
    Within,
    /// At the last point of the edge.
    End,
}

impl Edge {
    pub(super) fn line(from: DVec2, to: DVec2) -> Self {
        Self { from, to, arc: None }
    }

    /// An arc about `centre` that turns by `turn` [rad], positive counter-clockwise.
    pub(super) fn arc([from, to]: [DVec2; 2], centre: DVec2, turn: f64) -> Self {
        let arm = from - centre;
        Self { from, to, arc: Some(Arc { centre, radius: arm.length(), start: arm.to_angle(), turn }) }
    }

    pub(super) fn length(&self) -> f64 {
        self.arc.map_or_else(|| self.from.distance(self.to), |arc| arc.radius * arc.turn.abs())
    }

    /// The point at a fraction of the length of the edge.
    pub(super) fn at(&self, fraction: f64) -> DVec2 {
        match self.arc {
            None => self.from.lerp(self.to, fraction),
            Some(arc) => arc.centre + arc.radius * DVec2::from_angle(arc.start + fraction * arc.turn),
        }
    }

    /// Unit vector along the edge at a fraction of its length.
    pub(super) fn tangent(&self, fraction: f64) -> DVec2 {
        match self.arc {
            None => (self.to - self.from).normalize_or_zero(),
            Some(arc) => arc.turn.signum() * DVec2::from_angle(arc.start + fraction * arc.turn).perp(),
        }
    }

    /// Outward unit normal, to the right of the edge, at a fraction of its length.
    pub(super) fn normal(&self, fraction: f64) -> DVec2 {
        -self.tangent(fraction).perp()
    }

    /// Where the edge is nearest to a point, and the distance [m]: signed where that is between its ends,
    /// positive to its right.
    pub(super) fn nearest(&self, x: DVec2) -> (Foot, f64) {
        let within = match self.arc {
            None => {
                let along = self.to - self.from;
                let fraction = (x - self.from).dot(along) / along.length_squared();
                (fraction > 0.0 && fraction < 1.0).then(|| self.normal(0.0).dot(x - self.from))
            }
            Some(arc) => {
                let arm = x - arc.centre;
                let side = arc.turn.signum();
                let inside = side * (self.from - arc.centre).perp_dot(arm) > 0.0
                    && side * arm.perp_dot(self.to - arc.centre) > 0.0;
                inside.then(|| side * (arm.length() - arc.radius))
            }
        };
        within.map_or_else(
            || {
                let [start, end] = [self.from, self.to].map(|end| x.distance(end));
                if start <= end { (Foot::Start, start) } else { (Foot::End, end) }
            },
            |distance| (Foot::Within, distance),
        )
    }

    /// Largest coordinate along a vector of any length [m times its length].
    pub(super) fn support(&self, direction: DVec2) -> f64 {
        let ends = direction.dot(self.from).max(direction.dot(self.to));
        let extreme = self.arc.map(|arc| arc.centre + arc.radius * direction.normalize_or_zero());
        let on_it = |x: &DVec2| self.nearest(*x).0 == Foot::Within;
        extreme.filter(on_it).map_or(ends, |x| ends.max(direction.dot(x)))
    }

    /// Low and high corner of the box round it [m].
    pub(super) fn bounds(&self) -> (DVec2, DVec2) {
        let along = |direction: DVec2| self.support(direction);
        let low = -DVec2::new(along(DVec2::NEG_X), along(DVec2::NEG_Y));
        (low, DVec2::new(along(DVec2::X), along(DVec2::Y)))
    }

    /// Radius [m] of an arc that rounds a sharp convex corner, and the length [m] by which it falls short of
    /// the corner on both sides.
    pub(super) fn rounding(&self) -> Option<(f64, f64)> {
        self.arc
            .filter(|arc| arc.turn > 0.0 && arc.turn.cos() <= SHARP)
            .map(|arc| (arc.radius, arc.radius * (0.5 * arc.turn).tan()))
    }

    /// Number of pieces into which the edge is divided for a mesh or an integral.
    pub(super) fn pieces(&self) -> usize {
        self.arc.map_or(1, |arc| (arc.turn.abs() / PIECE * (1.0 - 1e-9)).ceil().max(1.0) as usize)
    }

    /// ∫ u ds [m²] of the first coordinate u between two fractions of its length.
    pub(super) fn swept(&self, from: f64, to: f64) -> f64 {
        match self.arc {
            None => self.length() * (to - from) * self.at(0.5 * (from + to)).x,
            Some(arc) => {
                let angle = |fraction: f64| arc.start + fraction * arc.turn;
                let turned = arc.turn * (to - from);
                let sines = angle(to).sin() - angle(from).sin();
                arc.radius * arc.turn.signum() * (arc.centre.x * turned + arc.radius * sines)
            }
        }
    }

    /// ∫ f(u, v) dv along the edge, by Gauss' rule of four points on each piece: exact for polynomials up to
    /// the sixth degree on a line, and to rounding on an arc.
    pub(super) fn integral(&self, f: &impl Fn(DVec2) -> f64) -> f64 {
        const POINTS: [(f64, f64); 4] = [
            (-0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
            (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
            (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
            (0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
        ];
        let (pieces, length) = (self.pieces(), self.length());
        let at = |n: usize, x: f64| (n as f64 + 0.5 * (1.0 + x)) / pieces as f64;
        let piece = |n: usize| {
            let value = |x: f64| f(self.at(at(n, x))) * self.tangent(at(n, x)).y;
            POINTS.iter().map(|(x, weight)| weight * value(*x)).sum::<f64>()
        };
        0.5 * length / pieces as f64 * (0..pieces).map(piece).sum::<f64>()
    }

    /// First half of the edge.
    pub(super) fn first_half(&self) -> Self {
        let arc = self.arc.map(|arc| Arc { turn: 0.5 * arc.turn, ..arc });
        Self { from: self.from, to: self.at(0.5), arc }
    }

    /// Image of the edge in v = 0, traversed backwards.
    pub(super) fn mirrored(&self) -> Self {
        let flip = |x: DVec2| DVec2::new(x.x, -x.y);
        let ends = [flip(self.to), flip(self.from)];
        self.arc
            .map_or_else(|| Self::line(ends[0], ends[1]), |arc| Self::arc(ends, flip(arc.centre), arc.turn))
    }

    /// Whether the edge is another edge within a distance [m].
    pub(super) fn agrees(&self, other: &Self, tolerance: f64) -> bool {
        [0.0, 0.5, 1.0].iter().all(|fraction| self.at(*fraction).distance(other.at(*fraction)) <= tolerance)
    }
}
