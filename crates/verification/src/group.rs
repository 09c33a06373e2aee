//! D9: discs on one axle, from touching to far apart, beside single discs and rollers.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../validation/D9_discs_on_an_axle/case.toml");
/// Diameter and thickness in the case file [m].
const DIAMETER: f64 = 0.2;
const THICKNESS: f64 = 0.05;
/// From the outermost disc's flank to the end of the fine zone, and to the wall [m].
const BESIDE: [f64; 2] = [0.125, 0.3];
/// Distances between the middles of two discs, over the diameter, with their names.
const TOUCHING: (f64, &str) = (THICKNESS / DIAMETER, "touching");
const SPACINGS: [(f64, &str); 5] =
    [TOUCHING, (0.5, "0.5 d apart"), (1.0, "1 d apart"), (2.0, "2 d apart"), (4.0, "4 d apart")];
/// The steady part: the last so much of the time.
const STEADY: f64 = 0.3;

/// Drag and vertical force [N].
type Forces = [f64; 2];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let single = tow(runner, "1 disc", &[])?;
    let mut rollers = Vec::new();
    for count in [2, 3] {
        let width = f64::from(count) * THICKNESS;
        let mut sets = box_for(width);
        sets.push(format!("body.disc.thickness={width} m"));
        sets.push(format!("body.disc.axle_inertia={} kg*m^2", 0.02 * f64::from(count)));
        rollers.push(tow(runner, &format!("roller of {count} t"), &sets)?);
    }
    let (Some(single), [Some(two), Some(three)]) = (single, rollers[..].try_into().unwrap_or([None; 2]))
    else {
        return Ok(());
    };
    for (spacing, name) in SPACINGS {
        group(runner, 2, spacing, name, [single, two])?;
    }
    for (spacing, name) in [SPACINGS[0], SPACINGS[4]] {
        group(runner, 3, spacing, name, [single, three])?;
    }
    Ok(())
}

/// The box and its fine zone for bodies over this width [m].
fn box_for(width: f64) -> Vec<String> {
    let [fine, wall] = BESIDE.map(|beside| 0.5 * width + beside);
    vec![format!("domain.y=['-{wall} m', '{wall} m']"), format!("grid.fine_y=['-{fine} m', '{fine} m']")]
}

/// A tow; its forces, summed over the bodies, over the steady part.
fn tow(runner: &mut Runner, variant: &str, sets: &[String]) -> Result<Option<Forces>, VerifyError> {
    if !runner.wants("D9", variant)? {
        return Ok(None);
    }
    let simulation = runner.run("D9", variant, CASE, sets)?;
    let forces = forces(&simulation);
    let figures = [("drag F_H [N]", forces[0]), ("vertical force F_V [N]", forces[1])];
    runner.put("D9", variant, simulation.wall_s, &figures)?;
    Ok(Some(forces))
}

/// Means of the forces over the steady part, summed over the bodies.
fn forces(simulation: &Simulation) -> Forces {
    let range = [(1.0 - STEADY) * simulation.case.duration, f64::INFINITY];
    let bodies = simulation.history.bodies.iter();
    bodies.fold([0.0; 2], |[drag, vertical], samples| {
        [
            drag + mean(samples, range, |s| s.time, |s| s.drag),
            vertical + mean(samples, range, |s| s.time, |s| s.vertical),
        ]
    })
}

/// Some discs at a spacing over the diameter, beside as many single ones, and touching beside the roller.
fn group(
    runner: &mut Runner,
    count: u32,
    spacing: f64,
    name: &str,
    [single, roller]: [Forces; 2],
) -> Result<(), VerifyError> {
    let variant = format!("{count} discs, {name}");
    if !runner.wants("D9", &variant)? {
        return Ok(());
    }
    let places: Vec<f64> =
        (0..count).map(|n| (f64::from(n) - 0.5 * f64::from(count - 1)) * spacing * DIAMETER).collect();
    let mut sets = box_for(2.0 * places[places.len() - 1] + THICKNESS);
    sets.push(format!("body.disc.y={} m", places[0]));
    for (n, y) in places.iter().enumerate().skip(1) {
        sets.push(format!(
            "body.disc{n}={{ shape='disc', diameter='{DIAMETER} m', thickness='{THICKNESS} m', friction=0.3, mass='4 kg', \
             axle_inertia='0.02 kg*m^2', sinkage='50 mm', y='{y} m' }}"
        ));
        sets.push(format!("joint.disc{n}={{ kind='hinge', bodies=['axle', 'disc{n}'] }}"));
    }
    let simulation = runner.run("D9", &variant, CASE, &sets)?;
    let [drag, vertical] = forces(&simulation);
    let over =
        |reference: Forces, count: f64| [drag / (count * reference[0]), vertical / (count * reference[1])];
    let [drag_factor, vertical_factor] = over(single, f64::from(count));
    let figures = if spacing == SPACINGS[4].0 {
        vec![
            ("drag over that of single discs", drag_factor),
            ("vertical force over that of single discs", vertical_factor),
        ]
    } else {
        let mut figures = vec![
            ("group factor of the drag", drag_factor),
            ("group factor of the vertical force", vertical_factor),
        ];
        if spacing == TOUCHING.0 {
            let [drag, vertical] = over(roller, 1.0);
            figures.push(("drag over that of the roller", drag));
            figures.push(("vertical force over that of the roller", vertical));
        }
        figures
    };
    runner.put("D9", &variant, simulation.wall_s, &figures)
}
