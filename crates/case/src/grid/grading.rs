//! Faces of the cells along one axis: uniform in the fine zone, growing geometrically outside it.

/// What the faces along one axis must satisfy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisGrading {
    /// Ends of the box [m].
    pub(crate) ends: [f64; 2],
    /// Ends of the fine zone [m]; it is extended to whole cells, and shortened where the box is too close.
    pub(crate) fine: [f64; 2],
    /// Required position of a face [m].
    pub(crate) anchor: f64,
    /// Cell width in the fine zone [m].
    pub(crate) cell: f64,
    /// Largest ratio of neighbouring widths.
    pub(crate) growth: f64,
}

/// Fraction of a cell below which two positions coincide.
const COINCIDE: f64 = 1e-6;
/// Largest number of cells along one axis.
const MAX_CELLS: f64 = 1e5;
/// Fine cells that may be given up to a graded zone before the growth is reported as too small.
const MAX_GIVEN_UP: u32 = 100;

/// The faces [m], and where the fine zone begins and ends among them [m].
pub(crate) fn faces(axis: &AxisGrading) -> Result<(Vec<f64>, [f64; 2]), String> {
    let AxisGrading { ends: [low, high], fine, anchor, cell, growth } = *axis;
    let across = (high - low) / cell;
    if across > MAX_CELLS || !across.is_finite() {
        return Err(format!("{across:.3e} cells along one axis are too many to run"));
    }
    let layer = |x: f64| (x - anchor) / cell;
    let mut first = (layer(fine[0]) + COINCIDE).floor().max((layer(low) - COINCIDE).ceil());
    let mut last = (layer(fine[1]) - COINCIDE).ceil().min((layer(high) + COINCIDE).floor());
    let face = |n: f64| anchor + n * cell;
    let has_cells = |first: f64, last: f64| {
        if first < last { Ok(()) } else { Err("no whole cell of the fine zone fits into the box".to_owned()) }
    };
    has_cells(first, last)?;
    let before = graded(|n| face(first + n) - low, cell, growth)?;
    first += before.given_up;
    let after = graded(|n| high - face(last - n), cell, growth)?;
    last -= after.given_up;
    has_cells(first, last)?;
    let mut faces: Vec<f64> = before.faces.iter().rev().map(|x| face(first) - x).collect();
    let count = (last - first).round() as usize;
    faces.extend((0..=count).map(|n| face(first + n as f64)));
    faces.extend(after.faces.iter().map(|x| face(last) + x));
    // Rounding must not leave a sliver between the last face and the box.
    if let Some(end) = faces.first_mut() {
        *end = low;
    }
    if let Some(end) = faces.last_mut() {
        *end = high;
    }
    Ok((faces, [face(first).max(low), face(last).min(high)]))
}

/// The faces on one side of the fine zone.
struct Graded {
    /// Fine cells that had to be given up.
    given_up: f64,
    /// Distances from the fine zone [m].
    faces: Vec<f64>,
}

/// Fills the rest of the box. Where no graded cells can fill it, cells of the fine zone are given up, one
/// after the other; `length` is the length to fill as a function of their number [m].
fn graded(length: impl Fn(f64) -> f64, cell: f64, growth: f64) -> Result<Graded, String> {
    for given_up in 0..MAX_GIVEN_UP {
        let given_up = f64::from(given_up);
        if let Some(faces) = outside(length(given_up), cell, growth) {
            return Ok(Graded { given_up, faces });
        }
    }
    Err(format!(
        "the box is not a whole number of cells, and cells that grow by {growth} cannot fill the difference"
    ))
}

/// Distances of the faces beyond a fine zone that ends `length` before the box; `None` if no growth ratio
/// from 1 to `growth` fills it with whole cells.
fn outside(length: f64, cell: f64, growth: f64) -> Option<Vec<f64>> {
    let length = length / cell;
    if length < COINCIDE {
        return Some(Vec::new());
    }
    let sum =
        |ratio: f64, count: usize| (0..count).fold((0.0, 1.0), |(s, w), _| (s + w * ratio, w * ratio)).0;
    let (mut count, mut reach, mut width) = (1, growth, growth);
    while reach < length * (1.0 - COINCIDE) {
        count += 1;
        width *= growth;
        reach += width;
    }
    if count as f64 > length * (1.0 + COINCIDE) {
        return None;
    }
    let (mut low, mut high) = (1.0, growth);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if sum(middle, count) < length { low = middle } else { high = middle }
    }
    let (mut position, mut width) = (0.0, cell);
    let next_face = |_| {
        width *= high;
        position += width;
        position
    };
    Some((0..count).map(next_face).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn axis(ends: [f64; 2], fine: [f64; 2], growth: f64) -> AxisGrading {
        AxisGrading { ends, fine, anchor: 0.0, cell: 0.1, growth }
    }

    #[test]
    fn uniform_box_is_uniform() {
        let (faces, _) = faces(&axis([-1.0, 0.5], [-1.0, 0.5], 1.0)).unwrap();
        assert_eq!(faces.len(), 16);
        assert!(faces.contains(&0.0));
    }

    #[test]
    fn a_remainder_without_growth_is_refused() {
        assert!(faces(&axis([-1.0, 0.55], [-1.0, 0.5], 1.0)).is_err());
        assert!(faces(&axis([0.0, 0.05], [0.0, 0.05], 1.2)).is_err());
        assert!(faces(&axis([0.0, 1e9], [0.0, 1.0], 1.2)).is_err());
        assert!(faces(&axis([0.0, f64::NAN], [0.0, 1.0], 1.2)).is_err());
    }

    proptest! {
        #[test]
        fn fills_the_box_smoothly(
            low in -3.0f64..-0.5, high in 0.5f64..3.0, a in 0.0f64..1.0, b in 0.0f64..1.0, growth in 1.05f64..1.5,
        ) {
            if let Ok((faces, fine)) = faces(&axis([low, high], [a * low, b * high], growth)) {
                prop_assert_eq!((faces[0], faces[faces.len() - 1]), (low, high));
                let widths: Vec<f64> = faces.windows(2).map(|w| w[1] - w[0]).collect();
                prop_assert!(widths.iter().all(|w| *w > 0.1 * (1.0 - 1e-5)));
                for pair in widths.windows(2) {
                    let ratio = (pair[1] / pair[0]).max(pair[0] / pair[1]);
                    prop_assert!(ratio <= growth * (1.0 + 1e-4), "{:?}", widths);
                }
                prop_assert!(faces.contains(&0.0) || fine[0] > 0.0 || fine[1] < 0.0);
            }
        }
    }
}
