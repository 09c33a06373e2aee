//! A face with any number of corners, as triangles.

use glam::{DVec2, DVec3};

/// Most corners of a face.
pub(super) const MOST_CORNERS: usize = 1000;
/// Distance of a face from its mean plane over its size beyond which it is not plane (chosen: what six digits
/// leave open, and a little).
const NOT_PLANE: f64 = 1e-4;

/// A face as triangles.
pub(super) struct Divided {
    pub(super) triangles: Vec<[u32; 3]>,
    /// How far the corners of the face lie from its mean plane [unit of the file], where that is more than
    /// rounding.
    pub(super) off_plane: Option<f64>,
}

/// The triangles of a face: all from one corner where none is folded over; otherwise its ears are cut off one
/// by one. Every corner stays, also one in the middle of an edge: other faces may end there. `Err` says what
/// is wrong with it.
pub(super) fn divided(corners: &[u32], points: &[DVec3]) -> Result<Divided, &'static str> {
    if corners.len() < 3 || corners.iter().any(|n| *n as usize >= points.len()) {
        return Err("has fewer than three corners");
    }
    let places: Vec<DVec3> = corners.iter().map(|n| points[*n as usize]).collect();
    let (normal, off_plane) = plane(&places);
    let found = fan(&places, normal).map_or_else(|| ears(&places, normal), Ok)?;
    let triangles = found.into_iter().map(|triangle| triangle.map(|n| corners[n])).collect();
    Ok(Divided { triangles, off_plane })
}

/// Normal of a face, as long as twice its area, and how far it is from plane.
fn plane(places: &[DVec3]) -> (DVec3, Option<f64>) {
    let first = places[0];
    let normal: DVec3 = places.windows(2).map(|ends| (ends[0] - first).cross(ends[1] - first)).sum();
    let Some(unit) = normal.try_normalize() else { return (normal, None) };
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    let most = |of: &dyn Fn(DVec3) -> f64| places.iter().map(|x| of(*x)).fold(0.0, f64::max);
    let off = most(&|x| unit.dot(x - middle).abs());
    let size = most(&|x| x.distance(middle));
    (normal, (places.len() > 3 && off > NOT_PLANE * size).then_some(off))
}

/// Triangles from the first corner with which none is folded over.
fn fan(places: &[DVec3], whole: DVec3) -> Option<Vec<[usize; 3]>> {
    let count = places.len();
    let at = |n: usize| places[n % count];
    let fan = |from: usize| (1..count - 1).map(move |n| [from, from + n, from + n + 1]);
    let is_even = |from: &usize| {
        let faces_out = |[a, b, c]: [usize; 3]| (at(b) - at(a)).cross(at(c) - at(a)).dot(whole) >= 0.0;
        count == 3 || fan(*from).all(faces_out)
    };
    let from = (0..count).find(is_even)?;
    Some(fan(from).map(|triangle| triangle.map(|n| n % count)).collect())
}

/// Twice the area of a triangle in the plane, positive where it is counter-clockwise.
fn area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Triangles by cutting off ears (Meisters 1975), the best shaped first.
fn ears(places: &[DVec3], normal: DVec3) -> Result<Vec<[usize; 3]>, &'static str> {
    const CROSSES: &str = "crosses itself";
    let Some(up) = normal.try_normalize() else { return Err("encloses no area") };
    let (across, along) = up.any_orthonormal_pair();
    // The pair is right-handed with the normal up to its sign.
    let along = along * up.dot(across.cross(along)).signum();
    let outline: Vec<DVec2> = places.iter().map(|x| DVec2::new(across.dot(*x), along.dot(*x))).collect();
    if crosses(&outline) {
        return Err(CROSSES);
    }
    let mut left: Vec<usize> = (0..outline.len()).collect();
    let mut quality: Vec<f64> = (0..left.len()).map(|n| ear(&outline, &left, n)).collect();
    let mut triangles = Vec::with_capacity(left.len() - 2);
    while left.len() > 3 {
        let best = (0..left.len()).fold(0, |a, b| if quality[b] > quality[a] { b } else { a });
        if quality[best] <= 0.0 {
            return Err(CROSSES);
        }
        triangles.push(around(&left, best));
        left.remove(best);
        quality.remove(best);
        for n in [(best + left.len() - 1) % left.len(), best % left.len()] {
            quality[n] = ear(&outline, &left, n);
        }
    }
    triangles.push([left[0], left[1], left[2]]);
    Ok(triangles)
}

/// The corner before one of those that are left, itself, and the one after it.
fn around(left: &[usize], n: usize) -> [usize; 3] {
    let count = left.len();
    [left[(n + count - 1) % count], left[n], left[(n + 1) % count]]
}

/// Area of the ear at a corner over the square of its longest side; 0 where there is none: at a corner that
/// is not convex, and where another one lies in the ear or on its edge.
fn ear(outline: &[DVec2], left: &[usize], n: usize) -> f64 {
    let [a, b, c] = around(left, n).map(|corner| outline[corner]);
    let longest = [b - a, c - b, a - c].map(DVec2::length_squared).into_iter().fold(0.0, f64::max);
    let quality = area([a, b, c]) / longest;
    if quality.is_nan() || quality <= 1e-12 {
        return 0.0;
    }
    let blocks = |other: usize| {
        let [before, x, after] = around(left, other).map(|corner| outline[corner]);
        // A hole is joined to the outline by an edge there and back: its ends come twice.
        if x == a || x == c {
            return false;
        }
        if x == b {
            let is_between = |y: DVec2| area([a, b, y]) > 0.0 && area([b, c, y]) > 0.0;
            return is_between(before) || is_between(after);
        }
        area([a, b, x]) >= 0.0 && area([b, c, x]) >= 0.0 && area([c, a, x]) >= 0.0
    };
    let count = left.len();
    let others = (2..count - 1).map(|step| (n + step) % count);
    if others.into_iter().any(blocks) { 0.0 } else { quality }
}

/// Whether an edge goes through another one.
fn crosses(outline: &[DVec2]) -> bool {
    let count = outline.len();
    let edge = |n: usize| [outline[n], outline[(n + 1) % count]];
    let cuts = |[a, b]: [DVec2; 2], [c, d]: [DVec2; 2]| {
        let apart = a.max(b).cmplt(c.min(d)).any() || c.max(d).cmplt(a.min(b)).any();
        !apart && area([a, b, c]) * area([a, b, d]) < 0.0 && area([c, d, a]) * area([c, d, b]) < 0.0
    };
    (0..count).any(|one| (one + 2..count).any(|other| cuts(edge(one), edge(other))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Area of the triangles of a face in the plane z = x/3, and of the outline.
    fn areas(outline: &[[f64; 2]]) -> Result<[f64; 2], &'static str> {
        let points: Vec<DVec3> = outline.iter().map(|[x, y]| DVec3::new(*x, *y, x / 3.0)).collect();
        let corners: Vec<u32> = (0..points.len() as u32).collect();
        let Divided { triangles, off_plane } = divided(&corners, &points)?;
        assert_eq!((triangles.len(), off_plane), (outline.len() - 2, None));
        let one = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|n| DVec2::from(outline[n as usize]));
            let area = 0.5 * area([a, b, c]);
            assert!(area >= 0.0, "{t:?}");
            area
        };
        let shoelace = (0..outline.len())
            .map(|n| DVec2::from(outline[n]).perp_dot(outline[(n + 1) % outline.len()].into()));
        // Every edge of the outline is one of a triangle.
        for n in 0..outline.len() as u32 {
            let ends = [n, (n + 1) % outline.len() as u32];
            let has = |t: &&[u32; 3]| (0..3).any(|m| [t[m], t[(m + 1) % 3]] == ends);
            assert_eq!(triangles.iter().filter(has).count(), 1, "{ends:?}");
        }
        Ok([triangles.iter().map(one).sum(), 0.5 * shoelace.sum::<f64>()])
    }

    #[track_caller]
    fn whole(outline: &[[f64; 2]]) {
        let [found, expected] = areas(outline).unwrap_or_else(|why| panic!("{why}: {outline:?}"));
        assert!((found / expected - 1.0).abs() < 1e-12, "{found}, not {expected}");
    }

    #[test]
    fn faces_of_any_outline_are_divided() {
        // A square, with corners in the middle of its edges, two of them on one.
        whole(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 1.5], [3.0, 3.0], [0.0, 3.0]]);
        // A comb, whose teeth no corner sees all.
        let mut comb = vec![[0.0, -1.0], [20.0, -1.0]];
        comb.extend((0..10).rev().flat_map(|n| {
            let x = 2.0 * f64::from(n);
            [[x + 1.0, 0.0], [x + 1.0, 5.0], [x, 5.0], [x, 0.0]]
        }));
        whole(&comb);
        // A star, and a spiral of three turns.
        let at = |angle: f64, r: f64| [r * angle.cos(), r * angle.sin()];
        let star = |n: u32| at(f64::from(n) * TAU / 200.0, if n.is_multiple_of(2) { 10.0 } else { 2.0 });
        whole(&(0..200).map(star).collect::<Vec<_>>());
        let turn = |n: u32| f64::from(n) * TAU / 40.0;
        let outer = (0..120).map(|n| at(turn(n), 1.0 + turn(n)));
        let inner = (0..120).rev().map(|n| at(turn(n), 0.5 + turn(n)));
        let spiral: Vec<_> = outer.chain(inner).collect();
        let [found, expected] = areas(&spiral).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12);
        // A plate with a hole, whose outline goes there and back on one edge.
        let plate = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
        let hole = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0]];
        whole(&[&plate[..], &hole].concat());
    }

    #[test]
    fn outlines_that_cross_themselves_are_refused() {
        let bow_tie = [[0.0, 0.0], [2.0, 1.0], [2.0, 0.0], [0.0, 1.5]];
        assert_eq!(areas(&bow_tie), Err("crosses itself"));
        let pentagram = [0, 2, 4, 1, 3]
            .map(|n| [0, 1].map(|m| (f64::from(n) * TAU / 5.0 - f64::from(m) * TAU / 4.0).cos()));
        assert_eq!(areas(&pentagram), Err("crosses itself"));
        let line = [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [2.0, 0.0]];
        assert!(areas(&line).is_err() || areas(&line).is_ok_and(|[found, _]| found == 0.0));
    }

    #[test]
    fn random_outlines_are_divided_or_refused() {
        let mut seed = 7_u64;
        // Knuth's linear congruential generator (1998), on a coarse lattice, so that corners coincide and lie
        // on edges.
        let mut random = |most: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) % most
        };
        let mut divided_ones = 0;
        for _ in 0..3000 {
            let count = 3 + random(9) as usize;
            let points: Vec<DVec3> =
                (0..count).map(|_| DVec3::new(random(6) as f64, random(6) as f64, 0.0)).collect();
            let corners: Vec<u32> = (0..count as u32).collect();
            if let Ok(found) = divided(&corners, &points) {
                assert_eq!(found.triangles.len(), count - 2);
                divided_ones += 1;
            }
        }
        assert!(divided_ones > 300, "{divided_ones}");
    }
}
