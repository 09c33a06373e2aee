//! The ground after bodies have passed: what a grid has left behind, and sections across the rut.

use crate::ground_column::GroundColumn;
use serde::{Deserialize, Serialize};

/// A column of the ground that a grid that travels has left behind, when it lay in the last layer of cells at
/// the end through which the soil leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SurfacePoint {
    /// Middle of the column of cells along x [m].
    pub x: f64,
    /// Along y [m].
    pub y: f64,
    /// The soil in the column.
    pub column: GroundColumn,
}

impl SurfacePoint {
    /// Number of numbers of a point.
    pub(crate) const NUMBERS: usize = 2 + GroundColumn::NUMBERS;

    /// The numbers of the point.
    pub(crate) fn to_array(self) -> [f64; Self::NUMBERS] {
        let mut numbers = [0.0; Self::NUMBERS];
        [numbers[0], numbers[1]] = [self.x, self.y];
        numbers[2..].copy_from_slice(&self.column.to_array());
        numbers
    }

    /// The point of these numbers.
    pub(crate) fn of(numbers: &[f64]) -> Self {
        Self { x: numbers[0], y: numbers[1], column: GroundColumn::from_numbers(&numbers[2..]) }
    }

    /// Position of the point along x (0) or y (1) [m].
    #[must_use]
    pub fn along(&self, axis: usize) -> f64 {
        if axis == 0 { self.x } else { self.y }
    }
}

/// A section across the rut of a body, over the columns that are nearest to this body. Areas are volumes per
/// length of the tow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RutSection {
    /// Position along the tow [m].
    #[serde(rename = "position_m")]
    pub position: f64,
    /// Depth of the deepest point below the undisturbed surface [m].
    #[serde(rename = "depth_m")]
    pub depth: f64,
    /// Width between the points at which the surface rises to the undisturbed one on both sides of the
    /// deepest point [m].
    #[serde(rename = "width_m")]
    pub width: f64,
    /// Area of the rut: soil displaced per length [m²].
    #[serde(rename = "area_m2")]
    pub area: f64,
    /// Height of the berm on the side of larger y, of a lateral tow larger x [m].
    #[serde(rename = "high_berm_height_m")]
    pub high_berm: f64,
    /// Height of the berm on the other side [m].
    #[serde(rename = "low_berm_height_m")]
    pub low_berm: f64,
    /// Area of the berms [m²].
    #[serde(rename = "berm_area_m2")]
    pub berm_area: f64,
    /// Area that the soil has lost by compaction; negative where it has become looser [m²].
    #[serde(rename = "compaction_m2")]
    pub compaction: f64,
    /// Area of voids below the surface [m²].
    #[serde(rename = "void_m2")]
    pub void: f64,
    /// Area of disturbed soil [m²].
    #[serde(rename = "disturbed_m2")]
    pub disturbed: f64,
    /// Area of mixed soil [m²].
    #[serde(rename = "mixed_m2")]
    pub mixed: f64,
    /// Depth down to which soil is disturbed [m].
    #[serde(rename = "disturbed_depth_m")]
    pub disturbed_depth: f64,
}

impl RutSection {
    /// The mean of some sections, its position that of their middle; `None` without any.
    #[must_use]
    pub fn mean(sections: &[Self]) -> Option<Self> {
        let mean = |value: fn(&Self) -> f64| sections.iter().map(value).sum::<f64>() / sections.len() as f64;
        (!sections.is_empty()).then(|| Self {
            position: mean(|s| s.position),
            depth: mean(|s| s.depth),
            width: mean(|s| s.width),
            area: mean(|s| s.area),
            high_berm: mean(|s| s.high_berm),
            low_berm: mean(|s| s.low_berm),
            berm_area: mean(|s| s.berm_area),
            compaction: mean(|s| s.compaction),
            void: mean(|s| s.void),
            disturbed: mean(|s| s.disturbed),
            mixed: mean(|s| s.mixed),
            disturbed_depth: mean(|s| s.disturbed_depth),
        })
    }
}
