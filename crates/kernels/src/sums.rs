//! What cells exert on nodes, and what rows add to the sums of a step.

/// Coefficients of the nodal forces of a cell: for each component the plain term and the terms signed by the
/// corner's side along x, y, z; last the hourglass damping.
pub const COEFFICIENTS: usize = 13;

/// Sums at a node: force along x, y, z, and damping.
pub const NODE_SUMS: usize = 4;

/// What a row of nodes adds to the sums of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// Work of gravity [J].
    pub gravity: f64,
    /// Kinetic energy [J].
    pub kinetic: f64,
    /// Largest component of a displacement since the last remap, each divided by the aspect of the cells [m].
    pub displacement: f64,
    /// The same of light nodes [m].
    pub displacement_light: f64,
}
