//! The probe of the energy balance.

use crate::history::EnergySample;
use solver::balance;
use solver::energy::{compressed_volume, overdense_portion, soil_volume};
use solver::halo::Halo;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// The energy balance of the whole, not of the modelled portion.
pub(super) fn sample<R: Precision>(model: &Model, state: &State<R>, halo: &Halo) -> EnergySample {
    let terms = &state.energy_balance;
    let whole = 1.0 / model.modelled_fraction();
    EnergySample {
        time: state.time,
        external: (terms.external + terms.kinetic_start + terms.inflow_elastic) * whole,
        kinetic: balance::kinetic_energy(model, state, halo) * whole,
        elastic: (balance::elastic_energy(model, state, halo) - terms.elastic_start) * whole,
        plastic: terms.plastic * whole,
        friction: terms.friction * whole,
        contact: terms.contact * whole,
        viscous: terms.viscous * whole,
        hourglass: terms.hourglass * whole,
        seepage: terms.seepage * whole,
        remap_loss: terms.remap * whole,
        volume_ratio: (soil_volume(&model.grid, &state.soil, halo) - terms.inflow_volume)
            / terms.volume_start,
        compression: compressed_volume(model, &state.soil, halo) / terms.volume_start,
        overdense: overdense_portion(model, &state.soil, halo),
        // Of its own probe.
        void: 0.0,
    }
}
