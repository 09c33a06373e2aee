//! Loops over one row of cells, without branches, compiled for several instruction sets.

use crate::scalar::Scalar;
use multiversion::multiversion;

/// What flows out of the cells of a row at some pressures: of each cell the sum of conductance times
/// difference over its neighbours. `at` and `conductance` hold the whole grid, the cells begin at `start`;
/// `stride` leads to the next ones along y, z. The two neighbours along an axis are added first, so that a
/// mirrored case gives mirrored sums.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub(super) fn outflow(
    at: &[f64],
    conductance: &[Vec<f64>; 3],
    diagonal: &[f64],
    start: usize,
    [y, z]: [usize; 2],
    out: &mut [f64],
) {
    let n = out.len();
    let own = &at[start..][..n];
    let [left, right] = [&at[start - 1..][..n], &at[start + 1..][..n]];
    let [behind, ahead] = [&at[start - y..][..n], &at[start + y..][..n]];
    let [below, above] = [&at[start - z..][..n], &at[start + z..][..n]];
    let [cx, cy, cz] = conductance.each_ref().map(Vec::as_slice);
    let [to_left, to_right] = [&cx[start - 1..][..n], &cx[start..][..n]];
    let [to_behind, to_ahead] = [&cy[start - y..][..n], &cy[start..][..n]];
    let [to_below, to_above] = [&cz[start - z..][..n], &cz[start..][..n]];
    let diagonal = &diagonal[start..][..n];
    for i in 0..n {
        let x = to_left[i] * left[i] + to_right[i] * right[i];
        let y = to_behind[i] * behind[i] + to_ahead[i] * ahead[i];
        let z = to_below[i] * below[i] + to_above[i] * above[i];
        out[i] = diagonal[i] * own[i] - (x + y + z);
    }
}

/// Rate at which the volume of the soil in each cell of a row grows [m³/s], from the velocities of the four
/// rows of nodes round it, as the Lagrangian stage strains it. Widths along x are those of the cells; `area`
/// and `widths` those along y and z.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub(super) fn expansion<R: Scalar>(
    velocity: &[Vec<R>; 3],
    starts: [usize; 4],
    fraction: &[R],
    width_x: &[R],
    [hy, hz]: [f64; 2],
    out: &mut [f64],
) {
    let n = out.len();
    let node_row = |component: usize, row: usize| &velocity[component][starts[row]..][..n + 1];
    let [x0, x1, x2, x3] = [0, 1, 2, 3].map(|row| node_row(0, row));
    let [y0, y1, y2, y3] = [0, 1, 2, 3].map(|row| node_row(1, row));
    let [z0, z1, z2, z3] = [0, 1, 2, 3].map(|row| node_row(2, row));
    let (fraction, width_x) = (&fraction[..n], &width_x[..n]);
    for i in 0..n {
        let hx = width_x[i].to_f64();
        let difference = |v: &[R], i: usize| v[i + 1].to_f64() - v[i].to_f64();
        let sum = |v: &[R], i: usize| v[i + 1].to_f64() + v[i].to_f64();
        let x = (difference(x0, i) + difference(x1, i)) + (difference(x2, i) + difference(x3, i));
        let y = (sum(y1, i) - sum(y0, i)) + (sum(y3, i) - sum(y2, i));
        let z = (sum(z2, i) + sum(z3, i)) - (sum(z0, i) + sum(z1, i));
        out[i] = 0.25 * fraction[i].to_f64() * (x * hy * hz + y * hx * hz + z * hx * hy);
    }
}

/// Sum of the products of two rows, weighted: Σ a b w. In eight partial sums, in an order that does not
/// depend on the compiler.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub(super) fn weighted(a: &[f64], b: &[f64], w: &[f64]) -> f64 {
    let n = a.len();
    let (a, b, w) = (&a[..n], &b[..n], &w[..n]);
    let mut sums = [0.0; 8];
    let whole = n - n % 8;
    for first in (0..whole).step_by(8) {
        for lane in 0..8 {
            sums[lane] += a[first + lane] * b[first + lane] * w[first + lane];
        }
    }
    let rest = (whole..n).map(|i| a[i] * b[i] * w[i]).fold(0.0, |sum, own| sum + own);
    sums.iter().fold(rest, |sum, own| sum + own)
}

/// Sum of the products of two rows.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len();
    let (a, b) = (&a[..n], &b[..n]);
    let mut sums = [0.0; 8];
    let whole = n - n % 8;
    for first in (0..whole).step_by(8) {
        for lane in 0..8 {
            sums[lane] += a[first + lane] * b[first + lane];
        }
    }
    let rest = (whole..n).map(|i| a[i] * b[i]).fold(0.0, |sum, own| sum + own);
    sums.iter().fold(rest, |sum, own| sum + own)
}
