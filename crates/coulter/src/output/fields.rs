//! What goes into the field files: the soil's cells, the bodies' surfaces, the free surface.

use super::error::OutputError;
use super::surface::HeightMap;
use super::vtk::{Appended, Dataset};
use glam::DVec3;
use mechanics::BodyState;
use physics::shape::Shape;
use solver::fields::{HISTORY, HISTORY_COUNT};
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;
use std::path::Path;

/// Cells with less soil than this are void: what they hold is rounding and is shown as nothing.
pub(super) const VOID: f64 = 1e-6;
/// Cells with less soil than this have no density: in slivers mass over volume scatters by a factor of ten and more.
const SLIVER: f64 = 0.01;

/// Values of one cell as they are shown: SI units, pressure positive in compression.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct CellView {
    pub(super) fraction: f64,
    pub(super) velocity: DVec3,
    pub(super) stress: [f64; 6],
    /// Mass of soil over volume of soil [kg/m³]; not-a-number in void and slivers.
    pub(super) density: f64,
    /// History variables, in the order of their table.
    pub(super) history: [f64; HISTORY_COUNT],
}

impl CellView {
    /// What cell `(i, j, k)` holds.
    pub(super) fn of(grid: &Grid, state: &State<impl Precision>, [i, j, k]: [usize; 3]) -> Self {
        let n = grid.index(i, j, k);
        let soil = &state.soil;
        let fraction = soil.fraction[n].into();
        if fraction < VOID {
            return Self { density: f64::NAN, ..Self::default() };
        }
        let density = soil.mass[n].into() / (fraction * grid.volume(i, j, k));
        Self {
            fraction,
            velocity: cell_velocity(grid, state, n),
            stress: std::array::from_fn(|c| soil.stress[c][n].into()),
            density: if fraction < SLIVER { f64::NAN } else { density },
            history: std::array::from_fn(|h| soil.history[h][n].into()),
        }
    }

    /// Mean pressure, positive in compression [Pa].
    pub(super) fn pressure(&self) -> f64 {
        0.0 - (self.stress[0] + self.stress[1] + self.stress[2]) / 3.0
    }

    /// Von Mises stress [Pa].
    pub(super) fn mises(&self) -> f64 {
        let [xx, yy, zz, xy, yz, xz] = self.stress;
        let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
        (0.5 * normal + 3.0 * (xy * xy + yz * yz + xz * xz)).sqrt()
    }
}

/// Mean velocity of a cell's nodes [m/s]. Nodes without mass do not move and do not count.
fn cell_velocity(grid: &Grid, state: &State<impl Precision>, n: usize) -> DVec3 {
    let [dx, dy, dz] = grid.stride;
    let corners = [0, dx, dy, dx + dy, dz, dx + dz, dy + dz, dx + dy + dz].map(|offset| n + offset);
    let mut sum = DVec3::ZERO;
    let mut count = 0.0;
    for node in corners.into_iter().filter(|&node| state.nodes.mass[node].into() > 0.0) {
        sum += node_velocity(state, node);
        count += 1.0;
    }
    if count > 0.0 { sum / count } else { DVec3::ZERO }
}

fn node_velocity(state: &State<impl Precision>, node: usize) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|axis| state.nodes.velocity[axis][node].into()))
}

fn each_place([columns, rows, layers]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..layers).flat_map(move |k| (0..rows).flat_map(move |j| (0..columns).map(move |i| [i, j, k])))
}

/// Writes the soil: `.vtr`.
pub(super) fn write_soil(path: &Path, grid: &Grid, state: &State<impl Precision>) -> Result<(), OutputError> {
    let mut data = Appended::default();
    let mut set = Dataset::default();
    let cells: Vec<CellView> = each_place(grid.cells()).map(|at| CellView::of(grid, state, at)).collect();
    let point_velocity = each_place(grid.cells().map(|n| n + 1))
        .flat_map(|[i, j, k]| node_velocity(state, grid.index(i, j, k)).to_array());
    set.section("PointData", &[data.floats("velocity", 3, point_velocity)]);
    let mut arrays = vec![
        data.floats("evf", 1, cells.iter().map(|c| c.fraction)),
        data.floats("velocity", 3, cells.iter().flat_map(|c| c.velocity.to_array())),
        data.floats("stress", 6, cells.iter().flat_map(|c| c.stress)),
        data.floats("pressure", 1, cells.iter().map(CellView::pressure)),
        data.floats("mises", 1, cells.iter().map(CellView::mises)),
        data.floats("density", 1, cells.iter().map(|c| c.density)),
    ];
    for (n, variable) in HISTORY.iter().enumerate() {
        arrays.push(data.floats(variable.name, 1, cells.iter().map(|c| c.history[n])));
    }
    set.section("CellData", &arrays);
    let axes = ["x", "y", "z"].iter().zip(&grid.faces);
    let tags: Vec<String> = axes.map(|(name, faces)| data.doubles(name, 1, faces.iter().copied())).collect();
    set.section("Coordinates", &tags);
    let [x, y, z] = grid.cells();
    set.extent = format!(" WholeExtent=\"0 {x} 0 {y} 0 {z}\"");
    set.piece = format!("Extent=\"0 {x} 0 {y} 0 {z}\"");
    data.write(path, "RectilinearGrid", state.time, &set)
}

/// Writes a body's surface where it is: `.vtp`, with the velocity of each point.
pub(super) fn write_body(
    path: &Path,
    shape: &dyn Shape,
    body: &BodyState,
    time: f64,
) -> Result<(), OutputError> {
    let mesh = shape.mesh();
    let rotation = body.pose.axes();
    let arms: Vec<DVec3> = mesh.points.iter().map(|p| rotation * *p).collect();
    let points: Vec<DVec3> = arms.iter().map(|arm| body.pose.position + *arm).collect();
    let velocity: Vec<DVec3> = arms.iter().map(|arm| body.twist.at(*arm)).collect();
    let polygons = mesh.triangles.iter().map(|t| t.map(i64::from).to_vec()).collect();
    write_polygons(path, time, &Polygons { points, polygons }, |data| {
        vec![data.floats("velocity", 3, velocity.iter().flat_map(|v| v.to_array()))]
    })
}

/// Writes the free surface: `.vtp`, with its height over the undisturbed one.
pub(super) fn write_surface(path: &Path, map: &HeightMap, time: f64) -> Result<(), OutputError> {
    let (columns, rows) = (map.centres[0].len(), map.centres[1].len());
    let indices = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let points =
        indices.map(|(i, j)| DVec3::new(map.centres[0][i], map.centres[1][j], map.at(i, j))).collect();
    let quads = (1..rows).flat_map(|j| (1..columns).map(move |i| (i, j)));
    let polygons = quads
        .map(|(i, j)| {
            let corner = |i: usize, j: usize| (j * columns + i) as i64;
            vec![corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)]
        })
        .collect();
    write_polygons(path, time, &Polygons { points, polygons }, |data| {
        vec![
            data.floats("height", 1, map.height.iter().copied()),
            data.floats("rise", 1, map.height.iter().map(|z| z - map.reference)),
        ]
    })
}

struct Polygons {
    points: Vec<DVec3>,
    polygons: Vec<Vec<i64>>,
}

fn write_polygons(
    path: &Path,
    time: f64,
    mesh: &Polygons,
    point_data: impl FnOnce(&mut Appended) -> Vec<String>,
) -> Result<(), OutputError> {
    let mut data = Appended::default();
    let mut set = Dataset::default();
    let tags = point_data(&mut data);
    set.section("PointData", &tags);
    let coordinates = mesh.points.iter().flat_map(|p| p.to_array());
    set.section("Points", &[data.doubles("Points", 3, coordinates)]);
    let ends = mesh.polygons.iter().scan(0, |end, polygon| {
        *end += polygon.len() as i64;
        Some(*end)
    });
    let connectivity = data.integers("connectivity", mesh.polygons.iter().flatten().copied());
    set.section("Polys", &[connectivity, data.integers("offsets", ends)]);
    set.piece = format!(
        "NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\"",
        mesh.points.len(),
        mesh.polygons.len()
    );
    data.write(path, "PolyData", time, &set)
}
