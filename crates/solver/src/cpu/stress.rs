//! One row of cells: velocity gradient → trial stress → strength → nodal force coefficients.
//!
//! Four plain loops over rows that lie in the first-level cache; each vectorises (the formulas are branch-free), and
//! each is compiled for what the processor has. `mul_add` is not used, so the result is the same to the bit.

use super::workspace::{COEFFICIENTS, RowSums, lane_sum};
use crate::model::{FRACTION_STRESSED, Model};
use multiversion::multiversion;
use physics::brick::{Sums, hourglass_coefficient};
use physics::elastic::Elastic;
use physics::mohr_coulomb::MohrCoulomb;
use physics::tensor::{Symmetric, deviator, jaumann, mean};
use physics::viscosity::BulkViscosity;

/// The nodal velocities at the four node rows round a row of cells: (y, z) = (0,0), (1,0), (0,1), (1,1).
pub(crate) type NodeRows<'a> = [[&'a [f64]; 3]; 4];

/// The cells of a row.
pub(crate) struct CellRow<'a> {
    pub(crate) fraction: &'a [f64],
    pub(crate) stress: [&'a mut [f64]; 6],
    pub(crate) plastic_strain: &'a mut [f64],
    pub(crate) gap_strain: &'a mut [f64],
}

/// Everything about a row that does not change.
pub(crate) struct RowConstants<'a> {
    pub(crate) elastic: Elastic,
    pub(crate) strength: Option<MohrCoulomb>,
    pub(crate) viscosity: BulkViscosity,
    /// ε ρ c / 4 [kg/(s m²)].
    pub(crate) hourglass: f64,
    /// Widths of the cells along x [m].
    pub(crate) width_x: &'a [f64],
    /// Widths along y and z [m].
    pub(crate) width_y: f64,
    pub(crate) width_z: f64,
    /// Time step [s].
    pub(crate) dt: f64,
}

impl<'a> RowConstants<'a> {
    pub(crate) fn new(model: &Model, width_x: &'a [f64], dt: f64) -> Self {
        let hourglass = hourglass_coefficient(model.method.hourglass, model.density, model.wave_speed(), 1.0);
        Self {
            elastic: model.elastic,
            strength: model.strength,
            viscosity: model.viscosity(),
            hourglass,
            width_x,
            width_y: 0.0,
            width_z: 0.0,
            dt,
        }
    }
}

/// Buffers of a row, all of the same length.
struct Buffers<'a> {
    /// Corner sums of the velocity: plain, and signed by the side x, y, z.
    plain: [&'a mut [f64]; 3],
    side: [[&'a mut [f64]; 3]; 3],
    hourglass: &'a mut [f64],
    trial: [&'a mut [f64]; 6],
    /// Volumetric rate [1/s].
    rate: &'a mut [f64],
    /// 1 where the soil bears stress, 0 where it is a void, loose or opened.
    alive: &'a mut [f64],
    /// Plastic work per volume [J/m³].
    work: &'a mut [f64],
    /// Dissipation by viscosity and hourglass [W].
    viscous: &'a mut [f64],
    damped: &'a mut [f64],
}

impl<'a> Buffers<'a> {
    fn split(buffer: &'a mut [f64], n: usize) -> Self {
        let mut parts = buffer.chunks_exact_mut(n);
        let mut next = || parts.next().unwrap_or_default();
        Self {
            plain: std::array::from_fn(|_| next()),
            side: std::array::from_fn(|_| std::array::from_fn(|_| next())),
            hourglass: next(),
            trial: std::array::from_fn(|_| next()),
            rate: next(),
            alive: next(),
            work: next(),
            viscous: next(),
            damped: next(),
        }
    }
}

/// Strains a row of `n` cells (a multiple of the vector length) for one step: updates its stresses and writes the
/// coefficients of its nodal forces. Returns what the row dissipated.
pub(crate) fn strain_row(
    constants: &RowConstants,
    nodes: &NodeRows,
    cells: &mut CellRow,
    buffer: &mut [f64],
    forces: &mut [&mut [f64]; COEFFICIENTS],
) -> RowSums {
    let n = cells.fraction.len();
    let mut b = Buffers::split(buffer, n);
    corner_sums(nodes, &mut b);
    trial_stress(constants, cells, &mut b);
    if let Some(strength) = &constants.strength {
        apply_strength(&constants.elastic, strength, cells, &mut b);
    }
    force_coefficients(constants, cells, &mut b, forces);
    RowSums {
        plastic: lane_sum(b.work),
        viscous: lane_sum(b.viscous) * constants.dt,
        hourglass: lane_sum(b.damped) * constants.dt,
        ..RowSums::default()
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn corner_sums(nodes: &NodeRows, b: &mut Buffers) {
    let n = b.rate.len();
    let hourglass = &mut b.hourglass[..n];
    hourglass.fill(0.0);
    for q in 0..3 {
        let v: [&[f64]; 4] = std::array::from_fn(|row| &nodes[row][q][..n + 1]);
        let plain = &mut b.plain[q][..n];
        let [x, y, z] = &mut b.side[q];
        let (x, y, z) = (&mut x[..n], &mut y[..n], &mut z[..n]);
        for i in 0..n {
            let sums = Sums::of([
                [v[0][i], v[0][i + 1]],
                [v[1][i], v[1][i + 1]],
                [v[2][i], v[2][i + 1]],
                [v[3][i], v[3][i + 1]],
            ]);
            plain[i] = sums.plain;
            x[i] = sums.side[0];
            y[i] = sums.side[1];
            z[i] = sums.side[2];
            hourglass[i] += sums.hourglass();
        }
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn trial_stress(constants: &RowConstants, cells: &mut CellRow, b: &mut Buffers) {
    let n = b.rate.len();
    let (dt, elastic) = (constants.dt, constants.elastic);
    let width = &constants.width_x[..n];
    let (per_y, per_z) = (0.25 / constants.width_y, 0.25 / constants.width_z);
    let fraction = &cells.fraction[..n];
    let gap_strain = &mut cells.gap_strain[..n];
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = &b.side;
    let (xx, xy, xz) = (&xx[..n], &xy[..n], &xz[..n]);
    let (yx, yy, yz) = (&yx[..n], &yy[..n], &yz[..n]);
    let (zx, zy, zz) = (&zx[..n], &zy[..n], &zz[..n]);
    let [s0, s1, s2, s3, s4, s5] = &cells.stress;
    let (s0, s1, s2, s3, s4, s5) = (&s0[..n], &s1[..n], &s2[..n], &s3[..n], &s4[..n], &s5[..n]);
    let [t0, t1, t2, t3, t4, t5] = &mut b.trial;
    let (t0, t1, t2) = (&mut t0[..n], &mut t1[..n], &mut t2[..n]);
    let (t3, t4, t5) = (&mut t3[..n], &mut t4[..n], &mut t5[..n]);
    let (rate, alive) = (&mut b.rate[..n], &mut b.alive[..n]);
    for i in 0..n {
        // Ghost columns have no width; a quotient of 0/0 there must not happen.
        let per_x = if width[i] > 0.0 { 0.25 / width[i] } else { 0.0 };
        let (dxx, dyy, dzz) = (xx[i] * per_x, yy[i] * per_y, zz[i] * per_z);
        let (vxy, vyx) = (xy[i] * per_y, yx[i] * per_x);
        let (vyz, vzy) = (yz[i] * per_z, zy[i] * per_y);
        let (vxz, vzx) = (xz[i] * per_z, zx[i] * per_x);
        let strain_rate: Symmetric = [dxx, dyy, dzz, 0.5 * (vxy + vyx), 0.5 * (vyz + vzy), 0.5 * (vxz + vzx)];
        let spin = [0.5 * (vxy - vyx), 0.5 * (vyz - vzy), 0.5 * (vxz - vzx)];
        let volumetric = dxx + dyy + dzz;
        // A gap closes before pressure builds.
        let gap = gap_strain[i];
        let open = gap + volumetric * dt;
        let has_gap = gap > 0.0;
        let stressed = fraction[i] > FRACTION_STRESSED;
        let stays_open = has_gap & (open > 0.0);
        let squeeze = if has_gap { if open < 0.0 { open } else { 0.0 } } else { volumetric * dt };
        gap_strain[i] = if stays_open & stressed { open } else { 0.0 };
        let old: Symmetric = [s0[i], s1[i], s2[i], s3[i], s4[i], s5[i]];
        let shear = deviator(strain_rate).map(|d| 2.0 * elastic.shear * d * dt);
        let turned = jaumann(old, spin);
        let pressed = elastic.bulk * squeeze;
        t0[i] = old[0] + pressed + shear[0] + turned[0] * dt;
        t1[i] = old[1] + pressed + shear[1] + turned[1] * dt;
        t2[i] = old[2] + pressed + shear[2] + turned[2] * dt;
        t3[i] = old[3] + shear[3] + turned[3] * dt;
        t4[i] = old[4] + shear[4] + turned[4] * dt;
        t5[i] = old[5] + shear[5] + turned[5] * dt;
        rate[i] = volumetric;
        alive[i] = if stressed & !stays_open { 1.0 } else { 0.0 };
    }
    b.work.fill(0.0);
}

/// How many cells are returned together: none of them yields in most groups, and a group is one or two vectors.
const GROUP: usize = 8;

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn apply_strength(elastic: &Elastic, strength: &MohrCoulomb, cells: &mut CellRow, b: &mut Buffers) {
    let n = b.rate.len();
    for start in (0..n).step_by(GROUP) {
        let range = start..start + GROUP;
        let trial: [&mut [f64; GROUP]; 6] = {
            let [t0, t1, t2, t3, t4, t5] = &mut b.trial;
            [t0, t1, t2, t3, t4, t5].map(|t| group(&mut t[range.clone()]))
        };
        let alive: &[f64; GROUP] = group(&mut b.alive[range.clone()]);
        let mut flags = 0.0;
        for l in 0..GROUP {
            let t: Symmetric = std::array::from_fn(|c| trial[c][l]);
            flags += if strength.may_yield(t) { alive[l] } else { 0.0 };
        }
        if flags == 0.0 {
            continue;
        }
        let old: [&[f64; GROUP]; 6] = {
            let [s0, s1, s2, s3, s4, s5] = &mut cells.stress;
            [s0, s1, s2, s3, s4, s5].map(|s| &*group(&mut s[range.clone()]))
        };
        let plastic_strain = group(&mut cells.plastic_strain[range.clone()]);
        let gap_strain = group(&mut cells.gap_strain[range.clone()]);
        let work = group(&mut b.work[range]);
        for l in 0..GROUP {
            let t: Symmetric = std::array::from_fn(|c| trial[c][l]);
            let yields = strength.may_yield(t) & (alive[l] > 0.0);
            let back = strength.return_map(t);
            let middle: Symmetric = std::array::from_fn(|c| 0.5 * (old[c][l] + back.stress[c]));
            let change: Symmetric = std::array::from_fn(|c| t[c] - back.stress[c]);
            // The average of old and new stress makes the sum over steps exact for central differences.
            let dissipated = elastic.compliance(middle, change);
            for c in 0..6 {
                trial[c][l] = if yields { back.stress[c] } else { t[c] };
            }
            plastic_strain[l] += if yields { back.plastic_strain } else { 0.0 };
            gap_strain[l] += if yields { back.gap_strain } else { 0.0 };
            work[l] = if yields { dissipated } else { 0.0 };
        }
    }
}

#[inline(always)]
fn group(slice: &mut [f64]) -> &mut [f64; GROUP] {
    match slice.try_into() {
        Ok(array) => array,
        Err(_) => unreachable!("rows are whole groups"),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn force_coefficients(
    constants: &RowConstants,
    cells: &mut CellRow,
    b: &mut Buffers,
    forces: &mut [&mut [f64]; COEFFICIENTS],
) {
    let n = b.rate.len();
    let width = &constants.width_x[..n];
    let (hy, hz) = (constants.width_y, constants.width_z);
    let fraction = &cells.fraction[..n];
    let (rate, alive) = (&b.rate[..n], &b.alive[..n]);
    let hourglass = &b.hourglass[..n];
    let work = &mut b.work[..n];
    let (viscous, damped) = (&mut b.viscous[..n], &mut b.damped[..n]);
    let [t0, t1, t2, t3, t4, t5] = &b.trial;
    let (t0, t1, t2, t3, t4, t5) = (&t0[..n], &t1[..n], &t2[..n], &t3[..n], &t4[..n], &t5[..n]);
    let [s0, s1, s2, s3, s4, s5] = &mut cells.stress;
    let (s0, s1, s2) = (&mut s0[..n], &mut s1[..n], &mut s2[..n]);
    let (s3, s4, s5) = (&mut s3[..n], &mut s4[..n], &mut s5[..n]);
    let [x0, xx, xy, xz, y0, yx, yy, yz, z0, zx, zy, zz, damping] = forces;
    let (x0, xx, xy, xz) = (&mut x0[..n], &mut xx[..n], &mut xy[..n], &mut xz[..n]);
    let (y0, yx, yy, yz) = (&mut y0[..n], &mut yx[..n], &mut yy[..n], &mut yz[..n]);
    let (z0, zx, zy, zz) = (&mut z0[..n], &mut zx[..n], &mut zy[..n], &mut zz[..n]);
    let damping = &mut damping[..n];
    let [px, py, pz] = &b.plain;
    let (px, py, pz) = (&px[..n], &py[..n], &pz[..n]);
    let [[sxx, sxy, sxz], [syx, syy, syz], [szx, szy, szz]] = &b.side;
    let (sxx, sxy, sxz) = (&sxx[..n], &sxy[..n], &sxz[..n]);
    let (syx, syy, syz) = (&syx[..n], &syy[..n], &syz[..n]);
    let (szx, szy, szz) = (&szx[..n], &szy[..n], &szz[..n]);
    for i in 0..n {
        let hx = width[i];
        let volume = hx * hy * hz;
        let length = cube_root_of_volume(hx, hy, hz);
        let bears = alive[i] > 0.0;
        let f = if bears { fraction[i] } else { 0.0 };
        let stress: Symmetric =
            [t0[i], t1[i], t2[i], t3[i], t4[i], t5[i]].map(|t| if bears { t } else { 0.0 });
        s0[i] = stress[0];
        s1[i] = stress[1];
        s2[i] = stress[2];
        s3[i] = stress[3];
        s4[i] = stress[4];
        s5[i] = stress[5];
        let q = constants.viscosity.stress(length, rate[i]);
        let h = f * constants.hourglass * length * length;
        let (ax, ay, az) = (-0.25 * f * hy * hz, -0.25 * f * hx * hz, -0.25 * f * hx * hy);
        x0[i] = h * px[i];
        xx[i] = h * sxx[i] + ax * (stress[0] + q);
        xy[i] = h * sxy[i] + ay * stress[3];
        xz[i] = h * sxz[i] + az * stress[5];
        y0[i] = h * py[i];
        yx[i] = h * syx[i] + ax * stress[3];
        yy[i] = h * syy[i] + ay * (stress[1] + q);
        yz[i] = h * syz[i] + az * stress[4];
        z0[i] = h * pz[i];
        zx[i] = h * szx[i] + ax * stress[5];
        zy[i] = h * szy[i] + ay * stress[4];
        zz[i] = h * szz[i] + az * (stress[2] + q);
        damping[i] = 8.0 * h;
        work[i] *= f * volume;
        viscous[i] = q * rate[i] * f * volume;
        damped[i] = h * hourglass[i];
    }
}

/// A length whose cube is about the cell's volume: harmonic mean of the widths, which stays on the safe side in a
/// stretched cell and needs no cube root in the loop.
#[inline(always)]
fn cube_root_of_volume(hx: f64, hy: f64, hz: f64) -> f64 {
    let denominator = hx * hy + hy * hz + hx * hz;
    3.0 * hx * hy * hz / denominator
}

/// Mean stress, compression positive [Pa].
#[must_use]
pub fn pressure(stress: Symmetric) -> f64 {
    -mean(stress)
}
