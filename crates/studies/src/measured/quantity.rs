//! What a column of a measured curve can be: its names, its unit, and whether curves run along it.

use coulter::case::quantity::{
    ANGLE, FORCE, LENGTH, Measure, SPEED, STRESS, TIME, TORQUE, TURN_RATE, unit_size,
};
use coulter::case::table_file::plain_name;

/// A quantity of a curve; values are in SI units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// Time [s].
    Time,
    /// Displacement u along the tow [m].
    Displacement,
    /// Sinkage z [m], positive downwards.
    Sinkage,
    /// Slip s, −1 locked, 0 rolling.
    Slip,
    /// Drag F_H [N].
    Drag,
    /// Vertical force F_V [N].
    Vertical,
    /// Lateral force [N].
    Lateral,
    /// Torque of the soil about the axle [N m]; of a body that is driven in yaw, the moment against which it
    /// turns about z.
    Torque,
    /// Pressure under a plate or on the base of a cone [Pa]: the vertical force over the area.
    Pressure,
    /// Speed v [m/s].
    Speed,
    /// Rotation Ω about the axle [rad].
    Rotation,
    /// Rate of rotation ω [rad/s].
    Spin,
    /// Moment of the soil about the x axis of space through the reference point [N m].
    MomentX,
    /// Moment about y [N m].
    MomentY,
    /// Moment about z [N m].
    MomentZ,
}

/// One quantity: its name in files, its aliases, its unit, its symbol, what it measures.
struct Entry {
    quantity: Quantity,
    names: &'static [&'static str],
    unit: &'static str,
    label: &'static str,
    /// `None` for a plain number.
    measure: Option<Measure>,
}

const fn entry(
    quantity: Quantity,
    names: &'static [&'static str],
    unit: &'static str,
    label: &'static str,
    measure: Option<Measure>,
) -> Entry {
    Entry { quantity, names, unit, label, measure }
}

/// Every quantity; the first of its names is the one that is written.
const ALL: [Entry; 15] = [
    entry(Quantity::Time, &["time", "t"], "s", "time t", Some(TIME)),
    entry(
        Quantity::Displacement,
        &["displacement", "displacement u", "u", "travel", "distance", "x"],
        "m",
        "displacement u",
        Some(LENGTH),
    ),
    entry(
        Quantity::Sinkage,
        &[
            "sinkage",
            "sinkage z",
            "z",
            "depth",
            "penetration",
            "penetration depth",
            "indentation",
            "settlement",
        ],
        "m",
        "sinkage z",
        Some(LENGTH),
    ),
    entry(Quantity::Slip, &["slip", "slip ratio", "s"], "-", "slip s", None),
    entry(
        Quantity::Drag,
        &[
            "drag",
            "drag F_H",
            "F_H",
            "horizontal",
            "horizontal force",
            "draught",
            "draught force",
            "draft",
            "draft force",
            "pull",
        ],
        "N",
        "drag F_H",
        Some(FORCE),
    ),
    entry(
        Quantity::Vertical,
        &[
            "vertical",
            "vertical F_V",
            "F_V",
            "vertical force",
            "vertical load",
            "force",
            "load",
            "normal force",
            "normal load",
            "axial force",
            "axial load",
        ],
        "N",
        "vertical force F_V",
        Some(FORCE),
    ),
    entry(Quantity::Lateral, &["lateral", "lateral force", "side force"], "N", "lateral force", Some(FORCE)),
    entry(Quantity::Torque, &["axle torque", "torque", "moment", "M"], "N m", "axle torque M", Some(TORQUE)),
    entry(
        Quantity::Pressure,
        &[
            "pressure",
            "p",
            "cone resistance",
            "q_c",
            "cone index",
            "tip resistance",
            "penetration resistance",
            "contact pressure",
        ],
        "Pa",
        "pressure p",
        Some(STRESS),
    ),
    entry(Quantity::Speed, &["speed", "v", "velocity"], "m/s", "speed v", Some(SPEED)),
    entry(Quantity::Rotation, &["rotation"], "rad", "rotation Ω", Some(ANGLE)),
    entry(Quantity::Spin, &["spin", "omega", "ω"], "rad/s", "rate of rotation ω", Some(TURN_RATE)),
    entry(Quantity::MomentX, &["moment x", "M_x", "torque x"], "N m", "moment about x M_x", Some(TORQUE)),
    entry(Quantity::MomentY, &["moment y", "M_y", "torque y"], "N m", "moment about y M_y", Some(TORQUE)),
    entry(Quantity::MomentZ, &["moment z", "M_z", "torque z"], "N m", "moment about z M_z", Some(TORQUE)),
];

/// The name of the quantity, and whether the column holds standard deviations of it: `drag sd`, `drag ±`.
pub(super) fn split_deviation(name: &str) -> (&str, bool) {
    for mark in ["±", "+-", " sd", "_sd", " SD", "_SD", " standard deviation"] {
        if let Some(base) = name.strip_suffix(mark) {
            return (base.trim(), true);
        }
    }
    (name, false)
}

impl Quantity {
    /// Every quantity.
    pub fn all() -> impl Iterator<Item = Self> {
        ALL.iter().map(|entry| entry.quantity)
    }

    /// The quantity with this name or alias, whatever its case and the marks between its words: `q_c`, `qc`,
    /// `cone_resistance`.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let plain = plain_name(name);
        let is_meant = |known: &str| plain_name(known) == plain;
        ALL.iter().find(|entry| entry.names.iter().any(|known| is_meant(known))).map(|entry| entry.quantity)
    }

    /// Every name and alias.
    pub fn names() -> impl Iterator<Item = &'static str> {
        ALL.iter().flat_map(|entry| entry.names.iter().copied())
    }

    /// Names and aliases of the quantity.
    #[must_use]
    pub fn aliases(self) -> &'static [&'static str] {
        self.entry().names
    }

    fn entry(self) -> &'static Entry {
        // Entries are in the order of the variants, which a test asserts.
        &ALL[self as usize]
    }

    /// Name of the quantity in files, such as `drag`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.entry().names[0]
    }

    /// SI unit of the quantity, such as `N`.
    #[must_use]
    pub fn unit(self) -> &'static str {
        self.entry().unit
    }

    /// Name of the quantity in charts, such as `drag F_H`.
    #[must_use]
    pub fn label(self) -> &'static str {
        self.entry().label
    }

    /// Name and unit, such as `drag [N]`.
    #[must_use]
    pub fn header(self) -> String {
        format!("{} [{}]", self.name(), self.unit())
    }

    /// Whether curves run along the quantity: time, displacement, sinkage, slip.
    #[must_use]
    pub fn is_abscissa(self) -> bool {
        self <= Self::Slip
    }

    /// Whether the quantity is a force, a torque or a pressure.
    #[must_use]
    pub fn is_load(self) -> bool {
        (Self::Drag..=Self::Pressure).contains(&self)
    }

    /// How many SI units a unit is.
    ///
    /// # Errors
    /// What is wrong with the unit, in words.
    pub fn factor(self, unit: &str) -> Result<f64, String> {
        let Some(measure) = self.entry().measure else {
            return match unit.trim() {
                "-" | "" | "1" => Ok(1.0),
                "%" => Ok(0.01),
                other => Err(format!("[{other}] is a unit, but {} is a plain number", self.name())),
            };
        };
        unit_size(unit, &measure)
    }

    /// A unit in which the quantity may be given, for messages.
    #[must_use]
    pub fn example(self) -> &'static str {
        match self.entry().measure {
            _ if self == Self::Pressure => "kPa",
            Some(measure) if measure.name == TORQUE.name => "N m",
            Some(measure) => measure.example.split_once(' ').map_or("", |(_, unit)| unit),
            None => "-",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_in_the_order_of_the_variants() {
        for (n, quantity) in Quantity::all().enumerate() {
            assert_eq!(quantity as usize, n);
            assert!(quantity.factor(quantity.unit()).unwrap() == 1.0, "{quantity:?}");
            assert!(quantity.factor(quantity.example()).is_ok(), "{quantity:?}");
        }
    }

    #[test]
    fn no_name_means_two_quantities() {
        let mut names: Vec<String> = Quantity::names().map(plain_name).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
