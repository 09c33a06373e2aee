//! Colours: a palette for curves that colour-blind readers can distinguish, and perceptually uniform colour
//! maps.
//!
//! The maps are defined in the OKLab space (B. Ottosson, 2020), in which equal steps look equal: lightness
//! rises evenly along a sequential map and from both ends of a diverging one, so that they can also be
//! printed in grey.

use std::sync::LazyLock;

/// Curve colours after Okabe and Ito (2008), strong ones first.
pub(crate) const CURVES: [&str; 7] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#7a7a7a"];

/// Steps of a colour map from one end to the other: even, so that the middle of a diverging map is a colour
/// of its own, and fine enough that no channel changes by more than one from step to step.
const STEPS: u32 = 8192;

/// A colour: red, green, blue.
pub(crate) type Rgb = [u8; 3];

/// The colour map of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ColourMap {
    /// From dark violet through green to light yellow.
    Sequential,
    /// From blue through almost white, for zero, to red-brown.
    Diverging,
    /// From pale to brown: volume fraction of soil.
    Earth,
    /// From blue to red-brown, but almost black for zero: for dark screens.
    DarkDiverging,
    /// From almost black to a light brown, for dark screens.
    DarkEarth,
}

impl ColourMap {
    const ALL: [Self; 5] =
        [Self::Sequential, Self::Diverging, Self::Earth, Self::DarkDiverging, Self::DarkEarth];

    /// The map for dark screens, on which pale ground would glare.
    pub(crate) fn for_dark(self) -> Self {
        match self {
            Self::Diverging => Self::DarkDiverging,
            Self::Earth => Self::DarkEarth,
            Self::Sequential | Self::DarkDiverging | Self::DarkEarth => self,
        }
    }

    /// The colour at a fraction of the map, 0 to 1.
    pub(crate) fn at(self, fraction: f64) -> Rgb {
        /// Colours of each map; pictures ask for millions.
        static TABLES: LazyLock<[Vec<Rgb>; 5]> = LazyLock::new(|| {
            ColourMap::ALL
                .map(|map| (0..=STEPS).map(|n| map.computed(f64::from(n) / f64::from(STEPS))).collect())
        });
        let s = if fraction.is_finite() { fraction.clamp(0.0, 1.0) } else { 0.0 };
        TABLES[self as usize][(s * f64::from(STEPS)).round() as usize]
    }

    fn computed(self, s: f64) -> Rgb {
        match self {
            Self::Sequential => {
                let hue = 305.0 - 200.0 * s;
                oklch(0.24 + 0.69 * s, 0.115 + 0.045 * (std::f64::consts::PI * s).sin(), hue)
            }
            Self::Diverging => {
                let side = 2.0 * s - 1.0;
                let hue = if side < 0.0 { 250.0 } else { 45.0 };
                oklch(0.955 - 0.53 * side.abs(), 0.15 * side.abs().powf(0.8), hue)
            }
            Self::Earth => oklch(0.975 - 0.40 * s, 0.005 + 0.065 * s, 75.0),
            Self::DarkDiverging => {
                let side = 2.0 * s - 1.0;
                let hue = if side < 0.0 { 250.0 } else { 45.0 };
                oklch(0.28 + 0.46 * side.abs(), 0.13 * side.abs().powf(0.8), hue)
            }
            Self::DarkEarth => oklch(0.22 + 0.48 * s, 0.005 + 0.065 * s, 75.0),
        }
    }
}

/// Colour of lightness 0 to 1, chroma, and hue [deg].
fn oklch(lightness: f64, chroma: f64, hue: f64) -> Rgb {
    let (sin, cos) = hue.to_radians().sin_cos();
    let (a, b) = (chroma * cos, chroma * sin);
    let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
    let linear = [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ];
    linear.map(|c| {
        let c = c.clamp(0.0, 1.0);
        let encoded = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
        (255.0 * encoded).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey([r, g, b]: Rgb) -> f64 {
        0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
    }

    #[test]
    fn sequential_maps_are_monotonic_in_grey() {
        for (map, sign) in
            [(ColourMap::Sequential, 1.0), (ColourMap::Earth, -1.0), (ColourMap::DarkEarth, 1.0)]
        {
            let greys: Vec<f64> = (0..=50).map(|n| sign * grey(map.at(f64::from(n) / 50.0))).collect();
            assert!(greys.windows(2).all(|g| g[1] >= g[0]), "{map:?}");
        }
        assert_eq!(ColourMap::Sequential.at(f64::NAN), ColourMap::Sequential.at(0.0));
    }

    #[test]
    fn the_steps_of_a_map_cannot_be_seen() {
        for map in ColourMap::ALL {
            for n in 0..STEPS {
                let [a, b] = [n, n + 1].map(|n| map.computed(f64::from(n) / f64::from(STEPS)));
                assert!(a.iter().zip(b).all(|(&a, b)| a.abs_diff(b) <= 1), "{map:?} {n} {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn the_diverging_map_is_pale_in_the_middle() {
        let middle = grey(ColourMap::Diverging.at(0.5));
        assert!(middle > 235.0);
        assert!(grey(ColourMap::Diverging.at(0.0)) < 130.0 && grey(ColourMap::Diverging.at(1.0)) < 130.0);
    }
}
