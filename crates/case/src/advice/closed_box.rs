//! Whether bodies that enter pump up a closed box.

use crate::closed_box::{ClosedBox, entering_volume};
use crate::resolved::Case;

/// Warns of bodies that enter soil which has nowhere to go.
pub(super) fn pumped(case: &Case, notes: &mut Vec<String>) {
    let Some(closed) = ClosedBox::of(case) else { return };
    let entering: f64 = case.touching().map(|(_, body)| entering_volume(case, body)).sum();
    let rise = closed.stiffness * entering;
    let relative = 100.0 * rise / closed.bearable;
    if rise <= 0.0 || relative <= ClosedBox::HARMLESS {
        return;
    }
    let larger = (relative / ClosedBox::HARMLESS).cbrt();
    let strength = case.soil.law.cohesion().filter(|strength| *strength > 0.0);
    let over_strength =
        strength.map_or_else(String::new, |strength| format!(", {:.1} times its strength", rise / strength));
    notes.push(format!(
        "The soil fills its box, and walls, floor and lid do not yield: {:.3e} m³ of bodies enter, and the pressure rises everywhere by \
         K ΔV/V = {:.1} kPa, {relative:.0} % of what the soil bears round them ({:.1} kPa){over_strength}, and their resistance with it. A box \
         {larger:.1} times as long, wide and deep has {:.0} % of it; boundaries at constant stress (`pressure` in domain.z_walls, x_walls, \
         y_walls) have none.",
        entering,
        1e-3 * rise,
        1e-3 * closed.bearable,
        ClosedBox::HARMLESS
    ));
}
