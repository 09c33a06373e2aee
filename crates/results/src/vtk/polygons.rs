//! Surfaces: `.vtp`. The bodies where they are, and the free surface.

use super::file::{DataArray, Dataset};
use crate::fields::HeightMap;
use crate::files::{Inside, OutputError};
use crate::history::GroundColumn;
use geometry::Shape;
use glam::DVec3;
use mechanics::BodyState;

/// Writes a body's surface where it is, with the velocity of each point; of the whole body its reference
/// point [m], rotation from its own axes to those of space (a vector [rad]), velocity [m/s], angular velocity
/// [rad/s].
pub(super) fn write_body(
    file: &Inside,
    shape: &dyn Shape,
    body: &BodyState,
    time: f64,
) -> Result<(), OutputError> {
    let mesh = shape.mesh();
    let rotation = body.pose.axes();
    let arms: Vec<DVec3> = mesh.points.iter().map(|p| rotation * *p).collect();
    let velocities = arms.iter().flat_map(|arm| body.twist.at(*arm).to_array());
    let surface = Surface {
        points: arms.iter().map(|arm| body.pose.position + *arm),
        point_count: arms.len(),
        polygons: mesh.triangles.iter().map(|corners| corners.map(i64::from)),
        polygon_count: mesh.triangles.len(),
    };
    let facts = vec![
        ("reference_point", body.pose.position),
        ("rotation", body.pose.rotation.to_scaled_axis()),
        ("velocity", body.twist.linear),
        ("angular_velocity", body.twist.angular),
    ];
    surface.write(file, time, facts, vec![DataArray::singles("velocity", [arms.len(), 3], velocities)])
}

/// Writes the free surface, with its height over the undisturbed one.
pub(super) fn write_surface(file: &Inside, map: &HeightMap, time: f64) -> Result<(), OutputError> {
    let (columns, rows) = (map.centres[0].len(), map.centres[1].len());
    let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let quads = (1..rows).flat_map(|j| (1..columns).map(move |i| (i, j)));
    let corner = |i: usize, j: usize| (j * columns + i) as i64;
    let surface = Surface {
        points: places.map(|(i, j)| DVec3::new(map.centres[0][i], map.centres[1][j], map.at(i, j))),
        point_count: columns * rows,
        polygons: quads
            .map(|(i, j)| [corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)]),
        polygon_count: columns.saturating_sub(1) * rows.saturating_sub(1),
    };
    let array = |name: &'static str, value: fn(&GroundColumn) -> f64| {
        DataArray::singles(name, [map.columns.len(), 1], map.columns.iter().map(value))
    };
    let rise = (0..rows).flat_map(|j| (0..columns).map(move |i| map.rise(i, j)));
    let point_data = vec![
        array("height", |column| column.z),
        DataArray::singles("rise", [map.columns.len(), 1], rise),
        array("compaction", |column| column.compaction),
        array("disturbed", |column| column.disturbed),
        array("mixed", |column| column.mixed),
    ];
    surface.write(file, time, Vec::new(), point_data)
}

/// Polygons of N corners each.
struct Surface<P, F> {
    points: P,
    point_count: usize,
    polygons: F,
    polygon_count: usize,
}

impl<P: Iterator<Item = DVec3>, F: Iterator<Item = [i64; N]>, const N: usize> Surface<P, F> {
    fn write(
        self,
        file: &Inside,
        time: f64,
        facts: Vec<(&'static str, DVec3)>,
        point_data: Vec<DataArray>,
    ) -> Result<(), OutputError> {
        let (points, polygons) = (self.point_count, self.polygon_count);
        let coordinates = self.points.flat_map(|p| p.to_array());
        let ends = (1..=polygons).map(|n| (n * N) as i64);
        Dataset {
            kind: "PolyData",
            extent: String::new(),
            piece: format!(
                "NumberOfPoints=\"{points}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" \
                 NumberOfPolys=\"{polygons}\""
            ),
            time,
            facts,
            sections: vec![
                ("PointData", point_data),
                ("Points", vec![DataArray::doubles("Points", [points, 3], coordinates)]),
                (
                    "Polys",
                    vec![
                        DataArray::integers("connectivity", polygons * N, self.polygons.flatten()),
                        DataArray::integers("offsets", polygons, ends),
                    ],
                ),
            ],
        }
        .write(file)
    }
}
