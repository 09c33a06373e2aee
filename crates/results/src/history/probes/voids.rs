//! The probe of voids: empty space under soil that rests on nothing.
//!
//! Soil without cohesion falls into a void; where it does not, cells that are filled in part bear stress.
//! Soil that is carried by a body, that has the cohesion to bridge a cell, or that is still falling is left
//! out.

use crate::domain::PlacedDomain;
use crate::ground_column::{GroundColumn, downwards};
use case::Case;
use case::resolved::{Law, Soil};
use glam::DVec3;
use solver::exact_sum::{ExactSum, over_blocks};
use solver::fields::PLASTIC_STRAIN;
use solver::halo::Halo;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// Height of soil over a void, in cells, from which on it counts: less is the free surface, which lies
/// anywhere in its cell (chosen).
const COVER: f64 = 0.7;
/// Volume fraction below which a cell under soil holds a void: soil that has been remapped is fuller than
/// that (chosen).
const FULL: f64 = 0.9;
/// Height of a fall, in cells, of which soil at rest has less than the speed (chosen).
const REST: f64 = 0.01;

/// Volume of the voids under resting soil over the volume of disturbed soil, at this time; 0 where no soil is
/// disturbed.
pub(super) fn sample<R: Precision>(case: &Case, model: &Model, state: &State<R>, halo: &Halo) -> f64 {
    let domain = PlacedDomain::of(&model.grid, state.grid_position);
    let width = case.grid.fine_cell();
    let falls: Vec<bool> = case.soils().map(|(_, soil)| falls(soil, width.x.min(width.y))).collect();
    if model.soil_gravity <= 0.0 || !falls.contains(&true) {
        return 0.0;
    }
    let view = View { domain: &domain, model, state, falls };
    let [columns, rows, _] = domain.cells();
    let (mut void, mut disturbed) = (ExactSum::default(), ExactSum::default());
    downwards(halo, vec![[0.0]; columns * rows], |covers| {
        for (n, [cover]) in covers.iter_mut().enumerate() {
            let sums = view.descend([n % columns, n / columns], cover);
            void.add(sums[0]);
            disturbed.add(sums[1]);
        }
    });
    let [void, disturbed] = over_blocks(halo, [void, disturbed]);
    if disturbed > 0.0 { void / disturbed } else { 0.0 }
}

/// Whether soil falls into a void as wide as a cell: its cohesion on both sides bears less than its weight, 2
/// c < γ b (Terzaghi 1943, the yielding strip, without friction, since at a free face nothing presses).
fn falls(soil: &Soil, width: f64) -> bool {
    match soil.law {
        Law::Elastic => false,
        _ => soil.law.cohesion().is_some_and(|c| 2.0 * c < soil.unit_weight * width),
    }
}

struct View<'a, R: Precision> {
    domain: &'a PlacedDomain<'a>,
    model: &'a Model,
    state: &'a State<R>,
    /// Whether each soil falls into a void.
    falls: Vec<bool>,
}

impl<R: Precision> View<'_, R> {
    /// Volumes of voids and of disturbed soil in a column of cells [m³], from above; `cover` is the height of
    /// the soil over the next cell that neither a body nor cohesion carries [m].
    fn descend(&self, [i, j]: [usize; 2], cover: &mut f64) -> [f64; 2] {
        let Self { domain, state, .. } = self;
        let soil = &state.soil;
        let mut sums = [0.0; 2];
        for k in (0..domain.cells()[2]).rev() {
            let (cell, height) = (domain.index([i, j, k]), domain.width(2, k));
            let fraction: f64 = soil.fraction[cell].into();
            if fraction < FULL && *cover > 0.0 {
                if self.is_at_a_body([i, j, k]) {
                    *cover = 0.0;
                } else if *cover >= COVER * height {
                    sums[0] += (1.0 - fraction) * domain.volume([i, j, k]);
                }
            }
            if fraction <= 0.0 {
                continue;
            }
            let strain: f64 = soil.history[PLASTIC_STRAIN][cell].into();
            if strain > GroundColumn::DISTURBED {
                sums[1] += fraction * domain.volume([i, j, k]);
            }
            if self.falls[soil.main_material(cell)] && self.rests([i, j, k]) {
                *cover += fraction * height;
            } else if fraction >= 0.5 {
                *cover = 0.0;
            }
        }
        sums
    }

    /// Whether the nodes of a cell are at rest.
    fn rests(&self, [i, j, k]: [usize; 3]) -> bool {
        let nodes = (0..8).map(|n| self.domain.index([i + n % 2, j + n / 2 % 2, k + n / 4]));
        let square = |node: usize| -> f64 {
            let speed = self.state.nodes.velocity.each_ref().map(|along| -> f64 { along[node].into() });
            speed.iter().map(|v| v * v).sum()
        };
        let mean = nodes.map(square).sum::<f64>() / 8.0;
        mean < 2.0 * self.model.soil_gravity * REST * self.domain.width(2, k)
    }

    /// Whether a body is within a cell's width of the middle of a cell.
    fn is_at_a_body(&self, at: [usize; 3]) -> bool {
        let middle = DVec3::from_array(std::array::from_fn(|axis| self.domain.centre(axis, at[axis])));
        let reach =
            DVec3::from_array(std::array::from_fn(|axis| self.domain.width(axis, at[axis]))).max_element();
        self.model.bodies.iter().enumerate().filter(|(_, body)| body.shape.has_surface()).any(|(n, body)| {
            let pose = self.state.pose(n);
            let (low, high) = body.bounds(pose);
            let is_near = middle.cmpge(low - reach).all() && middle.cmple(high + reach).all();
            is_near
                && body.shape.signed_distance(body.attitude(pose).inverse() * (middle - pose.position))
                    < reach
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use case::parse;
    use solver::initial;

    struct Cells {
        case: Case,
        model: Model,
        state: State,
    }

    /// Cells of 10 mm, five each way, in soil of this cohesion, with or without a block round the middle of
    /// the box.
    fn cells(cohesion: &str, with_block: bool) -> Cells {
        let block = "[body.block]\nshape = 'block'\nsize = ['10 mm', '10 mm', '10 mm']\nfriction = 0.3\nx = '25 mm'\ny = '25 mm'\nelevation = '-25 mm'\n";
        let text = format!(
            "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '30 deg'\ncohesion = '{cohesion}'\n\
             unit_weight = '16 kN/m^3'\nyoung_modulus = '1 MPa'\n\
             [domain]\nx = ['0 m', '50 mm']\ny = ['0 m', '50 mm']\nz = ['-50 mm', '0 m']\n\
             [grid]\ncell = '10 mm'\n[run]\nduration = '1 s'\n{}",
            if with_block { block } else { "" }
        );
        let case = parse(&text, "voids.toml", &[]).unwrap();
        let model = case::model::model(&case, 1);
        let mut state = initial::at_rest_on(&model, &model.ground);
        let all = state.soil.fraction.len();
        state.soil.history[PLASTIC_STRAIN] = vec![1.0; all];
        Cells { case, model, state }
    }

    /// Cells of void in the middle column when its cells have these fractions, from above.
    fn void(cells: &mut Cells, column: [f64; 5]) -> f64 {
        let grid = &cells.model.grid;
        for (n, fraction) in column.into_iter().enumerate() {
            cells.state.soil.fraction[grid.index(2, 2, 4 - n)] = fraction;
        }
        let soil = 120.0 + column.iter().sum::<f64>();
        sample(&cells.case, &cells.model, &cells.state, &Halo::whole()) * soil
    }

    #[test]
    fn an_empty_cell_under_resting_sand_is_a_void() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} and {b}");
        let sand = &mut cells("0 Pa", false);
        near(void(sand, [1.0, 1.0, 0.0, 1.0, 1.0]), 1.0);
        near(void(sand, [0.0, 1.0, 0.4, 0.7, 1.0]), 0.9);
        near(void(sand, [0.0, 0.5, 0.6, 1.0, 1.0]), 0.0);
        near(void(sand, [1.0, 0.95, 0.95, 1.0, 1.0]), 0.0);
        near(void(sand, [0.0; 5]), 0.0);
    }

    #[test]
    fn what_cohesion_or_a_body_carries_and_what_falls_is_none() {
        let hollow = [1.0, 1.0, 0.0, 1.0, 1.0];
        assert_eq!(void(&mut cells("1 kPa", false), hollow), 0.0);
        assert!(void(&mut cells("10 Pa", false), hollow) > 0.9, "too little for a cell's width");
        assert_eq!(void(&mut cells("0 Pa", true), hollow), 0.0);
        let mut falling = cells("0 Pa", false);
        falling.state.nodes.velocity[2].fill(-0.3);
        assert_eq!(void(&mut falling, hollow), 0.0);
    }
}
