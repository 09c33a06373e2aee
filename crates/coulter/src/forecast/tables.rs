//! The forecast as text: what is told on the terminal, and the table that is written to a file.

use super::{Interval, Outlook, Stated, mechanism_word};
use analytic::disc::Drive;
use analytic::forecast::{Load, ModelForecast};
use std::fmt::Write;

/// Header of `models.csv`.
const HEADER: &str = "model,applicable,drag F_H [N],vertical F_V [N],sinkage z [m],contact angle [deg],\
force inclination [deg],skid [-],mechanism,F_H_bar [-],F_V_bar [-],Z [-],note";

/// The forecast as text for a terminal.
#[must_use]
pub fn table(outlook: &Outlook) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = heading(&mut text, outlook);
    let _ = writeln!(
        text,
        "\n{:<22} {:>10} {:>10} {:>8} {:>8} {:>8} {:>7} {:>7} {:>7}  mechanism",
        "model", "F_H [N]", "F_V [N]", "z [mm]", "θ_f [°]", "η [°]", "skid", "F̄_H", "F̄_V"
    );
    let (good, bad): (Vec<_>, Vec<_>) = outlook.forecast.models.iter().partition(|m| m.applicable);
    for model in good {
        let _ = writeln!(text, "{}", line(outlook, model));
    }
    let _ = writeln!(text, "\ndo not apply here:");
    for model in bad {
        let number = if model.prediction.is_some() { line(outlook, model) } else { model.name.to_owned() };
        let _ = writeln!(text, "{number}\n    {}", model.note);
    }
    let _ = closing(&mut text, outlook);
    text
}

fn heading(text: &mut String, outlook: &Outlook) -> std::fmt::Result {
    let towing = &outlook.setting.towing;
    let pressed = match towing.load {
        Load::Weight(weight) => format!("free to sink under {weight:.4} N"),
        Load::Sinkage(z) => format!("held at a sinkage of {:.4} mm", 1e3 * z),
    };
    let axle = match towing.drive {
        Drive::Free => "free to turn".to_owned(),
        Drive::Locked => "locked".to_owned(),
        Drive::Braked(torque) => format!("braked with {torque:.4} N m"),
        Drive::Driven(torque) => format!("driven with {torque:.4} N m"),
        Drive::Slip(slip) => format!("turned at the slip {slip:.4}"),
    };
    writeln!(text, "{}: {}, {pressed}, {axle}", outlook.case, outlook.setting.discs.join(", "))?;
    let g = &outlook.forecast.groups;
    let mut list = format!("t̄ = {:.4}", g.thickness);
    let known = [
        ("W̄", g.weight),
        ("Z", g.sinkage),
        ("Ē", g.stiffness),
        ("c̄", Some(g.cohesion)),
        ("γtd² [N]", Some(outlook.force_scale())),
    ];
    for (name, value) in known {
        if let Some(value) = value {
            write!(list, ", {name} = {value:.4}")?;
        }
    }
    writeln!(text, "{list}")?;
    for remark in &outlook.setting.remarks {
        writeln!(text, "note: {remark}")?;
    }
    Ok(())
}

fn line(outlook: &Outlook, model: &ModelForecast) -> String {
    let found = model.prediction;
    let shown = |value: Option<f64>, width: usize, decimals: usize| match value {
        Some(value) => format!("{value:>width$.decimals$}"),
        None => format!("{:>width$}", "–"),
    };
    let scale = outlook.force_scale();
    let drag = found.map(|p| p.drag);
    let vertical = found.map(|p| p.vertical);
    format!(
        "{:<22} {} {} {} {} {} {} {} {}  {}",
        model.name,
        shown(drag, 10, 3),
        shown(vertical, 10, 3),
        shown(found.and_then(|p| p.sinkage).map(|z| 1e3 * z), 8, 2),
        shown(found.and_then(|p| p.contact_angle).map(f64::to_degrees), 8, 2),
        shown(found.map(|p| p.force_inclination.to_degrees()), 8, 2),
        shown(found.and_then(|p| p.skid), 7, 3),
        shown(drag.map(|f| f / scale), 7, 4),
        shown(vertical.map(|f| f / scale), 7, 4),
        found.and_then(|p| p.mechanism).map_or("–", mechanism_word),
    )
}

fn closing(text: &mut String, outlook: &Outlook) -> std::fmt::Result {
    let forecast = &outlook.forecast;
    if let Some(spread) = &forecast.spread {
        write!(
            text,
            "\nspread over {} models: drag {:.3} to {:.3} N",
            spread.count, spread.drag.low, spread.drag.high
        )?;
        if let Some(z) = spread.sinkage.filter(|_| outlook.sinks()) {
            write!(text, ", sinkage {:.2} to {:.2} mm", 1e3 * z.low, 1e3 * z.high)?;
        } else {
            write!(text, ", vertical force {:.3} to {:.3} N", spread.vertical.low, spread.vertical.high)?;
        }
        writeln!(text, " (not independent: no confidence interval)")?;
    }
    if let Some(full) = forecast.models_full_friction.first().and_then(|m| m.prediction) {
        let angle = forecast.operative_friction_angle.to_degrees();
        write!(
            text,
            "the plasticity models use Davis' angle, {angle:.2}°; at the full friction angle: drag {:.3} N",
            full.drag
        )?;
        match full.sinkage.filter(|_| outlook.sinks()) {
            Some(z) => writeln!(text, ", sinkage {:.2} mm", 1e3 * z)?,
            None => writeln!(text, ", vertical force {:.3} N", full.vertical)?,
        }
    }
    if let Some(faces) = &forecast.side_faces {
        writeln!(
            text,
            "friction on the flat faces, in none of the models: drag {:.3} N, vertical force {:.3} N",
            faces.drag, faces.vertical
        )?;
    }
    writeln!(text, "\n{}", forecast.recommendation)
}

/// The text of `models.csv`: one line per model.
#[must_use]
pub fn models_table(outlook: &Outlook) -> String {
    let mut text = format!("{HEADER}\n");
    let (scale, diameter) = (outlook.force_scale(), outlook.setting.towing.disc.diameter);
    for model in &outlook.forecast.models {
        let found = model.prediction;
        let sinkage = found.and_then(|p| p.sinkage);
        let numbers = [
            found.map(|p| p.drag),
            found.map(|p| p.vertical),
            sinkage,
            found.and_then(|p| p.contact_angle).map(f64::to_degrees),
            found.map(|p| p.force_inclination.to_degrees()),
            found.and_then(|p| p.skid),
        ];
        let groups =
            [found.map(|p| p.drag / scale), found.map(|p| p.vertical / scale), sinkage.map(|z| z / diameter)];
        let fields = |list: &[Option<f64>]| {
            list.iter().map(|x| x.map_or(String::new(), |x| format!("{x:.6e}"))).collect::<Vec<_>>().join(",")
        };
        let word = found.and_then(|p| p.mechanism).map_or("", mechanism_word);
        let note = model.note.replace('"', "'");
        let (name, applicable) = (model.name, model.applicable);
        let _ =
            writeln!(text, "{name},{applicable},{},{word},{},\"{note}\"", fields(&numbers), fields(&groups));
    }
    text
}

/// The intervals as text for a terminal.
#[must_use]
pub fn uncertainty_table(stated: &[Stated], intervals: &[Interval]) -> String {
    let mut text = String::from("\nuncertainty (Gaussian inputs, standard deviations as stated):\n");
    for s in stated {
        let (size, unit) = (s.variable.size, s.variable.unit);
        let _ = writeln!(text, "  {} = {:.5} ± {:.4} [{unit}]", s.key, s.mean / size, s.deviation / size);
    }
    for i in intervals {
        let _ = writeln!(
            text,
            "{}, {}: 5 % {:.5}, 50 % {:.5}, 95 % {:.5}",
            i.model, i.quantity, i.low, i.middle, i.high
        );
        let shares: Vec<String> =
            stated.iter().zip(&i.first_order).map(|(s, share)| format!("{} {share:.3}", s.key)).collect();
        let _ = writeln!(text, "    first-order Sobol indices: {}", shares.join(", "));
        if i.refused > 0.0 {
            let _ = writeln!(text, "    {:.1} % of the samples were refused and left out", 100.0 * i.refused);
        }
    }
    text
}
