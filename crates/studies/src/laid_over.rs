//! Curves of measurements and other runs for the plots of a report.

use crate::comparison::{Item, ItemKind, Unreadable, read_item, settle_signs};
use crate::measured::{ColumnChoice, Quantity, Record};
use coulter::history::steady::moving_average;
use coulter::output::{Overlay, PlotKind};
use std::path::Path;

/// Width of the moving average of the forces of another run, over the length of its curve (chosen: as smooth
/// as the report's own).
const SMOOTHING: f64 = 0.02;

/// Which quantity over which belongs to which plot.
const PLOTS: [(PlotKind, Quantity, Quantity); 6] = [
    (PlotKind::ForceDisplacement, Quantity::Displacement, Quantity::Drag),
    (PlotKind::ForceDisplacement, Quantity::Displacement, Quantity::Vertical),
    (PlotKind::ForceSinkage, Quantity::Sinkage, Quantity::Drag),
    (PlotKind::ForceSinkage, Quantity::Sinkage, Quantity::Vertical),
    (PlotKind::SinkageDisplacement, Quantity::Displacement, Quantity::Sinkage),
    (PlotKind::AxleTorque, Quantity::Displacement, Quantity::Torque),
];

/// The curves of a results folder or of a measured CSV file, overlaid on the plots of all bodies of a report,
/// and the record that they are from. `body` names the body of a run with several, and `choices` say what the
/// columns of a measurement are, whose forces have the signs of those of the report's own run, in the folder
/// `run`.
///
/// # Errors
/// [`Unreadable`] says what is wrong with it, also where it has no curve that a report shows.
pub fn laid_over(
    path: &Path,
    run: &Path,
    body: Option<&str>,
    choices: &[ColumnChoice],
) -> Result<(Vec<Overlay>, Record), Unreadable> {
    let mut item = read_item(path, body, choices)?;
    item.record.refuse_groups().map_err(Unreadable::Other)?;
    if !matches!(item.kind, ItemKind::Run | ItemKind::Measured) {
        return Err(Unreadable::Other(format!(
            "{}: a {} has no curves of its own; name the results folder of a run or a measured CSV file",
            path.display(),
            item.kind.name()
        )));
    }
    if item.kind == ItemKind::Measured {
        item = signed_as(item, read_item(run, None, &[])?).map_err(Unreadable::Other)?;
    }
    Ok((overlays(&item, path)?, item.record))
}

fn overlays(item: &Item, path: &Path) -> Result<Vec<Overlay>, Unreadable> {
    let overlays: Vec<Overlay> =
        PLOTS.iter().filter_map(|(plot, x, y)| overlay(item, path, *plot, [*x, *y])).collect();
    if overlays.is_empty() {
        return Err(Unreadable::Other(format!(
            "{}: it has no drag, vertical force, sinkage or axle torque along displacement or sinkage; give it such columns",
            path.display()
        )));
    }
    Ok(overlays)
}

/// A measurement whose forces have the signs of those of a run, along the first abscissa of the plots that
/// the measurement has.
fn signed_as(measured: Item, run: Item) -> Result<Item, String> {
    let along = measured.record.abscissae().find(|along| PLOTS.iter().any(|(_, x, _)| x == along));
    let Some(along) = along else { return Ok(measured) };
    let mut both = [measured, run];
    settle_signs(&mut both, along, &PLOTS.map(|(_, _, quantity)| quantity))?;
    let [measured, _] = both;
    Ok(measured)
}

fn overlay(item: &Item, path: &Path, plot: PlotKind, [x, y]: [Quantity; 2]) -> Option<Overlay> {
    let (along, values) = (item.record.values(x)?, item.record.values(y)?);
    // A wheel without torque and a column of zeros say nothing.
    if values.iter().all(|value| *value == 0.0) || along.iter().all(|value| *value == along[0]) {
        return None;
    }
    let measured = item.kind == ItemKind::Measured;
    let values = if measured { values.to_vec() } else { smooth(&item.record, values) };
    let points = along.iter().zip(values).map(|(x, y)| [*x, y]);
    let file = path.file_stem().or(path.file_name()).map(|name| name.to_string_lossy().into_owned());
    // An underscore would lower the letter after it.
    let source = file.unwrap_or_else(|| path.display().to_string()).replace('_', " ");
    Some(Overlay {
        name: format!("{}, {source}", y.label()),
        plot,
        body: None,
        measured,
        points: points.filter(|point| point.iter().all(|v| v.is_finite())).collect(),
    })
}

/// Values of a run without what is fast.
fn smooth(record: &Record, values: &[f64]) -> Vec<f64> {
    let Some(times) = record.values(Quantity::Time) else { return values.to_vec() };
    let span = times.last().zip(times.first()).map_or(0.0, |(last, first)| last - first);
    moving_average(times, values, SMOOTHING * span)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::write;
    use coulter::output::Inside;

    #[test]
    fn measured_curves_go_to_their_plots_and_others_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("field_trial.csv");
        write(&Inside::at(&path), b"displacement [mm],drag [N],sinkage [mm]\n0,0,1\n10,5,2\n20,6,3\n")
            .unwrap();
        let read = || read_item(&path, None, &[]).unwrap();
        let found = overlays(&read(), &path).unwrap();
        let plots: Vec<PlotKind> = found.iter().map(|overlay| overlay.plot).collect();
        assert_eq!(
            plots,
            [PlotKind::ForceDisplacement, PlotKind::ForceSinkage, PlotKind::SinkageDisplacement]
        );
        assert!(found[0].measured && found[0].name == "drag F_H, field trial");
        assert_eq!(found[0].points[1], [0.01, 5.0]);
        write(&Inside::at(&path), b"time [s],speed [m/s]\n0,1\n1,2\n").unwrap();
        assert!(overlays(&read(), &path).unwrap_err().to_string().contains("give it such columns"));
    }

    #[test]
    fn a_measured_force_of_the_other_sign_is_turned_or_refused_as_in_a_comparison() {
        let folder = tempfile::tempdir().unwrap();
        let read = |name: &str, text: &str| {
            let path = folder.path().join(name);
            write(&Inside::at(&path), text.as_bytes()).unwrap();
            read_item(&path, None, &[]).unwrap()
        };
        let of_run = |text: &str| Item { kind: ItemKind::Run, ..read("run.csv", text) };
        let run = of_run("sinkage [mm],vertical [N]\n1,5\n2,6\n");
        let settled = signed_as(read("press.csv", "sinkage [mm],vertical [N]\n1,-5\n2,-7\n"), run).unwrap();
        assert_eq!(settled.record.values(Quantity::Vertical), Some(&[5.0, 7.0][..]));
        assert!(settled.record.remarks[0].contains("its sign was turned"));
        let run = of_run("displacement [mm],vertical [N]\n1,5\n2,6\n");
        let towed = read("tow.csv", "displacement [mm],vertical [N]\n1,-5\n2,-7\n");
        assert!(signed_as(towed, run).unwrap_err().contains("--column"));
    }
}
