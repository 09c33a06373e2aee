//! A comparison from its items to its figures.

use super::align::{Aligned, aligned};
use super::common::in_common;
use super::figures::{Differences, differences};
use super::item::{Item, ItemKind};
use super::settled::{scale, settle_signs};
use super::steady::{SteadyMean, steady_mean};
use crate::measured::Quantity;
use crate::sources::{LeftOut, place, rising};

/// The request for a comparison.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ComparisonRequest {
    /// The number of the item that is the reference; `None` for the first measurement, otherwise the first
    /// item.
    pub reference: Option<usize>,
    /// The quantity along which curves run; `None` for that of the reference.
    pub against: Option<Quantity>,
    /// Quantities to compare; empty for all that the reference and another item have.
    pub quantities: Vec<Quantity>,
    /// The part of the abscissa that counts [SI].
    pub window: Option<[f64; 2]>,
    /// Whether the zero of the abscissa of the other items is moved to where they fit best.
    pub align: bool,
}

/// One quantity of one item beside the reference.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The number of the item.
    pub item: usize,
    /// The quantity that is compared.
    pub quantity: Quantity,
    /// Whole curve of the item, moved with the shift.
    pub curve: Vec<[f64; 2]>,
    /// The curves at common abscissae; `None` where they share none.
    pub aligned: Option<Aligned>,
    /// Differences to the reference.
    pub differences: Option<Differences>,
    /// Points of the reference at which a model says nothing.
    pub left_out: Vec<LeftOut>,
    /// Steady mean of the item.
    pub mean: Option<SteadyMean>,
    /// Whether the steady mean of the item and that of the reference have a value in common within their 90 %
    /// intervals; `None` where neither has one.
    pub overlaps: Option<bool>,
}

/// A comparison.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The number of the reference.
    pub reference: usize,
    /// The quantity along which curves run.
    pub against: Quantity,
    /// Quantities that were compared, each with the curve of the reference and its steady mean.
    pub quantities: Vec<(Quantity, Vec<[f64; 2]>, Option<SteadyMean>)>,
    /// Every other item beside the reference.
    pub compared: Vec<Compared>,
    /// Remarks on how files were read, and on items that have nothing in common with the reference.
    pub remarks: Vec<String>,
}

/// The part of a curve at its end over which a mean counts as steady.
const STEADY: f64 = 0.4;

/// Compares items with their reference. Of each case file that closed form is taken that applies at most
/// points of the reference.
///
/// # Errors
/// Why they have nothing to be compared, and what to do.
pub fn compare(items: &mut [Item], request: &ComparisonRequest) -> Result<Comparison, String> {
    let first_measured = items.iter().position(|item| item.kind == ItemKind::Measured);
    let number = request.reference.or(first_measured).unwrap_or(0);
    if items.is_empty() {
        return Err("there is nothing to compare".to_owned());
    }
    if items.len() < 2 {
        return Err(
            "name two things or more: results folders, forecasts, case files, measured CSV files".to_owned()
        );
    }
    scale(items)?;
    let against = against(&items[number], request)?;
    let places = items[number].record.values(against).unwrap_or_default();
    let places: Vec<f64> =
        inside(&rising(places, places), request.window).iter().map(|point| point[0]).collect();
    let whole = place(&items[number].record, against, &places);
    let settled = items.iter_mut().try_for_each(|item| item.settle(against, &places));
    settled.map_err(|why| format!("{why} (for {whole})"))?;
    let wanted = wanted(items, number, against, request);
    settle_signs(items, against, &wanted)?;
    let (items, reference) = (&*items, &items[number]);
    let mut quantities = Vec::new();
    for quantity in wanted {
        let (curve, _) = reference.curve(quantity, against, (&reference.record, &[]));
        let curve = inside(&curve, request.window);
        if curve.len() >= 2 {
            let mean = mean_of(reference, quantity, against, (&curve, request));
            quantities.push((quantity, curve, mean));
        }
    }
    if quantities.is_empty() {
        return Err(format!(
            "{} has no quantity along {} that another has, too; choose with --quantity and --against, or widen --window",
            reference.name,
            against.name()
        ));
    }
    let mut compared = Vec::new();
    for (quantity, curve, mean) in &quantities {
        for (other, item) in items.iter().enumerate().filter(|(n, _)| *n != number) {
            compared.extend(beside((item, other), reference, (*quantity, curve, *mean), (against, request)));
        }
    }
    let has_mean =
        |one: &Compared| quantities.iter().any(|(known, _, mean)| *known == one.quantity && mean.is_some());
    let shares = |n: usize| {
        let both = |one: &Compared| one.aligned.is_some() || (one.mean.is_some() && has_mean(one));
        compared.iter().any(|one| one.item == n && both(one))
    };
    refuse_silence(&compared, shares)?;
    let mut remarks: Vec<String> = items.iter().flat_map(|item| item.record.named_remarks()).collect();
    remarks.extend(in_common(items, (number, against), shares, request.window)?);
    Ok(Comparison { reference: number, against, quantities, compared, remarks })
}

/// Refuses a comparison in which models say nothing at the points of the reference, and nothing else shares
/// any with it.
fn refuse_silence(compared: &[Compared], shares: impl Fn(usize) -> bool) -> Result<(), String> {
    let said: Vec<String> = compared.iter().flat_map(|one| one.left_out.iter().map(LeftOut::text)).collect();
    if said.is_empty() || compared.iter().any(|one| shares(one.item)) {
        return Ok(());
    }
    Err(format!("fewer than two points are left to be compared: {}", said.join("; ")))
}

fn against(reference: &Item, request: &ComparisonRequest) -> Result<Quantity, String> {
    let found: Vec<Quantity> = reference.record.abscissae().collect();
    match request.against {
        Some(wanted) if found.contains(&wanted) => Ok(wanted),
        Some(wanted) => Err(format!(
            "{} does not run along {}; it has {}",
            reference.name,
            wanted.name(),
            found.iter().map(|quantity| quantity.name()).collect::<Vec<_>>().join(", ")
        )),
        None => found.first().copied().ok_or_else(|| {
            format!(
                "{} has no curve to be the reference; name a run or a measurement first, or with --reference",
                reference.name
            )
        }),
    }
}

/// The quantities of the reference that another has.
fn wanted(items: &[Item], number: usize, against: Quantity, request: &ComparisonRequest) -> Vec<Quantity> {
    let is_known = |quantity: Quantity| {
        let mut others = items.iter().enumerate().filter(|(n, _)| *n != number);
        others.any(|(_, item)| {
            item.stated(quantity).is_some() || item.record.values(quantity).is_some() || item.model.is_some()
        })
    };
    let is_wanted = |quantity: &Quantity| {
        if request.quantities.is_empty() {
            // Speeds and rotations are compared where they are asked for.
            !matches!(quantity, Quantity::Speed | Quantity::Rotation | Quantity::Spin) && is_known(*quantity)
        } else {
            request.quantities.contains(quantity)
        }
    };
    items[number].record.ordinates(against).filter(is_wanted).collect()
}

fn inside(points: &[[f64; 2]], window: Option<[f64; 2]>) -> Vec<[f64; 2]> {
    let [from, to] = window.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    points.iter().copied().filter(|point| point[0] >= from && point[0] <= to).collect()
}

/// The steady mean of an item: over the window, where there is one; what the item states itself; or over the
/// end of its curve. Curves along a sinkage or a slip are never steady.
fn mean_of(
    item: &Item,
    quantity: Quantity,
    against: Quantity,
    (curve, request): (&[[f64; 2]], &ComparisonRequest),
) -> Option<SteadyMean> {
    if !matches!(against, Quantity::Displacement | Quantity::Time) {
        return None;
    }
    if curve.is_empty() || (request.window.is_none() && item.kind != ItemKind::Measured) {
        return item.stated(quantity);
    }
    let (first, last) = (curve.first()?[0], curve.last()?[0]);
    let begin = if request.window.is_some() { first } else { last - STEADY * (last - first) };
    let values: Vec<f64> = curve.iter().filter(|point| point[0] >= begin).map(|point| point[1]).collect();
    steady_mean(&values)
}

fn beside(
    (item, number): (&Item, usize),
    known: &Item,
    (quantity, reference, mean): (Quantity, &[[f64; 2]], Option<SteadyMean>),
    (against, request): (Quantity, &ComparisonRequest),
) -> Option<Compared> {
    let (curve, left_out) = item.curve(quantity, against, (&known.record, reference));
    let curve = if request.align { curve } else { inside(&curve, request.window) };
    let found = aligned(reference, &curve, request.align && item.model.is_none());
    let own = mean_of(item, quantity, against, (&curve, request));
    if curve.is_empty() && own.is_none() && left_out.is_empty() {
        return None;
    }
    let shift = found.as_ref().map_or(0.0, |found| found.shift);
    Some(Compared {
        item: number,
        quantity,
        curve: curve.iter().map(|[x, y]| [x + shift, *y]).collect(),
        differences: found.as_ref().and_then(differences),
        aligned: found,
        left_out,
        overlaps: mean.zip(own).and_then(|(a, b)| a.overlaps(&b)),
        mean: own,
    })
}
