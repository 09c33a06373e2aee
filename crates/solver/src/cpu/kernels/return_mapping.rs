//! Return mapping of the trial stresses of a block of cells.

use super::cells::{BLOCK, Block, CellRow, RowConstants, tensor};
use super::physics::elastic::Elastic;
use super::physics::law::Law;
use super::physics::menetrey_willam::MenetreyWillam;
use super::physics::mohr_coulomb::MohrCoulomb;
use super::physics::tensor::Symmetric;
use super::physics::von_mises::VonMises;
use super::physics::yield_law::YieldLaw;
use super::{LANES, Real};
use crate::fields::PLASTIC_STRAIN;
use multiversion::multiversion;

/// Returns the trial stresses outside the yield surface to it; the result is their number. One function for
/// each law, so that each loop is compiled separately.
pub(super) fn apply(
    constants: &RowConstants,
    yield_law: &Law,
    cells: &mut CellRow,
    block: &mut Block,
) -> usize {
    match yield_law {
        Law::MohrCoulomb(law) => mohr_coulomb(constants, law, cells, block),
        Law::MenetreyWillam(law) => menetrey_willam(constants, law, cells, block),
        Law::VonMises(law) => von_mises(constants, law, cells, block),
    }
}

/// The same for one law. Most cells are elastic; those that yield are packed, so that the vectors of the
/// return mapping are full.
#[inline(always)]
fn apply_law(
    constants: &RowConstants,
    yield_law: &impl YieldLaw,
    cells: &mut CellRow,
    b: &mut Block,
) -> usize {
    let n = b.n.min(BLOCK);
    let plastic_strain = &cells.history[PLASTIC_STRAIN][b.start..b.start + n];
    for i in 0..n {
        let trial = tensor(&b.trial, i);
        b.yields[i] = if yield_law.may_yield(trial, plastic_strain[i]) { b.bears_stress[i] } else { 0.0 };
    }
    let (mut index, mut count) = ([0_u8; BLOCK], 0);
    for i in 0..n {
        index[count] = i as u8;
        count += usize::from(b.yields[i] > 0.0);
    }
    if count == 0 {
        return 0;
    }
    let mut packed = Yielding::default();
    for indices in index[..count].chunks(LANES) {
        let lanes = || indices.iter().map(|i| usize::from(*i)).enumerate();
        for (l, i) in lanes() {
            for c in 0..6 {
                packed.trial[c][l] = b.trial[c][i];
                packed.old[c][l] = cells.stress[c][b.start + i];
            }
            let volume = constants.width_x[b.start + i] * cells.width_y * cells.width_z;
            let critical = constants.material.critical_density * cells.fraction[b.start + i] * volume;
            packed.plastic_strain[l] = cells.history[PLASTIC_STRAIN][b.start + i];
            packed.dilates[l] = if cells.mass[b.start + i] >= critical { 1.0 } else { 0.0 };
        }
        packed.return_stress(&constants.material.elastic, yield_law);
        for (l, i) in lanes() {
            for c in 0..6 {
                b.trial[c][i] = packed.trial[c][l];
            }
            if constants.strains() {
                cells.history[PLASTIC_STRAIN][b.start + i] = packed.plastic_strain[l];
            }
            b.gap_strain[i] += packed.gap_strain[l];
            b.work[i] = packed.work[l];
        }
    }
    count
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn mohr_coulomb(constants: &RowConstants, law: &MohrCoulomb, cells: &mut CellRow, b: &mut Block) -> usize {
    apply_law(constants, law, cells, b)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn menetrey_willam(
    constants: &RowConstants,
    law: &MenetreyWillam,
    cells: &mut CellRow,
    b: &mut Block,
) -> usize {
    apply_law(constants, law, cells, b)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn von_mises(constants: &RowConstants, law: &VonMises, cells: &mut CellRow, b: &mut Block) -> usize {
    apply_law(constants, law, cells, b)
}

/// A vector of yielding cells.
#[derive(Default)]
struct Yielding {
    /// Trial stress, later the returned one [Pa].
    trial: [[Real; LANES]; 6],
    /// Stress at the start of the step [Pa].
    old: [[Real; LANES]; 6],
    /// 1 where the soil dilates, 0 at its critical density.
    dilates: [Real; LANES],
    /// Equivalent plastic strain at the start of the step, later at its end.
    plastic_strain: [Real; LANES],
    /// Increment of the gap strain.
    gap_strain: [Real; LANES],
    /// Plastic work per volume [J/m³].
    work: [Real; LANES],
}

impl Yielding {
    #[inline(always)]
    fn return_stress(&mut self, elastic: &Elastic, yield_law: &impl YieldLaw) {
        for l in 0..LANES {
            let trial = tensor(&self.trial, l);
            let old = tensor(&self.old, l);
            let returned = yield_law.return_map(trial, self.plastic_strain[l], self.dilates[l] > 0.0);
            let mut middle: Symmetric = [0.0; 6];
            let mut change: Symmetric = [0.0; 6];
            for c in 0..6 {
                middle[c] = 0.5 * (old[c] + returned.stress[c]);
                change[c] = trial[c] - returned.stress[c];
                self.trial[c][l] = returned.stress[c];
            }
            self.plastic_strain[l] += returned.plastic_strain;
            self.gap_strain[l] = returned.gap_strain;
            // With the mean of old and new stress, the sum over steps is exact for central differences.
            self.work[l] = elastic.compliance(middle, change);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::cells::{Lane, MaterialConstants};
    use super::super::physics::menetrey_willam::Eccentricity;
    use super::super::physics::viscosity::BulkViscosity;
    use super::*;
    use crate::fields::HISTORY_COUNT;
    use std::hint::black_box;
    use std::time::Instant;

    /// The best of many trials [s], since disturbances can only slow a measurement down.
    fn best(mut trial: impl FnMut()) -> f64 {
        let time = |_| {
            let clock = Instant::now();
            trial();
            clock.elapsed().as_secs_f64()
        };
        (0..2000).map(time).fold(f64::INFINITY, f64::min)
    }

    /// The return mapping of a law as the step calls it, for a row of cells.
    trait Apply<S>: Fn(&RowConstants, &S, &mut CellRow, &mut Block) -> usize {}
    impl<S, F: Fn(&RowConstants, &S, &mut CellRow, &mut Block) -> usize> Apply<S> for F {}

    /// Stresses of a block after the return mapping of a law, and its time [s].
    fn vectorised<S>(
        yield_law: &S,
        law: &impl Apply<S>,
        stress: impl Fn(usize) -> Symmetric,
    ) -> ([Lane; 6], f64) {
        let ones = [1.0; BLOCK];
        let material = MaterialConstants {
            elastic: Elastic::new(5e6, 0.3),
            yield_law: None,
            critical_density: 0.0,
            viscosity: BulkViscosity { linear: 0.0, quadratic: 0.0 },
            hourglass: 0.0,
        };
        let constants = RowConstants {
            material: &material,
            hourglass_yielding: 1.0,
            has_cubes: true,
            width_x: &ones,
            per_width_x: &[0.25; BLOCK],
            dt: 1.0,
        };
        let mut fields: [Vec<Real>; 6] = std::array::from_fn(|c| (0..BLOCK).map(|i| stress(i)[c]).collect());
        let mut history: [Vec<Real>; HISTORY_COUNT] = std::array::from_fn(|_| vec![0.0; BLOCK]);
        let mut cells = CellRow {
            fraction: &ones,
            mass: &ones,
            stress: fields.each_mut().map(Vec::as_mut_slice),
            history: history.each_mut().map(Vec::as_mut_slice),
            width_y: 1.0,
            width_z: 1.0,
        };
        let mut block = Block::new();
        (block.n, block.bears_stress) = (BLOCK, ones);
        let seconds = best(|| {
            for c in 0..6 {
                block.trial[c].copy_from_slice(cells.stress[c]);
            }
            cells.history[PLASTIC_STRAIN].fill(0.0);
            black_box(law(&constants, yield_law, &mut cells, &mut block));
        });
        (block.trial, seconds)
    }

    /// Ratios within one run, so that they hold on any machine: check and return mapping in vectors against
    /// the same formulas cell by cell.
    fn assert_vectorised<S: YieldLaw>(yield_law: &S, law: impl Apply<S>) {
        let yielding = |i: usize| [-1e3, -4e3 - i as Real, -9e3, 500.0, 10.0 * i as Real, -300.0];
        let resting = |i: usize| [-5e3, -4e3 - i as Real, -6e3, 50.0, i as Real, -30.0];
        let (returned, together) = vectorised(yield_law, &law, yielding);
        let one_by_one = best(|| {
            for i in 0..BLOCK {
                black_box(yield_law.return_map(black_box(yielding(i)), 0.0, true));
            }
        });
        let (left_alone, checked) = vectorised(yield_law, &law, resting);
        let checked_one_by_one = best(|| {
            for i in 0..BLOCK {
                black_box(yield_law.may_yield(black_box(resting(i)), 0.0));
            }
        });
        for i in 0..BLOCK {
            assert_eq!(tensor(&returned, i), yield_law.return_map(yielding(i), 0.0, true).stress);
            assert_eq!(tensor(&left_alone, i), resting(i));
        }
        #[cfg(target_arch = "x86_64")]
        let wide = std::arch::is_x86_feature_detected!("avx2");
        #[cfg(not(target_arch = "x86_64"))]
        let wide = false;
        let (gain, gain_check) = (one_by_one / together, checked_one_by_one / checked);
        assert!(!wide || (gain > 2.0 && gain_check > 3.0), "return {gain} times, check {gain_check} times");
    }

    #[test]
    fn the_return_mappings_are_vectorised() {
        let elastic = Elastic::new(5e6, 0.3);
        assert_vectorised(&MohrCoulomb::new(elastic, 0.6, 0.0, 100.0, 50.0), mohr_coulomb);
        let smooth = MenetreyWillam::new(elastic, 0.6, 0.1, 100.0, 50.0, Eccentricity::usual(0.6));
        assert_vectorised(&smooth, menetrey_willam);
        assert_vectorised(&VonMises::new(elastic, 3e3, 1e3), von_mises);
    }
}
