//! The body: a disc, a block, a plate, or any rigid body by the facets of its surface.

use crate::disc::Disc;
use crate::error::{ModelResult, positive, within};
use crate::resistive::{Axle, Facet};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// Deepest sinkage of a plate in the range of the models that look for one, over its shorter side (chosen).
const DEEPEST_PLATE: f64 = 10.0;
/// Deepest sinkage of a plate or a pipe over its shorter side (chosen: what is deeper is a pile, or is held
/// by deep soil).
const DEEPEST: f64 = 20.0;

/// The body.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A disc, or a roller with its axis perpendicular to the tow.
    Disc(Disc),
    /// A body with a plane front.
    Block(Block),
    /// A body whose front is neither plane nor that of a disc.
    Faceted(FacetedBody),
    /// A level plate that is pressed straight down: a footing.
    Plate(Plate),
    /// A cone on a shaft, tip down, that is pressed straight down.
    Cone(Penetrometer),
    /// A long cylinder that lies and is pressed down or pulled up.
    Pipe(Pipe),
}

/// A cone on a shaft, tip down.
#[derive(Clone, Debug, PartialEq)]
pub struct Penetrometer {
    /// Diameter d of the base of the cone [m].
    pub diameter: f64,
    /// Angle at the tip [rad], between opposite sides.
    pub apex: f64,
    /// Diameter of the shaft [m].
    pub shaft: f64,
    /// Surface of the penetrometer.
    pub surface: FacetedBody,
}

impl Penetrometer {
    /// Height of the cone alone [m].
    #[must_use]
    pub fn tip(&self) -> f64 {
        0.5 * self.diameter / (0.5 * self.apex).tan()
    }
}

/// A long cylinder that lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// Diameter d [m].
    pub diameter: f64,
    /// Length of the pipe, or that of the slice of an infinitely long one [m].
    pub length: f64,
    /// Whether the pipe is a slice in plane strain.
    pub plane_strain: bool,
}

/// Outline of the base of a plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline {
    /// A rectangle.
    Rectangle,
    /// A circle; width and length are its diameter.
    Circle,
    /// A slice of an infinitely long strip; its length is the width of the slice, to which forces refer.
    Strip,
}

/// A level plate that is pressed straight down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    /// Outline of the plate.
    pub outline: Outline,
    /// Width B of the base [m].
    pub width: f64,
    /// Length of the base [m].
    pub length: f64,
    /// Height of the body above it [m].
    pub height: f64,
}

impl Plate {
    /// Area of the base [m²].
    #[must_use]
    pub fn area(&self) -> f64 {
        let ratio = if self.outline == Outline::Circle { 0.25 * PI } else { 1.0 };
        ratio * self.width * self.length
    }

    /// The shorter side of the footing B [m].
    #[must_use]
    pub fn breadth(&self) -> f64 {
        if self.outline == Outline::Strip { self.width } else { self.width.min(self.length) }
    }
}

/// A rectangular block across the tow: a blade, a plate, a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Edge lengths along x, y and z before rotation [m].
    pub size: [f64; 3],
    /// Rotation about y [rad], positive when the top moves in the tow direction.
    pub orientation: f64,
    /// Whether the block is a slice of an infinitely wide block, without end effects.
    pub plane_strain: bool,
    /// Whether the base of the block rests on soil.
    pub has_base: bool,
}

/// A body of any shape and attitude by its facets.
#[derive(Clone, Debug, PartialEq)]
pub struct FacetedBody {
    /// Reference length d [m]: its diameter.
    pub length: f64,
    /// Width t across the tow [m].
    pub width: f64,
    /// Shorter side of the body in plan [m]; in plane strain its length along the tow.
    pub breadth: f64,
    /// Whether the body is a slice of an infinitely wide body.
    pub plane_strain: bool,
    /// Height of the bounding box of the body [m].
    pub height: f64,
    /// Depth of the lowest point of the body below its origin, through which the axle runs [m].
    pub below: f64,
    /// The axle about which the body rolls, if it does.
    pub axle: Axle,
    /// Facets of the surface of the body.
    pub facets: Arc<[Facet]>,
}

/// The plane front of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Front {
    /// Rake angle [rad]: 90° is upright, less leans back, more overhangs the soil ahead.
    pub rake: f64,
    /// Height of the lower edge of the front above the lowest edge of the block [m].
    pub lower_edge: f64,
    /// Height of the upper edge of the front above the lowest edge of the block [m].
    pub upper_edge: f64,
    /// Length of the block behind the front [m]; for an upright block the length of its base.
    pub length_behind: f64,
}

impl From<Disc> for Body {
    fn from(disc: Disc) -> Self {
        Self::Disc(disc)
    }
}

impl From<Plate> for Body {
    fn from(plate: Plate) -> Self {
        Self::Plate(plate)
    }
}

impl From<Pipe> for Body {
    fn from(pipe: Pipe) -> Self {
        Self::Pipe(pipe)
    }
}

impl From<Block> for Body {
    fn from(block: Block) -> Self {
        Self::Block(block)
    }
}

impl Body {
    /// Reference length d [m]: the diameter, a block's edge along z, the shorter side of a plate.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter,
            Self::Block(block) => block.size[2],
            Self::Faceted(body) => body.length,
            Self::Plate(plate) => plate.breadth(),
            Self::Cone(cone) => cone.diameter,
            Self::Pipe(pipe) => pipe.diameter,
        }
    }

    /// Width t across the tow [m]; of a plate its area over the shorter side.
    #[must_use]
    pub fn width(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.thickness,
            Self::Block(block) => block.size[1],
            Self::Faceted(body) => body.width,
            Self::Plate(plate) => plate.area() / plate.breadth(),
            Self::Cone(cone) => cone.diameter,
            Self::Pipe(pipe) => pipe.length,
        }
    }

    /// Height of the bounding box of the body [m]; of a plate, whose own height does not matter, ten times
    /// its shorter side.
    #[must_use]
    pub fn height(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter,
            Self::Block(block) => block.height(),
            Self::Faceted(body) => body.height,
            Self::Plate(plate) => DEEPEST_PLATE * plate.breadth(),
            Self::Cone(cone) => cone.surface.height,
            Self::Pipe(pipe) => pipe.diameter,
        }
    }

    /// Largest sinkage in the range of the models [m].
    #[must_use]
    pub fn deepest(&self) -> f64 {
        match self {
            Self::Disc(disc) => 0.95 * disc.diameter,
            Self::Plate(plate) => plate.height.max(DEEPEST * plate.breadth()),
            Self::Pipe(pipe) => DEEPEST * pipe.diameter,
            _ => self.height(),
        }
    }

    /// Shorter side of the body in plan [m], which limits how deep it is when it is pressed down; in plane
    /// strain its length along x.
    #[must_use]
    pub fn breadth(&self) -> f64 {
        match self {
            Self::Disc(disc) => disc.diameter.min(disc.thickness),
            Self::Block(block) if block.plane_strain => block.size[0],
            Self::Block(block) => block.size[0].min(block.size[1]),
            Self::Faceted(body) => body.breadth,
            Self::Plate(plate) => plate.breadth(),
            Self::Cone(_) | Self::Pipe(_) => self.length(),
        }
    }

    /// The disc, if the body is one.
    #[must_use]
    pub fn disc(&self) -> Option<&Disc> {
        match self {
            Self::Disc(disc) => Some(disc),
            _ => None,
        }
    }

    /// The block, if the body is one.
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
            Self::Cone(cone) => {
                within("shaft diameter [m]", cone.shaft, 0.0, cone.diameter)?;
                within("cone angle [rad]", cone.apex, 0.01, PI)?;
                positive("diameter of the cone [m]", cone.diameter).map(|_| ())
            }
            Self::Pipe(pipe) => {
                positive("diameter of the pipe [m]", pipe.diameter)?;
                positive("length of the pipe [m]", pipe.length).map(|_| ())
            }
            Self::Faceted(body) => {
                for length in [body.length, body.width, body.height] {
                    positive("length of the body [m]", length)?;
                }
                Ok(())
            }
            Self::Plate(plate) => {
                positive("width of the plate [m]", plate.width)?;
                positive("height of the plate [m]", plate.height)?;
                positive("length of the plate [m]", plate.length).map(|_| ())
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

    /// The four faces parallel to y: outward normal, distance from the origin [m] and length in the x–z
    /// plane [m].
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

    /// The faces parallel to y as facets; resistive force theory assigns no force to faces that move in their
    /// own plane.
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

/// Reference force γ t d² [N] of a body of the reference width t and length d [m] in soil of the unit weight
/// γ [N/m³], over which forces and weights are dimensionless, whatever the shape and the soil; `None` for
/// weightless soil.
#[must_use]
pub fn reference_force(unit_weight: f64, width: f64, length: f64) -> Option<f64> {
    let force = unit_weight * width * length * length;
    (force > 0.0 && force.is_finite()).then_some(force)
}
