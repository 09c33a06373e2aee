//! The grid-convergence index: how far a figure on the finest mesh may be from that on an infinitely fine
//! one.
//!
//! The equations, their symbols and the reasons for the constants are in `docs/theory/mesh-study.md`.
//! Sources: Roache (1994), Perspective: a method for uniform reporting of grid refinement studies, J. Fluids
//! Eng. 116; Roache (1998), Verification and validation in computational science and engineering; Celik et
//! al. (2008), Procedure for estimation and reporting of uncertainty due to discretization in CFD
//! applications, J. Fluids Eng. 130; Stern et al. (2001), Comprehensive approach to verification and
//! validation of CFD simulations, J. Fluids Eng. 123.

use serde::{Deserialize, Serialize};

/// Safety factor where three values converge monotonically (Roache 1998).
pub const SAFETY_CONVERGING: f64 = 1.25;
/// Safety factor where they do not, or where there are two (Roache 1994).
pub const SAFETY_OTHERWISE: f64 = 3.0;
/// Order that is assumed where none is observed: that of free surfaces and contact, which are placed to a
/// fraction of a cell.
pub const ASSUMED_ORDER: f64 = 1.0;
/// Least observed order that counts as convergence (Oberkampf and Roy 2010, Verification and validation in
/// scientific computing, section 8.8): below it the extrapolation divides by almost nothing.
pub const LEAST_ORDER: f64 = 0.5;
/// Largest order that is used: the differences and the transport of the solver are of second order at best,
/// so that a higher one is an accident.
pub const LARGEST_ORDER: f64 = 2.0;
/// Largest order that is searched for: beyond it the finest two values are equal in all but the last digits.
const MAX_OBSERVED: f64 = 50.0;

/// A figure on one mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnMesh {
    /// Representative cell width h [m].
    pub width: f64,
    /// The figure, in its unit.
    pub value: f64,
}

/// How a figure converges with the mesh, and how far its value on the finest one may be off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Convergence {
    /// Observed order of convergence; `null` with two meshes, and where the differences do not shrink with
    /// one sign.
    pub observed_order: Option<f64>,
    /// Order that the index is calculated with.
    pub order: f64,
    /// Safety factor.
    pub safety_factor: f64,
    /// Whether the finest three values rise, or fall, from mesh to mesh; `null` with two meshes.
    pub is_monotonic: Option<bool>,
    /// Richardson's value for h = 0, in the unit of the figure; `null` where no order is observed.
    pub extrapolated: Option<f64>,
    /// Half-width of the interval due to the mesh, in the unit of the figure: the index times the value.
    pub mesh_half_width: f64,
}

impl Convergence {
    /// The convergence of a figure on meshes from coarse to fine, of which the finest three count; `None`
    /// with fewer than two, with values that are not numbers and with widths that do not fall.
    #[must_use]
    pub fn of(meshes: &[OnMesh]) -> Option<Self> {
        let is_usable = |m: &OnMesh| m.value.is_finite() && m.width.is_finite() && m.width > 0.0;
        let falls = meshes.windows(2).all(|pair| pair[0].width > pair[1].width);
        if !falls || !meshes.iter().all(is_usable) {
            return None;
        }
        if let Some(three) = meshes.last_chunk::<3>() {
            return Some(Self::of_three(three));
        }
        meshes.last_chunk::<2>().map(|two| Self {
            mesh_half_width: SAFETY_OTHERWISE * error(two, ASSUMED_ORDER),
            ..Self::unobserved()
        })
    }

    fn unobserved() -> Self {
        Self { order: ASSUMED_ORDER, safety_factor: SAFETY_OTHERWISE, ..Self::default() }
    }

    fn of_three(three: &[OnMesh; 3]) -> Self {
        let [coarse, middle, fine] = three;
        let (first, last) = (middle.value - coarse.value, fine.value - middle.value);
        let observed_order = observed_order(three);
        let is_monotonic = Some(first * last > 0.0);
        let Some(order) = observed_order.filter(|p| *p >= LEAST_ORDER).map(|p| p.min(LARGEST_ORDER)) else {
            // Where the finest two values agree by accident, the range of the three still says how far off
            // they may be.
            let values = three.map(|m| m.value);
            let range = values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
                - values.iter().copied().fold(f64::INFINITY, f64::min);
            let mesh_half_width =
                (SAFETY_OTHERWISE * error(&[*middle, *fine], ASSUMED_ORDER)).max(0.5 * range);
            return Self { observed_order, is_monotonic, mesh_half_width, ..Self::unobserved() };
        };
        // With the observed order both pairs give one error constant; with a limited one the larger counts.
        let on_finest = (fine.width / middle.width).powf(order);
        let pair = [*middle, *fine];
        let error_fine = error(&pair, order);
        let error_middle = error(&[*coarse, *middle], order) * on_finest;
        Self {
            observed_order,
            order,
            safety_factor: SAFETY_CONVERGING,
            is_monotonic,
            extrapolated: Some(extrapolated(&pair, order)),
            mesh_half_width: SAFETY_CONVERGING * error_fine.max(error_middle),
        }
    }
}

/// Richardson's extrapolation of two values, coarse and fine, to h = 0 for an order of convergence p: f₁ +
/// (f₁ − f₂)/(r^p − 1).
#[must_use]
pub fn extrapolated([coarse, fine]: &[OnMesh; 2], order: f64) -> f64 {
    fine.value + (fine.value - coarse.value) / ((coarse.width / fine.width).powf(order) - 1.0)
}

/// The size of its correction of the finer value.
fn error([coarse, fine]: &[OnMesh; 2], order: f64) -> f64 {
    (fine.value - coarse.value).abs() / ((coarse.width / fine.width).powf(order) - 1.0)
}

/// Observed order of convergence p from three meshes, coarse to fine, whose ratios of refinement r need not
/// be equal: the positive solution of (f₂ − f₃)/(f₁ − f₂) = r₂₁^p (r₃₂^p − 1)/(r₂₁^p − 1), index 1 for the
/// finest. `None` where the differences do not shrink with one sign.
///
/// Source: Celik et al. (2008), equation 5.
#[must_use]
pub fn observed_order([coarse, middle, fine]: &[OnMesh; 3]) -> Option<f64> {
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

    fn on(meshes: &[[f64; 2]]) -> Convergence {
        let meshes: Vec<OnMesh> = meshes.iter().map(|&[width, value]| OnMesh { width, value }).collect();
        Convergence::of(&meshes).unwrap()
    }

    #[test]
    fn an_error_of_known_order_is_found_and_held() {
        for order in [0.5001, 1.0, 1.37, 2.0] {
            for widths in [[2.25, 1.5, 1.0], [2.1, 1.5, 1.0], [3.0, 1.2, 1.0]] {
                for (limit, constant) in [(14.4, 0.9), (-2.0, -0.3), (0.0, 1e-3)] {
                    let f = |h: f64| limit + constant * h.powf(order);
                    let found = on(&widths.map(|h| [h, f(h)]));
                    assert!((found.observed_order.unwrap() - order).abs() < 1e-6, "{order} {found:?}");
                    assert!((found.extrapolated.unwrap() - limit).abs() < 1e-6);
                    assert_eq!((found.safety_factor, found.is_monotonic), (1.25, Some(true)));
                    let error = (f(1.0) - limit).abs();
                    assert!((found.mesh_half_width / error - 1.25).abs() < 1e-6, "{found:?}");
                }
            }
        }
    }

    #[test]
    fn a_fourth_mesh_does_not_count() {
        let f = |h: f64| 3.0 + 0.1 * h;
        assert_eq!(
            on(&[[3.375, 99.0], [2.25, f(2.25)], [1.5, f(1.5)], [1.0, f(1.0)]]),
            on(&[[2.25, f(2.25)], [1.5, f(1.5)], [1.0, f(1.0)]])
        );
    }

    #[test]
    fn oscillating_values_have_no_order_and_a_wide_interval() {
        let found = on(&[[2.25, 14.4], [1.5, 12.8], [1.0, 13.5]]);
        assert_eq!((found.observed_order, found.extrapolated), (None, None));
        assert_eq!((found.is_monotonic, found.safety_factor, found.order), (Some(false), 3.0, 1.0));
        assert!((found.mesh_half_width - 3.0 * 0.7 / 0.5).abs() < 1e-12, "{found:?}");
        // The finest two agree by accident: half of the range remains.
        assert!((on(&[[2.25, 10.0], [1.5, 12.0], [1.0, 12.0]]).mesh_half_width - 1.0).abs() < 1e-12);
    }

    #[test]
    fn differences_that_grow_or_hardly_shrink_are_no_convergence() {
        for fine in [1.3, 1.1 + 0.099] {
            let found = on(&[[2.25, 1.0], [1.5, 1.1], [1.0, fine]]);
            assert_eq!((found.is_monotonic, found.safety_factor), (Some(true), 3.0), "{found:?}");
            assert!((found.mesh_half_width - 6.0 * (fine - 1.1)).abs() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn a_higher_order_than_the_second_is_not_believed() {
        let found = on(&[[2.25, 10.0], [1.5, 12.0], [1.0, 12.1]]);
        assert!(found.observed_order.unwrap() > 7.0 && found.order == 2.0);
        // The difference of the coarser two, carried to the finest mesh with the second order: 2/(1.5² −
        // 1)/1.5².
        assert!((found.mesh_half_width - 1.25 * 2.0 / 1.25 / 2.25).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn equal_values_have_no_error() {
        let found = on(&[[2.25, 7.0], [1.5, 7.0], [1.0, 7.0]]);
        assert_eq!((found.mesh_half_width, found.observed_order), (0.0, None));
        assert_eq!(on(&[[1.5, 0.0], [1.0, 0.0]]).mesh_half_width, 0.0);
    }

    #[test]
    fn a_value_near_zero_has_an_interval_of_its_own_size() {
        let f = |h: f64| 1e-6 * h - 1e-6;
        let found = on(&[[2.25, f(2.25)], [1.5, f(1.5)], [1.0, f(1.0)]]);
        assert_eq!(f(1.0), 0.0);
        assert!((found.mesh_half_width - 1.25e-6).abs() < 1e-12 && found.order > 0.99);
    }

    #[test]
    fn two_meshes_take_the_assumed_order() {
        let found = on(&[[1.5, 11.0], [1.0, 10.0]]);
        assert_eq!((found.observed_order, found.is_monotonic, found.extrapolated), (None, None, None));
        assert!((found.mesh_half_width - 6.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_mesh_study_has_no_index() {
        let none = |meshes: &[[f64; 2]]| {
            let meshes: Vec<OnMesh> = meshes.iter().map(|&[width, value]| OnMesh { width, value }).collect();
            assert_eq!(Convergence::of(&meshes), None);
        };
        none(&[]);
        none(&[[1.0, 1.0]]);
        none(&[[1.0, 1.0], [1.5, 1.0]]);
        none(&[[1.0, 1.0], [1.0, 1.0]]);
        none(&[[1.5, f64::NAN], [1.0, 1.0]]);
        none(&[[1.5, 1.0], [0.0, 1.0]]);
    }
}
