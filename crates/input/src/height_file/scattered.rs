//! Heights at points that lie on no grid, such as those of a survey: triangulated, and interpolated linearly
//! onto a grid.

use super::placement::{MOST_HEIGHTS, Raster};
use crate::data_file::{FileProblem, problem};
use crate::quantity::plain;
use spade::{DelaunayTriangulation, FloatTriangulation, HasPosition, Point2, Triangulation};

/// Lines of the grid over the mean distance of the points (chosen: a plane between three points then loses a
/// sixteenth of its rise at most).
const FINENESS: f64 = 2.0;
/// Most points: each gets four places of the grid.
const MOST_POINTS: usize = (MOST_HEIGHTS as f64 / (FINENESS * FINENESS)) as usize;
/// Fewest points of a surface.
const LEAST_POINTS: usize = 3;
/// Width of the squares that are searched for a point, over the mean distance of the points (chosen: of
/// points at random places a square in ten million is empty).
const SQUARE: f64 = 4.0;

struct Height {
    position: Point2<f64>,
    height: f64,
}

impl HasPosition for Height {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        self.position
    }
}

/// The heights on a grid over the largest part of a rectangle that the points surround, and what was done;
/// `line` is that of a point.
pub(super) fn gridded(
    points: &[[f64; 3]],
    line: impl Fn(usize) -> usize,
) -> Result<(Raster, String), FileProblem> {
    if points.len() > MOST_POINTS {
        let message = format!(
            "its {} points lie on no grid, and at most {MOST_POINTS} of such points are interpolated",
            points.len()
        );
        return problem(message, "cut out the part that the domain covers, or interpolate them onto a grid");
    }
    refuse_twins(points, line)?;
    let [low, high] = bounds(points);
    let size = [high[0] - low[0], high[1] - low[1]];
    let spacing = (size[0] * size[1] / points.len() as f64).sqrt();
    let flat = || {
        problem(
            format!("its {} points lie on no grid, and all on one line", points.len()),
            "give it points that surround the ground of the case",
        )
    };
    if spacing.is_nan() || spacing <= 1e-9 * size[0].max(size[1]) || points.len() < LEAST_POINTS {
        return flat();
    }
    // In distances of points from the middle: the triangulation wants no tiny numbers.
    let local = |value: f64, axis: usize| {
        let scaled = (value - 0.5 * (low[axis] + high[axis])) / spacing;
        if scaled.abs() < 1e-12 { 0.0 } else { scaled }
    };
    let height =
        |[x, y, z]: &[f64; 3]| Height { position: Point2::new(local(*x, 0), local(*y, 1)), height: *z };
    let Ok(surface) = DelaunayTriangulation::<Height>::bulk_load(points.iter().map(height).collect()) else {
        return flat();
    };
    let lines = [0, 1].map(|axis| {
        let steps = (FINENESS * size[axis] / spacing).ceil().max(1.0);
        (0..=steps as usize).map(|n| low[axis] + size[axis] * n as f64 / steps).collect::<Vec<f64>>()
    });
    let interpolation = surface.barycentric();
    let at = |x: f64, y: f64| {
        let place = Point2::new(local(x, 0), local(y, 1));
        interpolation.interpolate(|vertex| vertex.data().height, place).unwrap_or(f64::NAN)
    };
    let heights =
        lines[1].iter().flat_map(|y| lines[0].iter().map(|x| at(*x, *y)).collect::<Vec<_>>()).collect();
    let Some(raster) = surrounded(&Raster { lines, heights }) else { return flat() };
    let remark = report(points, spacing, &raster);
    Ok((raster, remark))
}

/// Refuses two points at one place.
fn refuse_twins(points: &[[f64; 3]], line: impl Fn(usize) -> usize) -> Result<(), FileProblem> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let place = |n: usize| [points[n][0], points[n][1]];
    order.sort_by(|a, b| place(*a)[0].total_cmp(&place(*b)[0]).then(place(*a)[1].total_cmp(&place(*b)[1])));
    match order.windows(2).find(|pair| place(pair[0]) == place(pair[1])) {
        Some(pair) => problem(
            format!("line {}: a second height at the same place", line(pair[0].max(pair[1]))),
            "give each place one height",
        ),
        None => Ok(()),
    }
}

fn bounds(points: &[[f64; 3]]) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for point in points {
        for axis in 0..2 {
            bounds[0][axis] = bounds[0][axis].min(point[axis]);
            bounds[1][axis] = bounds[1][axis].max(point[axis]);
        }
    }
    bounds
}

/// The part of a grid whose places all have a height: outer lines are cut off, always that which lacks most.
/// What has a height is convex, so that nothing inside lacks one where the outer lines are whole.
fn surrounded(raster: &Raster) -> Option<Raster> {
    let [columns, rows] = raster.lines.each_ref().map(Vec::len);
    let (mut x, mut y) = ([0, columns - 1], [0, rows - 1]);
    loop {
        let is_none = |column: usize, row: usize| raster.heights[row * columns + column].is_nan();
        let of_column = |column: usize| {
            (y[0]..=y[1]).filter(|row| is_none(column, *row)).count() as f64 / (y[1] - y[0] + 1) as f64
        };
        let of_row =
            |row: usize| (x[0]..=x[1]).filter(|n| is_none(*n, row)).count() as f64 / (x[1] - x[0] + 1) as f64;
        let lacking = [of_column(x[0]), of_column(x[1]), of_row(y[0]), of_row(y[1])];
        let most = lacking.iter().copied().fold(0.0, f64::max);
        if most == 0.0 {
            break;
        }
        match lacking.iter().position(|part| *part == most) {
            Some(0) => x[0] += 1,
            Some(1) => x[1] -= 1,
            Some(2) => y[0] += 1,
            _ => y[1] -= 1,
        }
        if x[0] >= x[1] || y[0] >= y[1] {
            return None;
        }
    }
    let lines = [raster.lines[0][x[0]..=x[1]].to_vec(), raster.lines[1][y[0]..=y[1]].to_vec()];
    let row = |row: usize| &raster.heights[row * columns + x[0]..=row * columns + x[1]];
    Some(Raster { lines, heights: (y[0]..=y[1]).flat_map(row).copied().collect() })
}

/// Reports what was done, and where points are missing.
fn report(points: &[[f64; 3]], spacing: f64, raster: &Raster) -> String {
    let ends = |axis: usize| {
        let line = &raster.lines[axis];
        [line[0], line[line.len() - 1]]
    };
    let [x, y] = [ends(0), ends(1)];
    let short = |length: f64| plain((length / spacing * 1e3).round() * spacing / 1e3);
    let mut report = format!(
        "its {} points lie on no grid: triangulated (Delaunay) and interpolated linearly onto {} × {} points over x = {} to {} m, y = {} to {} m, which they surround",
        points.len(),
        raster.lines[0].len(),
        raster.lines[1].len(),
        short(x[0]),
        short(x[1]),
        short(y[0]),
        short(y[1])
    );
    if let Some([x, y]) = gap(points, SQUARE * spacing, [x, y]) {
        report += &format!(
            "; there are gaps {} m wide and more without a point, such as at x = {} m, y = {} m, which triangles bridge",
            short(SQUARE * spacing),
            short(x),
            short(y)
        );
    }
    report
}

/// The middle of a square without any point.
fn gap(points: &[[f64; 3]], width: f64, ends: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let count = ends.map(|[low, high]| ((high - low) / width).floor() as usize);
    let mut is_hit = vec![false; count[0] * count[1]];
    for point in points {
        let square = [0, 1].map(|axis| (point[axis] - ends[axis][0]) / width);
        if square.iter().zip(count).all(|(n, count)| *n >= 0.0 && *n < count as f64) {
            is_hit[square[1] as usize * count[0] + square[0] as usize] = true;
        }
    }
    let empty = is_hit.iter().position(|is_hit| !is_hit)?;
    let middle = |axis: usize, n: usize| ends[axis][0] + width * (n as f64 + 0.5);
    Some([middle(0, empty % count[0]), middle(1, empty / count[0])])
}
