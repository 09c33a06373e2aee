//! Keys of the closed-form models.

use super::allowed_range::{BACKFILL, EXPONENT, FRACTION, NOT_NEGATIVE, POSITIVE};
use super::default_value::DefaultValue::{Derived, Number, Otherwise, Quantity, Word};
use super::key::{Key, Kind, key};
use super::words::{FACTORS, PUBLISHED_SOILS};
use crate::case::quantity::{ANGLE, LENGTH, RATE_RESISTANCE, STRESS, UNIT_WEIGHT};

pub(super) const FORECAST: &[Key] = &[
    key(
        "terrain",
        Kind::Choice(&PUBLISHED_SOILS),
        Derived("none"),
        "Soil whose published pressure–sinkage parameters n, k_c, k_φ and K are used (Bekker, Wong–Reece).",
    ),
    key(
        "sinkage_exponent",
        Kind::Number,
        Derived("none"),
        "Bekker's sinkage exponent n of p = (k_c/b + k_φ) zⁿ.",
    )
    .within(EXPONENT),
    key("cohesive_modulus", Kind::Modulus(1), Derived("none"), "Bekker's cohesive modulus k_c.")
        .within(NOT_NEGATIVE),
    key("frictional_modulus", Kind::Modulus(2), Derived("none"), "Bekker's frictional modulus k_φ.")
        .within(POSITIVE),
    key(
        "shear_deformation_modulus",
        Kind::Quantity(LENGTH),
        Otherwise { derived: "that of `terrain`", quantity: "15 mm" },
        "Janosi and Hanamoto's shear deformation modulus K (Wong–Reece); sand: 10 to 25 mm.",
    )
    .within(POSITIVE),
    key("cone_index", Kind::Quantity(STRESS), Derived("none"), "Cone index CI (Wismer–Luth, Brixius).")
        .within(POSITIVE),
    key(
        "plate_stiffness",
        Kind::Quantity(UNIT_WEIGHT),
        Derived("that of 3D-RFT"),
        "Pressure over depth under a level plate pushed down (2-D RFT).",
    )
    .within(POSITIVE),
    key(
        "bow_wave",
        Kind::Number,
        Number(0.0),
        "Bow wave: fraction χ of the displaced soil that accumulates in front of the disc.",
    )
    .within(FRACTION),
    key(
        "backfill",
        Kind::Quantity(ANGLE),
        Quantity("0 deg"),
        "Inclination β of the ground in front of the disc, positive when it rises (PW).",
    )
    .within(BACKFILL),
    key(
        "plough_weight_coefficient",
        Kind::Interval,
        Derived("none"),
        "C_w of the tow force of a plough under water, C_w W′ + C_s γ′ D³ + C_d v D²: friction over its weight in water, least and most.",
    )
    .within(NOT_NEGATIVE),
    key(
        "plough_slow_coefficient",
        Kind::Interval,
        Derived("none"),
        "C_s of the same: slow resistance over γ′ D³, D the depth, least and most.",
    )
    .within(NOT_NEGATIVE),
    key(
        "plough_rate_coefficient",
        Kind::Range(RATE_RESISTANCE),
        Derived("none"),
        "C_d of the same: growth of the resistance with the speed over D², least and most.",
    )
    .within(NOT_NEGATIVE),
    key(
        "factors",
        Kind::Choice(&FACTORS),
        Word("meyerhof"),
        "Shape, depth and inclination factors of the bearing capacity (BC).",
    ),
];
