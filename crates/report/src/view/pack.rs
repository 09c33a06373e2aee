//! Numbers as text that a page holds: whole steps, few bytes each, base 64.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Steps between the lowest and the highest height: finer than a pixel of any screen.
const STEPS: f64 = 4095.0;

/// Heights in whole steps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Packed {
    /// The lowest height [m]: step 1; step 0 is a place without ground.
    pub(super) low: f64,
    /// Height of a step [m].
    pub(super) step: f64,
    /// The steps of all times.
    pub(super) text: String,
}

/// Packs heights of several times at the same places, each as its change since the time before.
pub(super) fn packed(times: &[Vec<f64>]) -> Packed {
    let finite = || times.iter().flatten().copied().filter(|z| z.is_finite());
    let low = finite().fold(f64::INFINITY, f64::min);
    let high = finite().fold(f64::NEG_INFINITY, f64::max);
    let low = if low.is_finite() { low } else { 0.0 };
    let step = ((high - low) / STEPS).max(1e-6);
    let whole = |z: &f64| if z.is_finite() { 1 + ((z - low) / step).round() as i64 } else { 0 };
    let mut bytes = Vec::new();
    let mut before = vec![0; times.first().map_or(0, Vec::len)];
    for heights in times {
        let now: Vec<i64> = heights.iter().map(whole).collect();
        push_changes(&mut bytes, &before, &now);
        before = now;
    }
    Packed { low, step, text: STANDARD.encode(bytes) }
}

/// Adds the changes from one time to the next: even numbers up, odd ones down; after a 0 how many changes are
/// 0.
fn push_changes(bytes: &mut Vec<u8>, before: &[i64], now: &[i64]) {
    let mut zeros = 0;
    for change in before.iter().zip(now).map(|(a, b)| b - a) {
        if change == 0 {
            zeros += 1;
            continue;
        }
        push_zeros(bytes, &mut zeros);
        push_number(
            bytes,
            if change > 0 { 2 * change.unsigned_abs() } else { 2 * change.unsigned_abs() - 1 },
        );
    }
    push_zeros(bytes, &mut zeros);
}

fn push_zeros(bytes: &mut Vec<u8>, zeros: &mut u64) {
    if *zeros > 0 {
        bytes.push(0);
        push_number(bytes, *zeros);
        *zeros = 0;
    }
}

/// A number in groups of seven bits, the lowest first; all but the last have the eighth bit.
fn push_number(bytes: &mut Vec<u8>, mut number: u64) {
    while number > 127 {
        bytes.push(128 | (number & 127) as u8);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Numbers of sixteen bits, low byte first.
pub(super) fn words(numbers: impl Iterator<Item = u16>) -> String {
    STANDARD.encode(numbers.flat_map(u16::to_le_bytes).collect::<Vec<u8>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_packed_and_missing_ground_is_zero() {
        let Packed { low, step, text } = packed(&[vec![f64::NAN, 0.0, 4.095], vec![f64::NAN, 0.0, 4.094]]);
        assert_eq!((low, (1e3 * step).round()), (0.0, 1.0));
        // One zero; +1; +4096; then two zeros; −1.
        assert_eq!(STANDARD.decode(text).unwrap(), [0, 1, 2, 0x80, 0x40, 0, 2, 1]);
        assert_eq!(packed(&[vec![f64::NAN; 3]]).text, STANDARD.encode([0, 3]));
    }
}
