//! `coulter check`: the case as understood, what it will cost, and doubts about it.

use super::{Failure, say, speed};
use crate::case::estimate::{self, Cost};
use crate::case::quantity::plain;
use crate::case::resolved::{Body, Freedom, Law, Measured, Potential, Shape};
use crate::case::room::{self, words};
use crate::case::{self, Case, machine};
use crate::history::reference::Reference;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

/// Warnings that are printed at once.
const MOST_WARNINGS: usize = 20;

/// Dimensionless groups of one body; absent where the soil is weightless.
#[derive(Debug, Serialize)]
struct Groups {
    /// t/d.
    t_bar: f64,
    /// W/(γtd²).
    #[serde(rename = "W_bar")]
    w_bar: Option<f64>,
    /// E/(γd).
    #[serde(rename = "E_bar")]
    e_bar: Option<f64>,
    /// c/(γd), or s_u/(γd).
    c_bar: Option<f64>,
    /// v²/(g d), of the fastest prescribed motion.
    froude: Option<f64>,
}

pub(super) fn check(arguments: &Arguments) -> Result<(), Failure> {
    let case = case::load(&arguments.case, &arguments.overrides)?;
    let cost = estimate::cost(&case);
    let seconds = speed::wall_time(&case, &cost);
    let folder = PathBuf::from("results").join(&case.name);
    let mut warnings = case::advice(&case);
    warnings.extend(room::doubts(&cost, &folder));
    if arguments.json {
        return as_json(&case, &cost, seconds, &warnings);
    }
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = describe(&mut text, &case).and_then(|()| describe_cost(&mut text, &case, &cost, seconds));
    for warning in warnings.iter().take(MOST_WARNINGS) {
        let _ = writeln!(text, "warning  {warning}");
    }
    if let Some(more) = warnings.len().checked_sub(MOST_WARNINGS).filter(|more| *more > 0) {
        let _ = writeln!(text, "warning  … and {more} more; --json tells all");
    }
    say(&text)
}

fn as_json(case: &Case, cost: &Cost, seconds: Option<f64>, warnings: &[String]) -> Result<(), Failure> {
    let groups: serde_json::Map<String, serde_json::Value> =
        case.bodies.iter().map(|b| (b.name.clone(), serde_json::json!(groups(case, b)))).collect();
    let document = serde_json::json!({
        "case": case.name, "groups": groups, "cost": cost, "estimated_wall_s": seconds,
        "memory_available_bytes": machine::memory_available(), "warnings": warnings, "resolved": case,
    });
    let text = serde_json::to_string_pretty(&document).map_err(|e| Failure::Request(e.to_string()))?;
    say(&format!("{text}\n"))
}

fn groups(case: &Case, body: &Body) -> Groups {
    let reference = Reference::of(case, body);
    let (d, t) = (reference.length, reference.width);
    let gamma = case.soil.unit_weight;
    let strength = match case.soil.law {
        Law::MohrCoulomb { cohesion, .. } => Some(cohesion),
        Law::Tresca { shear_strength } => Some(shear_strength),
        Law::VonMises { yield_stress, .. } => Some(0.5 * yield_stress),
        Law::Elastic => None,
    };
    let heavy = |x: f64| (gamma > 0.0).then_some(x / gamma);
    let speed = body.translation.iter().map(prescribed_speed).fold(0.0, f64::max);
    Groups {
        t_bar: t / d,
        w_bar: downward_load(body).and_then(|w| heavy(w / (t * d * d))),
        e_bar: heavy(case.soil.young_modulus / d),
        c_bar: strength.and_then(|c| heavy(c / d)),
        froude: (case.gravity > 0.0).then_some(speed.powi(2) / (case.gravity * d)),
    }
}

fn prescribed_speed(freedom: &Freedom) -> f64 {
    if let Freedom::Prescribed { speed, .. } = freedom { speed.abs() } else { 0.0 }
}

/// The load that presses a body that is free to sink [N].
fn downward_load(body: &Body) -> Option<f64> {
    if let Freedom::Free { load, .. } = body.translation[2] { Some(-load) } else { None }
}

fn describe(text: &mut String, case: &Case) -> std::fmt::Result {
    let soil = &case.soil;
    writeln!(text, "{} ({})", case.title, case.name)?;
    let strength = match soil.law {
        Law::Elastic => "elastic".to_owned(),
        Law::Tresca { shear_strength } => format!("tresca, s_u = {shear_strength} Pa"),
        Law::VonMises { yield_stress, hardening_modulus } => {
            format!("von-mises, σ_y = {yield_stress} Pa, H = {hardening_modulus} Pa")
        }
        Law::MohrCoulomb {
            friction_angle,
            dilation_angle,
            cohesion,
            tension_cutoff,
            potential,
            critical_density,
        } => format!(
            "mohr-coulomb, φ = {:.4}°, ψ = {:.4}°{}, c = {cohesion} Pa, tension up to {tension_cutoff} Pa{}",
            friction_angle.to_degrees(),
            dilation_angle.to_degrees(),
            critical_density.map_or(String::new(), |rho| format!(" down to {rho:.1} kg/m³")),
            match potential {
                Potential::MohrCoulomb => String::new(),
                Potential::MenetreyWillam { meridional, deviatoric } =>
                    format!(", smooth potential (ε = {meridional}, e = {deviatoric:.4})"),
            }
        ),
    };
    writeln!(text, "soil     {strength}")?;
    writeln!(
        text,
        "         γ = {} N/m³, ρ = {:.1} kg/m³, E = {} Pa, ν = {}, K₀ = {:.3}",
        plain(soil.unit_weight),
        soil.density,
        plain(soil.young_modulus),
        plain(soil.poisson_ratio),
        soil.k0
    )?;
    for body in &case.bodies {
        describe_body(text, case, body)?;
    }
    if case.forecast != Measured::default() {
        writeln!(
            text,
            "note     the keys of [forecast] are for `coulter forecast` alone; a run takes no notice of them"
        )?;
    }
    Ok(())
}

fn describe_body(text: &mut String, case: &Case, body: &Body) -> std::fmt::Result {
    let shape = match body.shape {
        Shape::Disc { diameter, thickness } => {
            format!("disc, d = {} m, t = {} m", plain(diameter), plain(thickness))
        }
        Shape::Block { size, orientation } => {
            let turned = if orientation == 0.0 {
                String::new()
            } else {
                format!(", turned {:.1}°", orientation.to_degrees())
            };
            format!("block, {} × {} × {} m{turned}", plain(size.x), plain(size.y), plain(size.z))
        }
        Shape::Cylinder { diameter, length, axis } => {
            format!("cylinder along {axis}, d = {} m, l = {} m", plain(diameter), plain(length))
        }
        Shape::Sphere { diameter } => format!("sphere, d = {} m", plain(diameter)),
    };
    let mut friction =
        if body.friction.is_finite() { format!("μ = {}", body.friction) } else { "rough".into() };
    if body.shear_limit.is_finite() {
        friction += &format!(", at most {} Pa", body.shear_limit);
    }
    writeln!(text, "body     {}: {shape}, {friction}, m = {:.4} kg", body.name, body.mass)?;
    let [forward, lateral, heave] = &body.translation;
    let motions =
        [("forward", forward, "m/s", "N"), ("lateral", lateral, "m/s", "N"), ("heave", heave, "m/s", "N")];
    for (name, freedom, speed, load) in motions.into_iter().chain([("spin", &body.spin, "rad/s", "N m")]) {
        writeln!(text, "         {name:8} {}", describe_freedom(freedom, speed, load))?;
    }
    let groups = groups(case, body);
    let optional =
        [("W̄", groups.w_bar), ("Ē", groups.e_bar), ("c̄", groups.c_bar), ("v²/(gd)", groups.froude)];
    let mut list = format!("t̄ = {:.4}", groups.t_bar);
    for (name, value) in optional {
        if let Some(value) = value {
            write!(list, ", {name} = {value:.4}")?;
        }
    }
    writeln!(text, "         {list}")
}

fn describe_freedom(freedom: &Freedom, speed_unit: &str, load_unit: &str) -> String {
    match *freedom {
        Freedom::Fixed => "fixed".into(),
        Freedom::Prescribed { speed, start, ramp, end } => {
            let until = if end.is_finite() { format!(" until {} s", plain(end)) } else { String::new() };
            format!("{} {speed_unit}, from {} s within {} s{until}", plain(speed), plain(start), plain(ramp))
        }
        Freedom::Free { load: 0.0, .. } => "free".into(),
        Freedom::Free { load, start, ramp } => {
            format!("free, load {load:.4} {load_unit} from {} s within {} s", plain(start), plain(ramp))
        }
    }
}

fn describe_cost(text: &mut String, case: &Case, cost: &Cost, seconds: Option<f64>) -> std::fmt::Result {
    let [nx, ny, nz] = std::array::from_fn(|axis| case.grid.faces[axis].len().saturating_sub(1));
    let (low, high) = (case.domain.low, case.domain.high);
    let kind = match (case.domain.plane_strain, case.domain.share()) {
        (true, 1.0) => ", plane strain",
        (true, _) => ", plane strain, symmetric half",
        (false, 1.0) => "",
        (false, 0.5) => ", symmetric half",
        (false, _) => ", symmetric quarter",
    };
    writeln!(
        text,
        "box      x {} to {} m, y {} to {} m, z {} to {} m{kind}",
        plain(low.x),
        plain(high.x),
        plain(low.y),
        plain(high.y),
        plain(low.z),
        plain(high.z)
    )?;
    writeln!(
        text,
        "grid     {nx} × {ny} × {nz} = {} cells of {} mm and more, {} with soil",
        cost.estimate.cells,
        finest(case),
        cost.estimate.filled_cells
    )?;
    let memory = &cost.memory;
    writeln!(
        text,
        "memory   {}: grid {}, contact points {}, outputs {}, program {}",
        words(cost.memory_bytes),
        words(memory.grid_bytes),
        words(memory.contact_bytes),
        words(memory.outputs_bytes),
        words(memory.program_bytes)
    )?;
    let output = &cost.output;
    writeln!(
        text,
        "results  {}: fields {} in {} files, histories {}, checkpoints {}",
        words(output.total_bytes),
        words(output.fields_bytes),
        output.frames,
        words(output.histories_bytes),
        words(output.checkpoints_bytes)
    )?;
    writeln!(
        text,
        "time     {:.4} s in {} steps of {:.3e} s (waves run at {:.1} m/s)",
        case.duration, cost.estimate.steps, cost.estimate.time_step_s, cost.estimate.wave_speed_m_per_s
    )?;
    match seconds {
        Some(seconds) => writeln!(text, "run time about {seconds:.0} s on this machine"),
        None => {
            writeln!(text, "run time {:.3e} cell steps", cost.estimate.steps * cost.estimate.filled_cells)
        }
    }
}

/// The smallest widths of the cells along x, y, z [mm]; one number where they are the same.
fn finest(case: &Case) -> String {
    let widths = case.grid.faces.each_ref().map(|faces| {
        let finest = faces.windows(2).map(|f| f[1] - f[0]).fold(f64::INFINITY, f64::min);
        format!("{:.4}", 1e3 * finest)
    });
    if widths[0] == widths[1] && widths[1] == widths[2] { widths[0].clone() } else { widths.join(" × ") }
}
