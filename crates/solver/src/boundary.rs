//! What happens at the faces of the grid, and the symmetry that follows from it.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A face of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Boundary {
    /// A smooth wall: no motion through it, no friction along it.
    SmoothWall,
    /// A rough wall: no motion at all.
    RoughWall,
    /// A plane of symmetry: what lies beyond it mirrors what is modelled.
    Symmetry,
}

impl Boundary {
    /// Which velocity components vanish at a node on a face across `axis`.
    #[must_use]
    pub fn holds(self, axis: usize) -> [bool; 3] {
        match self {
            Self::SmoothWall | Self::Symmetry => std::array::from_fn(|component| component == axis),
            Self::RoughWall => [true; 3],
        }
    }
}

/// The faces of the grid by axis: at the low end and at the high end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Boundaries(pub [[Boundary; 2]; 3]);

impl Boundaries {
    /// Which velocity components no boundary holds at a node; `layer` is the node's layer along each axis in the whole grid,
    /// `last` the highest one.
    #[must_use]
    pub fn free_components(&self, layer: [usize; 3], last: [usize; 3]) -> [bool; 3] {
        let mut free = [true; 3];
        for axis in 0..3 {
            for (boundary, at) in self.0[axis].iter().zip([0, last[axis]]) {
                if layer[axis] == at {
                    for (component, _) in boundary.holds(axis).iter().enumerate().filter(|(_, held)| **held) {
                        free[component] = false;
                    }
                }
            }
        }
        free
    }

    /// The planes of symmetry among them.
    #[must_use]
    pub fn symmetry(&self) -> Symmetry {
        Symmetry { across: self.0.map(|pair| pair.contains(&Boundary::Symmetry)) }
    }
}

/// The planes of symmetry of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Symmetry {
    /// Whether there is one across x, y, z.
    pub across: [bool; 3],
}

impl Symmetry {
    /// Portion of the whole that is modelled.
    #[must_use]
    pub fn modelled_fraction(self) -> f64 {
        self.across.iter().map(|is_plane| if *is_plane { 0.5 } else { 1.0 }).product()
    }

    /// A vector of the whole, such as a force, from the sum over the modelled portion and its mirror images: components across
    /// a plane cancel.
    #[must_use]
    pub fn of_whole(self, sum: DVec3) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|axis| if self.across[axis] { 0.0 } else { sum[axis] }))
    }

    /// The same of a moment: components along a plane cancel, for a mirror turns them round.
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
        let free = |layer| boundaries.free_components(layer, [9, 5, 4]);
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
