//! Parameters of the method and of the closed-form models: each in the range of its key.

use crate::case::numbers::in_range;
use crate::case::problem::Problems;
use crate::case::resolved::{Measured, Numerics};

pub(super) fn numerics(numerics: &Numerics, problems: &mut Problems) {
    let all = [
        ("courant", numerics.courant),
        ("remap_displacement", numerics.remap_displacement),
        ("hourglass", numerics.hourglass),
        ("hourglass_yielding", numerics.hourglass_yielding),
        ("bulk_viscosity_linear", numerics.bulk_viscosity_linear),
        ("bulk_viscosity_quadratic", numerics.bulk_viscosity_quadratic),
        ("edge_inset", numerics.edge_inset),
        ("point_spacing", numerics.point_spacing),
        ("threads", numerics.threads as f64),
    ];
    for (key, number) in all {
        in_range(&format!("numerics.{key}"), number, problems);
    }
}

pub(super) fn forecast(measured: &Measured, problems: &mut Problems) {
    let plate = measured.plate.as_ref();
    let all = [
        ("backfill", Some(measured.backfill)),
        ("bow_wave", Some(measured.bow_wave)),
        ("cone_index", measured.cone_index),
        ("plate_stiffness", measured.plate_stiffness),
        ("sinkage_exponent", plate.map(|plate| plate.exponent)),
        ("cohesive_modulus", plate.map(|plate| plate.cohesive)),
        ("frictional_modulus", plate.map(|plate| plate.frictional)),
        ("shear_deformation_modulus", plate.map(|plate| plate.shear_deformation_modulus)),
    ];
    for (key, number) in all {
        if let Some(number) = number {
            in_range(&format!("forecast.{key}"), number, problems);
        }
    }
}
