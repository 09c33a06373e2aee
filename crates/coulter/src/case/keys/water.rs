//! Keys of the water over the ground.

use super::allowed_range::{NOT_NEGATIVE, POSITIVE, VOLUME_STRAIN};
use super::default_value::DefaultValue::{Derived, Flag, Number, Quantity, Required};
use super::key::{Key, Kind, key};
use super::usual_range::{GRAIN_DENSITY, PERMEABILITY, WATER_DENSITY};
use crate::case::quantity::{DENSITY, LENGTH, SPEED};

pub(super) const WATER: &[Key] = &[
    key("level", Kind::Quantity(LENGTH), Required, "Height of the surface of the water; soil and bodies lie below it."),
    key("density", Kind::Quantity(DENSITY), Quantity("1000 kg/m^3"), "Density of the water ρ_w; some 1025 kg/m^3 at sea.")
        .within(POSITIVE).usually(WATER_DENSITY),
    key(
        "grain_density",
        Kind::Quantity(DENSITY),
        Quantity("2650 kg/m^3"),
        "Density of the grains ρ_s; the submerged unit weight of soil is γ′ = ρ g (1 − ρ_w/ρ_s), ρ its dry density.",
    )
    .within(POSITIVE)
    .usually(GRAIN_DENSITY),
    key(
        "permeability",
        Kind::Quantity(SPEED),
        Derived("required for frictional soil"),
        "Permeability of the soil k (hydraulic conductivity): about 1e-5 m/s in silty sand, 1e-4 in fine, 1e-3 in coarse sand.",
    )
    .within(POSITIVE)
    .usually(PERMEABILITY),
    key(
        "volume_strain",
        Kind::Number,
        Derived("ρ/ρ_crit − 1; required for mohr-coulomb without critical_density"),
        "Volume strain ε of the soil as it fails, positive where it dilates: (n_max − n)/(1 − n_max); for the drainage number.",
    )
    .within(VOLUME_STRAIN),
    key(
        "pore_pressure",
        Kind::Flag,
        Flag(false),
        "Whether the pressure of the pore water is computed; otherwise the soil is drained, without excess pore pressure.",
    ),
    key(
        "drag_coefficient",
        Kind::Number,
        Number(1.0),
        "Drag coefficient C_d of the bodies, for their frontal area at the start; 0 for no drag of the water.",
    )
    .within(NOT_NEGATIVE),
    key(
        "accept_drained",
        Kind::Flag,
        Flag(false),
        "Run although the soil does not drain at this speed; `--accept-drained` sets it.",
    ),
];
