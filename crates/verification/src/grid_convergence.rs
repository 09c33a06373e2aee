//! The grid-convergence index of three meshes, of the benchmark that has it.
//!
//! Sources: Roache (1994), Perspective: a method for uniform reporting of grid refinement studies, J. Fluids
//! Eng. 116; Celik et al. (2008), Procedure for estimation and reporting of uncertainty due to discretization
//! in CFD applications, J. Fluids Eng. 130; Stern et al. (2001), J. Fluids Eng. 123; orders of at least ½:
//! Oberkampf and Roy (2010), Verification and validation in scientific computing, section 8.8.

use coulter::confidence::OnMesh;

/// Safety factors where three values converge, and where they do not (Roache 1994, 1998).
const SAFETY: [f64; 2] = [1.25, 3.0];
/// Orders that count as convergence: below the least the extrapolation divides by almost nothing; the
/// differences and the transport of the solver are of second order at best.
const ORDERS: [f64; 2] = [0.5, 2.0];
/// Largest order that is searched for: beyond it the finest two values are equal in all but the last digits.
const MAX_OBSERVED: f64 = 50.0;

/// How far the value on the finest of three meshes, coarse to fine, may be off, in its unit.
pub(crate) fn half_width(three: &[OnMesh; 3]) -> f64 {
    let [coarse, middle, fine] = three;
    let pair = [*middle, *fine];
    let Some(order) = observed_order(three).filter(|p| *p >= ORDERS[0]).map(|p| p.min(ORDERS[1])) else {
        // Where the finest two values agree by accident, the range of the three still says how far off they
        // may be.
        let values = three.map(|mesh| mesh.value);
        let range = values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
            - values.iter().copied().fold(f64::INFINITY, f64::min);
        return (SAFETY[1] * error(&pair, 1.0)).max(0.5 * range);
    };
    // With the observed order both pairs give one error constant; with a limited one the larger counts.
    let on_finest = (fine.width / middle.width).powf(order);
    SAFETY[0] * error(&pair, order).max(error(&[*coarse, *middle], order) * on_finest)
}

/// The value on an infinitely fine mesh, where an order is observed.
pub(crate) fn limit(three: &[OnMesh; 3]) -> Option<f64> {
    let order = observed_order(three).filter(|p| *p >= ORDERS[0])?.min(ORDERS[1]);
    Some(extrapolated(&[three[1], three[2]], order))
}

/// The size of Richardson's correction of the finer value.
fn error([coarse, fine]: &[OnMesh; 2], order: f64) -> f64 {
    (fine.value - coarse.value).abs() / ((coarse.width / fine.width).powf(order) - 1.0)
}

/// Richardson's extrapolation of two values, coarse and fine, to h = 0 for an order of convergence p: f₁ +
/// (f₁ − f₂)/(r^p − 1).
pub(crate) fn extrapolated([coarse, fine]: &[OnMesh; 2], order: f64) -> f64 {
    fine.value + (fine.value - coarse.value) / ((coarse.width / fine.width).powf(order) - 1.0)
}

/// Observed order of convergence p from three meshes, coarse to fine, whose ratios of refinement r need not
/// be equal: the positive solution of (f₂ − f₃)/(f₁ − f₂) = r₂₁^p (r₃₂^p − 1)/(r₂₁^p − 1), index 1 for the
/// finest. `None` where the differences do not shrink with one sign.
///
/// Source: Celik et al. (2008), equation 5.
pub(crate) fn observed_order([coarse, middle, fine]: &[OnMesh; 3]) -> Option<f64> {
    let shrink = (middle.value - coarse.value) / (fine.value - middle.value);
    let (upper, lower) = ((coarse.width / middle.width).ln(), (middle.width / fine.width).ln());
    // Grows with p, from the ratio of the logarithms on.
    let expected = |p: f64| (p * lower).exp() * (p * upper).exp_m1() / (p * lower).exp_m1();
    if !(shrink.is_finite() && shrink > upper / lower && shrink <= expected(MAX_OBSERVED)) {
        return None;
    }
    let (mut low, mut high) = (0.0, MAX_OBSERVED);
    for _ in 0..80 {
        let between = 0.5 * (low + high);
        if expected(between) < shrink { low = between } else { high = between }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on(meshes: [[f64; 2]; 3]) -> [OnMesh; 3] {
        meshes.map(|[width, value]| OnMesh { width, value })
    }

    #[test]
    fn an_error_of_known_order_is_found_and_held() {
        for order in [0.5001, 1.0, 1.37, 2.0] {
            for widths in [[2.25, 1.5, 1.0], [2.1, 1.5, 1.0], [3.0, 1.2, 1.0]] {
                for (zero, constant) in [(14.4, 0.9), (-2.0, -0.3), (0.0, 1e-3)] {
                    let f = |h: f64| zero + constant * h.powf(order);
                    let three = on(widths.map(|h| [h, f(h)]));
                    assert!((observed_order(&three).unwrap() - order).abs() < 1e-6);
                    assert!((limit(&three).unwrap() - zero).abs() < 1e-6);
                    let error = (f(1.0) - zero).abs();
                    assert!((half_width(&three) / error - 1.25).abs() < 1e-6);
                }
            }
        }
    }

    #[test]
    fn values_that_do_not_converge_have_a_wide_interval() {
        let three = on([[2.25, 14.4], [1.5, 12.8], [1.0, 13.5]]);
        assert_eq!((observed_order(&three), limit(&three)), (None, None));
        assert!((half_width(&three) - 3.0 * 0.7 / 0.5).abs() < 1e-12);
        // The finest two agree by accident: half of the range remains.
        assert!((half_width(&on([[2.25, 10.0], [1.5, 12.0], [1.0, 12.0]])) - 1.0).abs() < 1e-12);
        // Differences that grow or hardly shrink.
        for fine in [1.3, 1.1 + 0.099] {
            let half = half_width(&on([[2.25, 1.0], [1.5, 1.1], [1.0, fine]]));
            assert!((half - 6.0 * (fine - 1.1)).abs() < 1e-12);
        }
        // A higher order than the second: the difference of the coarser two, carried to the finest mesh.
        let half = half_width(&on([[2.25, 10.0], [1.5, 12.0], [1.0, 12.1]]));
        assert!((half - 1.25 * 2.0 / 1.25 / 2.25).abs() < 1e-12);
    }
}
