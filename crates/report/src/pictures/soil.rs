//! Soil in a slice with a smooth surface: where the volume fraction, linear between the centres of cells, is
//! ½.
//!
//! In a cell that a body takes up in part, what counts is the fraction of the rest: otherwise a gap would
//! seem to open between soil and body. Colours stay those of the cells, so that noise from cell to cell can
//! be seen.

/// Volume fraction at the surface.
const SURFACE: f64 = 0.5;
/// Points along either side of a cell at which it is looked up how much of it bodies take up.
const SAMPLES: usize = 4;
/// Cells of which bodies take up more than this say nothing of the soil beside them.
const TAKEN: f64 = 0.9;
/// How far values are carried on into cells without one [cells].
const REACH: usize = 2;

/// The soil of a slice.
pub(super) struct SmoothSoil {
    /// Centres of the cells along both axes [m].
    centres: [Vec<f64>; 2],
    edges: [Vec<f64>; 2],
    /// Fractions and values of the cells, those along the first axis fastest.
    fractions: Vec<f64>,
    values: Vec<Option<f64>>,
}

impl SmoothSoil {
    /// The soil from the faces of the cells along both axes [m], fraction and value of a cell, and whether a
    /// body covers a place.
    pub(super) fn new(
        faces: [&[f64]; 2],
        cell: impl Fn(usize, usize) -> (f64, f64),
        is_body: impl Fn(f64, f64) -> bool,
    ) -> Self {
        let [columns, layers] = faces.map(|faces| faces.len() - 1);
        let places = || (0..layers).flat_map(|k| (0..columns).map(move |i| (i, k)));
        let between =
            |axis: usize, n: usize, part: f64| faces[axis][n] + part * (faces[axis][n + 1] - faces[axis][n]);
        let part = |n: usize| (n as f64 + 0.5) / SAMPLES as f64;
        let taken = |i: usize, k: usize| {
            let samples = (0..SAMPLES * SAMPLES).map(|n| [part(n % SAMPLES), part(n / SAMPLES)]);
            let inside = samples.filter(|[a, b]| is_body(between(0, i, *a), between(1, k, *b)));
            inside.count() as f64 / (SAMPLES * SAMPLES) as f64
        };
        let of_rest = |(i, k): (usize, usize)| {
            let taken = taken(i, k);
            (taken <= TAKEN).then(|| (cell(i, k).0 / (1.0 - taken)).min(1.0))
        };
        let known: Vec<Option<f64>> = places().map(of_rest).collect();
        let fractions = carried_on(known, columns).into_iter().map(|f| f.unwrap_or(0.0)).collect();
        let value = |(i, k): (usize, usize)| {
            let (fraction, value) = cell(i, k);
            (fraction > SURFACE && value.is_finite()).then_some(value)
        };
        let values = carried_on(places().map(value).collect(), columns);
        let centres = faces.map(|faces| faces.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect());
        Self { centres, edges: faces.map(<[f64]>::to_vec), fractions, values }
    }

    /// The value of the soil at a place; `None` without soil.
    pub(super) fn at(&self, x: f64, z: f64) -> Option<f64> {
        let columns = self.centres[0].len();
        let cell = |axis: usize, at: f64| {
            let n = self.edges[axis].partition_point(|edge| *edge <= at);
            (n > 0 && n < self.edges[axis].len()).then(|| n - 1)
        };
        let (column, layer) = (cell(0, x)?, cell(1, z)?);
        let ((i, a), (k, b)) = (between(&self.centres[0], x), between(&self.centres[1], z));
        let fraction = |i: usize, k: usize| {
            self.fractions[k.min(self.centres[1].len() - 1) * columns + i.min(columns - 1)]
        };
        let row = |k: usize| (1.0 - a) * fraction(i, k) + a * fraction(i + 1, k);
        let here = (1.0 - b) * row(k) + b * row(k + 1);
        (here >= SURFACE).then(|| self.values[layer * columns + column]).flatten()
    }
}

/// The interval of rising values that holds a value, and where in it the value lies; beyond the ends the end.
fn between(values: &[f64], value: f64) -> (usize, f64) {
    let n = values.partition_point(|v| *v <= value).saturating_sub(1);
    let Some(next) = values.get(n + 1) else { return (n, 0.0) };
    (n, ((value - values[n]) / (next - values[n])).clamp(0.0, 1.0))
}

/// Carries known numbers on into neighbouring cells, as means of theirs.
fn carried_on(mut numbers: Vec<Option<f64>>, columns: usize) -> Vec<Option<f64>> {
    for _ in 0..REACH {
        let before = numbers.clone();
        let layers = before.len() / columns.max(1);
        for n in (0..before.len()).filter(|n| before[*n].is_none()) {
            let (i, k) = (n % columns, n / columns);
            let beside = [
                (i > 0).then(|| n - 1),
                (i + 1 < columns).then(|| n + 1),
                (k > 0).then(|| n - columns),
                (k + 1 < layers).then(|| n + columns),
            ];
            let known: Vec<f64> = beside.into_iter().flatten().filter_map(|m| before[m]).collect();
            if !known.is_empty() {
                numbers[n] = Some(known.iter().sum::<f64>() / known.len() as f64);
            }
        }
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two columns of three unit cells, filled to a height of 1.5.
    fn soil(is_body: impl Fn(f64, f64) -> bool, lost: f64) -> SmoothSoil {
        let faces = [vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 2.0, 3.0]];
        let fraction = move |i: usize, k: usize| [1.0, 0.5, 0.0][k] * if i == 1 { 1.0 - lost } else { 1.0 };
        SmoothSoil::new([&faces[0], &faces[1]], |i, k| (fraction(i, k), k as f64), is_body)
    }

    #[test]
    fn the_surface_lies_at_half_a_fraction() {
        let soil = soil(|_, _| false, 0.0);
        assert_eq!(soil.at(0.7, 1.45), Some(0.0));
        assert_eq!((soil.at(0.7, 1.55), soil.at(-0.1, 0.5), soil.at(0.5, 3.5)), (None, None, None));
    }

    #[test]
    fn a_body_opens_no_gap() {
        let covered = soil(|x, _| x > 1.5, 0.5);
        assert!(covered.at(1.4, 1.4).is_some());
        assert!(soil(|_, _| false, 0.5).at(1.4, 1.4).is_none());
    }
}
