//! Soil at rest: which stresses its law sustains, and with which earth pressure it rests on a slope.

use super::law::Law;
use crate::slope::Slope;

/// Coefficient of earth pressure at rest of a soil that has this one [−] on level ground: as much larger as
/// it takes for the soil to rest on the slope with 0.98 of its friction, where that is possible; 1 for soil
/// without friction, whose shear stress is then least.
pub(crate) fn k0(slope: &Slope, level: f64, law: &Law) -> f64 {
    if slope.is_level() {
        return level;
    }
    let Some(friction) = law.friction_angle().filter(|angle| *angle > 0.0) else { return 1.0 };
    /// Portion of sin φ that the soil at rest may mobilise, and steps in which the coefficient is raised.
    const MOBILISED: f64 = 0.98;
    const STEP: f64 = 0.005;
    let rests = |k0: &f64| {
        let [most, least] = extremes(slope.principal_stresses(*k0));
        most - least <= (most + least) * MOBILISED * friction.sin()
    };
    let raised = (0..600_u32).map(|n| level + STEP * f64::from(n)).find(rests);
    raised.unwrap_or(1.0)
}

/// The largest and the least of three stresses.
fn extremes(stresses: [f64; 3]) -> [f64; 2] {
    [f64::max, f64::min].map(|of| of(of(stresses[0], stresses[1]), stresses[2]))
}

/// Whether soil of a law sustains these principal stresses [Pa], compression positive; of sand up to the
/// critical state, since shear beyond it only hardens it up to its peak.
pub(crate) fn sustains(law: &Law, mut stresses: [f64; 3]) -> bool {
    stresses.sort_by(|a, b| b.total_cmp(a));
    law.sustains(stresses)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soil::MohrCoulomb;

    fn frictional(angle: f64) -> Law {
        Law::MohrCoulomb(MohrCoulomb { friction_angle: angle.to_radians(), ..MohrCoulomb::default() })
    }

    #[test]
    fn sand_rests_on_slopes_up_to_its_friction_angle() {
        let law = frictional(35.0);
        let level = 1.0 - 35_f64.to_radians().sin();
        for degrees in [0.0_f64, 5.0, 20.0, 30.0, 34.0, 36.0] {
            let slope = Slope { along: degrees.to_radians(), across: 0.0 };
            let ratio = k0(&slope, level, &law);
            assert_eq!(
                sustains(&law, slope.principal_stresses(ratio)),
                degrees < 35.0,
                "{degrees}°, {ratio}"
            );
            assert!(if degrees < 10.0 { ratio == level } else { ratio > level });
        }
    }
}
