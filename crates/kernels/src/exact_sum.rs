//! Exact sums of floating-point numbers: the same to the bit in whatever order, and in however many blocks,
//! the terms are added.
//!
//! The sum is kept as a whole number of units in the last place of the smallest number, in digits of 32 bits
//! with room for carries: the small superaccumulator of R. M. Neal (2015), Fast exact summation using small
//! and large superaccumulators, arXiv:1505.05571, section 3. Blocks of a grid add their digits as whole
//! numbers, so that no block needs the terms of the others.

/// Number of digits: enough for every finite number, and for carries beyond the largest.
const DIGITS: usize = 67;

/// Digits of a sum, and last the number of its terms that were not finite.
pub const NUMBERS: usize = DIGITS + 1;

/// Bits of a digit.
const BITS: usize = 32;

/// Terms between two propagations of carries: each adds less than 2⁵² to a digit of 63 bits.
const ROOM: u32 = 1 << 10;

/// Exponent of the unit of the first digit: that of the smallest number.
const UNIT: i32 = -1074;

/// An exact sum.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct ExactSum {
    /// The digits, and last the number of terms that were not finite.
    digits: [i64; NUMBERS],
    /// Terms that may be added before carries are propagated.
    room: u32,
}

impl Default for ExactSum {
    fn default() -> Self {
        Self { digits: [0; NUMBERS], room: ROOM }
    }
}

impl ExactSum {
    /// Adds a term.
    #[inline]
    pub fn add(&mut self, term: f64) {
        if term == 0.0 {
            return;
        }
        if !term.is_finite() {
            self.digits[DIGITS] += 1;
            return;
        }
        if self.room == 0 {
            self.carry();
        }
        self.room -= 1;
        let bits = term.to_bits();
        let exponent = ((bits >> 52) & 0x7ff) as usize;
        let fraction = bits & ((1 << 52) - 1);
        // A subnormal number has no implicit bit and the exponent of the smallest normal one.
        let (mantissa, place) =
            if exponent == 0 { (fraction, 0) } else { (fraction | (1 << 52), exponent - 1) };
        let (digit, shift) = (place / BITS, place % BITS);
        let low = ((mantissa << shift) & u64::from(u32::MAX)) as i64;
        let high = (mantissa >> (BITS - shift)) as i64;
        let sign = if term < 0.0 { -1 } else { 1 };
        self.digits[digit] += sign * low;
        self.digits[digit + 1] += sign * high;
    }

    /// Adds the terms of another sum.
    pub fn merge(&mut self, mut other: Self) {
        let terms = (ROOM - self.room) + (ROOM - other.room);
        if terms <= ROOM {
            self.room = ROOM - terms;
        } else {
            // The carries of both fit into what a thousand terms leave.
            self.carry();
            other.carry();
        }
        self.digits.iter_mut().zip(other.digits).for_each(|(own, digit)| *own += digit);
    }

    /// The sum as whole numbers: those of sums over several parts may be added one by one, and make up the
    /// sum over all.
    #[must_use]
    pub fn numbers(mut self) -> [i64; NUMBERS] {
        self.carry();
        self.digits
    }

    /// One of the [`ExactSum::numbers`] of a sum after [`ExactSum::carry`].
    #[inline]
    pub(crate) fn digit(&self, number: usize) -> i64 {
        self.digits[number]
    }

    /// The sum of these [`ExactSum::numbers`], which may have been added over as many as 2³⁰ parts.
    #[must_use]
    pub fn of_numbers(digits: [i64; NUMBERS]) -> Self {
        let mut sum = Self { digits, room: 0 };
        sum.carry();
        sum
    }

    /// Brings all digits but the last into 0 to 2³² − 1: the only such form of the sum.
    #[inline]
    pub fn carry(&mut self) {
        let mut carry = 0;
        for digit in &mut self.digits[..DIGITS - 1] {
            let sum = *digit + carry;
            carry = sum >> BITS;
            *digit = sum & i64::from(u32::MAX);
        }
        self.digits[DIGITS - 1] += carry;
        self.room = ROOM;
    }

    /// The sum, rounded to the nearest number; not a number if one of the terms was not finite.
    #[must_use]
    pub fn value(mut self) -> f64 {
        if self.digits[DIGITS] > 0 {
            return f64::NAN;
        }
        self.carry();
        let is_negative = self.digits[DIGITS - 1] < 0;
        if is_negative {
            self.digits.iter_mut().for_each(|digit| *digit = -*digit);
            self.carry();
        }
        let digits = &self.digits[..DIGITS];
        let Some(first) = digits.iter().rposition(|digit| *digit != 0) else { return 0.0 };
        // Four digits, and below them whether there is more: what rounding must know.
        let last = first.saturating_sub(3);
        let leading =
            digits[last..=first].iter().rev().fold(0_u128, |sum, digit| (sum << BITS) | *digit as u128);
        let is_inexact = digits[..last].iter().any(|digit| *digit != 0);
        let exponent = (BITS * last) as i32 + UNIT;
        let half = exponent / 2;
        let size = (leading | u128::from(is_inexact)) as f64 * 2_f64.powi(half) * 2_f64.powi(exponent - half);
        if is_negative { -size } else { size }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(terms: &[f64]) -> f64 {
        let mut sum = ExactSum::default();
        terms.iter().for_each(|term| sum.add(*term));
        sum.value()
    }

    /// A number of any size and sign, from a linear congruential generator.
    fn any(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let sign = *seed & (1 << 63);
        let exponent = ((*seed >> 33) % 2046) << 52;
        f64::from_bits(sign | exponent | (*seed >> 12))
    }

    #[test]
    fn sums_of_a_few_terms_are_rounded_once() {
        assert_eq!(sum(&[]), 0.0);
        assert_eq!(sum(&[1.5, 2.25, -0.75]), 3.0);
        assert_eq!(sum(&[1e300, 1.0, -1e300]), 1.0);
        assert_eq!(sum(&[1.0, 2_f64.powi(-53)]), 1.0, "a tie goes to the even number");
        assert_eq!(sum(&[1.0, 2_f64.powi(-53), f64::MIN_POSITIVE * 2_f64.powi(-52)]), 1.0 + f64::EPSILON);
        assert_eq!(sum(&[f64::MAX, f64::MAX, -f64::MAX]), f64::MAX);
        let smallest = f64::from_bits(1);
        assert_eq!(sum(&[smallest, smallest]), 2.0 * smallest);
        assert_eq!(sum(&[-3.0 * smallest, smallest]), -2.0 * smallest);
    }

    #[test]
    fn a_single_term_stays_what_it_is() {
        let mut seed = 1;
        for _ in 0..10_000 {
            let term = any(&mut seed);
            assert_eq!(sum(&[term]).to_bits(), term.to_bits());
        }
    }

    #[test]
    fn neither_order_nor_parts_change_a_bit() {
        let mut seed = 7;
        let mut terms: Vec<f64> = (0..20_000).map(|_| any(&mut seed)).collect();
        let all = sum(&terms);
        terms.reverse();
        assert_eq!(sum(&terms).to_bits(), all.to_bits());
        let mut parts = ExactSum::default();
        for part in terms.chunks(1023) {
            let mut own = ExactSum::default();
            part.iter().for_each(|term| own.add(*term));
            parts.merge(own);
        }
        assert_eq!(parts.value().to_bits(), all.to_bits());
        terms.sort_by(f64::total_cmp);
        assert_eq!(sum(&terms).to_bits(), all.to_bits());
        terms.extend(terms.clone().iter().map(|term| -term));
        assert_eq!(sum(&terms), 0.0);
    }

    #[test]
    fn what_is_not_finite_shows() {
        assert!(sum(&[1.0, f64::NAN]).is_nan());
        assert!(sum(&[f64::INFINITY, f64::NEG_INFINITY, 1.0]).is_nan());
        assert!(sum(&[f64::INFINITY]).is_nan());
    }
}
