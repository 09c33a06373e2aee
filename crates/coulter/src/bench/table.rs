//! A measurement as a table to read.

use super::measurement::Measurement;
use std::fmt::Write as _;

/// The measurement as text.
#[must_use]
pub fn table(m: &Measurement) -> String {
    let [nx, ny, nz] = m.cells;
    let mut text = String::new();
    let mut line = |name: &str, words: &str| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<9}{words}");
    };
    line("case", &format!("{}, {} precision", m.case, m.precision));
    line("grid", &format!("{nx} × {ny} × {nz} cells, {} with soil", m.filled_cells));
    let each = m.steps_in_remap.map_or(String::new(), |steps| format!(", each as long as {steps:.1} steps"));
    line(
        "steps",
        &format!("{}, {} remaps{each}; {:.1} % of the soil yields", m.steps, m.remaps, 100.0 * m.yielding),
    );
    line("memory", &format!("{:.0} bytes per cell", m.bytes_per_cell));
    let limits = |triad: f64, fma: f64| format!("triad {triad:.1} GB/s, multiply-add {fma:.1} GFLOP/s");
    line("machine", &format!("1 thread: {}", limits(m.triad, m.fma)));
    if m.threads > 1 {
        line("", &format!("{} threads: {}", m.threads, limits(m.triad_threads, m.fma_threads)));
    }
    let speed = |speed: f64| format!("{speed:.2} million cell-steps per core-second");
    line("speed", &format!("1 thread: {}", speed(m.million_cell_steps_per_core_second)));
    if m.threads > 1 {
        let each = speed(m.million_cell_steps_per_core_second_threads);
        line("", &format!("{} threads: {each}, {:.2} times as fast as one", m.threads, m.speed_up));
    }
    if let (Some(speed), Some(memory)) = (m.times_double, m.memory_of_double) {
        line(
            "",
            &format!("1 thread: {speed:.2} times as fast as in double precision, {memory:.2} of its memory"),
        );
    }
    text.push('\n');
    text.push_str(&stages(m));
    text
}

/// One line per stage.
fn stages(m: &Measurement) -> String {
    let mut text =
        format!("{:<12}{:>7}{:>11}{:>10}{:>10}\n", "stage", "time", "cell-step", "GFLOP/s", "of peak");
    let nanoseconds = 1e3 / m.million_cell_steps_per_core_second;
    let rows = [
        ("lagrange", m.split.lagrange, Some(m.operations.lagrange)),
        ("plasticity", m.split.plasticity, Some(m.operations.plasticity)),
        ("nodes", m.split.nodes, Some(m.operations.nodes)),
        ("remap", m.split.remap, None),
        ("contact", m.split.contact, None),
        ("other", m.split.other, None),
    ];
    for (name, fraction, rate) in rows {
        let _ = write!(text, "{name:<12}{:>5.1} %{:>8.2} ns", 100.0 * fraction, fraction * nanoseconds);
        if let Some(rate) = rate {
            let _ = write!(text, "{rate:>10.1}{:>8.1} %", 100.0 * rate / m.fma);
        }
        text.push('\n');
    }
    let per_cent = 100.0 * m.traffic / m.triad;
    let _ = writeln!(
        text,
        "lagrange, plasticity and nodes move {:.1} GB/s, {per_cent:.0} % of the triad",
        m.traffic
    );
    text
}
