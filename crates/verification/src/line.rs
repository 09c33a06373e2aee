//! Extrapolation of a force to zero displacement. Limit loads are those of the undeformed geometry; heave and
//! embedment add in proportion to the displacement.

/// Value at 0 of the straight line that fits the points best (least squares); not a number for fewer than two
/// points.
pub(crate) fn at_zero(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let middle = |axis: usize| points.iter().map(|p| p[axis]).sum::<f64>() / count;
    let [x, y] = [middle(0), middle(1)];
    let slope = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum::<f64>()
        / points.iter().map(|p| (p[0] - x).powi(2)).sum::<f64>();
    y - slope * x
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_line_is_read_at_zero() {
        let points = [[1.0, 5.0], [2.0, 7.0], [4.0, 11.0]];
        assert!((super::at_zero(&points) - 3.0).abs() < 1e-12);
    }
}
