//! What happens at the faces of the grid, and the symmetry that follows from it.

use crate::grid::Grid;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A face of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Boundary {
    /// A smooth wall: no motion through it, no friction along it.
    SmoothWall,
    /// A rough wall: no motion at all.
    RoughWall,
    /// A plane of symmetry: what lies beyond it mirrors what is modelled.
    Symmetry,
    /// Undisturbed ground lies beyond the boundary, at rest under geostatic stress, and enters where the grid
    /// moves that way.
    Inflow,
    /// Soil leaves through the boundary where the grid moves the other way. What lies beyond is at rest and
    /// like the soil next to it.
    Outflow,
    /// Undisturbed ground lies beyond the boundary and bears what it bears at rest, however the soil moves:
    /// the face yields, soil leaves and ground enters. Every step the cells beyond start from their stress at
    /// rest, strained by the nodes of the face against others at rest, so that waves leave in part.
    ConstantStress,
    /// No boundary of the domain but a cut, beyond which lies another block.
    Halo,
}

impl Boundary {
    /// Which velocity components vanish at a node on a face across `axis`; at constant stress, at the nodes
    /// beyond it.
    #[must_use]
    pub fn holds(self, axis: usize) -> [bool; 3] {
        match self {
            Self::SmoothWall | Self::Symmetry => std::array::from_fn(|component| component == axis),
            Self::RoughWall | Self::Inflow | Self::Outflow | Self::ConstantStress => [true; 3],
            Self::Halo => [false; 3],
        }
    }

    /// Whether soil flows through the boundary, so that the grid has ghost layers beyond it.
    #[must_use]
    pub fn is_open(self) -> bool {
        matches!(self, Self::Inflow | Self::Outflow | Self::ConstantStress)
    }

    /// Whether undisturbed ground enters through the boundary.
    #[must_use]
    pub fn lets_ground_in(self) -> bool {
        matches!(self, Self::Inflow | Self::ConstantStress)
    }

    /// Whether nodes on the face move freely.
    #[must_use]
    pub fn yields(self) -> bool {
        matches!(self, Self::ConstantStress | Self::Halo)
    }
}

/// The faces of the grid by axis: at the low end and at the high end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Boundaries(pub [[Boundary; 2]; 3]);

impl Boundaries {
    /// Which faces are open, by axis at the low end and at the high end.
    #[must_use]
    pub fn open_faces(&self) -> [[bool; 2]; 3] {
        self.0.map(|pair| pair.map(Boundary::is_open))
    }

    /// What lies beyond the end of a block along `axis`, the low one (0) or the high one (1).
    #[must_use]
    pub fn of_block(&self, grid: &Grid, axis: usize, end: usize) -> Boundary {
        if grid.is_cut(axis, end) { Boundary::Halo } else { self.0[axis][end] }
    }

    /// Which velocity components no boundary holds at a node; `layer` is the node's layer along each axis in
    /// the whole grid.
    #[must_use]
    pub fn free_components(&self, grid: &Grid, layer: [usize; 3]) -> [bool; 3] {
        let mut free = [true; 3];
        for axis in 0..3 {
            let domain = &grid.domain[axis];
            let is_on = [layer[axis] == domain.start, layer[axis] == domain.end];
            let is_beyond = [layer[axis] < domain.start, layer[axis] > domain.end];
            for (end, boundary) in self.0[axis].iter().enumerate() {
                if is_beyond[end] || is_on[end] && !boundary.yields() {
                    for (component, _) in boundary.holds(axis).iter().enumerate().filter(|(_, held)| **held) {
                        free[component] = false;
                    }
                }
            }
        }
        free
    }

    /// Whether any boundary lets the nodes on it move against a constant stress.
    #[must_use]
    pub fn have_constant_stress(&self) -> bool {
        self.0.as_flattened().contains(&Boundary::ConstantStress)
    }

    /// Layers of cells of a block that are strained along `axis`: those of the domain, with the ghost layers
    /// of cuts, and the first layer beyond a boundary at constant stress.
    #[must_use]
    pub fn strained(&self, grid: &Grid, axis: usize) -> Range<usize> {
        let inside = grid.inside(axis);
        let more = [0, 1].map(|end| {
            let is_yielding = self.of_block(grid, axis, end) == Boundary::ConstantStress;
            usize::from(is_yielding && !grid.outside(axis, end).is_empty())
        });
        inside.start - more[0]..inside.end + more[1]
    }

    /// Whether a row of cells of the memory, `[q, plane]`, is strained in a block.
    #[must_use]
    pub fn strain_row(&self, grid: &Grid, [q, plane]: [usize; 2]) -> bool {
        let contains = |axis: usize, n: usize| n > 0 && self.strained(grid, axis).contains(&(n - 1));
        contains(1, q) && contains(2, plane)
    }

    /// The planes of symmetry among the boundaries.
    #[must_use]
    pub fn symmetry(&self) -> Symmetry {
        Symmetry { across: self.0.map(|pair| pair.contains(&Boundary::Symmetry)) }
    }
}

/// The planes of symmetry of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Symmetry {
    /// Whether there is a plane of symmetry across x, y, z.
    pub across: [bool; 3],
}

impl Symmetry {
    /// Portion of the whole that is modelled.
    #[must_use]
    pub fn modelled_fraction(self) -> f64 {
        self.across.iter().map(|is_plane| if *is_plane { 0.5 } else { 1.0 }).product()
    }

    /// A vector of the whole, such as a force, from the sum over the modelled portion and its mirror images:
    /// components across a plane cancel.
    #[must_use]
    pub fn of_whole(self, sum: DVec3) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|axis| if self.across[axis] { 0.0 } else { sum[axis] }))
    }

    /// A moment of the whole, from the sum over the modelled portion and its mirror images: components along
    /// a plane cancel, for a mirror turns them round.
    #[must_use]
    pub fn moment_of_whole(self, sum: DVec3) -> DVec3 {
        let cancels = |axis: usize| (0..3).any(|plane| plane != axis && self.across[plane]);
        DVec3::from_array(std::array::from_fn(|axis| if cancels(axis) { 0.0 } else { sum[axis] }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Boundary::{RoughWall, SmoothWall, Symmetry as Plane};

    #[test]
    fn nodes_are_held_by_what_they_lie_on() {
        let boundaries = Boundaries([[Plane, SmoothWall], [SmoothWall; 2], [RoughWall, SmoothWall]]);
        let faces = [10, 6, 5].map(|n| (0..n).map(f64::from).collect());
        let grid = Grid::new(faces);
        let free = |layer| boundaries.free_components(&grid, layer);
        assert_eq!(free([3, 2, 2]), [true; 3]);
        assert_eq!(free([0, 2, 2]), [false, true, true]);
        assert_eq!(free([9, 5, 4]), [false; 3]);
        assert_eq!(free([3, 2, 0]), [false; 3]);
    }

    #[test]
    fn of_a_quarter_the_force_is_along_the_line_where_the_planes_meet() {
        let boundaries = Boundaries([[Plane, SmoothWall], [Plane, SmoothWall], [RoughWall; 2]]);
        let symmetry = boundaries.symmetry();
        assert_eq!(symmetry.modelled_fraction(), 0.25);
        assert_eq!(symmetry.of_whole(DVec3::ONE), DVec3::Z);
        assert_eq!(symmetry.moment_of_whole(DVec3::ONE), DVec3::ZERO);
        let half = Symmetry { across: [false, true, false] };
        assert_eq!(half.moment_of_whole(DVec3::ONE), DVec3::Y);
    }
}
