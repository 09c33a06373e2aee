//! A bounding-volume hierarchy of triangles: a binary tree of boxes along the axes, in which the nearest
//! triangle, those that a ray meets and those in a box are found in about the logarithm of their number.

use glam::DVec3;
use std::cell::Cell;

/// Most triangles in a leaf.
const LEAF: usize = 4;
/// Entries of the stacks: the tree is balanced, and no deeper than the logarithm of 2³² triangles.
const STACK: usize = 64;

/// A box round all triangles below a node.
#[derive(Clone, Copy, Debug)]
struct Node {
    low: DVec3,
    high: DVec3,
    /// First triangle of a leaf; of any other node the number of its second child, while the first child
    /// follows the node.
    first: u32,
    /// Number of triangles of a leaf, otherwise 0.
    count: u32,
}

impl Node {
    fn distance_squared(&self, x: DVec3) -> f64 {
        (self.low - x).max(x - self.high).max(DVec3::ZERO).length_squared()
    }

    fn middle_distance_squared(&self, x: DVec3) -> f64 {
        (0.5 * (self.low + self.high)).distance_squared(x)
    }
}

/// The tree, and the triangles in its order.
#[derive(Debug)]
pub(super) struct Hierarchy {
    nodes: Vec<Node>,
    /// Corners of the triangles [m].
    pub(super) corners: Vec<[DVec3; 3]>,
}

impl Hierarchy {
    /// The tree of these triangles, and the number of each triangle of the tree in the list that was given.
    pub(super) fn new(triangles: &[[DVec3; 3]]) -> (Self, Vec<u32>) {
        let centres: Vec<DVec3> = triangles.iter().map(|[a, b, c]| (*a + *b + *c) / 3.0).collect();
        let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
        let mut nodes = Vec::with_capacity(triangles.len());
        if !triangles.is_empty() {
            split(&mut nodes, triangles, &centres, &mut order, 0);
        }
        let corners = order.iter().map(|n| triangles[*n as usize]).collect();
        (Self { nodes, corners }, order)
    }

    /// Visits triangles that may be nearer to a point than the square of a distance [m²];
    /// `visit(triangle, squared)` returns the squared distance that is left.
    pub(super) fn nearest(&self, x: DVec3, mut least: f64, mut visit: impl FnMut(usize, f64) -> f64) {
        let mut stack = [(0_u32, 0.0_f64); STACK];
        let mut height = usize::from(!self.nodes.is_empty());
        while height > 0 {
            height -= 1;
            let (mut number, at) = stack[height];
            if at >= least {
                continue;
            }
            // Down to a leaf on the nearer side; the other one waits on the stack.
            loop {
                let node = &self.nodes[number as usize];
                if node.count > 0 {
                    for triangle in node.first..node.first + node.count {
                        least = visit(triangle as usize, least);
                    }
                    break;
                }
                let children = [number + 1, node.first];
                let squared = children.map(|child| self.nodes[child as usize].distance_squared(x));
                // Above a flat face all boxes are as near as the face: then those whose middle is nearer.
                let middles = || children.map(|child| self.nodes[child as usize].middle_distance_squared(x));
                let near = match squared {
                    [one, other] if one == other => usize::from(middles()[1] < middles()[0]),
                    [one, other] => usize::from(other < one),
                };
                if squared[1 - near] < least {
                    stack[height] = (children[1 - near], squared[1 - near]);
                    height += 1;
                }
                if squared[near] >= least {
                    break;
                }
                number = children[near];
            }
        }
    }

    /// Visits the triangles whose leaf passes a test of its box, and those above it too.
    fn visit(&self, passes: impl Fn(DVec3, DVec3) -> bool, mut each: impl FnMut(usize) -> bool) {
        let mut stack = [0_u32; STACK];
        let mut height = usize::from(!self.nodes.is_empty());
        while height > 0 {
            height -= 1;
            let number = stack[height];
            let node = &self.nodes[number as usize];
            if !passes(node.low, node.high) {
                continue;
            }
            if node.count == 0 {
                (stack[height], stack[height + 1]) = (node.first, number + 1);
                height += 2;
            } else if !(node.first..node.first + node.count).all(|triangle| each(triangle as usize)) {
                return;
            }
        }
    }

    /// Visits the triangles near a box, until `each` returns false.
    pub(super) fn in_box(&self, low: DVec3, high: DVec3, each: impl FnMut(usize) -> bool) {
        self.visit(|a, b| a.cmple(high).all() && b.cmpge(low).all(), each);
    }

    /// Visits the triangles near a ray from a point, until `each` returns false.
    pub(super) fn along(&self, from: DVec3, direction: DVec3, each: impl FnMut(usize) -> bool) {
        let inverse = direction.recip();
        let meets = |low: DVec3, high: DVec3| {
            let (one, other) = ((low - from) * inverse, (high - from) * inverse);
            let (enters, leaves) = (one.min(other).max_element(), one.max(other).min_element());
            enters <= leaves && leaves >= 0.0
        };
        self.visit(meets, each);
    }

    /// Visits triangles near a ray from a point, as far as what `visit` returned last, in lengths of the
    /// direction.
    pub(super) fn first_along(&self, from: DVec3, direction: DVec3, mut visit: impl FnMut(usize) -> f64) {
        let inverse = direction.recip();
        let farthest = Cell::new(f64::INFINITY);
        let meets = |low: DVec3, high: DVec3| {
            let (one, other) = ((low - from) * inverse, (high - from) * inverse);
            let (enters, leaves) = (one.min(other).max_element(), one.max(other).min_element());
            enters <= leaves && leaves >= 0.0 && enters <= farthest.get()
        };
        self.visit(meets, |triangle| {
            farthest.set(visit(triangle));
            true
        });
    }

    /// Largest coordinate along a direction [m].
    pub(super) fn extent(&self, direction: DVec3) -> f64 {
        let most = |node: &Node| (direction * node.low).max(direction * node.high).element_sum();
        let mut farthest = f64::NEG_INFINITY;
        let mut stack = [0_u32; STACK];
        let mut height = usize::from(!self.nodes.is_empty());
        while height > 0 {
            height -= 1;
            let number = stack[height];
            let node = &self.nodes[number as usize];
            if most(node) <= farthest {
                continue;
            }
            if node.count == 0 {
                let mut children = [number + 1, node.first];
                if most(&self.nodes[children[0] as usize]) > most(&self.nodes[children[1] as usize]) {
                    children.swap(0, 1);
                }
                [stack[height], stack[height + 1]] = children;
                height += 2;
            } else {
                for corners in &self.corners[node.first as usize..(node.first + node.count) as usize] {
                    farthest = corners.iter().map(|x| direction.dot(*x)).fold(farthest, f64::max);
                }
            }
        }
        farthest
    }
}

/// Appends the tree of the triangles in a part of the order, whose first has this number.
fn split(
    nodes: &mut Vec<Node>,
    triangles: &[[DVec3; 3]],
    centres: &[DVec3],
    order: &mut [u32],
    first: usize,
) {
    let corners = order.iter().flat_map(|n| triangles[*n as usize]);
    let (low, high) = bounds(corners);
    let number = nodes.len();
    if order.len() <= LEAF {
        nodes.push(Node { low, high, first: first as u32, count: order.len() as u32 });
        return;
    }
    nodes.push(Node { low, high, first: 0, count: 0 });
    let (low, high) = bounds(order.iter().map(|n| centres[*n as usize]));
    let axis = (high - low).max_position();
    let middle = order.len() / 2;
    // Equal coordinates in the order of the list, so that the tree depends on nothing but the triangles.
    let along = |n: &u32| centres[*n as usize][axis];
    order.select_nth_unstable_by(middle, |a, b| along(a).total_cmp(&along(b)).then(a.cmp(b)));
    let (one, other) = order.split_at_mut(middle);
    split(nodes, triangles, centres, one, first);
    nodes[number].first = nodes.len() as u32;
    split(nodes, triangles, centres, other, first + middle);
}

/// Low and high corner of the box round some points [m].
pub(super) fn bounds(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points.fold(empty, |(low, high), x| (low.min(x), high.max(x)))
}
