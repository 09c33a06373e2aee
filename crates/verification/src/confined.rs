//! A5, second part: oedometer and isotropic tests, in which every strain is prescribed.

use crate::error::VerifyError;
use crate::specimen::{CONFINEMENT, Specimen};
use physics::elastic::Elastic;
use physics::law::Law;
use physics::mohr_coulomb::MohrCoulomb;
use physics::tensor::Symmetric;

const INCREMENTS: usize = 600;
const INCREMENT: f64 = 1e-4;

/// Largest deviation of axial and lateral stress from the exact ones in an oedometer test, over the axial
/// stress.
pub(crate) fn oedometer<S: Specimen>(
    [friction, dilation, cohesion]: [f64; 3],
    make: impl Fn(Elastic, Law, Symmetric) -> S,
) -> Result<f64, VerifyError> {
    let elastic = Elastic::new(2e8, 0.3);
    let (phi, psi) = (friction.to_radians(), dilation.to_radians());
    let mut specimen =
        make(elastic, Law::MohrCoulomb(MohrCoulomb::new(elastic, phi, psi, cohesion, 0.0)), AT_REST);
    let mut worst = 0.0_f64;
    for n in 1..=INCREMENTS {
        specimen.strain([0.0, 0.0, -INCREMENT, 0.0, 0.0, 0.0])?;
        let [lateral, _, axial, ..] = specimen.stress();
        let exact = confined(phi, psi, cohesion, n as f64 * INCREMENT);
        let off = (axial + exact[0]).abs().max((lateral + exact[1]).abs()) / exact[0];
        worst = if off > worst || off.is_nan() { off } else { worst };
    }
    Ok(worst)
}

const AT_REST: Symmetric = [-CONFINEMENT, -CONFINEMENT, -CONFINEMENT, 0.0, 0.0, 0.0];

/// Axial and lateral pressure [Pa] after an axial compression without lateral strain: elastic, then on the
/// edge σ_x = σ_y = K_a σ_z of the pyramid, where both of its planes yield equally.
fn confined(phi: f64, psi: f64, cohesion: f64, strain: f64) -> [f64; 2] {
    let (young, poisson) = (2e8, 0.3);
    let elastic = Elastic::new(young, poisson);
    let (axial, lateral) = (elastic.constrained(), elastic.constrained() * poisson / (1.0 - poisson));
    let active = (1.0 - phi.sin()) / (1.0 + phi.sin());
    let bond = 2.0 * cohesion * active.sqrt();
    let reaches = active * axial - lateral;
    let first = if reaches > 0.0 {
        ((1.0 - active) * CONFINEMENT + bond) / -(lateral - active * axial)
    } else {
        f64::INFINITY
    };
    if strain <= first {
        return [CONFINEMENT + axial * strain, CONFINEMENT + lateral * strain];
    }
    // Lateral strain: the elastic strain (K_a (1 − ν) − ν) dσ/E and the plastic strain cancel; the axial
    // plastic strain follows from ψ.
    let flow = 2.0 * (1.0 - psi.sin()) / (1.0 + psi.sin());
    let compliance = (1.0 - 2.0 * poisson * active + flow * (active * (1.0 - poisson) - poisson)) / young;
    let pressure = CONFINEMENT + axial * first + (strain - first) / compliance;
    [pressure, active * pressure - bond]
}

/// Largest deviation of the stress from the exact one over the largest pressure, when a specimen is
/// compressed isotropically, unloaded until it separates, and compressed again: the gap must close before
/// pressure builds up.
pub(crate) fn isotropic<S: Specimen>(
    [friction, dilation, cohesion]: [f64; 3],
    opens: bool,
    make: impl Fn(Elastic, Law, Symmetric) -> S,
) -> Result<f64, VerifyError> {
    let elastic = Elastic::new(2e8, 0.3);
    let law = MohrCoulomb::new(elastic, friction.to_radians(), dilation.to_radians(), cohesion, 0.0);
    let mut specimen = make(elastic, Law::MohrCoulomb(law), AT_REST);
    let (mut strain, mut worst) = (0.0, 0.0_f64);
    let stages: &[(usize, f64)] =
        if opens { &[(300, -1.0), (500, 1.0), (400, -1.0)] } else { &[(INCREMENTS, -1.0)] };
    for &(count, sense) in stages {
        for _ in 0..count {
            let step = sense * INCREMENT;
            specimen.strain([step, step, step, 0.0, 0.0, 0.0])?;
            strain += 3.0 * step;
            let exact = (-CONFINEMENT + elastic.bulk * strain).min(0.0);
            let stress = specimen.stress();
            let off = (0..6).map(|n| (stress[n] - if n < 3 { exact } else { 0.0 }).abs()).fold(0.0, f64::max);
            worst = worst.max(off / (elastic.bulk * 3.0 * INCREMENTS as f64 * INCREMENT));
        }
    }
    Ok(worst)
}
