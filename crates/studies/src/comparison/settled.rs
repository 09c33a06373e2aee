//! Measurements that follow other conventions than what they are compared with: dimensionless, or with forces
//! of the other sign.

use super::item::{Item, ItemKind};
use crate::measured::{Quantity, Record, settle_force, sign_of};
use crate::sources::rising;
use coulter::history::reference::Reference;

/// Scales dimensionless columns of measurements as those of the runs and cases beside them.
///
/// # Errors
/// What is wrong, with the cure, where nothing says how, or two say it differently.
pub(super) fn scale(items: &mut [Item]) -> Result<(), String> {
    let references: Vec<Reference> = items.iter().filter_map(|item| item.reference.clone()).collect();
    for item in items.iter_mut().filter(|item| item.record.has_groups()) {
        let Some(first) = references.first() else { return item.record.refuse_groups() };
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * b.abs();
        let is_same = |other: &Reference| {
            same(other.length, first.length)
                && same(other.force().unwrap_or(0.0), first.force().unwrap_or(0.0))
        };
        if !references.iter().all(is_same) {
            return Err(format!(
                "{}: its columns are dimensionless, and the cases beside it have different reference quantities d, t and γ; compare it with one of \
                 them at a time",
                item.name
            ));
        }
        item.record.scale(first)?;
    }
    Ok(())
}

/// Turns forces of measurements where only the convention of signs differs.
///
/// # Errors
/// What is wrong, with the cure, where the difference may be real.
pub(crate) fn settle_signs(items: &mut [Item], against: Quantity, wanted: &[Quantity]) -> Result<(), String> {
    for n in 0..items.len() {
        if items[n].kind != ItemKind::Measured {
            continue;
        }
        for quantity in wanted.iter().filter(|quantity| quantity.is_load()) {
            let measured = &items[n].record;
            let (x, y) = (measured.values(against), measured.values(*quantity));
            let (Some(x), Some(y)) = (x, y) else { continue };
            let points = rising(x, y);
            let sign = |item: &Item| sign_of(&values(item, (*quantity, against), (measured, &points)));
            let is_model = |item: &&Item| item.kind != ItemKind::Measured;
            // Of measurements alone those that press and drag are right.
            let upright = || items.iter().any(|item| sign(item) == Some(1.0)).then_some(1.0);
            let expected = items.iter().filter(is_model).find_map(sign).or_else(upright);
            settle_force(&mut items[n].record, *quantity, against, expected)?;
        }
    }
    Ok(())
}

fn values(
    item: &Item,
    (quantity, against): (Quantity, Quantity),
    reference: (&Record, &[[f64; 2]]),
) -> Vec<f64> {
    match item.curve(quantity, against, reference).0 {
        curve if curve.is_empty() => item.stated(quantity).map(|mean| mean.mean).into_iter().collect(),
        curve => curve.iter().map(|point| point[1]).collect(),
    }
}
