//! The towed body: a disc, a block, or any rigid body by the facets of its surface.

use crate::disc::Disc;
use crate::error::{ModelResult, positive, within};
use crate::resistive::Facet;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// The towed body.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A disc, or a roller with its axis perpendicular to the tow.
    Disc(Disc),
    /// A body with a plane front.
    Block(Block),
    /// A body whose front is neither plane nor that of a disc.
    Faceted(FacetedBody),
}

/// A rectangular block across the tow: a blade, a plate, a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Edge lengths along x, y and z before rotation [m].
    pub size: [f64; 3],
    /// Rotation about y [rad], positive when the top moves in the tow direction.
    pub orientation: f64,
    /// Whether it is a slice of an infinitely wide block, without end effects.
    pub plane_strain: bool,
    /// Whether its base rests on soil.
    pub has_base: bool,
}

/// A body of any shape by its facets, centred on its origin and symmetric fore and aft.
#[derive(Clone, Debug, PartialEq)]
pub struct FacetedBody {
    /// Reference length d [m]: its diameter.
    pub length: f64,
    /// Width t across the tow [m].
    pub width: f64,
    /// Height of its bounding box [m].
    pub height: f64,
    /// Facets of its surface.
    pub facets: Arc<[Facet]>,
}

/// The plane front of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Front {
    /// Rake angle [rad]: 90° is upright, less leans back, more overhangs the soil ahead.
    pub rake: f64,
    /// Height of its lower edge above the lowest edge of the block [m].
    pub lower_edge: f64,
    /// Height of its upper edge above the lowest edge of the block [m].
    pub upper_edge: f64,
    /// Length of the block behind the front [m]; for an upright block the length of its base.
    pub length_behind: f64,
}

impl From<Disc> for Body {
    fn from(disc: Disc) -> Self {
        Self::Disc(disc)
    }
}

impl From<Block> for Body {
    fn from(block: Block) -> Self {
        Self::Block(block)
    }
}

impl Body {
    /// Reference length d [m]: the diameter, or a block's edge along z.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter,
            Self::Block(block) => block.size[2],
            Self::Faceted(body) => body.length,
        }
    }

    /// Width t across the tow [m].
    #[must_use]
    pub fn width(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.thickness,
            Self::Block(block) => block.size[1],
            Self::Faceted(body) => body.width,
        }
    }

    /// Height of its bounding box [m].
    #[must_use]
    pub fn height(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter,
            Self::Block(block) => block.height(),
            Self::Faceted(body) => body.height,
        }
    }

    /// Largest sinkage in the range of the models [m].
    #[must_use]
    pub fn deepest(&self) -> f64 {
        match self {
            Self::Disc(disc) => 0.95 * disc.diameter,
            _ => self.height(),
        }
    }

    /// Force scale γ t d² [N] of dimensionless forces, for the unit weight γ [N/m³].
    #[must_use]
    pub fn force_scale(&self, unit_weight: f64) -> f64 {
        unit_weight * self.width() * self.length().powi(2)
    }

    /// The disc, if it is one.
    #[must_use]
    pub fn disc(&self) -> Option<&Disc> {
        match self {
            Self::Disc(disc) => Some(disc),
            _ => None,
        }
    }

    /// The block, if it is one.
    #[must_use]
    pub fn block(&self) -> Option<&Block> {
        match self {
            Self::Block(block) => Some(block),
            _ => None,
        }
    }

    /// Checks the dimensions.
    ///
    /// # Errors
    /// Unless every length is positive and a block's orientation lies between −180° and 180°.
    pub fn check(&self) -> ModelResult<()> {
        match self {
            Self::Disc(disc) => disc.check(),
            Self::Block(block) => {
                for edge in block.size {
                    positive("edge of the block [m]", edge)?;
                }
                within("orientation [rad]", block.orientation, -PI, PI).map(|_| ())
            }
            Self::Faceted(body) => {
                for length in [body.length, body.width, body.height] {
                    positive("length of the body [m]", length)?;
                }
                Ok(())
            }
        }
    }
}

impl Block {
    /// Height of the bounding box of the rotated block [m].
    #[must_use]
    pub fn height(&self) -> f64 {
        let (sin, cos) = self.orientation.sin_cos();
        self.size[0] * sin.abs() + self.size[2] * cos.abs()
    }

    /// The four faces parallel to y: outward normal, distance from the origin [m] and length in the x–z plane [m].
    fn faces(&self) -> [([f64; 3], f64, f64); 4] {
        let (sin, cos) = self.orientation.sin_cos();
        let [long, _, high] = self.size;
        // With its top rotated towards x, the x axis of the block points downwards.
        let (forward, up) = ([cos, 0.0, -sin], [sin, 0.0, cos]);
        let back = |n: [f64; 3]| n.map(|x| -x);
        [
            (forward, 0.5 * long, high),
            (up, 0.5 * high, long),
            (back(forward), 0.5 * long, high),
            (back(up), 0.5 * high, long),
        ]
    }

    /// The front: the forward-facing face of the largest height.
    #[must_use]
    pub fn front(&self) -> Front {
        let frontal = |face: &([f64; 3], f64, f64)| face.0[0] * face.2;
        let faces = self.faces();
        let front = faces.iter().max_by(|a, b| frontal(a).total_cmp(&frontal(b))).unwrap_or(&faces[0]);
        let (normal, distance, length) = *front;
        let elevation = normal[2].atan2(normal[0]);
        let middle = 0.5 * self.height() + distance * normal[2];
        let half = 0.5 * length * normal[0];
        // Zero to rounding counts as zero.
        let lower_edge = middle - half;
        let lower_edge = if lower_edge.abs() < 1e-12 * length { 0.0 } else { lower_edge };
        Front {
            rake: FRAC_PI_2 - elevation,
            lower_edge,
            upper_edge: middle + half,
            length_behind: 2.0 * distance,
        }
    }

    /// The faces parallel to y as facets; resistive force theory assigns no force to faces that move in their own plane.
    #[must_use]
    pub fn facets(&self) -> [Facet; 4] {
        self.faces().map(|(normal, distance, length)| Facet {
            centroid: normal.map(|n| n * distance),
            normal,
            area: length * self.size[1],
            half_height: 0.5 * length * normal[0].abs(),
        })
    }
}
