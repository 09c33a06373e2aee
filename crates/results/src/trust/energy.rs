//! Checks of the balances of the whole model, and of the faces of the box.

use super::body::base;
use super::check::Check;
use super::limits::{self, Limit};
use super::setting::{BodySetting, Setting};
use crate::history::{BodySample, BoundarySample, EnergySample, ExchangeBalance, History, largest};

/// Energy and volume at the end of the run.
pub(super) fn checks(setting: &Setting, history: &History) -> Vec<Check> {
    let Some(end) = history.energy.last() else { return Vec::new() };
    let scale = setting.energy_scale(end);
    let per_cent = |energy: f64| if scale == 0.0 { 0.0 } else { 100.0 * energy.abs() / scale };
    let check = |limit: &'static Limit, value: f64| Check::of(limit, None, value);
    vec![
        check(&limits::ENERGY_BALANCE, 100.0 * setting.closure(end).abs()),
        check(&limits::HOURGLASS, per_cent(end.hourglass)),
        check(&limits::VISCOUS, per_cent(end.viscous)),
        check(&limits::REMAP_LOSS, per_cent(end.remap_loss)),
        check(&limits::CONTACT_ENERGY, per_cent(end.contact)),
        check(&limits::VOLUME, volume_change(setting, &history.energy[0], end)),
        check(&limits::OVERDENSE, 100.0 * largest(history.energy.iter().map(|sample| sample.overdense))),
        check(&limits::VOID, 100.0 * end.void),
    ]
}

/// Energy that passed to and from another program; `None` where none did.
pub(super) fn exchanged(history: &History) -> Option<Check> {
    let ExchangeBalance { work, difference, .. } = history.exchange;
    (work > 0.0).then(|| Check::of(&limits::EXCHANGE, None, 100.0 * difference.abs() / work))
}

/// Change of the soil volume that pressure does not account for [%], unless the soil is expected to change it
/// so.
fn volume_change(setting: &Setting, start: &EnergySample, end: &EnergySample) -> f64 {
    let change = 100.0 * (end.volume_ratio - 1.0 + end.compression - start.compression);
    let [compacts, dilates] = setting.changes_volume;
    let is_expected = if change > 0.0 { dilates } else { compacts };
    if is_expected { 0.0 } else { change.abs() }
}

/// Rise of the pressure in a closed box by the volume that has entered it, over what the soil bears [%].
pub(super) fn pumped(setting: &Setting, history: &History) -> Option<Check> {
    let per_volume = setting.pumped_per_volume?;
    let entered = |samples: &Vec<BodySample>| {
        let first = samples.first().map_or(0.0, |sample| sample.embedded_volume);
        samples.iter().map(|sample| sample.embedded_volume - first).fold(0.0, f64::max)
    };
    let volume: f64 = history.bodies.iter().map(entered).sum();
    Some(Check::of(&limits::PUMPED, None, 100.0 * per_volume * volume))
}

/// Lid, walls and floor.
pub(super) fn boundary_checks(setting: &Setting, history: &History) -> Vec<Check> {
    let samples = &history.boundaries;
    if samples.is_empty() {
        return Vec::new();
    }
    let most = |value: fn(&BoundarySample) -> f64| largest(samples.iter().map(value));
    let mut checks = vec![
        Check::of(
            &limits::LID,
            None,
            lid_force_ratio(setting, [most(|s| s.lid_force), most(|s| s.lid_area)], history),
        ),
        Check::of(&limits::WALLS, None, 1e4 * most(|s| s.wall_area)),
    ];
    if let Some(ratio) = stress_ratio(setting, history) {
        checks.push(Check::of(&limits::BOUNDARY_STRESS, None, ratio));
    }
    checks
}

/// Force on the lid over that on the bodies [%]; without a body that meets soil, 1 as soon as soil touches
/// the lid.
fn lid_force_ratio(setting: &Setting, [force, area]: [f64; 2], history: &History) -> f64 {
    let most = (0..history.boundaries.len()).map(|n| body_force(history, n)).fold(0.0, f64::max);
    if most > setting.least_force() {
        100.0 * force / most
    } else if area > 0.0 {
        1.0
    } else {
        0.0
    }
}

/// Sum of the forces on the bodies at one sample [N].
pub fn body_force(history: &History, n: usize) -> f64 {
    history.bodies.iter().filter_map(|samples| samples.get(n)).map(BodySample::force).sum()
}

/// Mean rise of the pressure at walls and floor over the mean contact pressure [%], in the last third of the
/// run. The contact pressure is the force on a body over its area projected along the force; one below a
/// tenth of the vertical pressure at the floor counts as that, since a rise is then a change of the soil's
/// own stress.
fn stress_ratio(setting: &Setting, history: &History) -> Option<f64> {
    /// Chosen: as for components of a force.
    const LEAST: f64 = 0.1;
    let count = history.boundaries.len();
    let last = 2 * count / 3..count;
    let mean = |value: &dyn Fn(usize) -> f64| last.clone().map(value).sum::<f64>() / last.len() as f64;
    let pressure = |n: usize| -> f64 {
        let bodies = setting.bodies.iter().zip(&history.bodies).filter(|(body, _)| body.volume > 0.0);
        bodies.filter_map(|(body, samples)| Some(contact_pressure(body, samples.get(n)?))).sum()
    };
    let (pressure, rise) = (mean(&pressure), mean(&|n| history.boundaries[n].stress_rise));
    let scale =
        if pressure < LEAST * setting.floor_pressure { LEAST * setting.floor_pressure } else { pressure };
    let has_surfaces = setting.bodies.iter().any(|body| body.volume > 0.0);
    (scale > 0.0 && has_surfaces).then(|| 100.0 * rise.max(0.0) / scale)
}

/// Force on a body over its projected area: its embedded front, and its base [Pa]; of a body that is turned
/// at least its torque over arm and area of the surface that it shears.
fn contact_pressure(body: &BodySetting, sample: &BodySample) -> f64 {
    let [length, width, height] = [0, 1, 2].map(|axis| body.extent[axis].unwrap_or(body.cell[axis]));
    let depth = sample.sinkage.min(height).max(body.cell[2]);
    let pressed = (sample.drag / (depth * width)).hypot(sample.vertical / base(body, sample.sinkage));
    let torque = match body.turned_about {
        Some(0) => sample.moment_x,
        Some(1) => sample.axle_torque,
        Some(_) => sample.moment_z,
        None => 0.0,
    };
    // A drum of these edges: π/2 (a + b) h around it.
    let sheared = 0.5 * std::f64::consts::PI * (length + width) * height;
    pressed.max(torque.abs() / (0.25 * (length + width) * sheared))
}
