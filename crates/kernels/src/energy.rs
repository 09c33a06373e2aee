//! Energies of a row, summed in double precision.

use super::Real;
use crate::layout::LANES;
use ::physics::elastic::{Elastic, Stiffening};
use ::physics::tensor::Symmetric;
use multiversion::multiversion;

/// A row of cells: its faces [m], and volume fractions. Cells beyond the last face count nothing.
#[derive(Clone, Copy, Debug)]
pub struct Cells<'a> {
    /// Positions of the faces along x [m].
    pub faces: &'a [f64],
    /// Volume fractions, of whole vectors.
    pub fraction: &'a [Real],
    /// Area of the cells across x [m²].
    pub across: f64,
    /// Kind of each cell; empty where all count.
    pub kinds: &'a [u8],
    /// The kind that counts.
    pub kind: u8,
}

/// Elastic energy of the soil of a material in a row of cells [J], from their stresses [Pa].
#[inline(always)]
#[must_use]
pub fn elastic_row(
    elastic: &Elastic,
    stiffening: Option<&Stiffening>,
    cells: Cells,
    stress: [&[Real]; 6],
) -> f64 {
    match stiffening {
        Some(stiffening) => stiffening_row(elastic, stiffening, cells, stress),
        None => linear_row(elastic, cells, stress),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn linear_row(elastic: &Elastic, cells: Cells, stress: [&[Real]; 6]) -> f64 {
    sum_of_row(|stress| elastic.energy(stress), cells, stress)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn stiffening_row(elastic: &Elastic, stiffening: &Stiffening, cells: Cells, stress: [&[Real]; 6]) -> f64 {
    sum_of_row(|stress| stiffening.energy(*elastic, stress), cells, stress)
}

/// Sum over a row of the energies from their densities.
#[inline(always)]
fn sum_of_row(
    density: impl Fn(Symmetric) -> f64,
    Cells { faces, fraction, across, kinds, kind }: Cells,
    stress: [&[Real]; 6],
) -> f64 {
    let mut lanes = [0.0; LANES];
    for start in (0..fraction.len()).step_by(LANES) {
        let mut width = [0.0; LANES];
        for (width, pair) in width.iter_mut().zip(faces[start..].windows(2)) {
            *width = pair[1] - pair[0];
        }
        let f = &fraction[start..start + LANES];
        let [xx, yy, zz, xy, yz, xz] = stress.map(|s| &s[start..start + LANES]);
        for l in 0..LANES {
            let f = if kinds.is_empty() || kinds[start + l] == kind { f[l] } else { 0.0 };
            let stress = [
                f64::from(xx[l]),
                f64::from(yy[l]),
                f64::from(zz[l]),
                f64::from(xy[l]),
                f64::from(yz[l]),
                f64::from(xz[l]),
            ];
            lanes[l] += f64::from(f) * (width[l] * across) * density(stress);
        }
    }
    total_of(lanes)
}

/// Kinetic energy of a row of nodes [J], from their masses [kg] and velocities [m/s].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn kinetic_row(mass: &[Real], velocity: [&[Real]; 3]) -> f64 {
    let mut lanes = [0.0; LANES];
    let [x, y, z] = velocity.map(|v| v.chunks(LANES));
    for (((m, x), y), z) in mass.chunks(LANES).zip(x).zip(y).zip(z) {
        for (l, lane) in lanes.iter_mut().enumerate().take(m.len()) {
            let [m, x, y, z] = [f64::from(m[l]), f64::from(x[l]), f64::from(y[l]), f64::from(z[l])];
            *lane += 0.5 * m * (x * x + y * y + z * z);
        }
    }
    total_of(lanes)
}

/// Sum of a vector's lanes.
fn total_of(lanes: [f64; LANES]) -> f64 {
    lanes.into_iter().fold(0.0, |a, b| a + b)
}
