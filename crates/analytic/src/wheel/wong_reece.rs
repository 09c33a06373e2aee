//! Wong and Reece: the stresses on a towed wheel, at the slip where its torque vanishes.

use super::{PressureSinkage, janosi_shear};
use crate::disc::{Disc, transition_from_slip};
use crate::error::{ModelResult, positive, undefined};
use numerics::quadrature::gauss_points;
use numerics::search::root;

/// A towed wheel in equilibrium with its load and without axle torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelState {
    /// Drag [N].
    pub drag: f64,
    /// Vertical force [N].
    pub vertical: f64,
    /// Sinkage [m].
    pub sinkage: f64,
    /// Entry angle θ₁ [rad].
    pub entry_angle: f64,
    /// Transition angle θ₀ [rad], where the pressure peaks and the friction changes sign.
    pub transition_angle: f64,
    /// The [`crate::slip`], negative.
    pub slip: f64,
}

/// Resultants over the rim: drag and vertical force [N], torque [N m].
#[derive(Clone, Copy)]
struct Sums {
    drag: f64,
    vertical: f64,
    torque: f64,
}

/// Drag, sinkage and slip of a towed rigid wheel under a load W [N].
///
/// Front (θ₀ < θ < θ₁): σ = (k_c/b + k_φ) rⁿ (cos θ − cos θ₁)ⁿ; behind, the same at θ₁ − θ (θ₁ − θ₀)/θ₀ (no
/// rear contact). τ by Janosi–Hanamoto with the shear displacements j = r[(θ₁−θ)(1 + K_v(1+i)) − (1+i)(sin
/// θ₁ − sin θ)] in front and r[(θ₀−θ) − (1+i)(sin θ₀ − sin θ)] behind, of opposite sense, v = rω(1+i), K_v so
/// that the first is 0 at θ₀; tan(45° − φ/2) = (cos θ₀ − 1/(1+i))/sin θ₀. θ₁ follows from the load, the slip
/// from zero torque. Source: Wong & Reece (1967), J. Terramech. 4(2), Part II; shear displacements read in
/// jcmadsen/pyTerramechanics. Bekker's modulus replaces Reece's, so that the published constants apply. Valid
/// for z ≲ 0.3 d.
///
/// # Errors
/// If an input is out of range, or there is no equilibrium.
pub fn wong_reece_towed(soil: &PressureSinkage, disc: &Disc, weight: f64) -> ModelResult<WheelState> {
    soil.check()?;
    disc.check()?;
    let load = positive("weight [N]", weight)?;
    let entry = |slip: f64| {
        let excess = |theta: f64| sums(soil, disc, theta, slip).vertical / load - 1.0;
        root(1e-3, 1.4, 1e-11, excess)
    };
    let torque = |slip: f64| entry(slip).map_or(f64::NAN, |theta| sums(soil, disc, theta, slip).torque);
    let Some(slip) = torque_free_slip(torque) else {
        return undefined("the wheel of Wong and Reece", "there is no slip without torque under this load");
    };
    let Some(entry_angle) = entry(slip) else {
        return undefined("the wheel of Wong and Reece", "it sinks to the axle under this load");
    };
    let Sums { drag, vertical, .. } = sums(soil, disc, entry_angle, slip);
    let transition_angle = transition_from_slip(slip, soil.friction_angle, entry_angle);
    let sinkage = disc.diameter * (0.5 * entry_angle).sin().powi(2);
    Ok(WheelState { drag, vertical, sinkage, entry_angle, transition_angle, slip })
}

/// The wheel of Wong & Reece at a given sinkage [m]; the vertical force is the load that the soil carries
/// there.
///
/// # Errors
/// As [`wong_reece_towed`].
pub fn wong_reece_at_depth(soil: &PressureSinkage, disc: &Disc, sinkage: f64) -> ModelResult<WheelState> {
    soil.check()?;
    let entry_angle = disc.contact(sinkage, 0.0)?.angle;
    let Some(slip) = torque_free_slip(|slip| sums(soil, disc, entry_angle, slip).torque) else {
        return undefined("the wheel of Wong and Reece", "there is no slip without torque at this sinkage");
    };
    let Sums { drag, vertical, .. } = sums(soil, disc, entry_angle, slip);
    let transition_angle = transition_from_slip(slip, soil.friction_angle, entry_angle);
    Ok(WheelState { drag, vertical, sinkage, entry_angle, transition_angle, slip })
}

/// The slip without torque closest to rolling: near rolling the front zone brakes the wheel, with more slip
/// the rear zone drives it.
fn torque_free_slip(torque: impl Fn(f64) -> f64) -> Option<f64> {
    let steps = (0..=30).map(|n| -0.002 - 0.02 * f64::from(n));
    let mut last: Option<(f64, f64)> = None;
    for slip in steps {
        let here = torque(slip);
        if let Some((before, value)) = last
            && value < 0.0
            && here >= 0.0
        {
            return root(before, slip, 1e-10, torque);
        }
        if here.is_finite() {
            last = Some((slip, here));
        }
    }
    None
}

fn sums(soil: &PressureSinkage, disc: &Disc, entry: f64, slip: f64) -> Sums {
    let r = 0.5 * disc.diameter;
    let middle = transition_from_slip(slip, soil.friction_angle, 0.98 * entry);
    let stretch = 1.0 / (1.0 + slip);
    let slope = if entry > middle { (entry.sin() - middle.sin()) / (entry - middle) } else { 0.0 };
    let depth = |theta: f64| r * 2.0 * (0.5 * (entry + theta)).sin() * (0.5 * (entry - theta)).sin();
    let mut sums = Sums { drag: 0.0, vertical: 0.0, torque: 0.0 };
    let mut add = |theta: f64, weight: f64, pressure_angle: f64, displacement: f64, sense: f64| {
        let area = r * disc.thickness * weight;
        let normal = soil.pressure(disc.thickness, depth(pressure_angle));
        // Positive towards increasing θ: forwards and up on the wheel, which brakes its rotation.
        let shear = sense * janosi_shear(soil, normal, displacement);
        sums.drag += area * (normal * theta.sin() - shear * theta.cos());
        sums.vertical += area * (normal * theta.cos() + shear * theta.sin());
        sums.torque -= area * r * shear;
    };
    for (theta, weight) in gauss_points(middle, entry) {
        let displacement = r * stretch * ((entry - theta) * slope - (entry.sin() - theta.sin()));
        add(theta, weight, theta, displacement, 1.0);
    }
    if middle > 0.0 {
        for (theta, weight) in gauss_points(0.0, middle) {
            let displacement = r * ((middle - theta) - stretch * (middle.sin() - theta.sin()));
            add(theta, weight, entry - theta * (entry - middle) / middle, displacement, -1.0);
        }
    }
    sums
}
