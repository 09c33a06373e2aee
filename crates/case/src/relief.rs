//! The relief of the ground in a case: a height map from a file, furrows, or both.

use crate::height_map::height_map;
use crate::key::allowed::POSITIVE;
use crate::key::checked;
use crate::key::words::FURROWS as SECTIONS;
use DefaultValue::{Quantity, Word};
use geometry::relief::{self, FurrowShape};
use input::height_file::HeightFile;
use input::key::{DefaultValue, Key, KeyOf, Kind, Place, declared, in_ranges, numbers, read};
use input::problem::Problems;
use input::quantity::{ANGLE, LENGTH};
use input::typed::Section;
use serde::Serialize;

/// How far the surface of the ground lies above or below `ground.surface`; level where it has neither map nor
/// furrows.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Relief {
    /// Heights from a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<HeightFile>,
    /// Furrows, on top of the heights of the map.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub furrows: Option<Furrows>,
}

/// Parallel furrows, all alike, as far above the level surface as below it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Furrows {
    /// Distance from crest to crest [m].
    pub spacing: f64,
    /// Height of the crests above the troughs [m].
    pub depth: f64,
    /// Angle from x to the furrows [rad].
    pub direction: f64,
    /// Distance of a crest from x = y = 0, across the furrows towards +x, or towards +y of furrows along x
    /// [m].
    pub offset: f64,
    /// Whether the section of the furrows is a triangle instead of a cosine.
    pub is_triangular: bool,
}

/// Keys of furrows, and where their values lie.
type Field = KeyOf<Furrows>;

const FIELDS: &[Field] = &[
    Field::new("spacing", Kind::Quantity(LENGTH), Place::Number(|furrows| &mut furrows.spacing))
        .within(POSITIVE)
        .means("Distance from crest to crest; at least two cells."),
    Field::new("depth", Kind::Quantity(LENGTH), Place::Number(|furrows| &mut furrows.depth))
        .within(POSITIVE)
        .means("Height of the crests above the troughs. The mean level of furrows is `ground.surface`."),
    Field::new("direction", Kind::Quantity(ANGLE), Place::Number(|furrows| &mut furrows.direction))
        .default(Quantity("90 deg"))
        .means("Angle from x to the furrows: 90 deg across the tow, 0 deg along it."),
    Field::new("offset", Kind::Quantity(LENGTH), Place::Number(|furrows| &mut furrows.offset))
        .default(Quantity("0 m"))
        .means(
            "Distance of a crest from x = y = 0 across the furrows, towards +x, or towards +y of furrows \
             along x.",
        ),
    Field::new(
        "section",
        Kind::Choice(&SECTIONS),
        Place::Word(|furrows, word| furrows.is_triangular = word == "triangular"),
    )
    .default(Word("sinusoidal"))
    .means("Section of the furrows: a cosine, or straight flanks between sharp crests and troughs."),
];

impl Furrows {
    pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    pub(crate) fn typed(section: &Section, problems: &mut Problems) -> Option<Self> {
        read(FIELDS, Self::default(), section, problems)
    }

    /// Reports numbers that are out of range.
    pub(crate) fn check(&self, problems: &mut Problems) {
        in_ranges("furrows", &numbers(FIELDS, self), problems);
    }

    /// Unit vector along x and y across the furrows, towards +x, or towards +y of furrows along x.
    #[must_use]
    pub fn across(&self) -> [f64; 2] {
        // Furrows along an axis are exactly so.
        const ROUND_OFF: f64 = 1e-12;
        let exact = |part: f64| if part.abs() < ROUND_OFF { 0.0 } else { part };
        let (sin, cos) = self.direction.sin_cos();
        let (x, y) = (exact(sin), exact(-cos));
        if x < 0.0 || x == 0.0 && y < 0.0 { [-x, -y].map(exact) } else { [x, y] }
    }

    /// Tangent of the steepest slope of the furrows.
    #[must_use]
    pub fn steepest(&self) -> f64 {
        self.of_solver().steepest()
    }

    fn of_solver(&self) -> relief::Furrows {
        let shape = if self.is_triangular { FurrowShape::Triangular } else { FurrowShape::Sinusoidal };
        let Self { spacing, depth, offset, .. } = *self;
        relief::Furrows { spacing, depth, across: self.across(), offset, shape }
    }
}

impl Relief {
    /// The relief of ground with these sections; `None` where one was given wrongly.
    pub(crate) fn typed(
        map: Option<&Section>,
        furrows: Option<&Section>,
        problems: &mut Problems,
    ) -> Option<Self> {
        let map = map.map(|section| height_map(section, problems));
        let furrows = furrows.map(|section| Furrows::typed(section, problems));
        let relief = Self {
            map: map.map_or(Some(None), |map| map.map(Some))?,
            furrows: furrows.map_or(Some(None), |furrows| furrows.map(Some))?,
        };
        checked(relief, problems, |relief, problems| {
            relief.furrows.iter().for_each(|furrows| furrows.check(problems));
        })
    }

    /// Whether the ground is level.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.map.is_none() && self.furrows.is_none()
    }

    /// The solver's relief.
    #[must_use]
    pub fn of_solver(&self) -> relief::Relief {
        relief::Relief {
            map: self.map.as_ref().map(|map| map.heights().clone()),
            furrows: self.furrows.map(|furrows| furrows.of_solver()),
        }
    }
}
