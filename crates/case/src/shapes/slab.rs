//! The slab of a plane strain case, which the width of a body follows.

/// Width of a body in plane strain [m]: its weight, load, mass and drive, forces on it and energies are those
/// per metre of width.
pub const PLANE_STRAIN_WIDTH: f64 = 1.0;

/// The slab of a plane strain case.
#[derive(Clone, Copy)]
pub(crate) struct Slab {
    /// Width of the slab along y [m].
    pub(crate) width: f64,
    /// Middle of the slab along y [m].
    pub(crate) middle: f64,
    /// Distance of contact points from sharp edges [m].
    pub(crate) inset: f64,
}

impl Slab {
    /// Width of a body [m]: that of the slab plus the inset of the contact points at both edges, so that the
    /// points cover the slab exactly.
    pub(crate) fn covering_width(&self) -> f64 {
        self.width + 2.0 * self.inset
    }
}
