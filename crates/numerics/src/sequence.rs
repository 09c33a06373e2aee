//! Sobol sequence.

/// Largest number of dimensions of a [`Sequence`].
pub const DIMENSIONS: usize = 20;

/// Degree and coefficients of the primitive polynomial, and the initial direction numbers, from the second
/// dimension on.
///
/// Source: Joe & Kuo (2008), file new-joe-kuo-6 (compared with public copies of that file, all nineteen
/// rows).
const DIRECTIONS: [(usize, u32, [u32; 7]); DIMENSIONS - 1] = [
    (1, 0, [1, 0, 0, 0, 0, 0, 0]),
    (2, 1, [1, 3, 0, 0, 0, 0, 0]),
    (3, 1, [1, 3, 1, 0, 0, 0, 0]),
    (3, 2, [1, 1, 1, 0, 0, 0, 0]),
    (4, 1, [1, 1, 3, 3, 0, 0, 0]),
    (4, 4, [1, 3, 5, 13, 0, 0, 0]),
    (5, 2, [1, 1, 5, 5, 17, 0, 0]),
    (5, 4, [1, 1, 5, 5, 5, 0, 0]),
    (5, 7, [1, 1, 7, 11, 19, 0, 0]),
    (5, 11, [1, 1, 5, 1, 1, 0, 0]),
    (5, 13, [1, 1, 1, 3, 11, 0, 0]),
    (5, 14, [1, 3, 5, 5, 31, 0, 0]),
    (6, 1, [1, 3, 3, 9, 7, 49, 0]),
    (6, 13, [1, 1, 1, 15, 21, 21, 0]),
    (6, 16, [1, 3, 1, 13, 27, 49, 0]),
    (6, 19, [1, 1, 1, 15, 7, 5, 0]),
    (6, 22, [1, 3, 1, 15, 13, 25, 0]),
    (6, 25, [1, 1, 5, 5, 19, 61, 0]),
    (7, 1, [1, 3, 7, 11, 23, 15, 103]),
];

/// A low-discrepancy sequence in up to twenty dimensions, with a random digital shift; no point lies on the
/// boundary.
///
/// Source: Sobol (1967) in Gray-code order (Antonov & Saleev 1979); direction numbers of Joe & Kuo (2008).
#[derive(Clone, Debug)]
pub struct Sequence {
    directions: Vec<[u32; 32]>,
    state: Vec<u32>,
    shift: Vec<u32>,
    count: u32,
}

impl Sequence {
    /// A sequence in `dimensions` dimensions (at most twenty, more are ignored), its shift drawn from `seed`.
    #[must_use]
    pub fn new(dimensions: usize, seed: u64) -> Self {
        let dimensions = dimensions.min(DIMENSIONS);
        let mut random = seed;
        let shift = (0..dimensions).map(|_| (split_mix(&mut random) >> 32) as u32).collect();
        Self {
            directions: (0..dimensions).map(directions).collect(),
            state: vec![0; dimensions],
            shift,
            count: 0,
        }
    }

    /// The next point of the unit cube, every coordinate strictly between 0 and 1.
    pub fn next_point(&mut self, point: &mut [f64]) {
        for ((x, state), shift) in point.iter_mut().zip(&self.state).zip(&self.shift) {
            *x = (f64::from(state ^ shift) + 0.5) / 4_294_967_296.0;
        }
        let bit = self.count.trailing_ones().min(31) as usize;
        for (state, directions) in self.state.iter_mut().zip(&self.directions) {
            *state ^= directions[bit];
        }
        self.count = self.count.wrapping_add(1);
    }
}

/// The 32 direction numbers of a dimension.
fn directions(dimension: usize) -> [u32; 32] {
    let mut v = [0_u32; 32];
    if dimension == 0 {
        for (i, v) in v.iter_mut().enumerate() {
            *v = 1 << (31 - i);
        }
        return v;
    }
    let (degree, polynomial, first) = DIRECTIONS[dimension - 1];
    for i in 0..32 {
        if i < degree {
            v[i] = first[i] << (31 - i);
            continue;
        }
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for k in 1..degree {
            if (polynomial >> (degree - 1 - k)) & 1 == 1 {
                v[i] ^= v[i - k];
            }
        }
    }
    v
}

/// Steele, Lea & Flood's (2014) SplitMix64.
fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dimension_visits_every_cell_once() {
        let mut sequence = Sequence::new(DIMENSIONS, 7);
        let mut visited = vec![[false; 1024]; DIMENSIONS];
        let mut point = [0.0; DIMENSIONS];
        for _ in 0..1024 {
            sequence.next_point(&mut point);
            for (visited, x) in visited.iter_mut().zip(point) {
                let cell = &mut visited[(x * 1024.0) as usize];
                assert!(!*cell && x > 0.0 && x < 1.0);
                *cell = true;
            }
        }
    }

    #[test]
    fn a_product_in_twenty_dimensions_is_integrated_well() {
        let mut sequence = Sequence::new(DIMENSIONS, 1);
        let mut point = [0.0; DIMENSIONS];
        let count = 1 << 14;
        let mut sum = 0.0;
        for _ in 0..count {
            sequence.next_point(&mut point);
            sum += point.iter().map(|x| 1.0 + 0.5 * (x - 0.5)).product::<f64>();
        }
        assert!((sum / f64::from(count) - 1.0).abs() < 3e-3);
    }
}
