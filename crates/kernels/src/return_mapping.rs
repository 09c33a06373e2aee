//! Return mapping of the trial stresses of a block of cells.

use super::cells::{BLOCK, Block, CellRow, RowConstants, tensor};
use super::physics::clay::Clay;
use super::physics::elastic::Elastic;
use super::physics::law::Law;
use super::physics::menetrey_willam::MenetreyWillam;
use super::physics::mohr_coulomb::MohrCoulomb;
use super::physics::sand::Sand;
use super::physics::tensor::{Symmetric, mean};
use super::physics::von_mises::VonMises;
use super::physics::yield_law::{Memory, Point, YieldLaw};
use super::{LANES, Real};
use crate::history::{INTACT_STRENGTH, NONLOCAL_DENSITY, PLASTIC_STRAIN, PRECONSOLIDATION, STRESS_RATIO};
use multiversion::multiversion;

/// Mean of the stresses before and after a step: with it the sum of the work over steps is exact for central
/// differences.
#[inline(always)]
fn middle(old: Symmetric, new: Symmetric) -> Symmetric {
    let mut middle: Symmetric = [0.0; 6];
    for c in 0..6 {
        middle[c] = 0.5 * (old[c] + new[c]);
    }
    middle
}

/// Plastic work per volume of a step [J/m³] with constant moduli: the mean stress on the plastic strain.
#[inline(always)]
fn plastic_work(elastic: &Elastic) -> impl Fn(Symmetric, Symmetric, Symmetric) -> Real + '_ {
    |old, trial, new| {
        let mut change: Symmetric = [0.0; 6];
        for c in 0..6 {
            change[c] = trial[c] - new[c];
        }
        elastic.compliance(middle(old, new), change)
    }
}

/// History variables that make up the memory of the soil.
const MEMORY: [usize; 3] = [STRESS_RATIO, PRECONSOLIDATION, NONLOCAL_DENSITY];

/// Returns the trial stresses outside the yield surface to it; the result is their number. One function for
/// each law, so that each loop is compiled separately.
pub fn apply(constants: &RowConstants, yield_law: &Law, cells: &mut CellRow, block: &mut Block) -> usize {
    match yield_law {
        Law::MohrCoulomb(law) => mohr_coulomb(constants, law, cells, block),
        Law::MenetreyWillam(law) => menetrey_willam(constants, law, cells, block),
        Law::VonMises(law) => von_mises(constants, law, cells, block),
        Law::Sand(law) => sand(constants, law, cells, block),
        Law::Clay(law) => clay(constants, law, cells, block),
    }
}

/// Returns the stresses of a block to the yield surface of one law. Most cells are elastic; those that yield
/// are packed, so that the vectors of the return mapping are full.
#[inline(always)]
fn apply_law<L: YieldLaw>(
    constants: &RowConstants,
    yield_law: &L,
    dissipation: impl Fn(Symmetric, Symmetric, Symmetric) -> Real,
    cells: &mut CellRow,
    b: &mut Block,
) -> usize {
    let (start, n) = b.span();
    let own = start..start + n;
    let plastic_strain = &cells.history[PLASTIC_STRAIN][own.clone()];
    let of = |h: usize| if L::REMEMBERS { &cells.history[h][own.clone()] } else { plastic_strain };
    let (stress_ratio, preconsolidation) = (of(STRESS_RATIO), of(PRECONSOLIDATION));
    let intact = if L::HAS_STRENGTH { &cells.history[INTACT_STRENGTH][own.clone()] } else { plastic_strain };
    for i in 0..n {
        let trial = tensor(&b.trial, i);
        let memory = Memory {
            stress_ratio: stress_ratio[i],
            preconsolidation: preconsolidation[i],
            nonlocal_density: 0.0,
            intact_strength: intact[i],
        };
        let duration = constants.dt;
        let point = Point { plastic_strain: plastic_strain[i], memory, duration, ..Point::default() };
        b.yields[i] = if yield_law.may_yield(trial, &point) { b.bears_stress[i] } else { 0.0 };
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
            packed.load::<L>(constants, cells, b, (l, i));
        }
        packed.return_stress(yield_law, constants.dt, &dissipation);
        for (l, i) in lanes() {
            packed.store::<L>(constants, cells, b, (l, i));
        }
    }
    count
}

/// [`apply`] for the law of Mohr–Coulomb.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn mohr_coulomb(
    constants: &RowConstants,
    law: &MohrCoulomb,
    cells: &mut CellRow,
    b: &mut Block,
) -> usize {
    apply_law(constants, law, plastic_work(&constants.material.elastic), cells, b)
}

/// [`apply`] for the law of Mohr–Coulomb with a smooth flow potential.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn menetrey_willam(
    constants: &RowConstants,
    law: &MenetreyWillam,
    cells: &mut CellRow,
    b: &mut Block,
) -> usize {
    apply_law(constants, law, plastic_work(&constants.material.elastic), cells, b)
}

/// [`apply`] for the law of sand.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn sand(constants: &RowConstants, law: &Sand, cells: &mut CellRow, b: &mut Block) -> usize {
    // Copies, which nothing written in the loops can change.
    let (law, elastic) = (*law, constants.material.elastic);
    // What is not stored of the work is dissipated, in elastic cells too: their moduli change with the
    // pressure.
    let dissipation = |old: Symmetric, trial: Symmetric, new: Symmetric| {
        let strained = std::array::from_fn(|c| trial[c] - old[c]);
        elastic.compliance(middle(old, new), strained) / law.stiffening.factor(-mean(old)) + law.energy(old)
            - law.energy(new)
    };
    let (start, n) = b.span();
    let stress = cells.stress.each_ref().map(|s| &s[start..start + n]);
    for i in 0..n {
        let (old, trial) = (stress.map(|s| s[i]), tensor(&b.trial, i));
        b.work[i] = if b.bears_stress[i] > 0.0 { dissipation(old, trial, trial) } else { 0.0 };
    }
    apply_law(constants, &law, dissipation, cells, b)
}

/// [`apply`] for the law of clay.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn clay(constants: &RowConstants, law: &Clay, cells: &mut CellRow, b: &mut Block) -> usize {
    apply_law(constants, law, plastic_work(&constants.material.elastic), cells, b)
}

/// [`apply`] for the law of von Mises.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn von_mises(constants: &RowConstants, law: &VonMises, cells: &mut CellRow, b: &mut Block) -> usize {
    apply_law(constants, law, plastic_work(&constants.material.elastic), cells, b)
}

/// A vector of yielding cells.
#[derive(Default)]
#[repr(align(64))]
struct Yielding {
    /// Trial stress, later the returned one [Pa].
    trial: [[Real; LANES]; 6],
    /// Stress at the start of the step [Pa].
    old: [[Real; LANES]; 6],
    /// Density [kg/m³], for laws that remember.
    density: [Real; LANES],
    /// 1 at the critical density, 0 where the soil dilates.
    is_critical: [Real; LANES],
    /// Memory at the start of the step, later at its end, in the order of [`MEMORY`].
    memory: [[Real; LANES]; 3],
    /// Strength of the intact soil [Pa], for laws that depend on it.
    intact_strength: [Real; LANES],
    /// Equivalent plastic strain at the start of the step, later at its end.
    plastic_strain: [Real; LANES],
    /// Increment of the gap strain.
    gap_strain: [Real; LANES],
    /// Dissipation per volume [J/m³].
    work: [Real; LANES],
}

impl Yielding {
    /// Takes cell `i` of the block into lane `l`.
    #[inline(always)]
    fn load<L: YieldLaw>(
        &mut self,
        constants: &RowConstants,
        cells: &CellRow,
        b: &Block,
        (l, i): (usize, usize),
    ) {
        let own = b.span().0 + i;
        for c in 0..6 {
            self.trial[c][l] = b.trial[c][i];
            self.old[c][l] = cells.stress[c][own];
        }
        let volume = constants.width_x[own] * cells.width_y * cells.width_z;
        let critical = constants.material.critical_density * cells.fraction[own] * volume;
        self.plastic_strain[l] = cells.history[PLASTIC_STRAIN][own];
        self.is_critical[l] = if cells.mass[own] >= critical { 0.0 } else { 1.0 };
        if L::HAS_STRENGTH {
            self.intact_strength[l] = cells.history[INTACT_STRENGTH][own];
        }
        if L::REMEMBERS {
            self.density[l] = cells.mass[own] / (cells.fraction[own] * volume);
            for n in 0..MEMORY.len() {
                self.memory[n][l] = cells.history[MEMORY[n]][own];
            }
        }
    }

    /// Returns lane `l` to cell `i` of the block.
    #[inline(always)]
    fn store<L: YieldLaw>(
        &self,
        constants: &RowConstants,
        cells: &mut CellRow,
        b: &mut Block,
        (l, i): (usize, usize),
    ) {
        let own = b.span().0 + i;
        for c in 0..6 {
            b.trial[c][i] = self.trial[c][l];
        }
        if constants.strains() {
            cells.history[PLASTIC_STRAIN][own] = self.plastic_strain[l];
            if L::REMEMBERS {
                for n in 0..MEMORY.len() {
                    cells.history[MEMORY[n]][own] = self.memory[n][l];
                }
            }
        }
        b.gap_strain[i] += self.gap_strain[l];
        b.work[i] = self.work[l];
    }

    #[inline(always)]
    fn return_stress(
        &mut self,
        yield_law: &impl YieldLaw,
        duration: Real,
        dissipation: &impl Fn(Symmetric, Symmetric, Symmetric) -> Real,
    ) {
        for l in 0..LANES {
            let trial = tensor(&self.trial, l);
            let old = tensor(&self.old, l);
            let memory = Memory {
                stress_ratio: self.memory[0][l],
                preconsolidation: self.memory[1][l],
                nonlocal_density: self.memory[2][l],
                intact_strength: self.intact_strength[l],
            };
            let point = Point {
                stress: old,
                density: self.density[l],
                is_critical: self.is_critical[l] > 0.0,
                plastic_strain: self.plastic_strain[l],
                memory,
                duration,
            };
            let returned = yield_law.return_map(trial, &point);
            self.memory[0][l] = returned.memory.stress_ratio;
            self.memory[1][l] = returned.memory.preconsolidation;
            for c in 0..6 {
                self.trial[c][l] = returned.stress[c];
            }
            self.plastic_strain[l] += returned.plastic_strain;
            self.gap_strain[l] = returned.gap_strain;
            self.work[l] = dissipation(old, trial, returned.stress);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::cells::{Lane, MaterialConstants};
    use super::super::physics::elastic::Stiffening;
    use super::super::physics::menetrey_willam::Eccentricity;
    use super::super::physics::sand::SandParameters;
    use super::super::physics::viscosity::BulkViscosity;
    use super::*;
    use crate::history::HISTORY_COUNT;
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

    /// Density of the soil [kg/m³].
    const DENSITY: Real = 1450.0;

    /// State at the start of a step that leads to a trial stress.
    fn before(trial: Symmetric, memory: Memory) -> Point {
        Point { stress: trial.map(|s| 0.9 * s), density: DENSITY, memory, ..Point::default() }
    }

    /// Stresses of a block after the return mapping of a law, and its time [s].
    fn vectorised<S>(
        yield_law: &S,
        law: &impl Apply<S>,
        stress: impl Fn(usize) -> Symmetric,
        memory: Memory,
    ) -> ([Lane; 6], f64) {
        let ones = [1.0; BLOCK];
        let material = MaterialConstants {
            elastic: Elastic::new(5e6, 0.3),
            yield_law: None,
            critical_density: 0.0,
            densest: DENSITY,
            loosest: 0.0,
            stiffening: None,
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
        let trial: [Lane; 6] = std::array::from_fn(|c| std::array::from_fn(|i| stress(i)[c]));
        let mut old: [Lane; 6] =
            std::array::from_fn(|c| std::array::from_fn(|i| before(stress(i), memory).stress[c]));
        let mut history: [Lane; HISTORY_COUNT] = [[0.0; BLOCK]; HISTORY_COUNT];
        let mut cells = CellRow {
            fraction: &ones,
            mass: &[DENSITY; BLOCK],
            stress: old.each_mut().map(<[Real; BLOCK]>::as_mut_slice),
            history: history.each_mut().map(<[Real; BLOCK]>::as_mut_slice),
            width_y: 1.0,
            width_z: 1.0,
        };
        let mut block = Block::new();
        (block.n, block.bears_stress) = (BLOCK, ones);
        let seconds = best(|| {
            block.trial = trial;
            cells.history[PLASTIC_STRAIN].fill(0.0);
            cells.history[STRESS_RATIO].fill(memory.stress_ratio);
            cells.history[PRECONSOLIDATION].fill(memory.preconsolidation);
            black_box(law(&constants, yield_law, &mut cells, &mut block));
        });
        (block.trial, seconds)
    }

    /// Compiled without vectors (`-C no-vectorize-loops -C no-vectorize-slp`) the return mappings gain 0.9 to
    /// 1.1 times; in vectors at least 1.8, where a machine has four doubles to a vector, and up to 13.
    const LEAST_GAIN: f64 = 1.4;

    /// Ratios within one run, so that they hold on any machine: check and return mapping in vectors against
    /// the same formulas cell by cell. A neighbour on the machine can spoil a round, so one quiet round of a
    /// few is enough.
    fn assert_vectorised<S: YieldLaw>(yield_law: &S, law: impl Apply<S>) {
        #[cfg(target_arch = "x86_64")]
        let wide = std::arch::is_x86_feature_detected!("avx2");
        #[cfg(not(target_arch = "x86_64"))]
        let wide = false;
        let rounds: Vec<[f64; 2]> = (0..5).map(|_| gains(yield_law, &law)).collect();
        let enough = |gains: &[f64; 2]| gains.iter().all(|&gain| gain > LEAST_GAIN);
        assert!(!wide || rounds.iter().any(enough), "return and check, times: {rounds:?}");
    }

    /// How many times faster a block of cells is in vectors than cell by cell: with a return to the yield
    /// surface, and for the check that finds nothing to return. Both must give the same stresses.
    fn gains<S: YieldLaw>(yield_law: &S, law: &impl Apply<S>) -> [f64; 2] {
        let yielding = |i: usize| [-1e3, -4e3 - i as Real, -9e3, 500.0, 10.0 * i as Real, -300.0];
        let resting = |i: usize| [-5e3, -4e3 - i as Real, -6e3, 50.0, i as Real, -30.0];
        let fresh = Memory { stress_ratio: 0.2, preconsolidation: 1e3, ..Memory::default() };
        let old = Memory { stress_ratio: 1.0, preconsolidation: 1e5, ..Memory::default() };
        let (returned, together) = vectorised(yield_law, law, yielding, fresh);
        let one_by_one = best(|| {
            for i in 0..BLOCK {
                black_box(
                    yield_law.return_map(black_box(yielding(i)), &black_box(before(yielding(i), fresh))),
                );
            }
        });
        let (left_alone, checked) = vectorised(yield_law, law, resting, old);
        let checked_one_by_one = best(|| {
            for i in 0..BLOCK {
                black_box(yield_law.may_yield(black_box(resting(i)), &black_box(before(resting(i), old))));
            }
        });
        for i in 0..BLOCK {
            let alone = yield_law.return_map(yielding(i), &before(yielding(i), fresh)).stress;
            assert_ne!(alone, yielding(i));
            assert_eq!(tensor(&returned, i), alone);
            assert_eq!(tensor(&left_alone, i), resting(i));
        }
        // Together they are checked, too.
        [(checked_one_by_one + one_by_one) / together, checked_one_by_one / checked]
    }

    #[test]
    fn the_return_mappings_are_vectorised() {
        let elastic = Elastic::new(5e6, 0.3);
        assert_vectorised(&MohrCoulomb::new(elastic, 0.6, 0.0, 100.0, 50.0), mohr_coulomb);
        let smooth = MenetreyWillam::new(elastic, 0.6, 0.1, 100.0, 50.0, Eccentricity::usual(0.6));
        assert_vectorised(&smooth, menetrey_willam);
        assert_vectorised(&VonMises::new(elastic, 3e3, 1e3), von_mises);
        let parameters = SandParameters {
            critical_friction: 0.56,
            limit_density: [1350.0, 1650.0],
            bolton: [10.0, 0.7],
            reference_strain: 0.0009,
            compression_modulus: 20e6,
        };
        let stiffening = Stiffening { least: 1e3, most: 5e4 };
        assert_vectorised(&Sand::new(elastic, stiffening, &parameters), sand);
    }
}
