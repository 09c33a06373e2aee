//! The probe of a body's rim: what the soil has done to each of its bins.

use case::tow::TowDirection;
use solver::model::Model;
use solver::state::{Body, RimSums};

/// The sums over the bins of a body's rim and over its flanks, with the impulses of the whole body along and
/// across its tow. Where only half of it is modelled, what acts along the axle cancels.
pub(super) fn sums(model: &Model, body: &Body, tow: TowDirection) -> Vec<RimSums> {
    let (symmetry, fraction) = (model.symmetry(), model.modelled_fraction());
    let lateral = if symmetry.across[1] { 0.0 } else { 1.0 };
    let of_whole = |sums: &RimSums| RimSums {
        impulse: tow.turned(symmetry.of_whole(sums.impulse)) / fraction,
        shear: [sums.shear[0], lateral * sums.shear[1], sums.shear[2]],
        slip: [sums.slip[0], lateral * sums.slip[1], sums.slip[2]],
        ..*sums
    };
    body.rim.iter().map(of_whole).collect()
}
