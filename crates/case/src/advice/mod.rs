//! Warnings about a case that can be run: whether the grid is fine enough, the tow slow enough, the box large
//! enough.

mod base;
mod closed_box;
mod few_cells;
pub(crate) mod inertia;
mod motions;
mod passive;
mod relief;
mod tables;
mod walls;

use super::estimate::estimate;
use super::model::sand;
use super::path::{Paths, body_length};
use super::resolved::{Body, Case, Law, MohrCoulomb, Motion, Output, Potential, Sand, Soil, Water};
use super::unusual::unusual;
use glam::DVec3;
use input::quantity::plain;
use passive::passive_coefficient;
use physics::elastic::Elastic;
use physics::menetrey_willam::{Eccentricity, MenetreyWillam};
use std::collections::BTreeSet;

/// Warnings, each a sentence or two; empty for a case without any.
#[must_use]
pub fn advice(case: &Case) -> Vec<String> {
    let mut notes = unusual(case);
    for (_, body) in case.touching() {
        few_cells::resolution(case, body, &mut notes);
        fine_zone(case, body, &mut notes);
        base::within_cell(case, body, &mut notes);
        motions::in_soil(case, body, &mut notes);
        motions::through_elastic_soil(case, body, &mut notes);
        // Nothing fails in front of a body that never enters the ground.
        if !motions::is_above_ground(case, body) {
            walls::walls_and_lid(case, body, &mut notes);
            inertia::speed(case, body, &mut notes);
        }
        surface(body, &mut notes);
    }
    motions::late(case, &mut notes);
    closed_box::pumped(case, &mut notes);
    relief::uneven(case, &mut notes);
    tables::files(case, &mut notes);
    timing(case, &mut notes);
    drainage(case, &mut notes);
    for (path, soil) in case.soils() {
        let mut own = Vec::new();
        strength(case, &path, soil, &mut own);
        softening(case, &path, soil, &mut own);
        sand_at_rest(soil, &mut own);
        let is_one = case.soils().count() == 1;
        notes.extend(own.into_iter().map(|note| if is_one { note } else { format!("[{path}]: {note}") }));
    }
    if case.bodies.is_empty() && case.soil.unit_weight == 0.0 && case.velocity == DVec3::ZERO {
        notes.push("There is no body and the soil has no weight: nothing will happen.".into());
    }
    // Two motions of a body may have the same ramp.
    let mut said = BTreeSet::new();
    notes.retain(|note| said.insert(note.clone()));
    notes
}

/// What was repaired of a surface that was read from a file, and whether its origin is far away.
fn surface(body: &Body, notes: &mut Vec<String>) {
    for repair in body.shape.mesh_report().into_iter().flat_map(|report| &report.repairs) {
        notes.push(format!("{}: its surface was repaired: {repair}.", body.name));
    }
    if let Some(report) = body.shape.mesh_report()
        && report.centroid.length() > report.size.max_element()
    {
        notes.push(format!(
            "{}: its reference point, the origin of its file, lies {:.3} m from its centroid: x, y, rotations and moments refer to \
             that point.",
            body.name,
            report.centroid.length()
        ));
    }
}

fn fine_zone(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let swept = Paths::of(case).of_body(body);
    let slack = 1e-6 * case.grid.cell;
    // What lies beyond a plane of symmetry is not modelled.
    let low_x = if case.domain.symmetric_x { swept.low.x.max(case.domain.low.x) } else { swept.low.x };
    let outside_x = low_x < case.grid.fine_low.x - slack || swept.high.x > case.grid.fine_high.x + slack;
    let outside_right = !case.domain.symmetric && swept.low.y < case.grid.fine_low.y - slack;
    let outside_y =
        !case.domain.plane_strain && (swept.high.y > case.grid.fine_high.y + slack || outside_right);
    let outside_z = swept.low.z < case.grid.fine_low.z - slack && swept.low.z > case.domain.low.z;
    if outside_x || outside_y || outside_z {
        notes.push(format!("{}: leaves the fine zone of the grid on its path.", body.name));
    }
}

/// Whether ramps are gentle and intervals no shorter than a step.
fn timing(case: &Case, notes: &mut Vec<String>) {
    let cost = estimate(case);
    let transit = (case.domain.high.z - case.domain.low.z) / cost.wave_speed_m_per_s;
    for body in &case.bodies {
        for freedom in body.motions() {
            let (Motion::Prescribed { ramp, .. } | Motion::Free { ramp, .. }) = freedom else { continue };
            let moves = !matches!(
                freedom,
                Motion::Free { load: 0.0, support: 0.0, .. } | Motion::Prescribed { speed: 0.0, .. }
            );
            if moves && ramp < 5.0 * transit {
                notes.push(format!(
                    "{}: a ramp of {ramp} s sends a shock wave through the soil; 5 wave transits take {:.2e} s.",
                    body.name,
                    5.0 * transit
                ));
            }
        }
    }
    if case.output.history_interval < cost.time_step_s {
        notes.push(format!(
            "output.history_interval is shorter than a time step, {:.2e} s.",
            cost.time_step_s
        ));
    }
    few_samples(case, notes);
}

/// Whether there are samples enough for steady means that a run is graded by.
fn few_samples(case: &Case, notes: &mut Vec<String>) {
    let during = case.steady_stage().map_or(case.duration, |stage| case.stages[stage].duration);
    let Output { history_interval, steady_fraction, .. } = case.output;
    let fewest = Output::FEWEST_SAMPLES;
    let samples = steady_fraction * during / history_interval;
    if !case.bodies.is_empty() && samples < fewest as f64 {
        notes.push(format!(
            "output.history_interval = {} s leaves {samples:.0} samples for the steady means, fewer than {fewest}: the run will be graded \
             doubtful; {:.2e} s leaves 50.",
            plain(history_interval),
            steady_fraction * during / 50.0
        ));
    }
}

/// Whether water can follow as the soil is sheared.
fn drainage(case: &Case, notes: &mut Vec<String>) {
    let beyond = |number: &f64| *number > Water::DRAINED[0] && !case.computes_pore_pressure();
    let Some(number) = case.drainage_number().filter(beyond) else { return };
    let effect = if case.volume_strain().is_some_and(|strain| strain < 0.0) {
        "the soil contracts as it is sheared, and the water in it bears part of the load: it may liquefy"
    } else {
        "the soil dilates as it is sheared, and suction makes it stronger than the run says"
    };
    notes.push(format!(
        "Drainage number (γ_w/γ′) v ε/k = {number:.3}: {effect}; up to {} it drains.",
        Water::DRAINED[0]
    ));
}

/// Dilatancy index above which sand counts as softening (chosen: a peak of 3.4° above the critical angle).
const SOFTENING: f64 = 1.0;

/// Softening sand whose bands depend on the cells.
fn softening(case: &Case, path: &str, soil: &Soil, notes: &mut Vec<String>) {
    let Some(Sand { characteristic_length, .. }) = soil.law.sand() else { return };
    let cell = case.grid.fine_cell().max_element();
    let consequence =
        "bands of softening sand are as wide as the cells, and its strength after the peak depends on them";
    if let Some(length) = characteristic_length.filter(|length| *length < 2.0 * cell) {
        notes.push(format!(
            "{path}.characteristic_length, {length:.4} m, is less than two cells of {cell:.4} m: {consequence}."
        ));
    }
    if characteristic_length.is_none() && sand(soil).is_some_and(|(_, index)| index > SOFTENING) {
        notes.push(format!("Sand this dense softens: without {path}.characteristic_length {consequence}."));
    }
}

/// Sand whose strength does not sustain the stress at rest.
fn sand_at_rest(soil: &Soil, notes: &mut Vec<String>) {
    let Some((law, index)) = sand(soil) else { return };
    let k0 = soil.k0;
    let [pressure, deviator, shape] = law.invariants([-k0, -k0, -1.0, 0.0, 0.0, 0.0]);
    if deviator > law.peak_ratio(index) * shape * pressure {
        notes.push(format!(
            "K₀ = {k0:.3} is outside the range that sand of this density can sustain: it will fail at once."
        ));
    }
}

fn strength(case: &Case, path: &str, soil: &Soil, notes: &mut Vec<String>) {
    let Law::MohrCoulomb(law) = soil.law else { return };
    let MohrCoulomb { friction_angle, dilation_angle, cohesion, potential, critical_density, .. } = law;
    let length = body_length(&case.bodies);
    let relative = cohesion / (soil.unit_weight * length);
    if cohesion > 0.0 && relative < 0.01 {
        notes.push(format!(
            "Cohesion c/(γd) = {relative:.1e} is tiny; c = 0 runs just as well and is the value for dry sand."
        ));
    }
    if dilation_angle > 0.0 && critical_density.is_none() {
        notes.push(format!(
            "Dilation ends only when the soil has expanded by a quarter, and makes it too strong on the way; {path}.critical_density ends it earlier."
        ));
    }
    if let Potential::MenetreyWillam { meridional, deviatoric } = potential {
        let elastic = Elastic::new(soil.young_modulus, soil.poisson_ratio);
        let shape = Eccentricity { meridional, deviatoric };
        let law = MenetreyWillam::new(elastic, friction_angle, dilation_angle, cohesion, 0.0, shape);
        if law.least_dissipation() < 0.0 {
            notes.push(format!(
                "With ψ so close to φ the smooth potential creates energy in some flow directions (up to {:.1} % of the \
                 frictional work); use a smaller {path}.dilation_angle.",
                -100.0 * law.least_dissipation()
            ));
        }
    }
    let passive = passive_coefficient(friction_angle);
    let at_rest = soil.k0;
    if cohesion == 0.0 && soil.unit_weight > 0.0 && !(1.0 / passive..=passive).contains(&at_rest) {
        notes.push(format!(
            "K₀ = {at_rest:.3} is outside the range that the soil can sustain ({:.3} to {passive:.3}): it will fail at \
             once.",
            1.0 / passive
        ));
    }
    if cohesion == 0.0 && soil.unit_weight == 0.0 {
        notes.push("The soil has neither weight nor cohesion, and therefore no strength.".into());
    }
}
