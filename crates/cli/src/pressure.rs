//! `coulter pressure`: passive pressure coefficients of a plane face, by every method.

use crate::common::{say, say_json};
use crate::failure::Failure;
use analytic::earth_pressure::{Comparison, Face, PassiveField, compare};
use analytic::error::ModelResult;
use coulter::case::quantity::{self, ANGLE, short};
use coulter::formats;
use serde_json::{Map, Value, json};
use std::fmt::Write;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Friction angle φ of the soil
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    friction_angle: String,
    /// Friction angle δ between face and soil; positive when the face exerts a downward shear force on the
    /// soil
    #[arg(long, value_name = "ANGLE", default_value = "0 deg", allow_hyphen_values = true)]
    wall_friction: String,
    /// Inclination α of the face to the horizontal: 90 deg is a vertical wall, a smaller angle overhangs the
    /// soil
    #[arg(long, value_name = "ANGLE", default_value = "90 deg", allow_hyphen_values = true)]
    surface: String,
    /// Inclination β of the ground in front of the face, positive when it rises
    #[arg(long, value_name = "ANGLE", default_value = "0 deg", allow_hyphen_values = true)]
    backfill: String,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

/// One method: its names in JSON and in the table, and its result.
struct Entry {
    key: &'static str,
    name: &'static str,
    answer: ModelResult<f64>,
}

pub(super) fn pressure(arguments: &Arguments) -> Result<(), Failure> {
    let face = Face {
        friction_angle: angle("--friction-angle", &arguments.friction_angle)?,
        wall_friction: angle("--wall-friction", &arguments.wall_friction)?,
        surface: angle("--surface", &arguments.surface)?,
        backfill: angle("--backfill", &arguments.backfill)?,
    };
    face.check().map_err(|why| Failure::Request(why.to_string()))?;
    let comparison = compare(&face);
    if arguments.json { say_json(&document(&comparison)) } else { table(&face, &comparison) }
}

fn angle(option: &str, text: &str) -> Result<f64, Failure> {
    quantity::parse(text, &ANGLE)
        .map_err(|why| Failure::Request(format!("{option}: {why}; write it such as \"33 deg\"")))
}

fn entries(found: &Comparison) -> [Entry; 6] {
    let field = found.sokolovskii.clone().map(|f| f.coefficient);
    [
        Entry { key: "rankine", name: "Rankine", answer: found.rankine.clone() },
        Entry { key: "coulomb", name: "Coulomb", answer: found.coulomb.clone() },
        Entry { key: "lancellotta", name: "Lancellotta", answer: found.lancellotta.clone() },
        Entry { key: "en1997", name: "EN 1997-1", answer: found.en1997.clone() },
        Entry { key: "sokolovskii", name: "Sokolovskii", answer: field },
        Entry { key: "log_spiral", name: "log spiral", answer: found.log_spiral.clone() },
    ]
}

fn document(found: &Comparison) -> Value {
    let (mut coefficients, mut reasons) = (Map::new(), Map::new());
    for Entry { key, answer, .. } in entries(found) {
        if let Err(why) = &answer {
            reasons.insert(key.into(), json!(why.to_string()));
        }
        coefficients.insert(key.into(), json!(answer.ok()));
    }
    if let Ok(PassiveField { coefficient, rupture_ratio }) = &found.sokolovskii {
        coefficients
            .insert("sokolovskii".into(), json!({ "K_n": coefficient, "rupture_ratio": rupture_ratio }));
    }
    coefficients.insert("format".into(), json!(formats::DOCUMENT));
    coefficients.insert("reasons".into(), Value::Object(reasons));
    Value::Object(coefficients)
}

fn table(face: &Face, found: &Comparison) -> Result<(), Failure> {
    let mut text = format!(
        "φ = {}°, δ = {}°, α = {}°, β = {}°\nnormal thrust P_n = ½ γ L² K_n\n\n{:<14} {:>9}\n",
        short(face.friction_angle.to_degrees()),
        short(face.wall_friction.to_degrees()),
        short(face.surface.to_degrees()),
        short(face.backfill.to_degrees()),
        "method",
        "K_n"
    );
    // Writing to a string cannot fail.
    for Entry { name, answer, .. } in entries(found) {
        let _ = match answer {
            Ok(coefficient) => writeln!(text, "{name:<14} {coefficient:>9.4}"),
            Err(why) => writeln!(text, "{name:<14} {:>9}  {why}", "–"),
        };
    }
    if let Ok(field) = &found.sokolovskii {
        let _ = writeln!(text, "\nthe ground fails up to {:.3} face lengths away", field.rupture_ratio);
    }
    say(&text)
}
