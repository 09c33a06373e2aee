//! The table of the history variables of the soil.

/// The weight by which a quantity is averaged when soils mix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// Averaged by volume.
    Volume,
    /// Averaged by mass.
    Mass,
}

/// A history variable of the soil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HistoryVariable {
    /// Name of the variable in field files.
    pub name: &'static str,
    /// Unit of the variable, "" where it has none.
    pub unit: &'static str,
    /// Carrier by which the variable is averaged.
    pub carrier: Carrier,
    /// Materials that need the variable; its array is empty where there is none of them.
    pub needed_by: Needing,
}

/// Materials that need a history variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needing {
    /// All materials.
    Every,
    /// Materials whose law remembers ([`physics::yield_law::YieldLaw::REMEMBERS`]).
    Sand,
    /// Materials with a strength at each point ([`physics::yield_law::YieldLaw::HAS_STRENGTH`]).
    Clay,
    /// Materials whose pore pressure is computed (`pore_water` of the solver's model).
    Water,
}

/// Which kinds of materials there are besides the usual ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kinds {
    /// Whether there is a material whose law remembers.
    pub sand: bool,
    /// Whether there is a material with a strength at each point.
    pub clay: bool,
    /// Whether there is a material whose pore pressure is computed.
    pub water: bool,
}

impl Kinds {
    /// Whether one of the kinds needs a history variable.
    #[must_use]
    pub fn need(self, variable: &HistoryVariable) -> bool {
        match variable.needed_by {
            Needing::Every => true,
            Needing::Sand => self.sand,
            Needing::Clay => self.clay,
            Needing::Water => self.water,
        }
    }

    /// The kinds of this and of another set.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            sand: self.sand || other.sand,
            clay: self.clay || other.clay,
            water: self.water || other.water,
        }
    }
}

macro_rules! history {
    ($($(#[$doc:meta])* $name:ident = $file:literal [$unit:literal] by $carrier:ident, needed_by: $needing:ident;)*) => {
        // Numbers the variables; its variants bear the names of the constants below.
        #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
        enum Number { $($name,)* Count }
        $($(#[$doc])* pub const $name: usize = Number::$name as usize;)*
        /// Number of history variables.
        pub const HISTORY_COUNT: usize = Number::Count as usize;
        /// The history variables, in the order of their arrays.
        pub const HISTORY: [HistoryVariable; HISTORY_COUNT] = [$(HistoryVariable {
            name: $file,
            unit: $unit,
            carrier: Carrier::$carrier,
            needed_by: Needing::$needing,
        },)*];
    };
}

history! {
    /// Equivalent plastic strain ∫√(⅔ ε̇ₚ:ε̇ₚ) dt.
    PLASTIC_STRAIN = "plastic_strain" [""] by Volume, needed_by: Every;
    /// Stress-free volumetric opening that must close before pressure can build up.
    GAP_STRAIN = "gap" [""] by Volume, needed_by: Every;
    /// Largest stress ratio q/(g p) that the sand has mobilised.
    STRESS_RATIO = "mobilised_stress_ratio" [""] by Volume, needed_by: Sand;
    /// Preconsolidation pressure: the largest mean pressure that the sand has borne.
    PRECONSOLIDATION = "preconsolidation_pressure" ["Pa"] by Volume, needed_by: Sand;
    /// Relative density averaged over the characteristic length, over-weighted, less that of the cell.
    NONLOCAL_DENSITY = "nonlocal_density" [""] by Volume, needed_by: Sand;
    /// Undrained shear strength of the clay before it was remoulded, at the reference rate.
    INTACT_STRENGTH = "intact_shear_strength" ["Pa"] by Volume, needed_by: Clay;
    /// Excess pore pressure: that of the water between the grains beyond the hydrostatic one.
    PORE_PRESSURE = "excess_pore_pressure" ["Pa"] by Volume, needed_by: Water;
    /// Excess pore pressure, extrapolated to the next step, in which it acts.
    PORE_PRESSURE_AHEAD = "excess_pore_pressure_ahead" ["Pa"] by Volume, needed_by: Water;
}
