//! Faces of the cells along one axis: uniform in the fine zone, growing geometrically outside it.

/// What the faces along one axis must do.
#[derive(Clone, Copy, Debug)]
pub(in crate::case) struct Axis {
    /// Ends of the box [m].
    pub(in crate::case) ends: [f64; 2],
    /// Ends of the fine zone [m]; it is widened to whole cells, and narrowed where the box is too near.
    pub(in crate::case) fine: [f64; 2],
    /// Where there should be a face [m].
    pub(in crate::case) anchor: f64,
    /// Cell width in the fine zone [m].
    pub(in crate::case) cell: f64,
    /// Largest ratio of neighbouring widths.
    pub(in crate::case) growth: f64,
}

/// Share of a cell below which two positions are the same.
const SAME: f64 = 1e-6;
/// More cells along one axis than any machine could hold.
const MOST_CELLS: f64 = 1e5;
/// Fine cells that a remainder may take in before the growth is called too small.
const MOST_TAKEN: u32 = 100;

/// The faces [m], and where the fine zone begins and ends among them [m].
pub(in crate::case) fn faces(axis: &Axis) -> Result<(Vec<f64>, [f64; 2]), String> {
    let Axis { ends: [low, high], fine, anchor, cell, growth } = *axis;
    let across = (high - low) / cell;
    if across > MOST_CELLS || !across.is_finite() {
        return Err(format!("{across:.3e} cells along one axis cannot be run"));
    }
    let layer = |x: f64| (x - anchor) / cell;
    let mut first = (layer(fine[0]) + SAME).floor().max((layer(low) - SAME).ceil());
    let mut last = (layer(fine[1]) - SAME).ceil().min((layer(high) + SAME).floor());
    let face = |n: f64| anchor + n * cell;
    let room = |first: f64, last: f64| {
        if first < last { Ok(()) } else { Err("no whole cell of the fine zone fits into the box".to_owned()) }
    };
    room(first, last)?;
    let before = graded(|n| face(first + n) - low, cell, growth)?;
    first += before.taken;
    let after = graded(|n| high - face(last - n), cell, growth)?;
    last -= after.taken;
    room(first, last)?;
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
    /// Fine cells that had to be taken in.
    taken: f64,
    /// Distances from the fine zone [m].
    faces: Vec<f64>,
}

/// Fills what is left of the box. A remainder that no growing cells can fill takes in cells of the fine zone, one
/// after the other; `length` says how long it is with so many of them [m].
fn graded(length: impl Fn(f64) -> f64, cell: f64, growth: f64) -> Result<Graded, String> {
    for taken in 0..MOST_TAKEN {
        let taken = f64::from(taken);
        if let Some(faces) = outside(length(taken), cell, growth) {
            return Ok(Graded { taken, faces });
        }
    }
    Err(format!("the box is no whole number of cells, and cells that grow by {growth} cannot make up for it"))
}

/// Distances of the faces beyond a fine zone that ends `length` before the box; `None` if no ratio from 1 to
/// `growth` makes whole cells fill it.
fn outside(length: f64, cell: f64, growth: f64) -> Option<Vec<f64>> {
    let length = length / cell;
    if length < SAME {
        return Some(Vec::new());
    }
    let sum =
        |ratio: f64, count: usize| (0..count).fold((0.0, 1.0), |(s, w), _| (s + w * ratio, w * ratio)).0;
    let (mut count, mut reach, mut width) = (1, growth, growth);
    while reach < length * (1.0 - SAME) {
        count += 1;
        width *= growth;
        reach += width;
    }
    if count as f64 > length * (1.0 + SAME) {
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

    fn axis(ends: [f64; 2], fine: [f64; 2], growth: f64) -> Axis {
        Axis { ends, fine, anchor: 0.0, cell: 0.1, growth }
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
