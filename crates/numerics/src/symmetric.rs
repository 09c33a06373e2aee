//! Dense symmetric matrices: Cholesky factor, solution, inverse, eigenvectors.
//!
//! Sums run in one fixed order, so that the bits do not depend on the vector units of the machine, as those
//! of the libraries do.

/// Sums of a product that run side by side, so that they vectorise.
const LANES: usize = 8;

/// A square matrix, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Square {
    /// Rows, and columns.
    pub size: usize,
    /// Entries, `size × size`.
    pub entries: Vec<f64>,
}

impl Square {
    /// The symmetric matrix with these entries on and below the diagonal; those above are left at zero.
    pub fn lower(size: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut entries = vec![0.0; size * size];
        for i in 0..size {
            for j in 0..=i {
                entries[i * size + j] = entry(i, j);
            }
        }
        Self { size, entries }
    }

    /// A row, as far as the diagonal.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.entries[i * self.size..i * self.size + i + 1]
    }
}

/// The product of two vectors of equal length.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (whole_a, rest_a) = a.as_chunks::<LANES>();
    let (whole_b, rest_b) = b.as_chunks::<LANES>();
    for (a, b) in whole_a.iter().zip(whole_b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

/// The Cholesky factor L of a positive definite matrix A = L Lᵀ.
#[derive(Clone, Debug, PartialEq)]
pub struct Cholesky(Square);

impl Cholesky {
    /// Factorises the lower triangle of a matrix; `None` where it is not positive definite.
    pub fn of(mut matrix: Square) -> Option<Self> {
        let size = matrix.size;
        for i in 0..size {
            let (above, rest) = matrix.entries.split_at_mut(i * size);
            let row = &mut rest[..=i];
            for j in 0..i {
                let other = &above[j * size..=j * size + j];
                row[j] = (row[j] - dot(&row[..j], &other[..j])) / other[j];
            }
            let square = row[i] - dot(&row[..i], &row[..i]);
            // Written so that a number that is not one fails, too.
            if !(square > 0.0 && square.is_finite()) {
                return None;
            }
            row[i] = square.sqrt();
        }
        Some(Self(matrix))
    }

    /// The factor with these entries on its diagonal, and zeros beside it.
    pub fn diagonal(entries: &[f64]) -> Self {
        Self(Square::lower(entries.len(), |i, j| if i == j { entries[i] } else { 0.0 }))
    }

    /// The logarithm of the determinant of A.
    pub fn log_determinant(&self) -> f64 {
        (0..self.0.size).map(|i| 2.0 * self.0.row(i)[i].ln()).sum()
    }

    /// The smallest entry of the diagonal of L, squared: what is left of a column when those before it are
    /// taken out.
    pub fn smallest(&self) -> f64 {
        (0..self.0.size).map(|i| self.0.row(i)[i]).fold(f64::INFINITY, f64::min).powi(2)
    }

    /// L⁻¹ b.
    pub fn forward(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        for i in 0..x.len() {
            let row = self.0.row(i);
            x[i] = (x[i] - dot(&row[..i], &x[..i])) / row[i];
        }
        x
    }

    /// L⁻ᵀ b.
    pub fn backward(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        for i in (0..x.len()).rev() {
            let row = self.0.row(i);
            x[i] /= row[i];
            let (before, at) = x.split_at_mut(i);
            for (x, l) in before.iter_mut().zip(row) {
                *x -= l * at[0];
            }
        }
        x
    }

    /// A⁻¹ b.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        self.backward(&self.forward(b))
    }

    /// L z.
    pub fn times(&self, z: &[f64]) -> Vec<f64> {
        (0..self.0.size).map(|i| dot(self.0.row(i), &z[..=i])).collect()
    }

    /// The lower triangle of A⁻¹.
    pub fn inverse(&self) -> Square {
        let size = self.0.size;
        // Row j of U = (L⁻¹)ᵀ, from the diagonal on; then A⁻¹ = U Uᵀ, products of rows.
        let mut upper = vec![0.0; size * size];
        for j in 0..size {
            let row = &mut upper[j * size..(j + 1) * size];
            row[j] = 1.0 / self.0.row(j)[j];
            for i in j + 1..size {
                let factor = self.0.row(i);
                row[i] = -dot(&factor[j..i], &row[j..i]) / factor[i];
            }
        }
        Square::lower(size, |i, j| {
            dot(&upper[i * size + i..(i + 1) * size], &upper[j * size + i..(j + 1) * size])
        })
    }
}

/// Rotations of Jacobi's method after which it has converged.
const SWEEPS: usize = 60;

/// Eigenvalues, the largest first, and unit eigenvectors, one in each row, of a symmetric matrix of n rows
/// and n columns. Source: Jacobi's method as in Golub & Van Loan (2013), *Matrix Computations*, section 8.5.
pub fn eigen(matrix: &[Vec<f64>]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let size = matrix.len();
    let mut a = matrix.to_vec();
    let mut vectors: Vec<Vec<f64>> =
        (0..size).map(|n| (0..size).map(|m| f64::from(u8::from(m == n))).collect()).collect();
    for _ in 0..SWEEPS {
        let off: f64 = (0..size).map(|i| a[i][..i].iter().map(|x| x * x).sum::<f64>()).sum();
        let all: f64 = a.iter().flatten().map(|x| x * x).sum();
        if off <= 1e-26 * all {
            break;
        }
        for p in 0..size {
            for q in p + 1..size {
                rotate(&mut a, &mut vectors, (p, q));
            }
        }
    }
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|i, j| a[*j][*j].total_cmp(&a[*i][*i]));
    // Rows of `vectors` are eigenvectors.
    (order.iter().map(|n| a[*n][*n]).collect(), order.iter().map(|n| vectors[*n].clone()).collect())
}

/// Makes the entry p, q zero.
fn rotate(a: &mut [Vec<f64>], vectors: &mut [Vec<f64>], (p, q): (usize, usize)) {
    if a[p][q] == 0.0 {
        return;
    }
    let ratio = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
    let cos = 1.0 / t.hypot(1.0);
    let sin = t * cos;
    for row in a.iter_mut() {
        (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
    }
    for n in 0..a.len() {
        (a[p][n], a[q][n]) = (cos * a[p][n] - sin * a[q][n], sin * a[p][n] + cos * a[q][n]);
        (vectors[p][n], vectors[q][n]) =
            (cos * vectors[p][n] - sin * vectors[q][n], sin * vectors[p][n] + cos * vectors[q][n]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Entries of the Lehmer matrix, whose inverse is tridiagonal.
    fn lehmer(i: usize, j: usize) -> f64 {
        (i.min(j) + 1) as f64 / (i.max(j) + 1) as f64
    }

    #[test]
    fn solution_and_inverse_belong_to_the_matrix() {
        let size = 27;
        let factor = Cholesky::of(Square::lower(size, lehmer)).unwrap();
        let inverse = factor.inverse();
        for i in 0..size {
            let unit: Vec<f64> = (0..size).map(|k| f64::from(u8::from(k == i))).collect();
            let solution = factor.solve(&unit);
            let again = factor.times(&factor.forward(&unit));
            assert!(again.iter().zip(&unit).all(|(a, u)| (a - u).abs() < 1e-12));
            for j in 0..=i {
                assert!((inverse.row(i)[j] - solution[j]).abs() < 1e-11);
                let product: f64 = (0..size).map(|k| lehmer(j, k) * solution[k]).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-11);
                assert!(i - j < 2 || inverse.row(i)[j].abs() < 1e-11);
            }
        }
        let pair = Cholesky::of(Square::lower(2, |i, j| if i == j { 2.0 } else { 1.0 })).unwrap();
        assert!((pair.log_determinant() - 3.0_f64.ln()).abs() < 1e-15);
    }

    #[test]
    fn what_is_not_positive_definite_is_refused() {
        assert!(Cholesky::of(Square::lower(2, |_, _| 1.0)).is_none());
        assert!(Cholesky::of(Square::lower(2, |_, _| f64::NAN)).is_none());
    }
    #[test]
    fn eigenvectors_make_up_the_matrix() {
        let matrix = vec![vec![4.0, 1.0, 0.5], vec![1.0, 3.0, -0.2], vec![0.5, -0.2, 2.0]];
        let (values, vectors) = eigen(&matrix);
        for i in 0..3 {
            for j in 0..3 {
                let again: f64 = (0..3).map(|k| values[k] * vectors[k][i] * vectors[k][j]).sum();
                assert!((again - matrix[i][j]).abs() < 1e-12);
            }
        }
        assert!(values.windows(2).all(|pair| pair[0] >= pair[1]));
    }
}
