//! Designs that fill the unit cube: Latin hypercubes and Sobol sequences. They are the same on every machine.

use super::StatisticsError;
use numerics::{Draws, Sequence};

/// Largest number of factors of [`sobol`]: the dimensions of the sequence.
pub const SOBOL_FACTORS: usize = numerics::sequence::DIMENSIONS;
/// Latin hypercubes among which the best is chosen, at most (chosen).
const CANDIDATES: usize = 200;
/// Products of differences that the choice may cost: about a second (chosen).
const EFFORT: usize = 100_000_000;

/// A Latin hypercube of `points` points in `factors` factors, `points × factors` numbers in [0, 1).
///
/// Each factor has one point in each of its `points` equal intervals, at random within it. Of up to 200 such
/// hypercubes the one with the largest smallest distance between two points is taken. Source: McKay, Beckman
/// & Conover (1979), Technometrics 21; maximin criterion of Johnson, Moore & Ylvisaker (1990), J. Stat. Plan.
/// Inference 26.
///
/// # Errors
/// [`StatisticsError::Design`] without points or factors.
pub fn latin_hypercube(points: usize, factors: usize, seed: u64) -> Result<Vec<Vec<f64>>, StatisticsError> {
    refuse_empty(points, factors)?;
    let mut random = generator(seed);
    let cost = points.saturating_mul(points).saturating_mul(factors) / 2;
    let candidates = if points == 1 { 1 } else { (EFFORT / cost.max(1)).clamp(1, CANDIDATES) };
    let mut best = one_hypercube(points, factors, &mut random);
    if candidates == 1 {
        return Ok(best);
    }
    let mut largest = smallest_distance(&best);
    for _ in 1..candidates {
        let next = one_hypercube(points, factors, &mut random);
        let distance = smallest_distance(&next);
        if distance > largest {
            (best, largest) = (next, distance);
        }
    }
    Ok(best)
}

/// The first `points` points of a Sobol sequence in `factors` factors with a random digital shift,
/// `points × factors` numbers in (0, 1). A power of two is the best number of points.
///
/// Source: Sobol (1967), direction numbers of Joe & Kuo (2008); shift: Owen (2000), Monte Carlo and
/// Quasi-Monte Carlo Methods 1998.
///
/// # Errors
/// [`StatisticsError::Design`] without points or factors, or with more than [`SOBOL_FACTORS`].
pub fn sobol(points: usize, factors: usize, seed: u64) -> Result<Vec<Vec<f64>>, StatisticsError> {
    refuse_empty(points, factors)?;
    if factors > SOBOL_FACTORS {
        let cure = format!("a Sobol sequence has at most {SOBOL_FACTORS} factors; use a Latin hypercube");
        return Err(StatisticsError::Design { points, factors, cure });
    }
    let mut sequence = Sequence::new(factors, seed);
    let next = |_| {
        let mut point = vec![0.0; factors];
        sequence.next_point(&mut point);
        point
    };
    Ok((0..points).map(next).collect())
}

fn refuse_empty(points: usize, factors: usize) -> Result<(), StatisticsError> {
    if points == 0 || factors == 0 {
        let cure = "ask for at least one point and one factor".to_owned();
        return Err(StatisticsError::Design { points, factors, cure });
    }
    Ok(())
}

/// The random numbers of a design's seed.
pub(super) fn generator(seed: u64) -> Draws {
    Draws::new(seed, 0xcafe_f00d_d15e_a5e5)
}

/// A Latin hypercube, not optimised.
fn one_hypercube(points: usize, factors: usize, random: &mut Draws) -> Vec<Vec<f64>> {
    let mut design = vec![vec![0.0; factors]; points];
    let mut order: Vec<usize> = (0..points).collect();
    for factor in 0..factors {
        for last in (1..points).rev() {
            order.swap(last, random.below(last + 1));
        }
        for (point, interval) in design.iter_mut().zip(&order) {
            // The last interval ends below 1 although the sum may round up to it.
            let place = (*interval as f64 + random.uniform()) / points as f64;
            point[factor] = place.min(1.0 - f64::EPSILON);
        }
    }
    design
}

/// The smallest squared distance between two points.
fn smallest_distance(design: &[Vec<f64>]) -> f64 {
    let squared = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    let from =
        |(n, a): (usize, &Vec<f64>)| design[..n].iter().map(|b| squared(a, b)).fold(f64::MAX, f64::min);
    design.iter().enumerate().map(from).fold(f64::MAX, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_latin_hypercube_has_one_point_in_every_interval_of_every_factor() {
        for (points, factors) in [(1, 1), (2, 3), (17, 16), (400, 5)] {
            let design = latin_hypercube(points, factors, 3).unwrap();
            for factor in 0..factors {
                let mut seen = vec![false; points];
                for point in &design {
                    assert!((0.0..1.0).contains(&point[factor]));
                    let interval = (point[factor] * points as f64) as usize;
                    assert!(!std::mem::replace(&mut seen[interval], true));
                }
            }
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_design_and_another_seed_another() {
        assert_eq!(latin_hypercube(20, 4, 1), latin_hypercube(20, 4, 1));
        assert_ne!(latin_hypercube(20, 4, 1), latin_hypercube(20, 4, 2));
        assert_eq!(sobol(20, 16, 1), sobol(20, 16, 1));
        assert_ne!(sobol(20, 16, 1), sobol(20, 16, 2));
        // The bits of one design, so that a change of the generator does not go unnoticed.
        let corner = latin_hypercube(3, 2, 7).unwrap()[0][0];
        assert_eq!(corner.to_bits(), PINNED, "{corner}");
    }
    const PINNED: u64 = 4_593_131_699_713_223_085;

    #[test]
    fn the_best_of_many_hypercubes_is_wider_than_the_first() {
        let first = one_hypercube(30, 3, &mut generator(5));
        let best = latin_hypercube(30, 3, 5).unwrap();
        assert!(smallest_distance(&best) > 1.5 * smallest_distance(&first));
    }

    #[test]
    fn a_sobol_design_integrates_better_than_chance() {
        let design = sobol(1024, 16, 11).unwrap();
        let mean = |f: &dyn Fn(&[f64]) -> f64| design.iter().map(|x| f(x)).sum::<f64>() / 1024.0;
        assert!((mean(&|x| x.iter().sum()) - 8.0).abs() < 5e-3);
        assert!((mean(&|x| 4.0 * x[0] * x[15]) - 1.0).abs() < 5e-3);
    }

    #[test]
    fn impossible_designs_are_refused() {
        assert!(latin_hypercube(0, 2, 0).is_err() && latin_hypercube(2, 0, 0).is_err());
        assert!(sobol(8, 0, 0).is_err() && sobol(8, SOBOL_FACTORS + 1, 0).is_err());
    }
}
