//! The cost of the case, in words.

use coulter::case::Case;
use coulter::case::estimate::Cost;
use coulter::case::quantity::short;
use coulter::case::resources::format_bytes;
use std::fmt::Write;

/// Box, grid, memory, results and time of a case; `seconds` is the estimated time of the run [s].
pub(super) fn describe_cost(
    text: &mut String,
    case: &Case,
    cost: &Cost,
    seconds: Option<f64>,
) -> std::fmt::Result {
    let [nx, ny, nz] = std::array::from_fn(|axis| case.grid.faces[axis].len().saturating_sub(1));
    let (low, high) = (case.domain.low, case.domain.high);
    let [low, high] = [low, high].map(|corner| corner.to_array().map(short));
    let sides = ["x", "y", "z"].iter().zip(low.iter().zip(&high));
    let sides: Vec<String> = sides.map(|(axis, (low, high))| format!("{axis} {low} to {high} m")).collect();
    writeln!(text, "box      {}{}", sides.join(", "), symmetry(case))?;
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
        format_bytes(cost.memory_bytes),
        format_bytes(memory.grid_bytes),
        format_bytes(memory.contact_bytes),
        format_bytes(memory.outputs_bytes),
        format_bytes(memory.program_bytes)
    )?;
    let output = &cost.output;
    writeln!(
        text,
        "results  {}: fields {} in {} files, histories {}, checkpoints {}",
        format_bytes(output.total_bytes),
        format_bytes(output.fields_bytes),
        output.frames,
        format_bytes(output.histories_bytes),
        format_bytes(output.checkpoints_bytes)
    )?;
    writeln!(
        text,
        "time     {} s in {} steps of {} s (wave speed {} m/s)",
        short(case.duration),
        cost.estimate.steps,
        short(cost.estimate.time_step_s),
        short(cost.estimate.wave_speed_m_per_s)
    )?;
    match seconds {
        Some(seconds) => writeln!(text, "run time about {} on this machine", time_in_words(seconds)),
        None => {
            writeln!(text, "run time {:.3e} cell steps", cost.estimate.steps * cost.estimate.filled_cells)
        }
    }
}

/// A time [s] in the unit in which one would say it.
pub(super) fn time_in_words(seconds: f64) -> String {
    const UNITS: [(f64, &str); 3] = [(365.25 * 86400.0, "years"), (86400.0, "days"), (3600.0, "h")];
    let unit = UNITS.iter().find(|(unit, _)| seconds >= 2.0 * unit);
    unit.map_or_else(|| format!("{seconds:.0} s"), |(unit, name)| format!("{:.0} {name}", seconds / unit))
}

/// Plane strain and planes of symmetry.
fn symmetry(case: &Case) -> &'static str {
    let domain = &case.domain;
    match (domain.plane_strain, domain.symmetric, domain.symmetric_x) {
        (true, _, false) => ", plane strain: forces, weights and energies per metre of width",
        (true, _, true) => {
            ", plane strain, symmetric half: forces, weights and energies of the whole per metre of width"
        }
        (false, false, false) => "",
        (false, true, true) => ", symmetric quarter",
        (false, _, _) => ", symmetric half",
    }
}

/// The smallest widths of the cells along x, y, z [mm]; one number where they are the same.
fn finest(case: &Case) -> String {
    let widths = case.grid.faces.each_ref().map(|faces| {
        let finest = faces.windows(2).map(|f| f[1] - f[0]).fold(f64::INFINITY, f64::min);
        short(1e3 * finest)
    });
    if widths[0] == widths[1] && widths[1] == widths[2] { widths[0].clone() } else { widths.join(" × ") }
}
