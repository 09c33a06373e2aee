//! What items have in common with the reference: something, or a word about why not.

use super::item::Item;
use crate::measured::Quantity;
use crate::sheet::short;

/// Remarks on the items that do not share anything with the reference.
///
/// # Errors
/// What to say where no items share anything: there is nothing to compare.
pub(super) fn in_common(
    items: &[Item],
    (reference, against): (usize, Quantity),
    shares: impl Fn(usize) -> bool,
    window: Option<[f64; 2]>,
) -> Result<Vec<String>, String> {
    let others: Vec<usize> = (0..items.len()).filter(|n| *n != reference).collect();
    let apart: Vec<usize> = others.iter().copied().filter(|n| !shares(*n)).collect();
    let why = |n: &usize| {
        let [one, other] = [&items[reference], &items[*n]].map(|item| reach(item, against));
        format!("no point of {other} lies along {} where {one}", against.name())
    };
    let mut remarks: Vec<String> = apart.iter().map(why).collect();
    if apart.len() < others.len() {
        return Ok(remarks);
    }
    if let Some([from, to]) = window {
        remarks.push(format!("--window is {} to {} {}", short(from), short(to), against.unit()));
    }
    Err(format!(
        "nothing to compare: {}; check units, signs and zeros of the two, or choose with --quantity, --against and --window",
        remarks.join("; ")
    ))
}

/// Where an item has values.
fn reach(item: &Item, against: Quantity) -> String {
    let Some(values) = item.record.values(against) else {
        return format!("{} (no curve along it)", item.name);
    };
    let ends =
        values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(*v), high.max(*v)]);
    format!("{} ({} to {} {})", item.name, short(ends[0]), short(ends[1]), against.unit())
}
