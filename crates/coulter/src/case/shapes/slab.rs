//! The slab of a plane strain case, which the width of a body follows.

/// The slab of a plane strain case.
#[derive(Clone, Copy)]
pub(in crate::case) struct Slab {
    /// Width of the slab along y [m].
    pub(in crate::case) width: f64,
    /// Middle of the slab along y [m].
    pub(in crate::case) middle: f64,
    /// Distance of contact points from sharp edges [m].
    pub(in crate::case) inset: f64,
}

impl Slab {
    /// Width of a body [m]: that of the slab plus the inset of the contact points at both edges, so that the points cover
    /// the slab exactly.
    pub(in crate::case) fn covering_width(&self) -> f64 {
        self.width + 2.0 * self.inset
    }
}
