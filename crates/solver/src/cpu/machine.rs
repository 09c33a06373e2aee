//! Peak performance of the machine: main memory traffic and multiply-adds. Compared with these, the speed of
//! the step shows how much there is left to gain (roofline model; Williams, Waterman & Patterson 2009).

use super::threads::Team;
use multiversion::multiversion;
use std::time::Instant;

/// Peak performance of a machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Machine {
    /// Traffic of `a = b + s c` with arrays far larger than the caches [GB/s] (McCalpin 1995: 24 bytes per
    /// entry).
    pub triad: f64,
    /// Multiply-adds in 64 bits, two operations each [GFLOP/s].
    pub fma: f64,
}

/// Entries of a triad array on each worker: 64 MiB.
const ENTRIES: usize = 8 << 20;
const TRIAD_TRIALS: usize = 6;
/// Multiply-adds on each lane in one trial, about a millisecond.
const ROUNDS: usize = 100_000;
const FMA_TRIALS: usize = 60;
/// Independent accumulators: enough to hide the latency of each behind the others.
const CHAINS: usize = 12;

/// Measures the machine with a number of threads; takes a second and 192 MiB for each. The best of several
/// trials counts, since disturbances can only slow a measurement down.
#[must_use]
pub fn measure(threads: usize) -> Machine {
    let team = Team::new(threads);
    let best = |trials: usize, trial: &mut dyn FnMut()| {
        let time = |_| {
            let clock = Instant::now();
            trial();
            clock.elapsed().as_secs_f64()
        };
        (0..trials).map(time).fold(f64::INFINITY, f64::min)
    };
    let mut chains = vec![[[1.0; 8]; CHAINS]; team.size()];
    let fma_seconds = best(FMA_TRIALS, &mut || team.for_each(&mut chains, multiply_add));
    std::hint::black_box(&chains);
    let mut arrays: Vec<[Vec<f64>; 3]> = (0..team.size()).map(|_| Default::default()).collect();
    // Each worker touches its own arrays first, so that they are allocated in its local memory.
    team.for_each(&mut arrays, |own| *own = [0.0, 1.0, 2.0].map(|x| vec![x; ENTRIES]));
    let triad_seconds = best(TRIAD_TRIALS, &mut || team.for_each(&mut arrays, |[a, b, c]| triad(a, b, c)));
    std::hint::black_box(&arrays);
    let workers = team.size() as f64;
    Machine {
        triad: 24e-9 * ENTRIES as f64 * workers / triad_seconds,
        fma: 2e-9 * (ROUNDS * CHAINS * 8) as f64 * workers / fma_seconds,
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn triad(a: &mut [f64], b: &[f64], c: &[f64]) {
    for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
        *a = b + 3.0 * c;
    }
}

/// A multiplication and an addition on processors without a fused operation.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn multiply_add(chains: &mut [[f64; 8]; CHAINS]) {
    let mut own = *chains;
    for _ in 0..ROUNDS {
        for chain in &mut own {
            for x in chain {
                *x = if multiversion::target::target_cfg_f!(target_feature = "fma") {
                    x.mul_add(0.999, 0.001)
                } else {
                    *x * 0.999 + 0.001
                };
            }
        }
    }
    *chains = own;
}
