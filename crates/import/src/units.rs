//! The units of a deck, which it does not state.

use std::str::FromStr;

/// Units of length, mass and time.
#[derive(Clone, Debug, PartialEq)]
pub struct Units {
    /// Unit of length [m].
    pub length: f64,
    /// Unit of mass [kg].
    pub mass: f64,
    /// Unit of time [s].
    pub time: f64,
    /// Their symbols, `mm-t-s`.
    pub name: String,
}

/// A word that names no units.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "units are written LENGTH-MASS-TIME, of m, cm, mm, in, ft; kg, t, g, slug; s, ms: such as mm-t-s or m-kg-s"
)]
pub struct UnknownUnits;

const LENGTHS: [(&str, f64); 5] = [("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("in", 0.0254), ("ft", 0.3048)];
const MASSES: [(&str, f64); 4] = [("kg", 1.0), ("t", 1e3), ("g", 1e-3), ("slug", 14.593_902_937_206_364)];
const TIMES: [(&str, f64); 2] = [("s", 1.0), ("ms", 1e-3)];

impl FromStr for Units {
    type Err = UnknownUnits;

    fn from_str(text: &str) -> Result<Self, UnknownUnits> {
        let lower = text.to_lowercase();
        let parts: Vec<&str> = lower.split('-').map(str::trim).collect();
        let [length, mass, time] = parts[..] else { return Err(UnknownUnits) };
        let find = |units: &[(&str, f64)], word: &str| {
            units.iter().find(|(name, _)| *name == word).map(|(_, size)| *size).ok_or(UnknownUnits)
        };
        let [length, mass, time] = [find(&LENGTHS, length)?, find(&MASSES, mass)?, find(&TIMES, time)?];
        Ok(Self { length, mass, time, name: lower })
    }
}

impl Units {
    /// Those in which the gravity of a deck is that of the Earth, within 3 %, and its soil weighs between 200
    /// and 5000 kg/m³; `None` unless exactly one set of metric units does so.
    pub(super) fn inferred(gravity: f64, density: f64) -> Option<Self> {
        let mut found = Vec::new();
        for (length, metres) in &LENGTHS[..3] {
            for (mass, kilograms) in &MASSES[..3] {
                for (time, seconds) in &TIMES {
                    let acceleration = gravity * metres / seconds.powi(2);
                    let weighs = density * kilograms / metres.powi(3);
                    if (acceleration / 9.81 - 1.0).abs() < 0.03 && (200.0..=5000.0).contains(&weighs) {
                        let name = format!("{length}-{mass}-{time}");
                        found.push(Self { length: *metres, mass: *kilograms, time: *seconds, name });
                    }
                }
            }
        }
        if found.len() == 1 { found.pop() } else { None }
    }

    /// Unit of speed [m/s].
    pub(super) fn speed(&self) -> f64 {
        self.length / self.time
    }

    /// Unit of acceleration [m/s²].
    pub(super) fn acceleration(&self) -> f64 {
        self.length / self.time.powi(2)
    }

    /// Unit of force [N].
    pub(super) fn force(&self) -> f64 {
        self.mass * self.acceleration()
    }

    /// Unit of stress [Pa].
    pub(super) fn stress(&self) -> f64 {
        self.force() / self.length.powi(2)
    }

    /// Unit of density [kg/m³].
    pub(super) fn density(&self) -> f64 {
        self.mass / self.length.powi(3)
    }
}
