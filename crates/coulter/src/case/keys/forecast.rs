//! Keys of the closed-form models.

use super::key::{Key, Kind, key};
use super::words::{FACTORS, PUBLISHED_SOILS};
use crate::case::quantity::{ANGLE, LENGTH, STRESS, UNIT_WEIGHT};

pub(super) const FORECAST: &[Key] = &[
    key(
        "terrain",
        Kind::Choice(&PUBLISHED_SOILS),
        "none",
        "Soil whose published pressure–sinkage parameters n, k_c, k_φ and K are used (Bekker, Wong–Reece).",
    ),
    key(
        "sinkage_exponent",
        Kind::Number,
        "none",
        "Bekker's sinkage exponent n of p = (k_c/b + k_φ) zⁿ, 0.05 to 2.5.",
    ),
    key("cohesive_modulus", Kind::Modulus(1), "none", "Bekker's cohesive modulus k_c."),
    key("frictional_modulus", Kind::Modulus(2), "none", "Bekker's frictional modulus k_φ."),
    key(
        "shear_deformation_modulus",
        Kind::Quantity(LENGTH),
        "that of `terrain`; otherwise 15 mm (sand: 10 to 25 mm)",
        "Janosi and Hanamoto's shear deformation modulus K (Wong–Reece).",
    ),
    key("cone_index", Kind::Quantity(STRESS), "none", "Cone index CI (Wismer–Luth, Brixius)."),
    key(
        "plate_stiffness",
        Kind::Quantity(UNIT_WEIGHT),
        "that of 3D-RFT",
        "Pressure over depth under a level plate pushed down (2-D RFT).",
    ),
    key(
        "bow_wave",
        Kind::Number,
        "0",
        "Bow wave: fraction χ of the displaced soil that accumulates in front of the disc, 0 to 1.",
    ),
    key(
        "backfill",
        Kind::Quantity(ANGLE),
        "0 deg",
        "Inclination β of the ground in front of the disc, -10 to 25 deg, positive when it rises (PW).",
    ),
    key(
        "factors",
        Kind::Choice(&FACTORS),
        "\"meyerhof\"",
        "Shape, depth and inclination factors of the bearing capacity (BC).",
    ),
];
