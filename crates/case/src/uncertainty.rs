//! Numbers with a standard deviation: `"35 ± 2 deg"`. The case holds the mean; the standard deviations are
//! returned separately.

use super::keys::{self, Kind};
use input::problem::Problems;
use input::quantity;
use input::tree::{Entry, Value};

/// Keys that may have a standard deviation, by section.
const UNCERTAIN_KEYS: [(&str, &[&str]); 3] = [
    ("soil", &["friction_angle", "unit_weight", "cohesion"]),
    ("body", &["friction", "weight"]),
    ("forecast", &["cone_index"]),
];

/// A standard deviation as the case states it.
#[derive(Clone, Debug, PartialEq)]
pub struct StandardDeviation {
    /// Key of the number, such as `soil.friction_angle`.
    pub key: String,
    /// The standard deviation, in SI units.
    pub deviation: f64,
}

/// Replaces every number that has a standard deviation by its mean, and returns the standard deviations.
pub(super) fn separate(root: &mut [Entry], problems: &mut Problems) -> Vec<StandardDeviation> {
    let mut deviations = Vec::new();
    for entry in root.iter_mut() {
        let section = entry.key.clone();
        let Value::Table(inner) = &mut entry.value else { continue };
        if section == "body" {
            for body in inner.iter_mut() {
                let path = format!("body.{}", body.key);
                if let Value::Table(fields) = &mut body.value {
                    separate_section("body", &path, fields, problems, &mut deviations);
                }
            }
        } else {
            separate_section(&section, &section, inner, problems, &mut deviations);
        }
    }
    deviations
}

fn separate_section(
    section: &str,
    path: &str,
    fields: &mut [Entry],
    problems: &mut Problems,
    deviations: &mut Vec<StandardDeviation>,
) {
    let Some((_, names)) = UNCERTAIN_KEYS.iter().find(|(name, _)| *name == section) else { return };
    for field in fields.iter_mut().filter(|f| names.contains(&f.key.as_str())) {
        let Value::Text(text) = &field.value else { continue };
        let Some((mean, deviation)) = split(text) else { continue };
        let key = format!("{path}.{}", field.key);
        match read(section, &field.key, mean, deviation) {
            Ok((value, deviation)) => {
                field.value = value;
                deviations.push(StandardDeviation { key, deviation });
            }
            Err(why) => complain(&key, &why, problems),
        }
    }
}

fn complain(key: &str, why: &str, problems: &mut Problems) {
    let cure = "write a mean and a standard deviation above 0, such as \"35 ± 2 deg\"";
    problems.add(key, format!("{key}: {why}"), cure);
}

/// Mean and deviation as typed.
fn split(text: &str) -> Option<(&str, &str)> {
    let (mean, deviation) = text.split_once('±').or_else(|| text.split_once("+-"))?;
    Some((mean.trim(), deviation.trim()))
}

/// The mean as the key wants it, and the standard deviation in SI units.
fn read(section: &str, key: &str, mean: &str, deviation: &str) -> Result<(Value, f64), String> {
    let known = keys::find(section).and_then(|s| s.keys.iter().find(|k| k.name == key));
    let (value, deviation) = match known.map(|k| k.kind) {
        Some(Kind::Quantity(measure)) => {
            let deviation_si = quantity::parse(deviation, &measure).map_err(|e| e.to_string())?;
            // The unit is written once, after both: "35 ± 2 deg".
            let (_, unit) = quantity::split_number(deviation);
            let has_unit = !quantity::split_number(mean).1.trim().is_empty();
            (
                Value::Text(if has_unit { mean.to_owned() } else { format!("{mean} {}", unit.trim()) }),
                deviation_si,
            )
        }
        _ => {
            let number = |text: &str| text.parse::<f64>().map_err(|_| format!("`{text}` is not a number"));
            (Value::Number(number(mean)?), number(deviation)?)
        }
    };
    if deviation > 0.0 && deviation.is_finite() {
        Ok((value, deviation))
    } else {
        Err("the standard deviation must be above 0".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Case;
    use super::super::load::parse_with_deviations;
    use super::*;
    use input::CaseError;
    use input::problem::Problems;

    const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");

    fn with(overrides: &[&str]) -> Result<(Case, Vec<StandardDeviation>), CaseError> {
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        parse_with_deviations(TOWED_DISC, "case.toml", &overrides, Problems::default())
    }

    #[test]
    fn the_case_holds_the_mean() {
        let (plain, none) = with(&[]).unwrap();
        assert!(none.is_empty());
        let stated = [
            "soil.friction_angle=35 ± 2 deg",
            "soil.unit_weight=16 ± 5e-1 kN/m^3",
            "body.disc.friction=\"0.3 ± 0.05\"",
            "body.disc.weight=\"40 N +- 2 N\"",
        ];
        let (case, deviations) = with(&stated).unwrap();
        assert_eq!(case, plain);
        let keys: Vec<&str> = deviations.iter().map(|d| d.key.as_str()).collect();
        assert_eq!(
            keys,
            ["soil.friction_angle", "soil.unit_weight", "body.disc.friction", "body.disc.weight"]
        );
        let expected = [2_f64.to_radians(), 500.0, 0.05, 2.0];
        for (found, expected) in deviations.iter().zip(expected) {
            assert!((found.deviation - expected).abs() < 1e-9 * expected, "{found:?}");
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for text in
            ["35 ± 0 deg", "35 ± deg", "± 2 deg", "35 ± 2", "35 ± 2 m", "35 ± -2 deg", "35 ± 2 ± 1 deg"]
        {
            assert!(with(&[&format!("soil.friction_angle={text}")]).is_err(), "{text}");
        }
        assert!(with(&["soil.poisson_ratio=\"0.3 ± 0.1\""]).is_err());
        assert!(with(&["soil.young_modulus=5 ± 1 MPa"]).is_err());
    }
}
