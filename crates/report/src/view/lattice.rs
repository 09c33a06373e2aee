//! The places at which heights are shown, the same at all times.

use super::surface::SurfaceAtTime;

/// Change of height, over the largest of all, from which on a place belongs to what is shown.
const NOTICEABLE: f64 = 0.02;
/// Ground that is shown around it, over its extent.
const MARGIN: f64 = 0.25;

/// Places along x and y [m], at most so many: where the surface changes or bodies are, and some ground
/// around.
pub(super) fn lattice(surfaces: &[SurfaceAtTime], bodies: [[f64; 2]; 2], most: usize) -> [Vec<f64>; 2] {
    let axes = [0, 1].map(|axis| places(surfaces, axis));
    let shown = shown(surfaces, &axes, bodies);
    let mut cropped = [0, 1].map(|axis| cropped(&axes[axis], shown[axis]));
    while cropped[0].len() * cropped[1].len() > most {
        let longer = usize::from(cropped[1].len() > cropped[0].len());
        cropped[longer] = thinned(&cropped[longer]);
    }
    cropped
}

/// The columns of a grid that stays; of one that travels places as close as its closest columns.
fn places(surfaces: &[SurfaceAtTime], axis: usize) -> Vec<f64> {
    let all = || surfaces.iter().map(|surface| &surface.axes[axis]);
    let Some(first) = all().next() else { return Vec::new() };
    if all().all(|places| places == first) {
        return first.clone();
    }
    let low = all().map(|places| places[0]).fold(f64::INFINITY, f64::min);
    let high = all().map(|places| places[places.len() - 1]).fold(f64::NEG_INFINITY, f64::max);
    let spacing = all().flat_map(|places| places.windows(2)).map(|pair| pair[1] - pair[0]);
    let spacing = spacing.fold(f64::INFINITY, f64::min).max((high - low) / 2000.0);
    let count = ((high - low) / spacing).ceil() as usize;
    (0..=count).map(|n| low + (high - low) * n as f64 / count as f64).collect()
}

/// The range along x and y that is worth showing [m].
fn shown(surfaces: &[SurfaceAtTime], axes: &[Vec<f64>; 2], bodies: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let change = |place: [f64; 2]| {
        let first = surfaces.first().map_or(f64::NAN, |surface| surface.at(place));
        let level = |surface: &SurfaceAtTime| if first.is_nan() { surface.level } else { first };
        surfaces.iter().map(|s| (s.at(place) - level(s)).abs()).fold(0.0, f64::max)
    };
    let places = || axes[1].iter().flat_map(|y| axes[0].iter().map(move |x| [*x, *y]));
    let changes: Vec<([f64; 2], f64)> = places().map(|place| (place, change(place))).collect();
    let most = changes.iter().map(|(_, change)| *change).fold(0.0, f64::max);
    let mut range = bodies;
    for (place, _) in changes.iter().filter(|(_, change)| most > 0.0 && *change > NOTICEABLE * most) {
        for axis in 0..2 {
            range[axis] = [range[axis][0].min(place[axis]), range[axis][1].max(place[axis])];
        }
    }
    if range.iter().any(|[low, high]| low >= high) {
        return [[f64::NEG_INFINITY, f64::INFINITY]; 2];
    }
    let margin = MARGIN * range.iter().map(|[low, high]| high - low).fold(f64::INFINITY, f64::min);
    range.map(|[low, high]| [low - margin, high + margin])
}

/// The places within a range, two at least.
fn cropped(places: &[f64], [low, high]: [f64; 2]) -> Vec<f64> {
    let from = places.partition_point(|place| *place < low).saturating_sub(1);
    let to = (places.partition_point(|place| *place <= high) + 1).min(places.len());
    let inside = &places[from.min(to)..to];
    if inside.len() < 2 { places.to_vec() } else { inside.to_vec() }
}

/// Every other place, and the last.
fn thinned(places: &[f64]) -> Vec<f64> {
    let mut few: Vec<f64> = places.iter().step_by(2).copied().collect();
    if places.len().is_multiple_of(2) {
        few.extend(places.last());
    }
    few
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(low: f64, count: usize) -> SurfaceAtTime {
        let x: Vec<f64> = (0..count).map(|n| low + n as f64).collect();
        SurfaceAtTime { heights: vec![0.0; 2 * count], axes: [x, vec![0.0, 1.0]], level: 0.0 }
    }

    #[test]
    fn the_ground_of_a_grid_that_travels_is_covered() {
        let whole = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let [x, y] = lattice(&[ramp(0.0, 10), ramp(4.5, 10)], whole, 100);
        assert_eq!((x[0], x[x.len() - 1], y.len()), (0.0, 13.5, 2));
        assert_eq!(lattice(&[ramp(0.0, 10)], whole, 100)[0].len(), 10);
    }

    #[test]
    fn far_ground_and_too_many_places_are_left_out() {
        let mut moved = ramp(0.0, 100_000);
        moved.heights[500..40_000].fill(-1.0);
        let [x, _] = lattice(&[ramp(0.0, 100_000), moved], [[600.0, 700.0], [0.2, 0.8]], 12_000);
        assert!(x.len() <= 6_001 && x[0] > 490.0 && x[x.len() - 1] < 40_010.0, "{}", x.len());
    }
}
