//! Exact sums over all blocks of a grid.

use crate::halo::Halo;
pub use ::kernels::exact_sum::ExactSum;

/// The values of some sums over all blocks.
pub fn over_blocks<const N: usize>(halo: &Halo, sums: [ExactSum; N]) -> [f64; N] {
    begin_over_blocks(halo, sums, &[]);
    end_over_blocks(halo, sums).0
}

/// Begins to add some sums over all blocks, and to find the largest of other values in any of them.
pub(crate) fn begin_over_blocks<const N: usize>(halo: &Halo, sums: [ExactSum; N], compared: &[f64]) {
    if !halo.is_alone() {
        halo.begin_reduction(sums.into_iter().flat_map(ExactSum::numbers).collect(), compared.to_vec());
    }
}

/// The values of the sums over all blocks, from those of this one, and the largest of the other values, if
/// there are several blocks.
pub(crate) fn end_over_blocks<const N: usize>(halo: &Halo, mut own: [ExactSum; N]) -> ([f64; N], Vec<f64>) {
    let (digits, largest) = halo.end_reduction();
    for (sum, digits) in own.iter_mut().zip(digits.as_chunks().0) {
        *sum = ExactSum::of_numbers(*digits);
    }
    (own.map(ExactSum::value), largest)
}
