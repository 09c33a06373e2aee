//! Roots and minima of functions of one variable.

/// A root of `f` between `a` and `b`, where its signs differ, by the Anderson–Björck variant of false
/// position with bisection as a safeguard, within `tolerance`, in the unit of `a` and `b`. `None` if the
/// signs do not differ or `f` is not a number there.
///
/// Source: Anderson & Björck (1973), BIT 13, 253–264.
pub fn root(mut a: f64, mut b: f64, tolerance: f64, mut f: impl FnMut(f64) -> f64) -> Option<f64> {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return Some(a);
    }
    if fb == 0.0 {
        return Some(b);
    }
    if fa.is_nan() || fb.is_nan() || fa.signum() == fb.signum() {
        return None;
    }
    let mut best = if fa.abs() < fb.abs() { (a, fa.abs()) } else { (b, fb.abs()) };
    for step in 0..200 {
        // Every fourth step bisects, so that the bracket shrinks for any `f`.
        let secant = (fa * b - fb * a) / (fa - fb);
        let bisect = step % 4 == 3 || !secant.is_finite();
        let c = if bisect { 0.5 * (a + b) } else { secant };
        // When two secant steps are this close, the last is far closer to the root than the tolerance.
        if !bisect && (c - b).abs() <= tolerance {
            return Some(c);
        }
        let fc = f(c);
        if fc == 0.0 {
            return Some(c);
        }
        if fc.is_nan() {
            return None;
        }
        if fc.abs() < best.1 {
            best = (c, fc.abs());
        }
        if (b - a).abs() <= 1e-3 * tolerance {
            break;
        }
        if fc * fb < 0.0 {
            (a, fa) = (b, fb);
        } else {
            let shrink = 1.0 - fc / fb;
            fa *= if shrink > 0.0 { shrink } else { 0.5 };
        }
        (b, fb) = (c, fc);
    }
    Some(best.0)
}

/// Position and value of the minimum of a unimodal `f` on `[a, b]`, by golden-section search: each of the
/// `steps` makes the interval 0.618 times as long. Source: Kiefer (1953), Proc. AMS 4.
pub fn minimum(mut a: f64, mut b: f64, steps: usize, f: impl Fn(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut fc, mut fd) = (f(c), f(d));
    for _ in 0..steps {
        if fc < fd {
            (b, d, fd) = (d, c, fc);
            c = b - GOLDEN * (b - a);
            fc = f(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + GOLDEN * (b - a);
            fd = f(d);
        }
    }
    if fc < fd { (c, fc) } else { (d, fd) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_found_where_there_is_one() {
        let found = root(0.0, 2.0, 1e-13, |x| x * x - 2.0).unwrap();
        assert!((found - 2.0_f64.sqrt()).abs() < 1e-12);
        assert!(root(0.0, 1.0, 1e-12, |x| x + 1.0).is_none());
    }

    #[test]
    fn a_minimum_is_found() {
        assert!((minimum(0.0, 3.0, 60, |x| (x - 1.3).powi(2)).0 - 1.3).abs() < 1e-7);
    }
}
