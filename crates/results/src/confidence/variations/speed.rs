//! A variation of the case at half the speed: whatever the case prescribes takes twice as long.

use super::change::{Change, Original};
use case::keys;
use case::resolved::{Case, Law, MOTIONS};
use glam::DVec3;
use input::quantity::{TIME, parse};
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// How much longer everything takes.
pub const LONGER: f64 = 2.0;

/// The case at half the speed.
pub(super) fn half_speed(original: Original) -> Result<Change, String> {
    if let Some(why) = objection(original.case) {
        return Err(why.to_owned());
    }
    let document: DocumentMut =
        original.text.parse().map_err(|_| "its text cannot be changed: it is not TOML".to_owned())?;
    let mut overrides = Vec::new();
    for (name, body) in tables(document.get("body")) {
        motions(&format!("body.{name}"), body, &mut overrides)?;
    }
    let mut changes = overrides.len();
    for (name, stage) in tables(document.get("stage")) {
        let path = format!("stage.{name}");
        for (body, item) in stage.iter() {
            if let Some(table) = item.as_table_like().filter(|_| body != "until") {
                motions(&format!("{path}.{body}"), table, &mut overrides)?;
            }
        }
        scale(&path, stage, ("duration", LONGER), &mut overrides)?;
        changes = overrides.len();
    }
    if changes == 0 {
        return Err("the case prescribes no motion and no load".to_owned());
    }
    for (section, key) in [("run", "duration"), ("output", "history_interval"), ("output", "field_interval")]
    {
        if let Some(table) = document.get(section).and_then(Item::as_table_like) {
            scale(section, table, (key, LONGER), &mut overrides)?;
        }
    }
    Ok(Change { overrides, what: "half the speed".to_owned(), time_factor: LONGER })
}

/// Why the case has no slower counterpart.
fn objection(case: &Case) -> Option<&'static str> {
    let has_rate = |law: &Law| matches!(law, Law::Tresca(clay) if clay.depends_on_rate());
    if case.computes_pore_pressure() {
        Some("the pore water has a time scale of its own, so that the speed is a part of the problem")
    } else if case.soils().any(|(_, soil)| has_rate(&soil.law)) {
        Some(
            "the strength of the soil depends on the rate of shear, so that the speed is a part of the problem",
        )
    } else if case.velocity != DVec3::ZERO {
        Some("the soil has a velocity of its own at the start")
    } else if !case.tables.is_empty() {
        Some("a motion follows a table")
    } else {
        None
    }
}

/// The named tables of a section.
fn tables(section: Option<&Item>) -> impl Iterator<Item = (&str, &dyn TableLike)> {
    let section = section.and_then(Item::as_table_like);
    section.into_iter().flat_map(|s| s.iter()).filter_map(|(name, item)| Some((name, item.as_table_like()?)))
}

/// Overrides for the motions of one body.
fn motions(path: &str, body: &dyn TableLike, overrides: &mut Vec<String>) -> Result<(), String> {
    for (key, motion) in MOTIONS.iter().filter_map(|key| Some((key, body.get(key)?.as_table_like()?))) {
        let path = format!("{path}.{key}");
        if motion.get("slip").is_some() {
            continue;
        }
        scale(&path, motion, ("speed", 1.0 / LONGER), overrides)?;
        for time in ["start", "ramp", "end"] {
            scale(&path, motion, (time, LONGER), overrides)?;
        }
        if motion.get("ramp").is_none() {
            overrides.push(format!("{path}.ramp=\"{} s\"", LONGER * usual_ramp(&path)));
        }
    }
    Ok(())
}

/// The ramp of a motion without one [s].
fn usual_ramp(path: &str) -> f64 {
    let text = keys::at(&format!("{path}.ramp")).map(|key| key.default.text()).unwrap_or_default();
    parse(text.trim_matches(['"', '`']), &TIME).unwrap_or(0.1)
}

/// An override for a number with a unit, times a factor; none where the key is not given.
fn scale(
    path: &str,
    table: &dyn TableLike,
    (key, factor): (&str, f64),
    overrides: &mut Vec<String>,
) -> Result<(), String> {
    let Some(item) = table.get(key) else { return Ok(()) };
    let text = item.as_value().and_then(Value::as_str);
    let scaled = text.and_then(|text| scaled(text, factor));
    let scaled = scaled.ok_or_else(|| format!("{path}.{key} cannot be changed in the text"))?;
    overrides.push(format!("{path}.{key}=\"{scaled}\""));
    Ok(())
}

/// `"0.2 m/s"` times a factor: `"0.1 m/s"`.
fn scaled(text: &str, factor: f64) -> Option<String> {
    let text = text.trim();
    let is_number = |c: char| c.is_ascii_digit() || "+-._eE".contains(c);
    let end = text.find(|c| !is_number(c)).unwrap_or(text.len());
    // `2e` of "2 em" is no number: its digits are.
    let (number, unit) = (1..=end).rev().find_map(|n| Some((text[..n].parse::<f64>().ok()?, &text[n..])))?;
    Some(format!("{}{unit}", number * factor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantity_keeps_its_unit() {
        assert_eq!(scaled("0.2 m/s", 0.5).unwrap(), "0.1 m/s");
        assert_eq!(scaled("-1e-3m/s", 0.5).unwrap(), "-0.0005m/s");
        assert_eq!(scaled(" 3 s ", 2.0).unwrap(), "6 s");
        assert_eq!(scaled("fast", 2.0), None);
    }

    #[test]
    fn the_usual_ramp_is_that_of_the_keys() {
        assert_eq!(usual_ramp("body.disc.forward"), 0.1);
    }
}
