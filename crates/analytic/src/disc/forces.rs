//! Drag and lift of a disc at a given sinkage.

use super::transition::share_angle;
use super::{
    Contact, Disc, Drive, Passive, Reaction, RimLoad, bearing_arc, heap_height, slip_from_transition,
    transition_from_slip, wedge,
};
use crate::bearing::Method;
use crate::error::{Answer, within};
use crate::numeric::root;
use crate::soil::Soil;

/// Which closed form gives the pressure on the rim.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Model {
    /// BC: the soil escapes sideways; narrow discs.
    Bearing,
    /// PW: the soil fails forwards, with crescents at the ends; wide discs.
    Wedge,
    /// PW without ends: a disc as wide as the ground.
    PlaneStrain,
    /// At every place of the rim the smaller pressure of BC and PW: the soil takes the weaker way out there.
    ///
    /// Near the surface that is mostly forwards, deeper under a thin disc sideways. The exact field of PW makes this
    /// possible: it grows from the free surface, and the pressure at a place does not depend on what happens deeper.
    /// Forces are never above those of either model and change continuously with everything.
    #[default]
    Weaker,
}

/// How the soil fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mechanism {
    /// Sideways from under the disc.
    Sideways,
    /// Forwards, ahead of the disc.
    Forwards,
}

impl Mechanism {
    /// The one under more than half of the thrust, from the share under which the soil escapes sideways.
    pub(super) fn of_share(sideways: f64) -> Self {
        if sideways > 0.5 { Self::Sideways } else { Self::Forwards }
    }
}

/// Everything but the sinkage.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    /// The soil; its friction angle is used as it is (see [`Soil::operative`]).
    pub soil: Soil,
    /// The disc.
    pub disc: Disc,
    /// What happens at the axle.
    pub drive: Drive,
    /// Fraction χ of the soil swept aside that heaps up before the disc, 0 to 1 (see [`heap_height`]).
    pub heap_fraction: f64,
    /// Rise β of the ground before the disc [rad]; only the wedge knows it.
    pub backfill: f64,
    /// Correction factors of the bearing model.
    pub method: Method,
    /// Source of the passive coefficient.
    pub passive: Passive<'a>,
}

impl Setting<'_> {
    /// A disc on level ground without heap, Meyerhof's factors, the field solved each time.
    #[must_use]
    pub fn new(soil: Soil, disc: Disc, drive: Drive) -> Self {
        let (method, passive) = (Method::default(), Passive::default());
        Self { soil, disc, drive, heap_fraction: 0.0, backfill: 0.0, method, passive }
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
    /// Net friction on the rim F_f = μ_m P_n [N]; positive against the tow.
    pub friction: f64,
    /// Torque of that friction about the axle [N m]; positive when it turns the disc forwards.
    pub rim_torque: f64,
    /// Mobilised friction μ_m: 0 free, μ locked, negative driven.
    pub mobilised_friction: f64,
    /// Contact angle θ_f [rad].
    pub contact_angle: f64,
    /// Inclination η of the force to the vertical, backwards [rad].
    pub force_inclination: f64,
    /// Angle θ₀ at which the friction on the rim changes sign [rad].
    pub transition_angle: f64,
    /// The [`crate::slip`] that goes with θ₀: −1 locked.
    pub slip: f64,
    /// How the soil fails under more than half of the thrust.
    pub mechanism: Mechanism,
    /// Share of the thrust under which it escapes sideways, 0 to 1.
    pub sideways_share: f64,
}

/// Forces on the disc at sinkage z [m].
///
/// F_H = H + μ_m V, F_V = V − μ_m H, with V and H the sums of the normal pressure and μ_m the mobilised friction: 0 for
/// a free disc, μ for a locked one, M/(R P_n) under an axle torque M (μ at most: then the disc slides), and at a given
/// slip the balance of the two friction zones. μ is never more than tan φ.
/// Source: derived for this project; models BC ([`bearing_arc`]) and PW ([`wedge`]).
///
/// # Errors
/// If an input is out of range or the model has no answer there.
pub fn disc_forces(model: Model, setting: &Setting<'_>, sinkage: f64) -> Answer<DiscForces> {
    let (rim, friction) = loaded_rim(model, setting, sinkage)?;
    Ok(assemble(model, setting, &rim, friction))
}

/// The vertical force of [`disc_forces`] alone [N], for a search over the sinkage.
///
/// # Errors
/// As [`disc_forces`].
pub fn vertical_force(model: Model, setting: &Setting<'_>, sinkage: f64) -> Answer<f64> {
    let (rim, friction) = loaded_rim(model, setting, sinkage)?;
    let Reaction { vertical, horizontal, .. } = rim.reaction();
    Ok(vertical - friction * horizontal)
}

/// The pressure on the rim and the friction μ_m that goes with it.
fn loaded_rim(model: Model, setting: &Setting<'_>, sinkage: f64) -> Answer<(RimLoad, f64)> {
    setting.soil.check()?;
    setting.drive.check()?;
    within("heap fraction", setting.heap_fraction, 0.0, 1.0)?;
    let heap =
        heap_height(setting.heap_fraction, setting.disc.thickness, sinkage, setting.soil.friction_angle);
    let contact = setting.disc.contact(sinkage, heap)?;
    let pressure = |friction: f64| rim(model, setting, &contact, friction);
    let friction = mobilised(setting, &pressure)?;
    Ok((pressure(friction)?, friction))
}

fn rim(model: Model, setting: &Setting<'_>, contact: &Contact, friction: f64) -> Answer<RimLoad> {
    let (soil, disc) = (&setting.soil, &setting.disc);
    let sideways = || bearing_arc(soil, disc, contact, friction, setting.method);
    let forwards = |ends| wedge(soil, disc, contact, friction, setting.backfill, ends, setting.passive);
    Ok(match model {
        Model::Bearing => sideways()?.into(),
        Model::Wedge => forwards(true)?.into(),
        Model::PlaneStrain => forwards(false)?.into(),
        Model::Weaker => match (sideways()?, forwards(true)) {
            (sideways, Ok(forwards)) => RimLoad::weaker(sideways, forwards),
            // Where the wedge has no field (a locked disc on a steep chord) the soil still has the other way out.
            (sideways, Err(_)) => sideways.into(),
        },
    })
}

/// The friction μ_m that the drive mobilises.
fn mobilised(setting: &Setting<'_>, pressure: &impl Fn(f64) -> Answer<RimLoad>) -> Answer<f64> {
    let most = setting.soil.shared_friction();
    match setting.drive {
        Drive::Free => Ok(0.0),
        Drive::Locked => Ok(most),
        Drive::Braked(torque) => Ok(balance(torque, most, 1.0, pressure)),
        Drive::Driven(torque) => Ok(balance(torque, most, -1.0, pressure)),
        Drive::Slip(slip) => {
            // The pressure depends on μ_m only weakly, and only its shape counts here: one pass is enough.
            let rim = pressure(0.0)?;
            let turn = transition_from_slip(slip, setting.soil.friction_angle, rim.angle());
            let share = rim.thrust(0.0, turn) / rim.thrust(0.0, rim.angle());
            Ok(most * (2.0 * share - 1.0))
        }
    }
}

/// The least |μ_m| whose friction holds the axle torque, or all of `most` where none does: the disc slides.
fn balance(torque: f64, most: f64, sign: f64, pressure: &impl Fn(f64) -> Answer<RimLoad>) -> f64 {
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

fn assemble(model: Model, setting: &Setting<'_>, rim: &RimLoad, friction: f64) -> DiscForces {
    let Reaction { normal, vertical, horizontal } = rim.reaction();
    let (drag, lift) = (horizontal + friction * vertical, vertical - friction * horizontal);
    let phi = setting.soil.friction_angle;
    let transition_angle = match setting.drive {
        Drive::Locked => rim.angle(),
        Drive::Slip(slip) => transition_from_slip(slip, phi, rim.angle()),
        _ if friction == 0.0 => share_angle(rim, 0.5),
        _ => share_angle(rim, 0.5 * (1.0 + friction / setting.soil.shared_friction())),
    };
    let slip = match setting.drive {
        Drive::Slip(slip) => slip,
        _ if friction > 0.0 && friction >= setting.soil.shared_friction() => -1.0,
        _ => slip_from_transition(transition_angle, phi),
    };
    let sideways_share = match model {
        Model::Bearing | Model::Weaker => rim.share_of_first(),
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
        mechanism: Mechanism::of_share(sideways_share),
        sideways_share,
    }
}
