//! A slice through soil and bodies, coloured by one quantity.

use super::canvas::{Canvas, Tone};
use super::frame::{Scale, View};
use super::soil::SmoothSoil;
use crate::plots::ColourMap;
use case::resolved::{Case, Ground};
use geometry::Shape;
use glam::DVec3;
use input::readable::Unit;
use mechanics::{BodyState, Pose};
use results::domain::PlacedDomain;
use results::fields::{CellView, reference_height};
use solver::fields::{PLASTIC_STRAIN, PORE_PRESSURE};
use solver::precision::Precision;
use solver::state::State;

const STEEL: Tone = [[196, 202, 210], [112, 120, 130]];
pub(super) const OUTLINE: Tone = [[25, 28, 35], [228, 232, 236]];
const SURFACE: Tone = [[70, 70, 70], [170, 174, 180]];
/// Cells with less soil than this do not count for the ends of a scale.
const SHOWN: f64 = 0.5;

/// The state from which the pictures are made, and the region that they show.
pub(super) struct Scene<'a, R> {
    pub(super) case: &'a Case,
    pub(super) domain: &'a PlacedDomain<'a>,
    pub(super) state: &'a State<R>,
    pub(super) shapes: Vec<Box<dyn Shape>>,
    pub(super) row: usize,
    pub(super) across: [f64; 2],
    pub(super) upward: [f64; 2],
}

impl<'a, R: Precision> Scene<'a, R> {
    pub(super) fn new(case: &'a Case, domain: &'a PlacedDomain<'a>, state: &'a State<R>) -> Self {
        let row = row_at(&domain.faces[1], plane_shown(case, state));
        let shapes: Vec<Box<dyn Shape>> = case.bodies.iter().map(|b| b.solid()).collect();
        let mut scene = Self { case, domain, state, shapes, row, across: [0.0; 2], upward: [0.0; 2] };
        scene.across = scene.range(0);
        scene.upward = scene.range(2);
        scene
    }

    /// The bodies with a surface: state and shape.
    pub(super) fn bodies(&self) -> impl Iterator<Item = (&BodyState, &dyn Shape)> {
        self.case.touching().map(|(n, _)| (&self.state.mechanism.bodies[n], self.shapes[n].as_ref()))
    }

    /// Ends of the fine zone along an axis [m], which travels with the grid.
    pub(super) fn fine_zone(&self, axis: usize) -> [f64; 2] {
        let grid = &self.case.grid;
        [grid.fine_low, grid.fine_high].map(|end| end[axis] + self.state.grid_position[axis])
    }

    /// The range to show along an axis: the fine zone with a margin, and the bodies.
    fn range(&self, axis: usize) -> [f64; 2] {
        let [low, high] = self.fine_zone(axis);
        let margin = 0.1 * (high - low).abs();
        let [first, last] = self.domain.ends(axis);
        let mut range = [(low - margin).max(first), (high + margin).min(last)];
        if range[1] <= range[0] || self.case.bodies.is_empty() {
            range = [first, last];
        }
        // A body that has moved far away (in a run that broke down) must not enlarge the view.
        let far = [first - 0.5 * (last - first), last + 0.5 * (last - first)];
        for (body, shape) in self.bodies() {
            let reach = reach(shape, &body.pose, axis);
            range = [range[0].min(reach[0] - 0.2 * margin), range[1].max(reach[1] + 0.2 * margin)];
            range = [range[0].max(far[0]), range[1].min(far[1])];
        }
        range
    }

    /// A slice in which soil has a smooth surface, at a volume fraction of ½, and is coloured by the `value`
    /// of each cell.
    fn slice(&self, title: &str, scale: &Scale, value: impl Fn(&CellView<R>) -> f64) -> Canvas {
        let cell = |i: usize, k: usize| CellView::of(self.domain, self.state, [i, self.row, k]);
        let y = self.domain.centre(1, self.row);
        let soil = SmoothSoil::new(
            [&self.domain.faces[0], &self.domain.faces[2]],
            |i, k| (cell(i, k).fraction, value(&cell(i, k))),
            |x, z| self.distance(DVec3::new(x, y, z)) < 0.0,
        );
        self.view(title, scale, |x, z| soil.at(x, z).map(|value| scale.colour(value)))
    }

    /// A slice of raw cells.
    fn raw_slice(&self, title: &str, scale: &Scale, value: impl Fn(&CellView<R>) -> Option<f64>) -> Canvas {
        self.view(title, scale, |x, z| {
            let at = [find(&self.domain.faces[0], x)?, self.row, find(&self.domain.faces[2], z)?];
            value(&CellView::of(self.domain, self.state, at)).map(|value| scale.colour(value))
        })
    }

    /// A view of the mid-plane with the bodies over what is there.
    fn view(&self, title: &str, scale: &Scale, colour: impl Fn(f64, f64) -> Option<Tone>) -> Canvas {
        let mut view = View::new(self.across, self.upward);
        let y = self.domain.centre(1, self.row);
        let pixel = view.pixel();
        view.paint(|x, z| self.body_colour(DVec3::new(x, y, z), pixel).or_else(|| colour(x, z)));
        self.spokes(&mut view);
        if let Ground::Level { .. } = self.case.ground {
            view.level(reference_height(self.case), SURFACE);
        }
        view.finish(title, ["x [m]", "z [m]"], scale);
        view.canvas
    }

    /// Distance from the nearest body [m], negative inside.
    fn distance(&self, point: DVec3) -> f64 {
        let all = self.bodies().map(|(body, shape)| shape.signed_distance(body.pose.point_in_body(point)));
        all.fold(f64::INFINITY, f64::min)
    }

    /// The colour of a body at a point, if there is one.
    fn body_colour(&self, point: DVec3, pixel: f64) -> Option<Tone> {
        let distance = self.distance(point);
        if distance.abs() < 1.2 * pixel { Some(OUTLINE) } else { (distance < 0.0).then_some(STEEL) }
    }

    /// A mark on each round body that rotates with it; the orientation of other bodies is visible anyway.
    fn spokes(&self, view: &mut View) {
        for (body, shape) in self.bodies().filter(|(_, s)| s.is_revolved()) {
            let top = 0.5 * shape.bounds().1.z;
            let (hub, tip) = (body.pose.position, body.pose.point(DVec3::new(0.0, 0.0, top)));
            view.line(&[[hub.x, hub.z], [tip.x, tip.z]], OUTLINE, 2.0);
        }
    }

    /// Values of the cells of the slice within the shown range, sorted.
    fn values(&self, value: impl Fn(&CellView<R>) -> f64) -> Vec<f64> {
        let [columns, _, layers] = self.domain.cells();
        let inside = |axis: usize, range: [f64; 2]| {
            let domain = self.domain;
            move |n: &usize| (range[0]..=range[1]).contains(&domain.centre(axis, *n))
        };
        let columns: Vec<usize> = (0..columns).filter(inside(0, self.across)).collect();
        let mut values: Vec<f64> = (0..layers)
            .filter(inside(2, self.upward))
            .flat_map(|k| columns.iter().map(move |&i| [i, self.row, k]))
            .map(|at| CellView::of(self.domain, self.state, at))
            .filter(|cell| cell.fraction > SHOWN)
            .map(|cell| value(&cell))
            .filter(|v| v.is_finite())
            .collect();
        values.sort_by(f64::total_cmp);
        values
    }

    fn high_end(&self, value: impl Fn(&CellView<R>) -> f64) -> f64 {
        let values = self.values(value);
        values.get((0.999 * values.len() as f64) as usize).copied().unwrap_or(1.0)
    }

    pub(super) fn fraction(&self) -> Canvas {
        let scale = Scale::linear(ColourMap::Earth, 0.0, 1.0, "volume fraction [–]".into());
        self.raw_slice("Soil volume fraction", &scale, |c| Some(c.fraction).filter(|f| *f > 1e-3))
    }

    pub(super) fn plastic_strain(&self) -> Canvas {
        let most = self.high_end(|c| c.history(PLASTIC_STRAIN)).max(1e-2);
        let high = 10f64.powf(most.log10().ceil());
        let label = "plastic strain [–], logarithmic".into();
        let scale = Scale { map: ColourMap::Sequential, low: 1e-3 * high, high, logarithmic: true, label };
        self.slice("Equivalent plastic strain", &scale, |c| c.history(PLASTIC_STRAIN))
    }

    pub(super) fn pressure(&self) -> Canvas {
        let most = self.high_end(|c| c.pressure()).max(1.0);
        let unit = Unit::stress(most);
        let label = format!("pressure [{}]", unit.name);
        let scale = Scale::linear(ColourMap::Sequential, 0.0, most / unit.size, label);
        self.slice("Mean pressure (compression positive)", &scale, |c| c.pressure() / unit.size)
    }

    /// The excess pore pressure, where one is computed.
    pub(super) fn pore_pressure(&self) -> Option<Canvas> {
        if self.state.soil.history[PORE_PRESSURE].is_empty() {
            return None;
        }
        let most = self.high_end(|c| c.history(PORE_PRESSURE).abs()).max(1.0);
        let unit = Unit::stress(most);
        let (end, label) = (most / unit.size, format!("excess pore pressure [{}]", unit.name));
        let scale = Scale::linear(ColourMap::Diverging, -end, end, label);
        Some(self.slice("Excess pore pressure", &scale, |c| c.history(PORE_PRESSURE) / unit.size))
    }

    pub(super) fn speed(&self) -> Canvas {
        let most = self.high_end(|c| c.velocity().length()).max(1e-6);
        let unit = Unit::speed(most);
        let scale =
            Scale::linear(ColourMap::Sequential, 0.0, most / unit.size, format!("speed [{}]", unit.name));
        self.slice("Speed of the soil", &scale, |c| c.velocity().length() / unit.size)
    }
}

/// Position along y of the slices: the middle of the first body, or of the domain [m].
pub(super) fn plane_shown<R>(case: &Case, state: &State<R>) -> f64 {
    match case.touching().next() {
        _ if case.domain.symmetric => 0.0,
        Some((n, _)) => state.pose(n).position.y,
        None => 0.5 * (case.domain.low.y + case.domain.high.y),
    }
}

/// The row of cells between these faces along y that holds a plane; the first if none does.
pub(super) fn row_at(faces: &[f64], plane: f64) -> usize {
    faces.iter().skip(1).position(|y| *y > plane).unwrap_or(0)
}

/// The index of the interval of `edges` that contains `value`.
pub(super) fn find(edges: &[f64], value: f64) -> Option<usize> {
    let n = edges.partition_point(|edge| *edge <= value);
    (n > 0 && n < edges.len()).then(|| n - 1)
}

/// Extent of a body along an axis [m].
fn reach(shape: &dyn Shape, pose: &Pose, axis: usize) -> [f64; 2] {
    let points = shape.mesh().points;
    points
        .iter()
        .map(|p| pose.point(*p)[axis])
        .fold([f64::INFINITY, f64::NEG_INFINITY], |r, v| [r[0].min(v), r[1].max(v)])
}
