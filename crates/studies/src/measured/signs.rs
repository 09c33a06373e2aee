//! Which way measured depths and forces count: downwards and against the body, or the other way round.

use super::header::{Sign, Values};
use super::{Quantity, Record};
use coulter::case::table_file::{Placed, TableColumn, placed};

/// Part of the largest magnitude up to which values of the other sign are noise (chosen).
const NOISE: f64 = 0.05;

/// The sign that values have throughout, but for noise about zero: 1 or −1; `None` where they have both, or
/// are all zero.
#[must_use]
pub fn sign_of(values: &[f64]) -> Option<f64> {
    let (low, high) = values.iter().fold((0.0_f64, 0.0_f64), |(low, high), v| (low.min(*v), high.max(*v)));
    match () {
        () if high > 0.0 && -low <= NOISE * high => Some(1.0),
        () if low < 0.0 && high <= -NOISE * low => Some(-1.0),
        () => None,
    }
}

impl Values {
    /// Whether the sign of the values was stated.
    pub(super) fn is_stated(&self) -> bool {
        self.sign == Sign::Stated
    }
}

/// Depths positive downwards [m]: those that count upwards are turned where that is the one reading, and
/// refused where it is not.
pub(super) fn settle_depth(
    found: &Values,
    mut values: Vec<f64>,
    column: &TableColumn,
    remarks: &mut Vec<String>,
) -> Result<Vec<f64>, Placed> {
    if found.quantity != Quantity::Sinkage || found.is_stated() {
        return Ok(values);
    }
    let title = &column.title;
    let refuse = |message: String| {
        let cure = format!(
            "say which way it counts: --column \"{title}\"=sinkage downwards, --column \"{title}\"=-sinkage upwards, from the surface"
        );
        Err(placed(column.at.clone(), message, cure))
    };
    let goes_down = || values.last().zip(values.first()).is_some_and(|(last, first)| last < first);
    let turned = match (found.sign, sign_of(&values)) {
        (Sign::Height, Some(1.0)) => {
            return refuse(format!(
                "\"{title}\" is above zero throughout: where the surface lies is not known"
            ));
        }
        (Sign::Height, _) | (_, Some(-1.0)) => true,
        (_, None) if goes_down() => {
            return refuse(format!(
                "\"{title}\" goes from positive to negative values, and may count upwards"
            ));
        }
        _ => false,
    };
    if turned {
        values.iter_mut().for_each(|value| *value = 0.0 - *value);
        remarks.push(format!("\"{title}\" counts upwards: read as depths, its sign turned"));
    }
    Ok(values)
}

/// Turns the sign of measured values that is another than `expected` throughout, and says so, where that is
/// the one reading: of the force and the pressure under what is pressed down, and of the drag of what is
/// towed.
///
/// # Errors
/// What is wrong, with the cure, where the difference may be real.
pub fn settle_force(
    record: &mut Record,
    quantity: Quantity,
    along: Quantity,
    expected: Option<f64>,
) -> Result<(), String> {
    let name = record.name.clone();
    let Some(channel) = record.channels.iter_mut().find(|channel| channel.quantity == quantity) else {
        return Ok(());
    };
    let (Some(sign), Some(expected)) = (sign_of(&channel.values), expected) else { return Ok(()) };
    if sign == expected || channel.is_stated || along == Quantity::Slip {
        return Ok(());
    }
    let is_safe = match quantity {
        Quantity::Vertical | Quantity::Pressure => along == Quantity::Sinkage,
        Quantity::Drag => true,
        _ => false,
    };
    let word = quantity.name();
    let [measured, other] = if sign < 0.0 { ["negative", "positive"] } else { ["positive", "negative"] };
    let title = &channel.title;
    if !is_safe {
        return Err(format!(
            "{name}: \"{title}\" is {measured} throughout, the {word} of the others {other}: if only the convention differs, add \
             --column \"{title}\"=-{word}; if not, --column \"{title}\"={word}"
        ));
    }
    channel.values.iter_mut().for_each(|value| *value = 0.0 - *value);
    let remark =
        format!("\"{title}\" is {measured} throughout, where {word} is {other}: its sign was turned");
    record.remarks.push(remark);
    Ok(())
}
