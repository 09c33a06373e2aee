//! What a rendered picture should show.

use std::path::{Path, PathBuf};

/// What a file holds, by its extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageFormat {
    /// `.png`: a picture.
    Png,
    /// `.gif`: an animation in 255 colours.
    Gif,
    /// `.apng`: an animation in full colour.
    Apng,
}

impl ImageFormat {
    /// The format of a file.
    ///
    /// # Errors
    /// What its name must end in.
    pub fn of(path: &Path) -> Result<Self, String> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("gif") => Ok(Self::Gif),
            Some("apng") => Ok(Self::Apng),
            _ => Err("its name must end in .png (a picture), .gif or .apng (an animation)".to_owned()),
        }
    }
}

/// From where the soil is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint {
    /// Direction of view in plan, from the x axis towards y [rad]: 0 looks along the tow.
    pub azimuth: f64,
    /// How far the viewer looks down [rad], 0 to π/2.
    pub elevation: f64,
    /// Magnification, 1: all of it fills the picture.
    pub zoom: f64,
    /// Whether the viewer moves with the first body and sees its surroundings only.
    pub follow: bool,
}

impl Viewpoint {
    /// Obliquely from behind, from the right of the tow.
    pub const OBLIQUE: Self = Self { azimuth: 0.66, elevation: 0.46, zoom: 1.0, follow: false };
    /// Across the tow.
    pub const SIDE: Self = Self { azimuth: std::f64::consts::FRAC_PI_2, elevation: 0.02, ..Self::OBLIQUE };
    /// From above, the tow to the right.
    pub const ABOVE: Self = Self {
        azimuth: std::f64::consts::FRAC_PI_2,
        elevation: std::f64::consts::FRAC_PI_2,
        ..Self::OBLIQUE
    };
    /// Towards the body as it comes.
    pub const FRONT: Self = Self { azimuth: 3.4, elevation: 0.3, ..Self::OBLIQUE };
}

/// What the colours of the soil mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colouring {
    /// Height above or below the undisturbed surface.
    Height,
    /// Nothing: the soil looks as soil does.
    Plain,
}

/// What to draw, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderOptions {
    /// Files to write, in the formats of [`ImageFormat`].
    pub files: Vec<PathBuf>,
    /// Viewpoint of the pictures; `None`: obliquely, from the side in plane strain.
    pub viewpoint: Option<Viewpoint>,
    /// What the colours mean.
    pub colouring: Colouring,
    /// Size of the pictures [pixels].
    pub size: [usize; 2],
    /// Whether the background is dark.
    pub dark: bool,
    /// Whether title, scale and time are written on the picture.
    pub labelled: bool,
    /// Time of the picture [s]: the nearest recorded one is drawn; the last unless given.
    pub time: Option<f64>,
    /// How long an animation lasts [s].
    pub duration: f64,
}
