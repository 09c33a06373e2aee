//! Pore pressure around a blade that cuts saturated sand: steady flow of water to the shear plane, by
//! boundary elements.
//!
//! Two regions meet at the shear plane A–B: the undisturbed ground and the cut layer, which slides up along
//! the blade A–C. Lengths are over the thickness of the layer h_i, the tip of the blade is the origin, the
//! blade moves along x.

use crate::error::{ModelResult, undefined, within};
use numerics::elimination::solve_linear;
use std::f64::consts::{FRAC_PI_2, PI};

/// Elements along the shear plane, the blade and the upper face of the layer (chosen: four times as many
/// change p₁ₘ by up to 0.5 %, p₂ₘ by up to 1.2 %, before a blade ten times as high as the layer 1.8 %).
const ELEMENTS: usize = 24;
/// Elements along the shorter faces.
const FEW: usize = 12;
/// Elements of the closed cut surface behind the tip.
const AT_TIP: usize = 8;
/// First element of a surface that extends to infinity, growth of the following ones, and where they end
/// (chosen).
const FIRST: f64 = 0.02;
const GROWTH: f64 = 1.25;
const FAR: f64 = 300.0;
/// Length of the layer beyond the top of the blade, both of its faces open to the water (chosen: one twice as
/// long has at most 1 % more suction on the blade).
const BEYOND: f64 = 3.0;

/// A blade, its shear plane, and what is permeable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seepage {
    /// Blade angle α to the horizontal behind the tip [rad].
    pub blade_angle: f64,
    /// Shear angle β [rad].
    pub shear_angle: f64,
    /// Height of the blade over the thickness of the layer h_b/h_i.
    pub height_ratio: f64,
    /// Permeability of the undisturbed sand over that of the cut layer k_i/k_max.
    pub permeability_ratio: f64,
    /// Length of the cut surface behind the tip through which no water flows, over h_i: a worn tip; 0 for a
    /// sharp one.
    pub closed_tip: f64,
}

/// Mean suction over ρ_w g v ε h_i/k_max, Miedema's p₁ₘ and p₂ₘ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanSuction {
    /// Mean suction on the shear plane.
    pub shear_plane: f64,
    /// Mean suction on the blade.
    pub blade: f64,
}

/// What is known on an element.
#[derive(Clone, Copy, PartialEq)]
enum Face {
    /// Open to the water: no suction.
    Open,
    /// No flow.
    Closed,
    /// Element of the shear plane of this number, counted from the tip.
    Shear(usize),
}

type Point = [f64; 2];

/// A boundary element of constant suction and flow, its region on the left.
#[derive(Clone, Copy)]
struct Element {
    from: Point,
    to: Point,
    face: Face,
}

impl Seepage {
    /// The mean suction on shear plane and blade.
    ///
    /// Laplace's equation in both regions; at the shear plane one suction, and k_i ∂p/∂n + k_max ∂p/∂n = ρ_w
    /// g ε v sin β, what flows to it from both sides. Open: the uncut surface, the cut one behind the tip,
    /// both faces of the layer where there is no blade. Source: Miedema (1987, 2019), The Delft Sand, Clay &
    /// Rock Cutting Model, ch. 6 and 12.3; the method is this project's.
    ///
    /// # Errors
    /// Unless 5° ≤ α ≤ 90°, 0 < β, α + β < 175°, 1 ≤ h_b/h_i ≤ 10 and both other ratios are in range.
    pub fn mean_suction(&self) -> ModelResult<MeanSuction> {
        let rounding = 5_f64.to_radians();
        within("blade angle [rad]", self.blade_angle, rounding, FRAC_PI_2)?;
        within("shear angle [rad]", self.shear_angle, 1e-3, PI - rounding - self.blade_angle)?;
        within("height of the blade over the thickness of the layer", self.height_ratio, 1.0, 10.0)?;
        within("ratio of the permeabilities", self.permeability_ratio, 1e-3, 1e3)?;
        within("closed length behind the tip", self.closed_tip, 0.0, 1.0)?;
        let regions = [self.ground(), self.layer()];
        let (rows, right) = self.equations(&regions);
        let Some(found) = solve_linear(rows, right) else {
            return undefined("the flow of water", "its equations are singular");
        };
        // Of region 1 the suction on the shear plane, of region 2 that on the blade.
        let columns = columns(&regions);
        let mean = |region: usize, wanted: fn(Face) -> bool| {
            let of = regions[region].iter().zip(&columns[region]).filter(|(element, _)| wanted(element.face));
            let (sum, length) = of.fold((0.0, 0.0), |(sum, length), (element, column)| {
                let own = element.length();
                (sum + own * found[*column], length + own)
            });
            sum / length
        };
        Ok(MeanSuction {
            shear_plane: mean(0, |face| matches!(face, Face::Shear(_))),
            blade: mean(1, |face| face == Face::Closed),
        })
    }

    /// The upper end of the shear plane.
    fn crest(&self) -> Point {
        [1.0 / self.shear_angle.tan(), 1.0]
    }

    /// Boundary of the undisturbed ground: its surface, the shear plane downwards, the cut surface.
    fn ground(&self) -> Vec<Element> {
        let (tip, crest, worn) = ([0.0; 2], self.crest(), [-self.closed_tip, 0.0]);
        let mut all: Vec<Element> = outwards(crest, 1.0)
            .into_iter()
            .rev()
            .map(|[near, far]| Element { from: far, to: near, face: Face::Open })
            .collect();
        all.extend(numbered(crest, tip, |n| ELEMENTS - 1 - n));
        if self.closed_tip > 0.0 {
            all.extend(line(tip, worn, AT_TIP, Face::Closed));
        }
        all.extend(outwards(worn, -1.0).into_iter().map(|[near, far]| Element {
            from: near,
            to: far,
            face: Face::Open,
        }));
        all
    }

    /// Boundary of the cut layer: the shear plane upwards, its upper face, its end, its lower face beyond the
    /// blade, the blade.
    fn layer(&self) -> Vec<Element> {
        let (sin, cos) = self.blade_angle.sin_cos();
        let along = |from: Point, length: f64| [from[0] - length * cos, from[1] + length * sin];
        let (tip, crest, blade) = ([0.0; 2], self.crest(), self.height_ratio / sin);
        let (top, end) = (along(tip, blade), along(tip, blade + BEYOND));
        let upper_end = along(crest, blade + BEYOND);
        let mut all = numbered(tip, crest, |n| n);
        all.extend(line(crest, upper_end, ELEMENTS, Face::Open));
        all.extend(line(upper_end, end, FEW, Face::Open));
        all.extend(line(end, top, FEW, Face::Open));
        all.extend(line(top, tip, ELEMENTS, Face::Closed));
        all
    }

    /// The equations ½ p + Σ H p = Σ G q of all elements, for the unknowns of [`columns`].
    fn equations(&self, regions: &[Vec<Element>; 2]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let columns = columns(regions);
        let unknowns = regions[0].len() + regions[1].len();
        let sink = self.shear_angle.sin();
        let (mut rows, mut right) = (Vec::with_capacity(unknowns), Vec::with_capacity(unknowns));
        for (region, elements) in regions.iter().enumerate() {
            // Logarithms of lengths over one longer than the region: its equations are not singular then.
            let size = 10.0 * (1.0 + BEYOND + self.height_ratio) / self.blade_angle.sin();
            for (n, at) in elements.iter().enumerate() {
                let (mut row, mut known) = (vec![0.0; unknowns], 0.0);
                for (m, element) in elements.iter().enumerate() {
                    let (g, h) = element.influence(at.middle(), size);
                    let h = if n == m { 0.5 } else { h };
                    match element.face {
                        Face::Open => row[columns[region][m]] -= g,
                        Face::Closed => row[columns[region][m]] += h,
                        Face::Shear(number) => {
                            row[columns[region][m]] += h;
                            let flow = regions[0].len() + number;
                            if region == 0 {
                                row[flow] -= g;
                            } else {
                                // What does not come from the ground comes through the layer.
                                row[flow] += self.permeability_ratio * g;
                                known += sink * g;
                            }
                        }
                    }
                }
                rows.push(row);
                right.push(known);
            }
        }
        (rows, right)
    }
}

/// The column of the unknown of every element: first those of the ground, the suction of the shear plane
/// among them; then the flow from the ground to the shear plane; then those of the layer.
fn columns(regions: &[Vec<Element>; 2]) -> [Vec<usize>; 2] {
    let ground: Vec<usize> = (0..regions[0].len()).collect();
    let shear = |number: usize| {
        regions[0].iter().position(|element| element.face == Face::Shear(number)).unwrap_or_default()
    };
    let mut next = regions[0].len() + ELEMENTS;
    let layer = regions[1].iter().map(|element| match element.face {
        Face::Shear(number) => shear(number),
        _ => {
            next += 1;
            next - 1
        }
    });
    let layer = layer.collect();
    [ground, layer]
}

impl Element {
    fn length(&self) -> f64 {
        (self.to[0] - self.from[0]).hypot(self.to[1] - self.from[1])
    }

    fn middle(&self) -> Point {
        [0.5 * (self.from[0] + self.to[0]), 0.5 * (self.from[1] + self.to[1])]
    }

    /// Integrals over the element of the fundamental solution −ln(r/R)/2π of a source at a point, and of its
    /// derivative along the outward normal.
    fn influence(&self, at: Point, size: f64) -> (f64, f64) {
        let (length, middle) = (self.length(), self.middle());
        let tangent = [(self.to[0] - self.from[0]) / length, (self.to[1] - self.from[1]) / length];
        let from_middle = [at[0] - middle[0], at[1] - middle[1]];
        let along = from_middle[0] * tangent[0] + from_middle[1] * tangent[1];
        let across = from_middle[0] * tangent[1] - from_middle[1] * tangent[0];
        let (a, b) = (along - 0.5 * length, along + 0.5 * length);
        let logarithm = |x: f64| if x == 0.0 { 0.0 } else { x * (x.hypot(across) / size).ln() };
        let angle = b.atan2(across.abs()) - a.atan2(across.abs());
        let g = -(logarithm(b) - logarithm(a) - length + across.abs() * angle) / (2.0 * PI);
        (g, across.signum() * angle / (2.0 * PI))
    }
}

/// Elements from one point to another, shorter towards both ends.
fn line(from: Point, to: Point, count: usize, face: Face) -> Vec<Element> {
    let at = |n: usize| {
        let fraction = 0.5 * (1.0 - (PI * n as f64 / count as f64).cos());
        [from[0] + fraction * (to[0] - from[0]), from[1] + fraction * (to[1] - from[1])]
    };
    (0..count).map(|n| Element { from: at(n), to: at(n + 1), face }).collect()
}

/// The elements of the shear plane, with their numbers.
fn numbered(from: Point, to: Point, number: impl Fn(usize) -> usize) -> Vec<Element> {
    let mut all = line(from, to, ELEMENTS, Face::Open);
    for (n, element) in all.iter_mut().enumerate() {
        element.face = Face::Shear(number(n));
    }
    all
}

/// Ends of the elements of a level surface from a point to infinity, in the direction of ±x; the near end
/// first.
fn outwards(from: Point, sign: f64) -> Vec<[Point; 2]> {
    let (mut all, mut reached, mut length) = (Vec::new(), 0.0, FIRST);
    while reached < FAR {
        let ends = [reached, reached + length].map(|distance| [from[0] + sign * distance, from[1]]);
        all.push(ends);
        reached += length;
        length *= GROWTH;
    }
    all
}
