//! Empirical mobility numbers: resistance from the cone index.

use super::RollingResistance;
use crate::disc::Disc;
use crate::error::{ModelResult, positive, within};

/// Dimensionless groups of a wheel on soil of cone index CI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MobilityGroup {
    /// Wheel numeric C_n = CI b d / W.
    pub wheel_numeric: f64,
    /// Brixius' mobility number B_n = C_n (1 + 5 δ/h)/(1 + 3 b/d); a rigid wheel has no deflection δ.
    pub mobility_number: f64,
}

impl MobilityGroup {
    /// The groups of a rigid wheel from the cone index [Pa] and the weight [N].
    ///
    /// # Errors
    /// If an input is not positive, or C_n < 1, where the wheel would be immobile.
    pub fn rigid(cone_index: f64, disc: &Disc, weight: f64) -> ModelResult<Self> {
        disc.check()?;
        let area = disc.thickness * disc.diameter;
        let numeric = positive("cone index [Pa]", cone_index)? * area / positive("weight [N]", weight)?;
        let wheel_numeric = within("wheel numeric", numeric, 1.0, f64::MAX)?;
        let mobility_number = wheel_numeric / (1.0 + 3.0 * disc.thickness / disc.diameter);
        Ok(Self { wheel_numeric, mobility_number })
    }
}

/// Towed force of Wismer & Luth: R/W = 1.2/C_n + 0.04, R in N; without a sinkage (0 is returned).
///
/// Source: Wismer & Luth (1973) (recalled; the same 1.2/C_n + 0.04 read in public code for tractors). For
/// tyres with b/d ≈ 0.3 on cohesive-frictional soil.
///
/// # Errors
/// As [`MobilityGroup::rigid`].
pub fn wismer_luth_towed(cone_index: f64, disc: &Disc, weight: f64) -> ModelResult<RollingResistance> {
    let group = MobilityGroup::rigid(cone_index, disc, weight)?;
    Ok(RollingResistance { resistance: weight * (1.2 / group.wheel_numeric + 0.04), sinkage: 0.0 })
}

/// Motion resistance of Brixius (NRMM family): R/W = 1/B_n + 0.04 + 0.5 s/√B_n, R in N, at slip s (0 to 1);
/// without a sinkage (0 is returned).
///
/// Source: Brixius (1987), ASAE 87-1622 (recalled, medium confidence). For tyres, B_n > 1.
///
/// # Errors
/// As [`MobilityGroup::rigid`], and for a slip outside 0 to 1.
pub fn brixius_towed(cone_index: f64, disc: &Disc, weight: f64, slip: f64) -> ModelResult<RollingResistance> {
    let group = MobilityGroup::rigid(cone_index, disc, weight)?;
    let s = within("slip", slip, 0.0, 1.0)?;
    let b = within("mobility number", group.mobility_number, 0.2, f64::MAX)?;
    Ok(RollingResistance { resistance: weight * (1.0 / b + 0.04 + 0.5 * s / b.sqrt()), sinkage: 0.0 })
}
