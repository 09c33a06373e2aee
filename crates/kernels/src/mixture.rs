//! Cells whose soil is of several materials.

/// Number of the main material of a cell: the one with the largest volume, from the fractions of the second
/// material, the third, ….
#[inline(always)]
pub fn main_material(others: impl Iterator<Item = f64> + Clone) -> usize {
    let first = (0, 1.0 - others.clone().sum::<f64>());
    let most = |a: (usize, f64), b: (usize, f64)| if b.1 > a.1 { b } else { a };
    others.enumerate().map(|(n, portion)| (n + 1, portion)).fold(first, most).0
}

/// Mass of a cell [kg] if all of its soil, as compressed as it is, were of its main material, from the mass
/// and the densities of the undeformed materials: a law knows densities of its own soil alone.
#[inline(always)]
pub fn mass_as_main(densities: &[f64], others: impl Iterator<Item = f64> + Clone, mass: f64) -> f64 {
    let mixed = densities[1..]
        .iter()
        .zip(others.clone())
        .fold(densities[0], |sum, (density, portion)| sum + portion * (density - densities[0]));
    mass * densities[main_material(others)] / mixed
}
