//! The models of the forecast, their names and their errors.

use super::Towing;

/// A closed-form model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Candidate {
    /// The governing one of [`Candidate::Bearing`] and [`Candidate::Wedge`] at every point of the rim.
    Governing,
    /// BC: bearing capacity on the arc.
    Bearing,
    /// PW: passive wedge before the chord of a disc or the front of a block, with ends.
    Wedge,
    /// PW in plane strain.
    PlaneStrain,
    /// Hetherington & Littleton (1978).
    HetheringtonLittleton,
    /// 3D-RFT, Agarwal et al. (2023).
    SpatialResistive,
    /// 2-D RFT, Li et al. (2013).
    PlanarResistive,
    /// Bekker (1956).
    Bekker,
    /// Wong & Reece (1967).
    WongReece,
    /// Wismer & Luth (1973).
    WismerLuth,
    /// Brixius (1987).
    Brixius,
    /// McKyes & Ali (1977).
    McKyesAli,
    /// Godwin & Spoor (1977).
    GodwinSpoor,
    /// Brinch Hansen (1966), Ovesen (1964).
    BrinchHansen,
    /// Bearing capacity of a plate or of a disc that is pressed straight down.
    Footing,
    /// Cone or pile at depth: cavity expansion in sand, N_kt in clay.
    Penetration,
    /// Pipe pressed into clay, Aubeny et al. (2005).
    Pipe,
    /// Pipe or plate that is pulled up.
    Uplift,
}

impl Candidate {
    /// All models, in the order of the tables.
    pub const ALL: [Self; 18] = [
        Self::Governing,
        Self::Bearing,
        Self::Wedge,
        Self::PlaneStrain,
        Self::HetheringtonLittleton,
        Self::SpatialResistive,
        Self::PlanarResistive,
        Self::Bekker,
        Self::WongReece,
        Self::WismerLuth,
        Self::Brixius,
        Self::McKyesAli,
        Self::GodwinSpoor,
        Self::BrinchHansen,
        Self::Footing,
        Self::Penetration,
        Self::Pipe,
        Self::Uplift,
    ];

    /// The name in tables and files; scripts rely on it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Governing => "weaker of BC and PW",
            Self::Bearing => "BC",
            Self::Wedge => "PW",
            Self::PlaneStrain => "PW plane strain",
            Self::HetheringtonLittleton => "Hetherington-Littleton",
            Self::SpatialResistive => "3D-RFT",
            Self::PlanarResistive => "2-D RFT",
            Self::Bekker => "Bekker",
            Self::WongReece => "Wong-Reece",
            Self::WismerLuth => "Wismer-Luth",
            Self::Brixius => "Brixius",
            Self::McKyesAli => "McKyes-Ali",
            Self::GodwinSpoor => "Godwin-Spoor",
            Self::BrinchHansen => "Brinch Hansen",
            Self::Footing => "bearing capacity",
            Self::Penetration => "cone or pile",
            Self::Pipe => "pipe",
            Self::Uplift => "uplift",
        }
    }

    /// Whether the model is a plasticity solution, to be evaluated at the recommended [`super::Strength`];
    /// the others are fits to measurements.
    #[must_use]
    pub fn is_plastic(self) -> bool {
        matches!(
            self,
            Self::Governing
                | Self::Bearing
                | Self::Wedge
                | Self::PlaneStrain
                | Self::HetheringtonLittleton
                | Self::BrinchHansen
                | Self::Footing
        )
    }

    /// Standard deviation of ln(resistance of the soil over that of the model): its own error, apart from
    /// that of the input.
    ///
    /// Chosen beforehand, from the errors that the pages of the models state: a third to a half for discs,
    /// plates in sand and fits, a quarter for blades with ends, three tenths for uplift (the scatter of tests
    /// about the vertical slip model), and what the solver leaves for plane strain and clay.
    #[must_use]
    pub fn log_error(self, towing: &Towing) -> f64 {
        match self {
            Self::PlaneStrain if towing.body.block().is_some() => 0.15,
            Self::Uplift => 0.3,
            _ if towing.soil.is_undrained() => 0.2,
            Self::Wedge | Self::McKyesAli | Self::GodwinSpoor | Self::BrinchHansen => 0.25,
            _ => 0.4,
        }
    }
}
