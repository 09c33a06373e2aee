//! Numerical tools shared by the models: roots, minima, quadrature.

/// Abscissae of the 16-point Gauss–Legendre rule on (−1, 1), positive half (Abramowitz & Stegun 1964, table 25.4).
const GAUSS_NODES: [f64; 8] = [
    0.095_012_509_837_637_44,
    0.281_603_550_779_258_9,
    0.458_016_777_657_227_4,
    0.617_876_244_402_643_7,
    0.755_404_408_355_003,
    0.865_631_202_387_831_7,
    0.944_575_023_073_232_6,
    0.989_400_934_991_649_9,
];
/// Weights that go with [`GAUSS_NODES`].
const GAUSS_WEIGHTS: [f64; 8] = [
    0.189_450_610_455_068_5,
    0.182_603_415_044_923_6,
    0.169_156_519_395_002_54,
    0.149_595_988_816_576_73,
    0.124_628_971_255_533_87,
    0.095_158_511_682_492_78,
    0.062_253_523_938_647_89,
    0.027_152_459_411_754_095,
];

/// Points and weights of the 16-point Gauss–Legendre rule on `[from, to]`.
pub(crate) fn gauss_points(from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    GAUSS_NODES
        .into_iter()
        .zip(GAUSS_WEIGHTS)
        .flat_map(move |(x, w)| [(middle - half * x, half * w), (middle + half * x, half * w)])
}

/// A root of `f` between `a` and `b`, where its signs differ, by the Anderson–Björck variant of false position with
/// bisection as a safeguard. `None` if the signs do not differ or `f` is not a number there.
///
/// Source: Anderson & Björck (1973), BIT 13, 253–264.
pub(crate) fn root(mut a: f64, mut b: f64, tolerance: f64, mut f: impl FnMut(f64) -> f64) -> Option<f64> {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return Some(a);
    }
    if fb == 0.0 {
        return Some(b);
    }
    if fa.is_nan() || fb.is_nan() || fa.signum() == fb.signum() {
        return None;
    }
    let mut best = if fa.abs() < fb.abs() { (a, fa.abs()) } else { (b, fb.abs()) };
    for step in 0..200 {
        // Every fourth step bisects, so that the bracket shrinks for any `f`.
        let secant = (fa * b - fb * a) / (fa - fb);
        let bisect = step % 4 == 3 || !secant.is_finite();
        let c = if bisect { 0.5 * (a + b) } else { secant };
        // When two secant steps are this close, the last is far closer to the root than the tolerance.
        if !bisect && (c - b).abs() <= tolerance {
            return Some(c);
        }
        let fc = f(c);
        if fc == 0.0 {
            return Some(c);
        }
        if fc.is_nan() {
            return None;
        }
        if fc.abs() < best.1 {
            best = (c, fc.abs());
        }
        if (b - a).abs() <= 1e-3 * tolerance {
            break;
        }
        if fc * fb < 0.0 {
            (a, fa) = (b, fb);
        } else {
            let shrink = 1.0 - fc / fb;
            fa *= if shrink > 0.0 { shrink } else { 0.5 };
        }
        (b, fb) = (c, fc);
    }
    Some(best.0)
}

/// Position and value of the minimum of a unimodal `f` on `[a, b]`, by golden-section search.
pub(crate) fn minimum(mut a: f64, mut b: f64, steps: usize, f: impl Fn(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut fc, mut fd) = (f(c), f(d));
    for _ in 0..steps {
        if fc < fd {
            (b, d, fd) = (d, c, fc);
            c = b - GOLDEN * (b - a);
            fc = f(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + GOLDEN * (b - a);
            fd = f(d);
        }
    }
    if fc < fd { (c, fc) } else { (d, fd) }
}

/// The solution x of A x = b by elimination with partial pivoting; `None` if A is singular. Rows of A are overwritten.
pub(crate) fn solve_linear(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for column in 0..n {
        let pivot = (column..n).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        right.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let base = &above[column];
        if base[column] == 0.0 || !base[column].is_finite() {
            return None;
        }
        for (offset, row) in below.iter_mut().enumerate() {
            let factor = row[column] / base[column];
            for (entry, of_base) in row[column..].iter_mut().zip(&base[column..]) {
                *entry -= factor * of_base;
            }
            right[column + 1 + offset] -= factor * right[column];
        }
    }
    for column in (0..n).rev() {
        let known: f64 = (column + 1..n).map(|other| rows[column][other] * right[other]).sum();
        right[column] = (right[column] - known) / rows[column][column];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrature_is_exact_for_a_high_polynomial() {
        let sum: f64 = gauss_points(0.0, 1.0).map(|(x, w)| w * x.powi(20)).sum();
        assert!((sum - 1.0 / 21.0).abs() < 1e-14);
    }

    #[test]
    fn a_root_is_found_where_there_is_one() {
        let found = root(0.0, 2.0, 1e-13, |x| x * x - 2.0).unwrap();
        assert!((found - 2.0_f64.sqrt()).abs() < 1e-12);
        assert!(root(0.0, 1.0, 1e-12, |x| x + 1.0).is_none());
    }

    #[test]
    fn linear_equations_are_solved_and_singular_ones_refused() {
        let found = solve_linear(vec![vec![0.0, 2.0], vec![3.0, 1.0]], vec![4.0, 5.0]).unwrap();
        assert!((found[0] - 1.0).abs() < 1e-14 && (found[1] - 2.0).abs() < 1e-14);
        assert!(solve_linear(vec![vec![1.0, 2.0], vec![2.0, 4.0]], vec![1.0, 2.0]).is_none());
    }

    #[test]
    fn a_minimum_is_found() {
        assert!((minimum(0.0, 3.0, 60, |x| (x - 1.3).powi(2)).0 - 1.3).abs() < 1e-7);
    }
}
