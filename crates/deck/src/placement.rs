//! Rigid motions: where an instance or a coordinate system stands.

/// A rigid motion: a rotation and then a translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moved {
    pub(super) rotation: [[f64; 3]; 3],
    pub(super) translation: [f64; 3],
}

impl Default for Moved {
    fn default() -> Self {
        Self { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], translation: [0.0; 3] }
    }
}

impl Moved {
    /// A point in the moved place.
    pub(super) fn point(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.direction(point);
        [0, 1, 2].map(|axis| turned[axis] + self.translation[axis])
    }

    /// A direction, turned.
    pub(super) fn direction(&self, vector: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
    }
}

/// The rotation by an angle in degrees about an axis; numbers within 10⁻¹² of 0 or ±1 are these.
pub(super) fn about(axis: [f64; 3], degrees: f64) -> Option<[[f64; 3]; 3]> {
    let [x, y, z] = unit(axis)?;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let rest = 1.0 - cos;
    let matrix = [
        [cos + x * x * rest, x * y * rest - z * sin, x * z * rest + y * sin],
        [y * x * rest + z * sin, cos + y * y * rest, y * z * rest - x * sin],
        [z * x * rest - y * sin, z * y * rest + x * sin, cos + z * z * rest],
    ];
    let snapped = |value: f64| if (value - value.round()).abs() < 1e-12 { value.round() } else { value };
    Some(matrix.map(|row| row.map(snapped)))
}

/// A right-handed set of axes: the first along `a`, the second in the plane of both; `None` where they lie in
/// a line.
pub(super) fn axes(a: [f64; 3], b: [f64; 3]) -> Option<[[f64; 3]; 3]> {
    let first = unit(a)?;
    let third = unit(cross(first, b))?;
    Some([first, cross(third, first), third])
}

/// A vector of length 1; `None` for 0.
pub(super) fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0 && length.is_finite()).then(|| vector.map(|x| x / length))
}

/// The vector product.
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
