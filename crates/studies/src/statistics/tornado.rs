//! The tornado of a response: how far it swings as one factor goes from its low to its high end, the others
//! held.

use super::StatisticsError;
use super::data::check;
use super::effects::main_effect;
use super::gaussian_process::GaussianProcess;
use std::collections::BTreeMap;

/// Where the numbers of a tornado come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwingSource {
    /// From points that differ from the base point in one factor only.
    OneAtATime,
    /// From a surrogate, the other factors at their means.
    Surrogate,
    /// From the mean response over all points at the ends of the factor.
    MainEffects,
}

/// The swing of a response with one factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// Number of the factor.
    pub factor: usize,
    /// Low and high end of the factor, in its unit.
    pub ends: [f64; 2],
    /// The response at the ends of the factor, in the unit of the response.
    pub responses: [f64; 2],
}

/// The swings of a response with all factors that vary, the widest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Tornado {
    /// The response at the base point, or its mean over all points.
    pub base: f64,
    /// One swing for each factor that varies.
    pub swings: Vec<Swing>,
    /// Where the swings come from.
    pub source: SwingSource,
}

impl Tornado {
    fn new(base: f64, mut swings: Vec<Swing>, source: SwingSource) -> Self {
        let width = |swing: &Swing| (swing.responses[1] - swing.responses[0]).abs();
        swings.sort_by(|a, b| width(b).total_cmp(&width(a)).then(a.factor.cmp(&b.factor)));
        Self { base, swings, source }
    }
}

/// The tornado of a response at inputs, `n × factors` numbers: from one-at-a-time points where every factor
/// that varies has them, else from the surrogate where there is one that predicts, else from main effects.
///
/// # Errors
/// [`StatisticsError`] for fewer than two points, lists that do not agree, numbers that are not finite, and
/// inputs that are all equal.
pub fn tornado(
    inputs: &[Vec<f64>],
    values: &[f64],
    surrogate: Option<&GaussianProcess>,
) -> Result<Tornado, StatisticsError> {
    let factors = check(inputs, values, 2, "a tornado")?;
    let column = |k: usize| inputs.iter().map(|input| input[k]).collect::<Vec<f64>>();
    let ends = |k: usize| {
        let column = column(k);
        [
            column.iter().copied().fold(f64::INFINITY, f64::min),
            column.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ]
    };
    let varying: Vec<(usize, [f64; 2])> =
        (0..factors).map(|k| (k, ends(k))).filter(|(_, [low, high])| high > low).collect();
    if varying.is_empty() {
        return Err(StatisticsError::EqualInputs);
    }
    if let Some(found) = one_at_a_time(inputs, values, &varying) {
        return Ok(found);
    }
    let count = values.len() as f64;
    if let Some(process) = surrogate.and_then(|process| process.trusted().ok()) {
        let middle: Vec<f64> = (0..factors).map(|k| column(k).iter().sum::<f64>() / count).collect();
        let at = |k: usize, x: f64| {
            let mut place = middle.clone();
            place[k] = x;
            process.mean(&place)
        };
        let swing = |(k, ends): &(usize, [f64; 2])| Swing {
            factor: *k,
            ends: *ends,
            responses: ends.map(|x| at(*k, x)),
        };
        return Ok(Tornado::new(
            process.mean(&middle),
            varying.iter().map(swing).collect(),
            SwingSource::Surrogate,
        ));
    }
    let swing = |(k, _): &(usize, [f64; 2])| {
        let effect = main_effect(&column(*k), values)?;
        let ends = [effect[0], effect[effect.len() - 1]];
        Ok(Swing { factor: *k, ends: ends.map(|end| end.level), responses: ends.map(|end| end.mean) })
    };
    let swings = varying.iter().map(swing).collect::<Result<Vec<_>, StatisticsError>>()?;
    Ok(Tornado::new(values.iter().sum::<f64>() / count, swings, SwingSource::MainEffects))
}

/// The tornado about the point that most others differ from in one factor only; `None` where a factor has no
/// such points.
fn one_at_a_time(inputs: &[Vec<f64>], values: &[f64], varying: &[(usize, [f64; 2])]) -> Option<Tornado> {
    let middle: Vec<f64> = varying
        .iter()
        .map(|(k, _)| inputs.iter().map(|x| x[*k]).sum::<f64>() / inputs.len() as f64)
        .collect();
    // Of a grid every point will do: then the one nearest to the middle.
    let distance = |n: usize| -> f64 {
        let part = |((k, [low, high]), middle): (&(usize, [f64; 2]), &f64)| {
            ((inputs[n][*k] - middle) / (high - low)).powi(2)
        };
        varying.iter().zip(&middle).map(part).sum()
    };
    let ranked: Vec<(usize, f64)> =
        neighbours(inputs).into_iter().enumerate().map(|(n, count)| (count, distance(n))).collect();
    // The first of equals, so that the choice does not hang on the order of comparison.
    let base = (0..inputs.len())
        .rev()
        .max_by(|a, b| ranked[*a].0.cmp(&ranked[*b].0).then(ranked[*b].1.total_cmp(&ranked[*a].1)))?;
    let swings = varying.iter().map(|(k, _)| {
        let mut slice = vec![(inputs[base][*k], values[base])];
        let along = inputs.iter().zip(values).filter(|(other, _)| only(&inputs[base], other) == Some(*k));
        slice.extend(along.map(|(other, value)| (other[*k], *value)));
        let low = slice.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0))?;
        let high = slice.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0))?;
        (high.0 > low.0).then_some(Swing { factor: *k, ends: [low.0, high.0], responses: [low.1, high.1] })
    });
    Some(Tornado::new(values[base], swings.collect::<Option<Vec<_>>>()?, SwingSource::OneAtATime))
}

/// For each point the number of those that differ from it in one factor at most, itself counted once for each
/// factor.
fn neighbours(inputs: &[Vec<f64>]) -> Vec<usize> {
    let mut counts = vec![0; inputs.len()];
    for k in 0..inputs.first().map_or(0, Vec::len) {
        let others = |input: &Vec<f64>| -> Vec<u64> {
            // Adding zero makes both zeros alike.
            let bits = |(n, x): (usize, &f64)| if n == k { 0 } else { (x + 0.0).to_bits() };
            input.iter().enumerate().map(bits).collect()
        };
        let mut groups: BTreeMap<Vec<u64>, Vec<usize>> = BTreeMap::new();
        for (n, input) in inputs.iter().enumerate() {
            groups.entry(others(input)).or_default().push(n);
        }
        for group in groups.values() {
            group.iter().for_each(|n| counts[*n] += group.len());
        }
    }
    counts
}

/// The one factor in which two inputs differ; `None` where they differ in none or in several.
fn only(a: &[f64], b: &[f64]) -> Option<usize> {
    let mut different = (0..a.len()).filter(|k| a[*k] != b[*k]);
    let first = different.next()?;
    different.next().is_none().then_some(first)
}

#[cfg(test)]
mod tests {
    use super::super::design::sobol;
    use super::super::gaussian_process::fit;
    use super::*;

    fn response(x: &[f64]) -> f64 {
        10.0 + 2.0 * x[0] - 6.0 * x[1] + x[0] * x[1]
    }

    #[test]
    fn points_that_differ_in_one_factor_are_used() {
        let inputs: Vec<Vec<f64>> =
            [[1.0, 1.0], [0.0, 1.0], [2.0, 1.0], [1.0, 0.5], [1.0, 3.0]].iter().map(|x| x.to_vec()).collect();
        let values: Vec<f64> = inputs.iter().map(|x| response(x)).collect();
        let found = tornado(&inputs, &values, None).unwrap();
        assert_eq!((found.source, found.base), (SwingSource::OneAtATime, 7.0));
        assert_eq!(found.swings[0], Swing { factor: 1, ends: [0.5, 3.0], responses: [9.5, -3.0] });
        assert_eq!(found.swings[1], Swing { factor: 0, ends: [0.0, 2.0], responses: [4.0, 10.0] });
    }

    #[test]
    fn of_a_grid_the_middle_is_the_base() {
        let inputs: Vec<Vec<f64>> =
            (0..5).flat_map(|a| (0..3).map(move |b| vec![f64::from(a), f64::from(b)])).collect();
        let values: Vec<f64> = inputs.iter().map(|x| response(x)).collect();
        let found = tornado(&inputs, &values, None).unwrap();
        assert_eq!((found.source, found.base), (SwingSource::OneAtATime, response(&[2.0, 1.0])));
    }

    #[test]
    fn other_designs_go_through_a_surrogate_or_main_effects() {
        let inputs = sobol(64, 2, 1).unwrap();
        let values: Vec<f64> = inputs.iter().map(|x| response(x)).collect();
        let rough = tornado(&inputs, &values, None).unwrap();
        assert_eq!((rough.source, rough.swings[0].factor), (SwingSource::MainEffects, 1));
        let process = fit(&inputs, &values).unwrap();
        let fine = tornado(&inputs, &values, Some(&process)).unwrap();
        assert_eq!(fine.source, SwingSource::Surrogate);
        let [low, high] = fine.swings[0].responses;
        assert!((high - low + 5.5).abs() < 0.2, "{fine:?}");
        assert_eq!(tornado(&[vec![1.0], vec![1.0]], &[1.0, 2.0], None), Err(StatisticsError::EqualInputs));
    }
}
