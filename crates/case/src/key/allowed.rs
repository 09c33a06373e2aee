//! Ranges that several keys share, and those that need a reason.

use Bound::{Exclusive, Inclusive};
use input::key::{AllowedRange, Bound, from};
use physics::sand;
use solver::cpu::threads::MAX_WORKERS;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

pub(crate) const POSITIVE: AllowedRange = from(Exclusive(0.0), Bound::None);
pub(crate) const NOT_NEGATIVE: AllowedRange = from(Inclusive(0.0), Bound::None);
pub(crate) const AT_LEAST_ONE: AllowedRange = from(Inclusive(1.0), Bound::None);
pub(crate) const FRACTION: AllowedRange = from(Inclusive(0.0), Inclusive(1.0));
pub(crate) const POSITIVE_FRACTION: AllowedRange = from(Exclusive(0.0), Inclusive(1.0));
pub(crate) const BELOW_HALF: AllowedRange =
    AllowedRange { low: Inclusive(0.0), high: Exclusive(0.5), why: "0.5 would be incompressible" };
pub(crate) const ACUTE: AllowedRange = from(Inclusive(0.0), Exclusive(FRAC_PI_2));
pub(crate) const BEVEL: AllowedRange = from(Exclusive(0.0), Exclusive(FRAC_PI_2));
pub(crate) const APEX: AllowedRange = from(Exclusive(0.0), Exclusive(PI));
pub(crate) const GROUSERS: AllowedRange =
    AllowedRange { low: Inclusive(1.0), high: Inclusive(360.0), why: "a wheel without grousers is a disc" };
pub(crate) const RELATIVE_DENSITY: AllowedRange = AllowedRange {
    low: Inclusive(sand::RELATIVE_DENSITY[0]),
    high: Inclusive(sand::RELATIVE_DENSITY[1]),
    why: "0 is the loosest and 1 the densest state of the standard tests",
};
pub(crate) const SLIP: AllowedRange =
    AllowedRange { low: Inclusive(-1.0), high: Exclusive(1.0), why: "1 is spinning on the spot" };
pub(crate) const TILT: AllowedRange = AllowedRange {
    low: Inclusive(-FRAC_PI_2),
    high: Inclusive(FRAC_PI_2),
    why: "beyond 90° the axle points back; turn the body by yaw instead",
};
pub(crate) const SLOPE: AllowedRange = AllowedRange {
    low: Inclusive(-FRAC_PI_4),
    high: Inclusive(FRAC_PI_4),
    why: "no sand rests on a steeper one",
};
pub(crate) const VOLUME_STRAIN: AllowedRange =
    AllowedRange { low: Inclusive(-0.3), high: Inclusive(0.5), why: "from the loosest to the densest soils" };
pub(crate) const GROWTH: AllowedRange = from(Inclusive(1.0), Inclusive(1.5));
pub(crate) const ASPECT: AllowedRange =
    AllowedRange { low: Inclusive(1.0), high: Inclusive(4.0), why: "flatter cells have not been tested" };
pub(crate) const SPACING: AllowedRange = from(Inclusive(0.05), Inclusive(4.0));
pub(crate) const ECCENTRICITY: AllowedRange = from(Exclusive(0.5), Inclusive(1.0));
pub(crate) const EXPONENT: AllowedRange = from(Inclusive(0.05), Inclusive(2.5));
pub(crate) const BACKFILL: AllowedRange =
    from(Inclusive(-10.0 * (PI / 180.0)), Inclusive(25.0 * (PI / 180.0)));
pub(crate) const THREADS: AllowedRange = from(Inclusive(0.0), Inclusive(MAX_WORKERS as f64));
pub(crate) const IN_THE_RUN: AllowedRange = AllowedRange {
    low: Inclusive(0.0),
    high: Bound::None,
    why: "a negative time is before the start of the run",
};
