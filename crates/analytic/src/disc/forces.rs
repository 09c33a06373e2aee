//! Drag and vertical force of a disc at a given sinkage.

use super::bearing_arc::friction_limit;
use super::transition::angle_at_fraction;
use super::{
    Contact, Disc, Drive, Ends, Passive, Reaction, RimLoad, WedgeFace, bearing_arc, bow_wave_height,
    slip_from_transition, transition_from_slip, wedge,
};
use crate::bearing::Method;
use crate::error::{ModelResult, within};
use crate::soil::Soil;
use numerics::search::root;

/// Closed form of the pressure on the rim.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Model {
    /// BC: the soil fails sideways; narrow discs.
    Bearing,
    /// PW: the soil fails forwards, with side crescents; wide discs.
    Wedge,
    /// PW in plane strain: without end effects.
    PlaneStrain,
    /// The governing mechanism at every point of the rim: the lower of the pressures of BC and PW.
    ///
    /// Near the surface the soil mostly fails forwards, deeper under a thin disc sideways. The pointwise
    /// minimum is justified by the exact field of PW, which develops from the free surface: the pressure at a
    /// point does not depend on what happens deeper. The forces never exceed those of either model and are
    /// continuous in all parameters.
    #[default]
    Governing,
}

/// Failure mechanism of the soil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mechanism {
    /// Sideways from under the disc.
    Sideways,
    /// Forwards, ahead of the disc.
    Forwards,
}

impl Mechanism {
    /// The mechanism of more than half of the thrust, from the fraction under which the soil fails sideways.
    pub(super) fn governing(sideways: f64) -> Self {
        if sideways > 0.5 { Self::Sideways } else { Self::Forwards }
    }
}

/// A disc in its soil: all parameters but the sinkage.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    /// The soil; its friction angle is used as given (see [`Soil::operative`]).
    pub soil: Soil,
    /// The disc.
    pub disc: Disc,
    /// How the axle is driven.
    pub drive: Drive,
    /// Fraction χ of the displaced soil that stands as a bow wave before the disc, 0 to 1 (see
    /// [`bow_wave_height`]).
    pub bow_wave_fraction: f64,
    /// Slope β of the ground before the disc [rad], rising forwards; used by the wedge only.
    pub backfill: f64,
    /// Correction factors of the bearing model.
    pub method: Method,
    /// How the passive coefficient is evaluated.
    pub passive: Passive<'a>,
}

impl Setting<'_> {
    /// A disc on level ground without a bow wave, with Meyerhof's factors and the passive field solved for
    /// each face.
    #[must_use]
    pub fn new(soil: Soil, disc: Disc, drive: Drive) -> Self {
        let (method, passive) = (Method::default(), Passive::default());
        Self { soil, disc, drive, bow_wave_fraction: 0.0, backfill: 0.0, method, passive }
    }
}

/// Forces on a disc at a given sinkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscForces {
    /// Drag F_H [N].
    pub drag: f64,
    /// Vertical force F_V [N].
    pub vertical: f64,
    /// Normal thrust P_n on the rim [N].
    pub normal: f64,
    /// Net friction force on the rim F_f = μ_m P_n [N]; positive against the tow.
    pub friction: f64,
    /// Torque of that friction about the axle [N m]; positive when it rotates the disc forwards.
    pub rim_torque: f64,
    /// Mobilised friction μ_m: 0 free, μ locked, negative driven.
    pub mobilised_friction: f64,
    /// Contact angle θ_f [rad].
    pub contact_angle: f64,
    /// Inclination η of the force to the vertical, backwards [rad].
    pub force_inclination: f64,
    /// Angle θ₀ at which the friction on the rim changes sign [rad].
    pub transition_angle: f64,
    /// The [`crate::slip`] corresponding to θ₀: −1 locked.
    pub slip: f64,
    /// Failure mechanism under more than half of the thrust.
    pub mechanism: Mechanism,
    /// Fraction of the thrust under which the soil fails sideways, 0 to 1.
    pub sideways_fraction: f64,
}

/// Forces on the disc at sinkage z [m].
///
/// F_H = H + μ_m V, F_V = V − μ_m H, with V and H the resultants of the normal pressure and μ_m the mobilised
/// friction: 0 for a free disc, μ for a locked one, M/(R P_n) under an axle torque M (at most μ, where the
/// disc slides), and at a given slip the balance of the two friction zones. μ is never more than tan φ.
/// Source: derived for this project; models BC ([`bearing_arc`]) and PW ([`wedge`]).
///
/// # Errors
/// If an input is out of range or the model has no result there.
pub fn disc_forces(model: Model, setting: &Setting<'_>, sinkage: f64) -> ModelResult<DiscForces> {
    let loaded = loaded_rim(model, setting, sinkage)?;
    Ok(assemble(model, setting, &loaded))
}

/// The vertical force of [`disc_forces`] alone [N], for searches over the sinkage.
///
/// # Errors
/// As [`disc_forces`].
pub fn vertical_force(model: Model, setting: &Setting<'_>, sinkage: f64) -> ModelResult<f64> {
    let Loaded { rim, friction, .. } = loaded_rim(model, setting, sinkage)?;
    let Reaction { vertical, horizontal, .. } = rim.reaction();
    Ok(vertical - friction * horizontal)
}

/// What acts on the rim.
struct Loaded {
    rim: RimLoad,
    /// The mobilised friction μ_m.
    friction: f64,
    /// The largest friction that the rim can transfer.
    most: f64,
}

fn loaded_rim(model: Model, setting: &Setting<'_>, sinkage: f64) -> ModelResult<Loaded> {
    setting.soil.check()?;
    setting.drive.check()?;
    within("bow wave fraction", setting.bow_wave_fraction, 0.0, 1.0)?;
    let bow_wave = bow_wave_height(
        setting.bow_wave_fraction,
        setting.disc.thickness,
        sinkage,
        setting.soil.friction_angle,
    );
    let contact = setting.disc.contact(sinkage, bow_wave)?;
    let pressure = |friction: f64| rim(model, setting, &contact, friction);
    let most = friction_limit(&setting.soil, &setting.disc, &contact)?;
    let friction = mobilised(setting, most, &pressure)?;
    Ok(Loaded { rim: pressure(friction)?, friction, most })
}

fn rim(model: Model, setting: &Setting<'_>, contact: &Contact, friction: f64) -> ModelResult<RimLoad> {
    let (soil, disc) = (&setting.soil, &setting.disc);
    let sideways = || bearing_arc(soil, disc, contact, friction, setting.method);
    let forwards = |ends| {
        let face = WedgeFace { backfill: setting.backfill, ends, passive: setting.passive };
        wedge(soil, disc, contact, friction, &face)
    };
    Ok(match model {
        Model::Bearing => sideways()?.into(),
        Model::Wedge => forwards(Ends::Crescents)?.into(),
        Model::PlaneStrain => forwards(Ends::PlaneStrain)?.into(),
        Model::Governing => match (sideways()?, forwards(Ends::Crescents)) {
            (sideways, Ok(forwards)) => RimLoad::lower_envelope(sideways, forwards),
            // Where no wedge exists (a locked disc with a steep chord) the soil can still fail sideways.
            (sideways, Err(_)) => sideways.into(),
        },
    })
}

/// The friction μ_m that the drive mobilises, at most `most`.
fn mobilised(
    setting: &Setting<'_>,
    most: f64,
    pressure: &impl Fn(f64) -> ModelResult<RimLoad>,
) -> ModelResult<f64> {
    match setting.drive {
        Drive::Free => Ok(0.0),
        Drive::Locked => Ok(most),
        Drive::Braked(torque) => Ok(balance(torque, most, 1.0, pressure)),
        Drive::Driven(torque) => Ok(balance(torque, most, -1.0, pressure)),
        Drive::Slip(slip) => {
            // Only the shape of the pressure matters here, and it depends weakly on μ_m: one pass is enough.
            let rim = pressure(0.0)?;
            let transition = transition_from_slip(slip, setting.soil.friction_angle, rim.angle());
            let behind = rim.thrust(0.0, transition) / rim.thrust(0.0, rim.angle());
            Ok(most * (2.0 * behind - 1.0))
        }
    }
}

/// The least |μ_m| whose friction balances the axle torque, or `most` where none does and the disc slides.
fn balance(torque: f64, most: f64, sign: f64, pressure: &impl Fn(f64) -> ModelResult<RimLoad>) -> f64 {
    let surplus = |friction: f64| match pressure(sign * friction) {
        Ok(rim) => friction * rim.reaction().normal * rim.radius() - torque,
        Err(_) => f64::NAN,
    };
    const STEPS: u32 = 8;
    for step in 0..STEPS {
        let (low, high) = (f64::from(step), f64::from(step + 1));
        let (low, high) = (most * low / f64::from(STEPS), most * high / f64::from(STEPS));
        if surplus(high) >= 0.0 {
            return sign * root(low, high, 1e-14, surplus).unwrap_or(high);
        }
    }
    sign * most
}

fn assemble(model: Model, setting: &Setting<'_>, loaded: &Loaded) -> DiscForces {
    let Loaded { rim, friction, most } = loaded;
    let (friction, most) = (*friction, *most);
    let Reaction { normal, vertical, horizontal } = rim.reaction();
    let (drag, lift) = (horizontal + friction * vertical, vertical - friction * horizontal);
    let phi = setting.soil.friction_angle;
    let transition_angle = match setting.drive {
        Drive::Locked => rim.angle(),
        Drive::Slip(slip) => transition_from_slip(slip, phi, rim.angle()),
        _ if friction == 0.0 => angle_at_fraction(rim, 0.5),
        _ => angle_at_fraction(rim, 0.5 * (1.0 + friction / most)),
    };
    let slip = match setting.drive {
        Drive::Slip(slip) => slip,
        _ if friction > 0.0 && friction >= most => -1.0,
        _ => slip_from_transition(transition_angle, phi),
    };
    let sideways_fraction = match model {
        Model::Bearing | Model::Governing => rim.fraction_of_first(),
        Model::Wedge | Model::PlaneStrain => 0.0,
    };
    DiscForces {
        drag,
        vertical: lift,
        normal,
        friction: friction * normal,
        rim_torque: friction * normal * rim.radius(),
        mobilised_friction: friction,
        contact_angle: rim.angle(),
        force_inclination: drag.atan2(lift),
        transition_angle,
        slip,
        mechanism: Mechanism::governing(sideways_fraction),
        sideways_fraction,
    }
}
