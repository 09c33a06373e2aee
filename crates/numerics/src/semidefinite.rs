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
    fn a_repeated_row_is_left_out() {
        let mut a = [2.0, 2.0, 1.0, 2.0, 2.0, 1.0, 1.0, 1.0, 3.0];
        let mut b = [3.0, 3.0, 4.0];
        factor(&mut a, 3);
        solve(&a, &mut b);
        assert_eq!(b[1], 0.0);
        assert!((b[0] - 1.0).abs() < 1e-15 && (b[2] - 1.0).abs() < 1e-15, "{b:?}");
    }
}
