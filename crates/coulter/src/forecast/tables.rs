//! The forecast as text for a terminal.

use super::outlook::{Outlook, mechanism_word};
use super::uncertainty::{InputDeviation, Intervals};
use analytic::disc::{Drive, Mechanism};
use analytic::forecast::{Load, ModelForecast, Prediction, Strength};
use input::quantity::short;
use input::text::wrapped;
use std::fmt::Write;

/// The forecast as text for a terminal.
#[must_use]
pub fn table(outlook: &Outlook, intervals: &Intervals) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = heading(&mut text, outlook);
    let (forces, depths) = if outlook.sinks() { ("", "5–95 %") } else { ("5–95 %", "") };
    let _ = writeln!(
        text,
        "\n{:<22} {:>8} {:^17} {:>8} {:^17} {:>7} {:^15} {:>6} {:>6} {:>7} {:>8} {:>8}  mechanism",
        "model",
        "F_H [N]",
        "5–95 %",
        "F_V [N]",
        forces,
        "z [mm]",
        depths,
        "θ_f [°]",
        "η [°]",
        "slip",
        "F̄_H",
        "F̄_V"
    );
    let (good, bad): (Vec<_>, Vec<_>) = outlook.forecast.models.iter().partition(|m| m.applicable);
    for model in good {
        let _ = writeln!(text, "{}", line(outlook, intervals, model));
    }
    if !intervals.list.is_empty() {
        let _ = writeln!(text, "{}", wrapped(&meaning_of_intervals(intervals)));
    }
    if let Some(warning) = unanswered(intervals) {
        let _ = writeln!(text, "{}", wrapped(&warning));
    }
    let _ = writeln!(text, "\ndo not apply here:");
    let (shown, without_answer): (Vec<_>, Vec<_>) = bad.iter().partition(|m| m.prediction.is_some());
    for model in shown {
        let _ = writeln!(text, "{}\n    {}", line(outlook, intervals, model), model.note);
    }
    for group in without_answer.chunk_by(|a, b| a.note == b.note) {
        let names: Vec<&str> = group.iter().map(|m| m.name).collect();
        let _ = writeln!(text, "{}\n    {}", names.join(", "), group[0].note);
    }
    if let Some(under_water) = &outlook.under_water {
        text += &under_water.text(&outlook.forecast, outlook.sinks());
    }
    let _ = closing(&mut text, outlook);
    text
}

/// The meaning of the columns of intervals.
fn meaning_of_intervals(intervals: &Intervals) -> String {
    let of = |s: &InputDeviation| {
        let (size, unit) = (s.variable.size, s.variable.unit);
        let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
        format!("{} {} ± {}{unit}", s.variable.label, short(s.mean / size), short(s.deviation / size))
    };
    let inputs = intervals.inputs.iter().map(of).collect::<Vec<_>>().join(", ");
    let whose = if intervals.assumed { "assumed" } else { "stated" };
    let cure = if intervals.assumed {
        " (state others in the case, as in \"35 ± 2 deg\", or with --uncertainty --spread)"
    } else {
        ""
    };
    format!(
        "5–95 %: with {whose} uncertainties of the input, {inputs}{cure}, and the error of the model itself: its resistance is taken \
         to be right within {}",
        errors(intervals)
    )
}

/// The errors of the models, as factors of one standard deviation; there is at least one interval.
fn errors(intervals: &Intervals) -> String {
    let all = || intervals.list.iter().map(|i| i.model_error.exp());
    let (least, most) = (all().fold(f64::INFINITY, f64::min), all().fold(1.0, f64::max));
    if least < most {
        format!("a factor of {least:.2} to {most:.2}, by model (one standard deviation)")
    } else {
        format!("a factor of {most:.2} (one standard deviation)")
    }
}

/// Fraction of samples without an answer from which an interval is called open.
const MANY_UNANSWERED: f64 = 0.05;

/// The models many of whose samples have no answer, and what that means for their intervals.
fn unanswered(intervals: &Intervals) -> Option<String> {
    let mut models: Vec<String> = intervals
        .list
        .iter()
        .filter(|i| i.refused > MANY_UNANSWERED)
        .map(|i| format!("{:.0} % of the samples of {}", 100.0 * i.refused, i.model))
        .collect();
    models.dedup();
    (!models.is_empty()).then(|| {
        format!(
            "without an answer: {}. Where the soil does not carry the body in them it digs in: the upper end of the interval is open",
            models.join(", ")
        )
    })
}

fn heading(text: &mut String, outlook: &Outlook) -> std::fmt::Result {
    let towing = &outlook.input.towing;
    let vertical = match towing.load {
        Load::Weight(weight) => format!("free to sink under {} N", short(weight)),
        Load::Sinkage(z) => format!("held at a sinkage of {} mm", short(1e3 * z)),
    };
    let axle = match towing.drive {
        _ if towing.pressed => "pressed straight down".to_owned(),
        Drive::Locked if towing.body.disc().is_none() => "not rotating".to_owned(),
        Drive::Free => "free to rotate".to_owned(),
        Drive::Locked => "locked".to_owned(),
        Drive::Braked(torque) => format!("braked with {} N m", short(torque)),
        Drive::Driven(torque) => format!("driven with {} N m", short(torque)),
        Drive::Slip(slip) => format!("rotated at a slip of {}", short(slip)),
    };
    writeln!(text, "{}: {}, {vertical}, {axle}", outlook.case, outlook.input.bodies.join(", "))?;
    let g = &outlook.forecast.groups;
    let mut list = format!("t̄ = {}", short(g.thickness));
    let known = [
        ("W̄", g.weight),
        ("Z", g.sinkage),
        ("Ē", g.stiffness),
        ("c̄", g.cohesion),
        ("γtd² [N]", outlook.force_scale()),
    ];
    for (name, value) in known {
        if let Some(value) = value {
            write!(list, ", {name} = {}", short(value))?;
        }
    }
    writeln!(text, "{list}")?;
    for remark in &outlook.input.remarks {
        writeln!(text, "{}", wrapped(&format!("note: {remark}")))?;
    }
    Ok(())
}

fn line(outlook: &Outlook, intervals: &Intervals, model: &ModelForecast) -> String {
    let found = model.prediction;
    let shown = |value: Option<f64>, width: usize| match value {
        Some(value) => format!("{:>width$}", fixed(value)),
        None => format!("{:>width$}", "–"),
    };
    let range = |quantity: &str, size: f64, width: usize| match intervals.of(model.name, quantity) {
        // A model that does not depend on the uncertain inputs.
        Some(i) if i.high - i.low <= 1e-9 * i.middle.abs() => format!("{:^width$}", "unchanged"),
        Some(i) => format!("{:^width$}", format!("{} … {}", fixed(i.low / size), fixed(i.high / size))),
        None => " ".repeat(width),
    };
    let of = |name: &str| outlook.predicted(model, name);
    let columns = [
        shown(of("drag"), 8),
        range("drag_N", 1.0, 17),
        shown(of("vertical"), 8),
        range("vertical_N", 1.0, 17),
        shown(of("sinkage").map(|z| 1e3 * z), 7),
        range("sinkage_m", 1e-3, 15),
        shown(of("contact_angle").map(f64::to_degrees), 6),
        shown(of("force_inclination").map(f64::to_degrees), 6),
        shown(of("slip"), 7),
        shown(of("F_H_bar"), 8),
        shown(of("F_V_bar"), 8),
    ];
    format!("{:<22} {}  {}", model.name, columns.join(" "), found.map_or("–".into(), |p| mechanism(&p)))
}

/// Four significant digits, with trailing zeros, so that columns line up.
fn fixed(value: f64) -> String {
    // What rounds to nothing has no sign.
    let value = if value.abs() < 0.5e-4 { 0.0 } else { value };
    let digits = if value == 0.0 { 1 } else { 3 - value.abs().log10().floor() as i32 };
    format!("{value:.*}", digits.clamp(0, 4) as usize)
}

/// The failure mechanism, with its fraction of the thrust where two are combined.
fn mechanism(found: &Prediction) -> String {
    match (found.mechanism, found.sideways_fraction) {
        (Some(mechanism), Some(sideways)) => {
            let fraction = if mechanism == Mechanism::Sideways { sideways } else { 1.0 - sideways };
            let word = mechanism_word(mechanism);
            if fraction > 0.995 { word.to_owned() } else { format!("{word} {:.0} %", 100.0 * fraction) }
        }
        _ => "–".to_owned(),
    }
}

fn closing(text: &mut String, outlook: &Outlook) -> std::fmt::Result {
    let forecast = &outlook.forecast;
    if let Some(spread) = forecast.scatter.as_ref().filter(|s| s.count > 1) {
        let other = match spread.sinkage.filter(|_| outlook.sinks()) {
            Some(z) => format!("sinkage {:.2} to {:.2} mm", 1e3 * z.low, 1e3 * z.high),
            None => format!("vertical force {:.3} to {:.3} N", spread.vertical.low, spread.vertical.high),
        };
        let drag = if outlook.input.towing.pressed {
            String::new()
        } else {
            format!("drag {:.3} to {:.3} N, ", spread.drag.low, spread.drag.high)
        };
        write!(text, "\nrange of {} models: {drag}{other}", spread.count)?;
        writeln!(text, " (they are not independent, so this is not a confidence interval)")?;
    }
    other_strength(text, outlook)?;
    sideways(text, outlook)?;
    if let Some(faces) = &forecast.side_faces {
        writeln!(
            text,
            "friction on the flat faces, which no model includes: drag {:.3} N, vertical force {:.3} N",
            faces.drag, faces.vertical
        )?;
    }
    writeln!(text, "\n{}", wrapped(&forecast.recommendation))
}

/// Lateral force and moments, of the models that give them.
fn sideways(text: &mut String, outlook: &Outlook) -> std::fmt::Result {
    for model in &outlook.forecast.models {
        let lateral = model.prediction.and_then(|found| found.lateral);
        let Some((lateral, [x, y, z])) = lateral.zip(outlook.moment(model)) else { continue };
        writeln!(
            text,
            "{}: lateral force {lateral:.3} N; moments about x, y, z through the centre {x:.3}, {y:.3}, {z:.3} N m",
            model.name
        )?;
    }
    Ok(())
}

/// What the recommended model says at the other friction angle, where ψ < φ.
fn other_strength(text: &mut String, outlook: &Outlook) -> std::fmt::Result {
    let forecast = &outlook.forecast;
    let other = forecast.models_other_strength.iter().find(|m| Some(m.model) == forecast.recommended);
    let Some(found) = other.filter(|m| m.model.is_plastic()).and_then(|m| m.prediction) else {
        return Ok(());
    };
    let full = outlook.input.towing.soil.friction_angle.to_degrees();
    let davis = forecast.operative_friction_angle.to_degrees();
    match forecast.strength {
        Strength::Full => write!(
            text,
            "the plasticity models use the full friction angle, {full:.2}°; at Davis' angle, {davis:.2}°: "
        )?,
        Strength::Davis => {
            write!(text, "the plasticity models use Davis' angle, {davis:.2}°; at the full friction angle: ")?
        }
    }
    let mut values = Vec::new();
    if !outlook.input.towing.pressed {
        values.push(format!("drag {:.3} N", found.drag));
    }
    values.push(match found.sinkage.filter(|_| outlook.sinks()) {
        Some(z) => format!("sinkage {:.2} mm", 1e3 * z),
        None => format!("vertical force {:.3} N", found.vertical),
    });
    writeln!(text, "{}", values.join(", "))
}

/// The intervals in full as text for a terminal.
#[must_use]
pub fn uncertainty_table(intervals: &Intervals) -> String {
    let mut text = String::from(
        "\nuncertainty (Gaussian inputs, standard deviations as stated; the error of each model, log-normal):\n",
    );
    for s in &intervals.inputs {
        let (size, unit) = (s.variable.size, s.variable.unit);
        let _ = writeln!(text, "  {} = {:.5} ± {:.4} [{unit}]", s.key, s.mean / size, s.deviation / size);
    }
    let inputs =
        intervals.inputs.iter().map(|s| format!("{:>16}", s.key.rsplit('.').next().unwrap_or(&s.key)));
    let with_thrust = intervals
        .list
        .iter()
        .any(|i| i.first_order.len() > intervals.inputs.len() + 1)
        .then_some("its thrust");
    let of_model = ["model itself"].into_iter().chain(with_thrust);
    let inputs = inputs.chain(of_model.map(|name| format!("{name:>16}")));
    let _ = writeln!(
        text,
        "\n{:<22} {:<12} {:>8} {:>8} {:>8}   first-order Sobol index of\n{:<62} {}   evaluations",
        "model",
        "quantity",
        "5 %",
        "50 %",
        "95 %",
        "",
        inputs.collect::<Vec<_>>().join(" ")
    );
    for i in &intervals.list {
        let (name, size) = match i.quantity {
            "sinkage_m" => ("z [mm]", 1e-3),
            "vertical_N" => ("F_V [N]", 1.0),
            _ => ("F_H [N]", 1.0),
        };
        let [low, middle, high] = [i.low, i.middle, i.high].map(|x| fixed(x / size));
        let indices: Vec<String> = i.first_order.iter().map(|index| format!("{index:>16.3}")).collect();
        let refused = if i.refused > 0.0 {
            format!(", {:.1} % of them without an answer and left out", 100.0 * i.refused)
        } else {
            String::new()
        };
        let _ = writeln!(
            text,
            "{:<22} {name:<12} {low:>8} {middle:>8} {high:>8}           {}   {}{refused}",
            i.model,
            indices.join(" "),
            i.evaluations
        );
    }
    text
}
