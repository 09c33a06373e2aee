//! The range of a number. It stands once, at its key: reading, `validate`, the documentation and the JSON schema take it from
//! there.

use physics::sand;
use solver::cpu::threads::MAX_WORKERS;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// No end.
    None,
    /// The number itself is allowed.
    Inclusive(f64),
    /// The number itself is not allowed.
    Exclusive(f64),
}

use Bound::{Exclusive, Inclusive};

/// Which numbers a key allows, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllowedRange {
    /// Low end.
    pub low: Bound,
    /// High end.
    pub high: Bound,
    /// What a number outside would mean; empty where that is plain.
    pub why: &'static str,
}

const fn from(low: Bound, high: Bound) -> AllowedRange {
    AllowedRange { low, high, why: "" }
}

pub(in crate::case) const POSITIVE: AllowedRange = from(Exclusive(0.0), Bound::None);
pub(in crate::case) const NOT_NEGATIVE: AllowedRange = from(Inclusive(0.0), Bound::None);
pub(in crate::case) const AT_LEAST_ONE: AllowedRange = from(Inclusive(1.0), Bound::None);
pub(in crate::case) const FRACTION: AllowedRange = from(Inclusive(0.0), Inclusive(1.0));
pub(in crate::case) const POSITIVE_FRACTION: AllowedRange = from(Exclusive(0.0), Inclusive(1.0));
pub(in crate::case) const BELOW_HALF: AllowedRange =
    AllowedRange { low: Inclusive(0.0), high: Exclusive(0.5), why: "0.5 would be incompressible" };
pub(in crate::case) const ACUTE: AllowedRange = from(Inclusive(0.0), Exclusive(FRAC_PI_2));
pub(in crate::case) const BEVEL: AllowedRange = from(Exclusive(0.0), Exclusive(FRAC_PI_2));
pub(in crate::case) const APEX: AllowedRange = from(Exclusive(0.0), Exclusive(PI));
pub(in crate::case) const GROUSERS: AllowedRange =
    AllowedRange { low: Inclusive(1.0), high: Inclusive(360.0), why: "a wheel without grousers is a disc" };
pub(in crate::case) const RELATIVE_DENSITY: AllowedRange = AllowedRange {
    low: Inclusive(sand::RELATIVE_DENSITY[0]),
    high: Inclusive(sand::RELATIVE_DENSITY[1]),
    why: "0 is the loosest and 1 the densest state of the standard tests",
};
pub(in crate::case) const SLIP: AllowedRange =
    AllowedRange { low: Inclusive(-1.0), high: Exclusive(1.0), why: "1 is spinning on the spot" };
pub(in crate::case) const TILT: AllowedRange = AllowedRange {
    low: Inclusive(-FRAC_PI_2),
    high: Inclusive(FRAC_PI_2),
    why: "beyond 90° the axle points back; turn the body by yaw instead",
};
pub(in crate::case) const SLOPE: AllowedRange = AllowedRange {
    low: Inclusive(-FRAC_PI_4),
    high: Inclusive(FRAC_PI_4),
    why: "no sand rests on a steeper one",
};
pub(in crate::case) const VOLUME_STRAIN: AllowedRange =
    AllowedRange { low: Inclusive(-0.3), high: Inclusive(0.5), why: "from the loosest to the densest soils" };
pub(in crate::case) const GROWTH: AllowedRange = from(Inclusive(1.0), Inclusive(1.5));
pub(in crate::case) const ASPECT: AllowedRange =
    AllowedRange { low: Inclusive(1.0), high: Inclusive(4.0), why: "flatter cells have not been tested" };
pub(in crate::case) const SPACING: AllowedRange = from(Inclusive(0.05), Inclusive(4.0));
pub(in crate::case) const ECCENTRICITY: AllowedRange = from(Exclusive(0.5), Inclusive(1.0));
pub(in crate::case) const EXPONENT: AllowedRange = from(Inclusive(0.05), Inclusive(2.5));
pub(in crate::case) const BACKFILL: AllowedRange =
    from(Inclusive(-10.0 * (PI / 180.0)), Inclusive(25.0 * (PI / 180.0)));
pub(in crate::case) const THREADS: AllowedRange = from(Inclusive(0.0), Inclusive(MAX_WORKERS as f64));
pub(in crate::case) const IN_THE_RUN: AllowedRange = AllowedRange {
    low: Inclusive(0.0),
    high: Bound::None,
    why: "a negative time is before the start of the run",
};

impl AllowedRange {
    /// Whether it contains a number; not-a-number is in no range.
    #[must_use]
    pub fn contains(&self, number: f64) -> bool {
        let low = match self.low {
            Bound::None => !number.is_nan(),
            Inclusive(low) => number >= low,
            Exclusive(low) => number > low,
        };
        let high = match self.high {
            Bound::None => !number.is_nan(),
            Inclusive(high) => number <= high,
            Exclusive(high) => number < high,
        };
        low && high
    }

    /// In words; `shown` writes a number with its unit.
    #[must_use]
    pub fn text(&self, shown: impl Fn(f64) -> String) -> String {
        // Zero alone needs no unit.
        let alone = |number: f64| if number == 0.0 { "0".to_owned() } else { shown(number) };
        let text = match (self.low, self.high) {
            (Bound::None, Bound::None) => "any number".to_owned(),
            (Bound::None, Inclusive(high)) => format!("at most {}", alone(high)),
            (Bound::None, Exclusive(high)) => format!("below {}", alone(high)),
            (Inclusive(low), Bound::None) => format!("{} or more", alone(low)),
            (Exclusive(low), Bound::None) => format!("above {}", alone(low)),
            (Inclusive(low), Inclusive(high)) => format!("from {} to {}", shown(low), shown(high)),
            (Inclusive(low), Exclusive(high)) => format!("{} or more and below {}", shown(low), shown(high)),
            (Exclusive(low), Inclusive(high)) => format!("above {} and at most {}", shown(low), shown(high)),
            (Exclusive(low), Exclusive(high)) => format!("above {} and below {}", shown(low), shown(high)),
        };
        if self.why.is_empty() { text } else { format!("{text} ({})", self.why) }
    }
}
