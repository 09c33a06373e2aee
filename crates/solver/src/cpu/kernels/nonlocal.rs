//! The nonlocal relative density of soil with a characteristic length, which regularises its softening.
//!
//! Volume of the soil and relative density are averaged with the weight exp(−r²/l²), l the length, by compact
//! passes of conservative diffusion along each axis: no soil is averaged beyond walls and planes of symmetry,
//! cells may have any widths, and blocks only need their neighbours. A cell keeps [`OVERWEIGHT`] times what
//! the average differs by from its own value.

use super::physics::law::Law;
use super::rows::nonlocal::{Averaged, Spread};
use super::sweep::part;
use super::{Real, Soil, Workspace};
use crate::cpu::fields_on_device::DeviceRemap;
use crate::fields::NONLOCAL_DENSITY;
use crate::grid::Grid;
use crate::halo::Halo;
use crate::halo::filling::{At, fill};
use crate::model::Model;

/// Largest diffusion number of a pass: above ½ it would not be monotonic; ⅓ averages three cells alike.
const MOST_DIFFUSION: f64 = 1.0 / 3.0;

/// A pass along an axis: what a cell takes over of the differences to its lower and its higher neighbour.
pub(super) struct Spreading {
    pub(super) axis: usize,
    pub(super) weights: Vec<[Real; 2]>,
}

/// Renews the nonlocal densities of the soil of the first material with a characteristic length.
pub(crate) fn average(model: &Model, soil: &mut Soil, workspace: &mut Workspace, halo: &Halo) {
    let found = model.materials.iter().enumerate().find_map(|(n, m)| Some((n, m.characteristic_length?)));
    let Some((number, length)) = found else { return };
    let Some(Law::Sand(law)) = workspace.materials[number].yield_law else { return };
    if let Some(device) = &mut workspace.device {
        return device.average_density(model, &mut soil.history[NONLOCAL_DENSITY]);
    }
    let (passes, count) = passes(&model.grid, length);
    let [mut own, mut other] = std::mem::take(&mut workspace.averages);
    let layout = model.grid.layout();
    let Soil { fraction, mass, history, .. } = soil;
    let Workspace { team, partition, width_x, material, .. } = &*workspace;
    let averaged = Averaged {
        layout,
        width_x: &width_x[0],
        law: &law,
        fraction,
        mass: workspace.mass_of_laws(mass),
        material,
        number: number as u8,
    };
    let [fractions, densities] = &mut own;
    team.rows2(partition, fractions, densities, |row, fractions, densities| {
        averaged.collect(part(&layout, row), [fractions, densities]);
    });
    for Spreading { axis, weights } in (0..count).flat_map(|_| &passes) {
        fill(halo, &model.grid, At::Cells, &mut own);
        let spread = Spread { layout, axis: *axis, weights };
        for (from, to) in own.iter().zip(&mut other) {
            team.rows(partition, to, |row, to| spread.pass(part(&layout, row), from, to));
        }
        std::mem::swap(&mut own, &mut other);
    }
    let both = own.each_ref().map(Vec::as_slice);
    team.rows(partition, &mut history[NONLOCAL_DENSITY], |row, out| {
        averaged.store(part(&layout, row), both, out);
    });
    fill(halo, &model.grid, At::Cells, [&mut history[NONLOCAL_DENSITY]]);
    workspace.averages = [own, other];
}

/// The passes along the axes, and how often they are repeated.
pub(super) fn passes(grid: &Grid, length: f64) -> (Vec<Spreading>, usize) {
    let variance = 0.5 * length * length;
    let count = (0.5 * variance / (MOST_DIFFUSION * grid.finest() * grid.finest())).ceil().max(1.0);
    let diffusion = 0.5 * variance / count;
    let axes = (0..3).filter(|axis| grid.whole_cells()[*axis] > 1);
    let passes = axes.map(|axis| {
        let width: Vec<f64> = (0..grid.cells()[axis]).map(|n| grid.width(axis, n)).collect();
        let across = |low: usize| diffusion / (0.5 * (width[low] + width[low + 1]));
        let weights = (0..width.len()).map(|n| {
            let low = if n > 0 { across(n - 1) / width[n] } else { 0.0 };
            let high = if n + 1 < width.len() { across(n) / width[n] } else { 0.0 };
            [low, high].map(|weight| weight as Real)
        });
        Spreading { axis, weights: weights.collect() }
    });
    (passes.collect(), count as usize)
}

#[cfg(test)]
mod tests {
    use super::super::rows::nonlocal::OVERWEIGHT;
    use super::*;
    use crate::halo::Halo;
    use crate::initial::{Filling, at_rest};
    use crate::material::Material;
    use crate::scalar::Scalar;
    use glam::DVec3;
    use physics::double as exact;
    use std::f64::consts::FRAC_1_SQRT_2;

    /// Weightless dense sand in a box of cells that widen along x, with a characteristic length [m].
    fn model(length: f64) -> Model {
        let elastic = exact::elastic::Elastic::new(5e6, 0.3);
        let parameters = exact::sand::SandParameters {
            critical_friction: 0.56,
            limit_density: [1350.0, 1650.0],
            bolton: [10.0, 0.7],
            reference_strain: 0.0009,
            compression_modulus: 20e6,
        };
        let stiffening = exact::elastic::Stiffening { least: 1e3, most: 2e4 };
        let law = exact::sand::Sand::new(elastic, stiffening, &parameters);
        let material = Material {
            yield_law: Some(exact::law::Law::Sand(law)),
            characteristic_length: Some(length),
            ..Material::linear_elastic(elastic, 1550.0)
        };
        let x = (0..=60)
            .map(|n| {
                let s = f64::from(n - 30);
                0.01 * s + 2e-5 * s * s * s.signum()
            })
            .collect();
        let y = (0..=3).map(|n| 0.01 * f64::from(n)).collect();
        let z = (0..=60).map(|n| 0.01 * f64::from(n - 30)).collect();
        Model::bare(Grid::padded([x, y, z], Real::LANES), material)
    }

    #[test]
    fn even_sand_keeps_its_density_and_a_disturbance_spreads_over_the_length() {
        const LENGTH: f64 = 0.06;
        let model = model(LENGTH);
        let everywhere = Filling::between(DVec3::splat(-1e9), DVec3::splat(1e9));
        let mut state = at_rest::<Real>(&model, &everywhere);
        let mut workspace = Workspace::new(&model, &state, 2);
        average(&model, &mut state.soil, &mut workspace, &Halo::whole());
        let most = |field: &[Real]| field.iter().fold(0.0, |most: Real, x| most.max(x.abs()));
        assert!(most(&state.soil.history[NONLOCAL_DENSITY]) < 1e-4);

        // One cell across the box a little denser: its average is a Gaussian of the length.
        let Some(Law::Sand(law)) = workspace.materials[0].yield_law else { panic!("no sand") };
        let grid = &model.grid;
        for j in 0..3 {
            state.soil.mass[grid.index(30, j, 30)] *= 1.02;
        }
        average(&model, &mut state.soil, &mut workspace, &Halo::whole());
        let density = |c: usize| law.relative_density(state.soil.mass[c] / grid.volume_of(c) as Real);
        let undisturbed = f64::from(density(grid.index(0, 1, 0)));
        let (mut sum, mut spread) = (0.0, [0.0; 2]);
        for k in 0..60 {
            for i in 0..60 {
                let c = grid.index(i, 1, k);
                let mean = f64::from(state.soil.history[NONLOCAL_DENSITY][c] / OVERWEIGHT + density(c));
                let amount = (mean - undisturbed) * grid.volume_of(c);
                let x = grid.centre(0, i) - grid.centre(0, 30);
                sum += amount;
                spread[0] += amount * x * x;
                spread[1] += amount * grid.centre(2, k).powi(2);
            }
        }
        let c = grid.index(30, 1, 30);
        let added = (f64::from(density(c)) - undisturbed) * grid.volume_of(c);
        assert!((sum / added - 1.0).abs() < 0.01, "{sum} of {added}");
        for spread in spread {
            let deviation = (spread / sum).sqrt();
            assert!((deviation / (LENGTH * FRAC_1_SQRT_2) - 1.0).abs() < 0.05, "{deviation}");
        }
    }
}
