//! What is under tow: a disc, or any other rigid body by the pieces of its surface.

use crate::disc::Disc;
use crate::error::{Answer, positive, within};
use crate::resistive::Facet;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// The body under tow.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A disc, or a roller across the tow.
    Disc(Disc),
    /// A body with a plane front.
    Block(Block),
    /// A body whose front is neither plane nor that of a disc.
    Round(Round),
}

/// A rectangular block across the tow: a blade, a plate, a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Edges along x, y and z before it is turned [m].
    pub size: [f64; 3],
    /// Angle by which it is turned about y [rad], its top towards the tow if positive.
    pub orientation: f64,
    /// Whether it stands for a slab cut from an endless one, so that it has no ends.
    pub endless: bool,
    /// Whether there is soil under its base.
    pub has_base: bool,
}

/// A body of any shape, centred on its origin and alike in front and behind.
#[derive(Clone, Debug, PartialEq)]
pub struct Round {
    /// Reference length d [m]: its diameter.
    pub length: f64,
    /// Width t across the tow [m].
    pub width: f64,
    /// Height of the box round it [m].
    pub height: f64,
    /// Pieces of its surface.
    pub facets: Arc<[Facet]>,
}

/// The plane front of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Front {
    /// Rake [rad]: 90° is upright, less leans back over what it has cut, more overhangs the soil.
    pub rake: f64,
    /// Height of its lower edge above the lowest edge of the block [m].
    pub lift: f64,
    /// Height of its upper edge above the lowest edge of the block [m].
    pub top: f64,
    /// Length of the block behind it [m]: that of the base of an upright block.
    pub behind: f64,
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
    /// Reference length d [m]: the diameter, a block's edge along z.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter,
            Self::Block(block) => block.size[2],
            Self::Round(round) => round.length,
        }
    }

    /// Width t across the tow [m].
    #[must_use]
    pub fn width(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.thickness,
            Self::Block(block) => block.size[1],
            Self::Round(round) => round.width,
        }
    }

    /// Height of the box round it [m].
    #[must_use]
    pub fn height(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter,
            Self::Block(block) => block.height(),
            Self::Round(round) => round.height,
        }
    }

    /// Deepest sinkage that the models take [m].
    #[must_use]
    pub fn deepest(&self) -> f64 {
        match self {
            Self::Disc(disc) => 0.95 * disc.diameter,
            _ => self.height(),
        }
    }

    /// The force γ t d² [N] that makes forces dimensionless, for the unit weight [N/m³].
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

    /// Refuses a body without size.
    ///
    /// # Errors
    /// Unless every length is above 0 and a block's orientation lies between −180° and 180°.
    pub fn check(&self) -> Answer<()> {
        match self {
            Self::Disc(disc) => disc.check(),
            Self::Block(block) => {
                for edge in block.size {
                    positive("edge of the block [m]", edge)?;
                }
                within("orientation [rad]", block.orientation, -PI, PI).map(|_| ())
            }
            Self::Round(round) => {
                for length in [round.length, round.width, round.height] {
                    positive("length of the body [m]", length)?;
                }
                Ok(())
            }
        }
    }
}

impl Block {
    /// Height of the box round the turned block [m].
    #[must_use]
    pub fn height(&self) -> f64 {
        let (sin, cos) = self.orientation.sin_cos();
        self.size[0] * sin.abs() + self.size[2] * cos.abs()
    }

    /// The four faces across the tow by outward normal, distance from the origin and length in the plane of the tow.
    fn faces(&self) -> [([f64; 3], f64, f64); 4] {
        let (sin, cos) = self.orientation.sin_cos();
        let [long, _, high] = self.size;
        // Turned with its top towards x: the x axis of the block dips.
        let (forward, up) = ([cos, 0.0, -sin], [sin, 0.0, cos]);
        let back = |n: [f64; 3]| n.map(|x| -x);
        [
            (forward, 0.5 * long, high),
            (up, 0.5 * high, long),
            (back(forward), 0.5 * long, high),
            (back(up), 0.5 * high, long),
        ]
    }

    /// The face that meets the soil with the largest height.
    #[must_use]
    pub fn front(&self) -> Front {
        let frontal = |face: &([f64; 3], f64, f64)| face.0[0] * face.2;
        let faces = self.faces();
        let front = faces.iter().max_by(|a, b| frontal(a).total_cmp(&frontal(b))).unwrap_or(&faces[0]);
        let (normal, distance, length) = *front;
        let elevation = normal[2].atan2(normal[0]);
        let middle = 0.5 * self.height() + distance * normal[2];
        let half = 0.5 * length * normal[0];
        // What is level to rounding is level.
        let lift = middle - half;
        let lift = if lift.abs() < 1e-12 * length { 0.0 } else { lift };
        Front { rake: FRAC_PI_2 - elevation, lift, top: middle + half, behind: 2.0 * distance }
    }

    /// Its faces across the tow as pieces of surface; those along the tow slide past the soil and feel nothing.
    #[must_use]
    pub fn facets(&self) -> [Facet; 4] {
        self.faces().map(|(normal, distance, length)| Facet {
            middle: normal.map(|n| n * distance),
            normal,
            area: length * self.size[1],
            rise: 0.5 * length * normal[0].abs(),
        })
    }
}
