//! The minimum of a smooth function of a few variables: the BFGS method with a backtracking line search.

use crate::symmetric::dot;

/// Steps of a search at most (chosen).
const STEPS: usize = 80;
/// Largest change of a variable in a step (chosen): they are logarithms.
const LARGEST_STEP: f64 = 1.5;
/// Decrease below which a search ends (chosen): differences of likelihoods that mean nothing.
const SMALL: f64 = 1e-5;
/// Portion of the decrease that the slope promises with which a step is content. Source: Nocedal & Wright
/// (2006), eq. (3.4).
const SUFFICIENT: f64 = 1e-4;

/// A minimum.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimum {
    /// Place of the minimum.
    pub place: Vec<f64>,
    /// The value there.
    pub value: f64,
}

/// Searches downhill from `start`. `function` gives value and gradient, `None` where it has none; then the
/// step is shortened.
///
/// `None` where the start has no value. Source: Nocedal & Wright (2006), *Numerical Optimization*, algorithm
/// 6.1.
pub fn minimise(start: Vec<f64>, function: impl Fn(&[f64]) -> Option<(f64, Vec<f64>)>) -> Option<Minimum> {
    let (mut value, mut gradient) = function(&start)?;
    let mut place = start;
    let mut inverse = identity(place.len());
    for _ in 0..STEPS {
        let mut direction: Vec<f64> = inverse.iter().map(|row| -dot(row, &gradient)).collect();
        if dot(&direction, &gradient) >= 0.0 {
            inverse = identity(place.len());
            direction = gradient.iter().map(|g| -g).collect();
        }
        let largest = direction.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if largest > LARGEST_STEP {
            direction.iter_mut().for_each(|x| *x *= LARGEST_STEP / largest);
        }
        let Some((length, next)) = line_search(&place, &direction, value, &gradient, &function) else {
            break;
        };
        let step: Vec<f64> = direction.iter().map(|x| length * x).collect();
        let change: Vec<f64> = next.1.iter().zip(&gradient).map(|(new, old)| new - old).collect();
        place.iter_mut().zip(&step).for_each(|(x, s)| *x += s);
        let gain = value - next.0;
        (value, gradient) = next;
        if gain < SMALL {
            break;
        }
        update(&mut inverse, &step, &change);
    }
    Some(Minimum { place, value })
}

/// The length of a step that decreases the function enough, with value and gradient behind it.
fn line_search(
    place: &[f64],
    direction: &[f64],
    value: f64,
    gradient: &[f64],
    function: &impl Fn(&[f64]) -> Option<(f64, Vec<f64>)>,
) -> Option<(f64, (f64, Vec<f64>))> {
    let slope = dot(direction, gradient);
    let mut length = 1.0;
    for _ in 0..12 {
        let there: Vec<f64> = place.iter().zip(direction).map(|(x, d)| x + length * d).collect();
        if let Some(next) = function(&there).filter(|next| next.0 <= value + SUFFICIENT * length * slope) {
            return Some((length, next));
        }
        length *= 0.4;
    }
    None
}

fn identity(size: usize) -> Vec<Vec<f64>> {
    (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

/// The inverse of the matrix of second derivatives, corrected by a step. Source: Nocedal & Wright (2006), eq.
/// (6.17).
fn update(inverse: &mut [Vec<f64>], step: &[f64], change: &[f64]) {
    let curvature = dot(step, change);
    // Without curvature along the step the matrix would cease to be positive definite.
    if curvature <= 1e-10 * dot(step, step).sqrt() * dot(change, change).sqrt() {
        return;
    }
    let moved: Vec<f64> = inverse.iter().map(|row| dot(row, change)).collect();
    let scale = (1.0 + dot(change, &moved) / curvature) / curvature;
    for (i, row) in inverse.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry += scale * step[i] * step[j] - (step[i] * moved[j] + moved[i] * step[j]) / curvature;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_valley_of_rosenbrock_is_followed_to_its_end() {
        let valley = |x: &[f64]| {
            let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
            // No value on one side, as where a matrix is not positive definite.
            (x[0] < 1.2).then(|| (a * a + 100.0 * b * b, vec![-2.0 * a - 400.0 * x[0] * b, 200.0 * b]))
        };
        let found = minimise(vec![-1.2, 1.0], valley).unwrap();
        assert!(found.value < 1e-5 && (found.place[0] - 1.0).abs() < 1e-2, "{found:?}");
        assert!(minimise(vec![2.0, 0.0], valley).is_none());
    }
}
