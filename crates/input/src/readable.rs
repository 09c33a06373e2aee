//! Numbers as people read them: three digits, and a unit that fits.

/// A unit in which a quantity is shown, and its size in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Symbol of the unit.
    pub name: &'static str,
    /// Size in the SI unit.
    pub size: f64,
}

impl Unit {
    fn pick(largest: f64, choices: &[(&'static str, f64)]) -> Self {
        let fitting = choices.iter().rev().find(|(_, size)| largest >= *size * 0.9999);
        let (name, size) = *fitting.or(choices.first()).unwrap_or(&("", 1.0));
        Self { name, size }
    }

    /// A unit for quantities up to `largest` of this SI unit.
    pub fn of(unit: &'static str, largest: f64) -> Self {
        match unit {
            "N" => Self::force(largest),
            "N m" => Self::torque(largest),
            "m" => Self::length(largest),
            "-" => Self { name: "", size: 1.0 },
            name => Self { name, size: 1.0 },
        }
    }

    /// A unit for lengths up to `largest` [m].
    pub fn length(largest: f64) -> Self {
        Self::pick(largest, &[("mm", 1e-3), ("m", 1.0)])
    }

    /// A unit for forces up to `largest` [N].
    pub fn force(largest: f64) -> Self {
        let unit = Self::pick(largest / 10.0, &[("N", 1.0), ("kN", 1e3), ("MN", 1e6)]);
        if largest < 10.0 { Self { name: "N", size: 1.0 } } else { unit }
    }

    /// A unit for torques up to `largest` [N m].
    pub fn torque(largest: f64) -> Self {
        let force = Self::force(largest);
        let name = match force.name {
            "kN" => "kN m",
            "MN" => "MN m",
            _ => "N m",
        };
        Self { name, ..force }
    }

    /// A unit for stresses up to `largest` [Pa].
    pub fn stress(largest: f64) -> Self {
        Self::pick(largest, &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6)])
    }

    /// A unit for energies up to `largest` [J].
    pub fn energy(largest: f64) -> Self {
        Self::pick(largest / 10.0, &[("J", 1.0), ("kJ", 1e3), ("MJ", 1e6)])
    }

    /// A unit for speeds up to `largest` [m/s].
    pub fn speed(largest: f64) -> Self {
        Self::pick(largest, &[("mm/s", 1e-3), ("m/s", 1.0)])
    }
}

/// Largest finite size among values.
pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.filter(|v| v.is_finite()).fold(0.0, |most, v| most.max(v.abs()))
}

/// A number with three significant digits; a dash where it is not finite.
#[must_use]
pub fn digits(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    // Adding zero turns a negative zero into a positive one.
    let (value, size) = (value + 0.0, value.abs());
    let text = if size != 0.0 && !(1e-3..1e6).contains(&size) {
        format!("{value:.2e}")
    } else {
        let whole = if size > 0.0 { size.log10().floor() as i32 } else { 0 };
        format!("{value:.*}", (2 - whole).clamp(0, 6) as usize)
    };
    text.replace('-', "\u{2212}")
}

/// A quantity with three digits in a unit.
pub fn quantity(value: f64, unit: Unit) -> String {
    format!("{} {}", digits(value / unit.size), unit.name)
}

/// A stress [Pa] with three digits, in a unit that fits.
pub fn stress(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { quantity(value, Unit::stress(value)) }
}

/// An angle [rad] in degrees with three digits.
pub fn degrees(angle: f64) -> String {
    format!("{}°", digits(angle.to_degrees()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_readable() {
        assert_eq!(Unit::length(0.3).name, "mm");
        assert_eq!(Unit::force(500.0).name, "N");
        assert_eq!(Unit::force(25e3).name, "kN");
        assert_eq!(Unit::stress(2.5e4).name, "kPa");
    }
}
