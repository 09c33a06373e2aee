//! The rut: seen from above, and in cross-section.

use super::frame::{Scale, View};
use super::scene::{OUTLINE, Scene, find};
use crate::plots::{Chart, ColourMap, Curve, Stroke};
use case::resolved::{Case, Ground};
use glam::DVec3;
use input::readable::{digits, largest};
use mechanics::Pose;
use results::fields::HeightMap;
use results::files::{Inside, OutputError, write_whole};
use results::tables::push_line;
use solver::precision::Precision;
use solver::state::State;

/// The free surface from above.
pub(super) fn plan<R: Precision>(scene: &Scene<'_, R>, map: &HeightMap) -> View {
    let across = map.with_ground_left(0, scene.across);
    let ([first, last], middle) = (map.inside[1], scene.state.grid_position.y);
    let reach = 1.1 * fine_reach(scene.case);
    let inside =
        if reach > 0.0 { [first.max(middle - reach), last.min(middle + reach)] } else { [first, last] };
    let sideways = map.with_ground_left(1, inside);
    let mut view = View::new(across, sideways);
    let level = matches!(scene.case.ground, Ground::Level { .. });
    let scale = height_scale(map, level, across, sideways);
    view.paint(|x, y| {
        let (i, j) = (find(&map.edges[0], x)?, find(&map.edges[1], y)?);
        Some(scale.colour(1e3 * map.rise(i, j)))
    });
    for (n, body) in scene.case.touching() {
        for points in body.outlines() {
            view.line(&outline(&points, scene.state.pose(n)), OUTLINE, 2.0);
        }
    }
    let title = if level { "Rut and berm from above" } else { "Height of the soil from above" };
    view.finish(title, ["x [m]", "y [m]"], &scale);
    view
}

/// How far the fine zone extends sideways from y = 0 at the start [m].
fn fine_reach(case: &Case) -> f64 {
    case.grid.fine_high.y.abs().max(case.grid.fine_low.y.abs())
}

/// Colour scale for heights [mm]: symmetric about the undisturbed surface, or from the floor up for a column.
fn height_scale(map: &HeightMap, level: bool, across: [f64; 2], sideways: [f64; 2]) -> Scale {
    let rise = |n: usize| {
        let (i, j) = (n % map.centres[0].len(), n / map.centres[0].len());
        let inside = |v: f64, r: [f64; 2]| v >= r[0] && v <= r[1];
        let shown = inside(map.centres[0][i], across) && inside(map.centres[1][j], sideways);
        shown.then(|| 1e3 * map.rise(i, j))
    };
    let most = largest((0..map.columns.len()).filter_map(rise)).max(1e-3);
    if level {
        Scale::linear(ColourMap::Diverging, -most, most, "height [mm]".into())
    } else {
        Scale::linear(ColourMap::Sequential, 0.0, most, "height [mm]".into())
    }
}

/// A vertical section of the free surface.
pub(super) struct Profile {
    name: &'static str,
    title: String,
    /// The horizontal axis: `x` or `y`.
    axis: char,
    /// Position along the axis, height above the undisturbed surface at first and at the end [m]; of uneven
    /// ground above that over which it rises and falls.
    points: Vec<[f64; 3]>,
    /// The range of the axis that the chart shows [m].
    shown: [f64; 2],
    /// Whether heights and lengths are drawn to the same scale.
    true_scale: bool,
}

/// The profile along the tow in the mid-plane, and the cross-section of the rut behind the first body.
pub(super) fn profiles<R: Precision>(scene: &Scene<'_, R>, map: &HeightMap) -> Vec<Profile> {
    let Scene { case, state, .. } = *scene;
    let level = map.reference;
    let rise =
        |points: Vec<[f64; 3]>| points.into_iter().map(|p| [p[0], p[1] - level, p[2] - level]).collect();
    let first = case.touching().next();
    let y = first.map_or(0.5 * (map.edges[1][0] + map.edges[1][map.edges[1].len() - 1]), |(n, _)| {
        state.pose(n).position.y
    });
    let everything = [f64::NEG_INFINITY, f64::INFINITY];
    let fine = map.with_ground_left(0, scene.fine_zone(0));
    let along = Profile {
        name: "profile",
        title: format!("Free surface along the tow, y = {} m", digits(y)),
        axis: 'x',
        points: rise(map.along(y)),
        shown: if first.is_none() { everything } else { fine },
        true_scale: false,
    };
    if first.is_none() || case.domain.plane_strain {
        return vec![along];
    }
    let x = section_range(case, state);
    let (reach, middle) = (1.2 * fine_reach(case), state.grid_position.y);
    let across = Profile {
        name: "rut_section",
        title: format!("Free surface across the tow, x = {} … {} m", digits(x[0]), digits(x[1])),
        axis: 'y',
        points: rise(map.section(x[0], x[1])),
        shown: if reach > 0.0 { [middle - reach, middle + reach] } else { everything },
        true_scale: true,
    };
    vec![along, across]
}

impl Profile {
    /// Writes the profile as a table and as a chart.
    pub(super) fn write(&self, dir: &Inside) -> Result<(), OutputError> {
        let mut table = format!("{} [m],height [m]\n", self.axis);
        for point in &self.points {
            push_line(&mut table, &[point[0], point[2]]);
        }
        write_whole(&dir.join(format!("{}.csv", self.name)), table.as_bytes())?;
        write_whole(&dir.join(format!("{}.svg", self.name)), self.chart().svg().as_bytes())
    }

    fn chart(&self) -> Chart {
        let inside = |p: &&[f64; 3]| p[0] >= self.shown[0] && p[0] <= self.shown[1];
        let points: Vec<[f64; 3]> = self.points.iter().filter(inside).map(|p| p.map(|v| 1e3 * v)).collect();
        let is_level = points.iter().all(|p| p[1] == 0.0);
        let undisturbed = if is_level {
            [points.first(), points.last()].map(|p| [p.map_or(0.0, |p| p[0]), 0.0]).to_vec()
        } else {
            points.iter().map(|p| [p[0], p[1]]).collect()
        };
        let points: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[2]]).collect();
        Chart {
            title: self.title.clone(),
            x_label: format!("{} [mm]", self.axis),
            y_label: "height [mm]".to_owned(),
            true_scale: self.true_scale,
            with_zero: true,
            height: 250.0,
            curves: vec![
                Curve { name: "undisturbed".into(), points: undisturbed, colour: 6, stroke: Stroke::Dashed },
                Curve::solid("at the end", 5, points),
            ],
            ..Chart::default()
        }
    }
}

/// Where the cross-section is taken, along x [m].
fn section_range(case: &Case, state: &State<impl Precision>) -> [f64; 2] {
    let Some((n, described)) = case.touching().next() else {
        return [case.domain.low.x, case.domain.high.x];
    };
    let shape = described.solid();
    let length = shape.bounds().1.x - shape.bounds().0.x;
    let now = state.pose(n).position.x;
    let travel = now - described.position.x;
    // A body that has hardly moved has left no rut: the section is through the body itself.
    let behind = if travel.abs() > length { length * travel.signum() } else { 0.0 };
    let middle = now - behind;
    [middle - 0.25 * length, middle + 0.25 * length]
}

/// The outline of a solid seen from above: the convex hull of the points of its surface [m, body frame],
/// closed.
fn outline(points: &[DVec3], pose: &Pose) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = points.iter().map(|p| pose.point(*p)).map(|p| [p.x, p.y]).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut hull = half_hull(points.iter());
    hull.extend(half_hull(points.iter().rev()).into_iter().skip(1));
    hull
}

/// One side of the convex hull of points sorted along x.
fn half_hull<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> Vec<[f64; 2]> {
    let mut hull: Vec<[f64; 2]> = Vec::new();
    for &p in points {
        while let [.., a, b] = hull[..] {
            let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            if turn > 0.0 {
                break;
            }
            hull.pop();
        }
        hull.push(p);
    }
    hull
}
