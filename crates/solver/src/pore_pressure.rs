//! The pressure of the water in the pores of the soil.
//!
//! Grains and water do not compress, so water must flow in where the soil expands: ∇·(k/γ_w ∇p) = ∇·v, with p
//! the pressure beyond the hydrostatic one and v the velocity of the soil. The soil feels it as a total
//! stress σ − p 1. Both are solved in turn: the pressure from the velocities at the end of a step, after
//! contact, and extrapolated acts in the next. What that pressure will do to the velocities is anticipated by
//! the inertia of the soil, which stands beside the mobility of the water and bounds the pressure of water
//! that can hardly flow. The time step remains that of the soil, whatever the permeability.

use crate::contact::workspace::ContactWorkspace;
use crate::contact::{self, Pressed};
use crate::cpu::seepage::{self, Balance, SeepageWorkspace};
use crate::cpu::stopwatch::Stage;
use crate::cpu::workspace::SoilWorkspace;
use crate::error::{Breakdown, Location};
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::model::Model;
use crate::state::State;

/// How much of the inertia of the soil is anticipated, over that of its nodes in a full row of cubes. Above 1
/// for the light nodes in its surface; more makes pressures lag behind, and changes nothing in steady motion.
const ANTICIPATED: f64 = 2.0;

/// Renews the pore pressures at the end of a step, from the velocities after contact.
///
/// # Errors
/// [`Breakdown`] where no pressures balance the flow of the water.
pub(crate) fn renew<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    seepage: &mut SeepageWorkspace,
    (contact, pressed): (&ContactWorkspace, &[Pressed]),
    halo: &Halo,
) -> Result<(), Breakdown> {
    let Some(water) = &model.pore_water else { return Ok(()) };
    let dt = model.time_step();
    let opened = contact
        .pressure_cells
        .iter()
        .zip(&contact.openings)
        .filter_map(|(cell, rate)| Some(((*cell)?, *rate)));
    let closed = pressed.iter().map(|own| (own.cell, -own.volume(&model.grid, &state.soil) / dt));
    seepage.open_gaps(opened.chain(closed));
    let inertia = ANTICIPATED * dt / model.least_density();
    let (mobility, height) = (water.mobility(), state.grid_position.z);
    let balance = Balance { model, water, mobility, with_inertia: mobility + inertia, height };
    let off = balance.solve(state, soil, seepage, halo);
    soil.stopwatch().lap(Stage::Seepage);
    if off == 0.0 {
        return Ok(());
    }
    Err(Breakdown::Untrustworthy {
        what: format!("the flow of the pore water does not balance (off by {off:.1} times what is allowed)"),
        cure: "use a smaller numerics.courant, or fewer cells".into(),
        time: state.time,
        step: state.step,
        location: Location::UNKNOWN,
    })
}

/// Finds between which cells water can flow, after a contact search, and where a run resumes.
pub(crate) fn find_paths<R: Kernels>(
    model: &Model,
    state: &State<R>,
    seepage: &mut SeepageWorkspace,
    contact: &mut ContactWorkspace,
) {
    if model.pore_water.is_none() {
        return;
    }
    seepage.set_bodies(contact.body_cells.iter().map(|own| (own.cell, own.fraction)));
    seepage::find(model, &state.soil, seepage);
    contact::find_pressure_cells(model, state, seepage, contact);
}
