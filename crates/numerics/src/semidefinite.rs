//! Small dense symmetric systems of equations.

/// A pivot below this fraction of its diagonal entry means that the row repeats earlier ones.
const REDUNDANT: f64 = 1e-12;

/// Factors a symmetric, positive semi-definite matrix of `n` rows in place: A = L D Lᵀ, with L below the
/// diagonal and the inverse of D on it. Rows that repeat earlier ones get an inverse of 0: their unknown is 0
/// and their equation is left to the others.
pub fn factor(a: &mut [f64], n: usize) {
    for i in 0..n {
        let diagonal = a[i * n + i];
        for j in 0..i {
            let known: f64 = (0..j).map(|k| a[i * n + k] * a[j * n + k]).sum();
            a[i * n + j] -= known;
        }
        let mut pivot = diagonal;
        for j in 0..i {
            let scaled = a[i * n + j] * a[j * n + j];
            pivot -= a[i * n + j] * scaled;
            a[i * n + j] = scaled;
        }
        a[i * n + i] = if pivot > REDUNDANT * diagonal { 1.0 / pivot } else { 0.0 };
    }
}

/// Solves the factored system for the right-hand side `b`, in place.
pub fn solve(factors: &[f64], b: &mut [f64]) {
    let n = b.len();
    for i in 0..n {
        let known: f64 = (0..i).map(|j| factors[i * n + j] * b[j]).sum();
        b[i] -= known;
    }
    for i in 0..n {
        b[i] *= factors[i * n + i];
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| factors[j * n + i] * b[j]).sum();
        b[i] -= known;
    }
}

/// Whether a symmetric matrix of `n` rows is positive semi-definite, up to round-off. Rows may differ in
/// unit.
#[must_use]
pub fn is_semidefinite(a: &[f64], n: usize) -> bool {
    const ROUND_OFF: f64 = 1e-9;
    let scale: Vec<f64> = (0..n).map(|i| a[i * n + i]).collect();
    if !a.iter().all(|entry| entry.is_finite()) || scale.iter().any(|diagonal| *diagonal < 0.0) {
        return false;
    }
    let mut scaled = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            let size = (scale[i] * scale[j]).sqrt();
            let entry = a[i * n + j];
            if size == 0.0 && entry != 0.0 {
                return false;
            }
            scaled[i * n + j] = if size > 0.0 { entry / size } else { 0.0 };
        }
        scaled[i * n + i] += ROUND_OFF;
    }
    // With the round-off added it is definite, and has a Cholesky factor.
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| scaled[i * n + k] * scaled[j * n + k]).sum();
            let rest = scaled[i * n + j] - known;
            if i == j {
                if rest <= 0.0 {
                    return false;
                }
                scaled[i * n + i] = rest.sqrt();
            } else {
                scaled[i * n + j] = rest / scaled[j * n + j];
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_systems_are_solved() {
        let mut a = [4.0, 1.0, 0.5, 1.0, 3.0, -1.0, 0.5, -1.0, 2.0];
        let x = [1.0, -2.0, 0.5];
        let mut b: Vec<f64> = (0..3).map(|i| (0..3).map(|j| a[3 * i + j] * x[j]).sum()).collect();
        factor(&mut a, 3);
        solve(&a, &mut b);
        assert!(b.iter().zip(x).all(|(b, x)| (b - x).abs() < 1e-14), "{b:?}");
    }

    #[test]
    fn semidefinite_matrices_are_told_from_others() {
        assert!(is_semidefinite(&[4.0, 1e-6, 1e-6, 1e-12], 2));
        assert!(is_semidefinite(&[1.0, 2.0, 2.0, 4.0], 2) && is_semidefinite(&[0.0; 9], 3));
        for wrong in
            [[1.0, 2.0, 2.0, 3.9], [-1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 1.0, 1.0], [f64::NAN, 0.0, 0.0, 1.0]]
        {
            assert!(!is_semidefinite(&wrong, 2), "{wrong:?}");
        }
    }

    #[test]
    fn a_repeated_row_is_left_out() {
        let mut a = [2.0, 2.0, 1.0, 2.0, 2.0, 1.0, 1.0, 1.0, 3.0];
        let mut b = [3.0, 3.0, 4.0];
        factor(&mut a, 3);
        solve(&a, &mut b);
        assert_eq!(b[1], 0.0);
        assert!((b[0] - 1.0).abs() < 1e-15 && (b[2] - 1.0).abs() < 1e-15, "{b:?}");
    }
}
