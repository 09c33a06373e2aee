//! How far the ground of a case reaches: up to its highest surface, and as far as the grid goes.

use super::path::Paths;
use super::resolved::Case;
use solver::grid::GHOSTS;

impl Case {
    /// Height that no surface of the ground exceeds at the start [m].
    #[must_use]
    pub fn top_of_ground(&self) -> f64 {
        if self.is_even() {
            return self.ground.surface();
        }
        let heaps = self.soil_bodies.iter().map(|body| body.solver_body(0).bounds[1].z);
        let highest = self.ground.surface() + self.relief.of_solver().extremes(self.area())[1];
        heaps.fold(highest, f64::max)
    }

    /// Ends along x and y of the ground that the grid meets on its way, with the ghost layers in front of it
    /// [m].
    pub(crate) fn area(&self) -> [[f64; 2]; 2] {
        let travelled = Paths::of(self).of_grid();
        [0, 1].map(|axis| {
            let faces = &self.grid.faces[axis];
            let follows = self.grid.follow.is_some_and(|follow| follow.axes[axis]);
            let width = |n: usize| faces.get(n + 1).zip(faces.get(n)).map_or(0.0, |(high, low)| high - low);
            let ghosts = [0, faces.len().saturating_sub(2)]
                .map(|n| if follows { GHOSTS as f64 * width(n) } else { 0.0 });
            let (low, high) = (self.domain.low[axis], self.domain.high[axis]);
            [low + travelled[0][axis] - ghosts[0], high + travelled[1][axis] + ghosts[1]]
        })
    }
}
