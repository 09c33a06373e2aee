//! How fast a device is on a case, and whether its bits are the processor's.

use super::measure::{Options, case_for};
use crate::run::RunError;
use crate::simulation::Simulation;
use case::resolved;
use results::domain::PlacedDomain;
use results::formats;
use serde::Serialize;
use solver::cpu::stopwatch::Stage;
use solver::device::{Device, DeviceError};
use solver::precision::Precision;
use std::fmt::Write as _;
use std::time::Instant;

/// The same steps on a device and on the processor.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DeviceMeasurement {
    /// Version of the document.
    pub format: u32,
    /// Name of the case.
    pub case: String,
    /// "double" or "single".
    pub precision: &'static str,
    /// Name of the device.
    pub device: String,
    /// Cells with soil.
    pub filled_cells: usize,
    /// Steps that are measured.
    pub steps: u32,
    /// Remaps in them.
    pub remaps: u64,
    /// Whether states, bodies and contact end in the same bits.
    pub same_bits: bool,
    /// Million cell-steps per second of wall clock on the device, remaps included.
    pub million_cell_steps_per_second: f64,
    /// The same without remaps and what crosses for them.
    pub million_cell_steps_per_second_between_remaps: f64,
    /// Million cell-steps per second of wall clock on the processor, with as many threads as were asked for.
    pub million_cell_steps_per_second_of_processor: f64,
    /// Share of the time that each stage takes: the Lagrangian stage on the device, remaps, contact.
    pub shares: [f64; 3],
    /// Bytes that cross in a step, remaps included.
    pub bytes_per_step: f64,
}

/// Measures a case on a device, and the same steps on the processor.
///
/// # Errors
/// [`RunError`] when there is no such device, it cannot run the case, or the physics fails.
pub fn measure_on_device(options: &Options, device: Device) -> Result<DeviceMeasurement, RunError> {
    match options.case.numerics.precision {
        resolved::Precision::Double => measure_in::<f64>(options, device),
        resolved::Precision::Single => measure_in::<f32>(options, device),
    }
}

fn measure_in<R: Precision>(options: &Options, device: Device) -> Result<DeviceMeasurement, RunError> {
    let driver = device.open()?.ok_or_else(|| DeviceError("name one: gpu, gpu:N or stand-in".to_owned()))?;
    let name = driver.name().to_owned();
    let failed = |cause: solver::error::Breakdown| DeviceError(cause.to_string());
    let mut team = Simulation::<R>::new(&case_for(options, options.threads));
    team.steps(options.warm_up).map_err(failed)?;
    let moving = team.checkpoint().kept();
    let mut there = Simulation::<R>::resume(&case_for(options, options.threads), moving, 0.0);
    there.use_device(driver)?;
    // The fields go to the device before the clock starts.
    there.steps(1).and_then(|()| team.steps(1)).map_err(failed)?;
    let mut seconds = [0.0; 2];
    let (remaps, crossed) = (there.state.remaps, there.crossed_to_device().unwrap_or_default());
    there.stopwatch().start();
    for (simulation, seconds) in [&mut there, &mut team].into_iter().zip(&mut seconds) {
        let clock = Instant::now();
        simulation.steps(options.steps).map_err(failed)?;
        *seconds = clock.elapsed().as_secs_f64();
    }
    let shares = [Stage::Lagrange, Stage::Remap, Stage::Contact]
        .map(|stage| there.stopwatch().seconds(stage) / seconds[0]);
    let filled = PlacedDomain::of(&team.model.grid, team.state.grid_position).filled_cells(&team.state);
    let cell_steps = 1e-6 * filled as f64 * f64::from(options.steps);
    let crossed = there.crossed_to_device().unwrap_or_default() - crossed;
    Ok(DeviceMeasurement {
        format: formats::DOCUMENT,
        case: options.case.name.clone(),
        precision: R::NAME,
        device: name,
        filled_cells: filled,
        steps: options.steps,
        remaps: there.state.remaps - remaps,
        same_bits: there.checkpoint().to_bytes()? == team.checkpoint().to_bytes()?,
        million_cell_steps_per_second: cell_steps / seconds[0],
        million_cell_steps_per_second_between_remaps: cell_steps / (seconds[0] * (1.0 - shares[1])),
        million_cell_steps_per_second_of_processor: cell_steps / seconds[1],
        shares,
        bytes_per_step: crossed as f64 / f64::from(options.steps),
    })
}

/// A measurement in words.
#[must_use]
pub fn device_table(measured: &DeviceMeasurement) -> String {
    let m = measured;
    let mut text = String::new();
    let [lagrange, remap, contact] = m.shares.map(|share| 100.0 * share);
    // Writing to a string cannot fail.
    let _ =
        writeln!(text, "case     {}, {} precision, {} cells with soil", m.case, m.precision, m.filled_cells);
    let _ = writeln!(text, "device   {}", m.device);
    let _ = writeln!(text, "bits     {} those of the processor", if m.same_bits { "are" } else { "are NOT" });
    let _ = writeln!(
        text,
        "speed    {:.2} million cell-steps per second, {:.2} between remaps; the processor {:.2}",
        m.million_cell_steps_per_second,
        m.million_cell_steps_per_second_between_remaps,
        m.million_cell_steps_per_second_of_processor
    );
    let _ = writeln!(
        text,
        "time     {lagrange:.0} % Lagrangian stage, {remap:.0} % in {} remaps of {} steps, {contact:.0} % contact",
        m.remaps, m.steps
    );
    let _ = writeln!(text, "crossing {:.3} MB per step, remaps included", 1e-6 * m.bytes_per_step);
    text
}
