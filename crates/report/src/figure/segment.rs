//! Parts of paths.

/// A part of a path; places as the path has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Segment {
    /// A move to a new start.
    Move([f64; 2]),
    /// A line to a place.
    Line([f64; 2]),
    /// A curve with one control point.
    Bend([f64; 2], [f64; 2]),
    /// A curve with two control points, and its end.
    Curve([[f64; 2]; 3]),
    /// Back to the start.
    Close,
}
