//! The soil of a cell as it is shown.

use crate::domain::PlacedDomain;
use glam::DVec3;
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;

/// Cells with less soil than this are void: what they hold is rounding and is shown as nothing.
const VOID: f64 = 1e-6;
/// Nodes beside a cell with less soil than this lie at a surface: what alternates round them is not told from
/// what varies.
const WELL_FILLED: f64 = 0.5;
/// Cells with less soil than this have no density: in slivers mass over volume scatters by a factor of ten
/// and more.
const SLIVER: f64 = 0.01;

/// A cell as it is shown: SI units, pressure positive in compression; all zero where it is void.
pub struct CellView<'a, R> {
    domain: &'a PlacedDomain<'a>,
    state: &'a State<R>,
    at: [usize; 3],
    index: usize,
    /// Volume fraction of the soil.
    pub fraction: f64,
}

impl<'a, R: Precision> CellView<'a, R> {
    /// Cell `(i, j, k)` of the domain.
    pub fn of(domain: &'a PlacedDomain<'a>, state: &'a State<R>, at: [usize; 3]) -> Self {
        let index = domain.index(at);
        let fraction = state.soil.fraction[index].into();
        Self { domain, state, at, index, fraction: if fraction < VOID { 0.0 } else { fraction } }
    }

    fn is_void(&self) -> bool {
        self.fraction == 0.0
    }

    fn unless_void(&self, value: R) -> f64 {
        if self.is_void() { 0.0 } else { value.into() }
    }

    /// Mean velocity of the nodes of the cell [m/s]. Nodes without mass do not move and do not count.
    pub fn velocity(&self) -> DVec3 {
        if self.is_void() {
            return DVec3::ZERO;
        }
        let ([dx, dy, dz], n) = (self.domain.grid.stride, self.index);
        let corners = [0, dx, dy, dx + dy, dz, dx + dz, dy + dz, dx + dy + dz].map(|offset| n + offset);
        let mut sum = DVec3::ZERO;
        let mut count = 0.0;
        for node in corners.into_iter().filter(|&node| self.state.nodes.mass[node].into() > 0.0) {
            sum += node_velocity(self.state, node);
            count += 1.0;
        }
        if count > 0.0 { sum / count } else { DVec3::ZERO }
    }

    /// Stress xx, yy, zz, xy, yz, xz [Pa], tension positive, without what alternates from cell to cell along
    /// two or three axes: that exerts no force on any node, and says nothing of the soil. Stress that varies
    /// linearly stays as it is.
    pub(crate) fn stress(&self) -> [f64; 6] {
        if self.is_void() {
            return [0.0; 6];
        }
        let mut sum = [0.0; 6];
        for node in 0..8 {
            let shares = self.shares(node);
            for (cell, share) in shares.into_iter().flatten() {
                for (sum, component) in sum.iter_mut().zip(&self.state.soil.stress) {
                    *sum += 0.125 * share * component[cell].into();
                }
            }
        }
        sum
    }

    /// The part of the stresses of the cells round one of its nodes that is constant or linear there, in this
    /// cell: the cells with their shares; its own stress alone where one of them holds little soil. Bit
    /// `axis` of the node is set at the high end.
    fn shares(&self, node: usize) -> [Option<(usize, f64)>; 8] {
        let grid = self.domain.grid;
        let cells = self.domain.cells();
        let is_flat = |axis: usize| grid.whole_cells()[axis] == 1;
        let axes = (0..3).filter(|axis| !is_flat(*axis)).count() as f64;
        // Beyond the end of the domain lies the mirror image of the cell.
        let step = |axis: usize| -> isize {
            let (is_high, stride) = (node >> axis & 1 == 1, grid.stride[axis].cast_signed());
            let is_last = self.at[axis] == if is_high { cells[axis] - 1 } else { 0 };
            if is_last && self.domain.reaches(axis, usize::from(is_high)) {
                0
            } else if is_high {
                stride
            } else {
                -stride
            }
        };
        let steps = [0, 1, 2].map(step);
        let mut shares = [None; 8];
        for (n, share) in shares.iter_mut().enumerate() {
            let beyond = (0..3).filter(|axis| n >> axis & 1 == 1);
            if beyond.clone().any(is_flat) {
                continue;
            }
            let cell = self.index.wrapping_add_signed(beyond.clone().map(|axis| steps[axis]).sum());
            if self.state.soil.fraction[cell].into() < WELL_FILLED {
                let mut own = [None; 8];
                own[0] = Some((self.index, 1.0));
                return own;
            }
            *share = Some((cell, (1.0 + axes - 2.0 * beyond.count() as f64) / axes.exp2()));
        }
        shares
    }

    /// Mean pressure, positive in compression [Pa].
    pub fn pressure(&self) -> f64 {
        let [xx, yy, zz, ..] = self.stress();
        0.0 - (xx + yy + zz) / 3.0
    }

    /// Von Mises stress [Pa].
    pub(crate) fn mises(&self) -> f64 {
        let [xx, yy, zz, xy, yz, xz] = self.stress();
        let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
        (0.5 * normal + 3.0 * (xy * xy + yz * yz + xz * xz)).sqrt()
    }

    /// Mass of soil over volume of soil [kg/m³]; not-a-number in void and slivers.
    pub(crate) fn density(&self) -> f64 {
        if self.fraction < SLIVER {
            return f64::NAN;
        }
        self.state.soil.mass[self.index].into() / (self.fraction * self.domain.volume(self.at))
    }

    /// Value of history variable number `n` in the order of the table, in its unit.
    pub fn history(&self, n: usize) -> f64 {
        self.unless_void(self.state.soil.history[n][self.index])
    }
}

/// Velocity of a node [m/s].
pub fn node_velocity(state: &State<impl Precision>, node: usize) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|axis| state.nodes.velocity[axis][node].into()))
}

/// Mean pressure of all cells as it is written and drawn [Pa], compression positive, x fastest, then y; zero
/// where a cell is void.
#[must_use]
pub fn shown_pressure<R: Precision>(grid: &Grid, state: &State<R>) -> Vec<f64> {
    let domain = PlacedDomain::of(grid, state.grid_position);
    let [columns, rows, layers] = domain.cells();
    let each = (0..layers).flat_map(|k| (0..rows).flat_map(move |j| (0..columns).map(move |i| [i, j, k])));
    each.map(|at| CellView::of(&domain, state, at).pressure()).collect()
}

/// Number of cells with soil.
pub fn filled_cells(domain: &PlacedDomain, state: &State<impl Precision>) -> u64 {
    domain.indices().filter(|&cell| state.soil.fraction[cell].into() > VOID).count() as u64
}
