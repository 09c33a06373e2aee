//! Facets and sharp edges of a triangle mesh.

use super::edges::{Side, by_edge, sides};
use super::mesh::Mesh;
use glam::DVec3;

/// Cosine of the angle between the normals of two triangles beyond which their common edge is sharp: 25°.
pub(super) const SHARP: f64 = 0.906;

/// A mesh divided at its sharp edges.
#[derive(Debug)]
pub(super) struct Facets {
    /// Number of the facet of each triangle.
    pub(super) of: Vec<usize>,
    /// Unit normal of each facet that is flat.
    pub(super) normal: Vec<Option<DVec3>>,
    /// Sharp convex edges of each facet, by their ends [m].
    pub(super) convex: Vec<Vec<[DVec3; 2]>>,
}

/// Outward unit normal of each triangle; zero for one without area.
pub(super) fn normals(mesh: &Mesh) -> Vec<DVec3> {
    let normal = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|n| mesh.points[n as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    };
    mesh.triangles.iter().map(normal).collect()
}

impl Facets {
    /// The facets of a mesh whose triangles share their points.
    pub(super) fn new(mesh: &Mesh, normals: &[DVec3]) -> Self {
        let sides = sides(&mesh.triangles);
        let mut parent: Vec<usize> = (0..normals.len()).collect();
        for edge in by_edge(&sides) {
            if let [one, other] = edge
                && let [one, other] = [one, other].map(|side| side.triangle as usize)
                && normals[one].dot(normals[other]) > SHARP
            {
                let (one, other) = (root(&mut parent, one), root(&mut parent, other));
                parent[one.max(other)] = one.min(other);
            }
        }
        // A facet is numbered where its first triangle comes.
        let (mut of, mut facets) = (vec![0; normals.len()], 0);
        for triangle in 0..normals.len() {
            let root = root(&mut parent, triangle);
            of[triangle] = if root == triangle { facets } else { of[root] };
            facets += usize::from(root == triangle);
        }
        let convex = convex(mesh, normals, &of, facets, &sides);
        Self { normal: flat(normals, &of, facets), of, convex }
    }
}

/// The first triangle of the facet to which a triangle belongs.
fn root(parent: &mut [usize], triangle: usize) -> usize {
    let mut root = triangle;
    while parent[root] != root {
        parent[root] = parent[parent[root]];
        root = parent[root];
    }
    root
}

/// Sharp edges at which the surface is convex. One that does not join two triangles counts as such.
fn convex(
    mesh: &Mesh,
    normals: &[DVec3],
    of: &[usize],
    facets: usize,
    sides: &[Side],
) -> Vec<Vec<[DVec3; 2]>> {
    let mut convex = vec![Vec::new(); facets];
    for edge in by_edge(sides) {
        let ends = [edge[0].low, edge[0].high].map(|n| mesh.points[n as usize]);
        if let [one, other] = edge {
            let [first, second] = [one, other].map(|side| normals[side.triangle as usize]);
            let opposite = mesh.triangles[other.triangle as usize][(usize::from(other.corner) + 2) % 3];
            let is_sharp = first.dot(second) <= SHARP;
            let beyond = mesh.points[opposite as usize] - ends[0];
            if !is_sharp || first.dot(beyond) >= 0.0 {
                continue;
            }
        }
        for side in edge {
            convex[of[side.triangle as usize]].push(ends);
        }
    }
    convex
}

/// The normal that all triangles of a facet have in common.
fn flat(normals: &[DVec3], of: &[usize], facets: usize) -> Vec<Option<DVec3>> {
    let mut common = vec![None; facets];
    let mut is_flat = vec![true; facets];
    for (normal, facet) in normals.iter().zip(of).filter(|(normal, _)| **normal != DVec3::ZERO) {
        let first = *common[*facet].get_or_insert(*normal);
        is_flat[*facet] &= first.distance(*normal) < 1e-9;
    }
    common.into_iter().zip(is_flat).map(|(normal, flat)| normal.filter(|_| flat)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Block, Disc, Shape, Sphere};

    fn facets(shape: &dyn Shape) -> Facets {
        let mesh = shape.mesh();
        Facets::new(&mesh, &normals(&mesh))
    }

    #[test]
    fn edges_are_sharp_where_the_shape_is() {
        let block = facets(&Block { size: DVec3::new(0.3, 0.2, 0.1) });
        assert_eq!(block.normal.len(), 6);
        assert!(
            block.normal.iter().all(Option::is_some) && block.convex.iter().all(|edges| edges.len() == 4)
        );
        let disc = facets(&Disc { diameter: 0.2, thickness: 0.05 });
        let flat = disc.normal.iter().flatten().count();
        assert_eq!((disc.normal.len(), flat), (3, 2));
        let sphere = facets(&Sphere { diameter: 0.2 });
        assert_eq!((sphere.normal.len(), sphere.convex[0].len()), (1, 0));
    }

    #[test]
    fn a_notch_has_concave_edges() {
        // Two faces of a right-angled trough, open at their other edges.
        let points = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 1.0], [-1.0, 0.0, 1.0]].map(DVec3::from);
        let mesh = Mesh { points: points.to_vec(), triangles: vec![[0, 2, 1], [0, 1, 3]] };
        let notch = Facets::new(&mesh, &normals(&mesh));
        assert_eq!(notch.of, [0, 1]);
        let along_y = |ends: &[DVec3; 2]| ends.iter().all(|x| x.x == 0.0 && x.z == 0.0);
        assert!(!notch.convex.iter().flatten().any(along_y), "{notch:?}");
        assert_eq!(notch.convex[0].len(), 2);
    }
}
