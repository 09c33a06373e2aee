//! The section that shows the soil surface and the bodies in space: data for its script, and what the caption
//! says of them.

use crate::view::{SurfaceView, displacements};
use results::folder::RunRecord;
use results::history::History;
use serde::Serialize;
use std::path::Path;

/// The section.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(super) struct Space {
    /// The data of the script as JSON; `None` where there is nothing to show.
    data: Option<String>,
    /// What is shown of what there is.
    extent: String,
    /// Why there is no view although the run has field files.
    problem: Option<String>,
}

/// Makes the section from the field files of a run. Where one of them is damaged or was removed the report
/// says so instead.
pub(super) fn space(dir: &Path, record: &RunRecord, history: &History) -> Space {
    let read = SurfaceView::read(dir, record);
    let made = read.map_err(|error| error.to_string()).and_then(|view| {
        let Some(mut view) = view else { return Ok(Space::default()) };
        view.displacements = displacements(record, history, &view.times);
        let data = view.json().map_err(|error| error.to_string())?;
        Ok(Space { data: Some(data), extent: extent(&view), problem: None })
    });
    made.unwrap_or_else(|problem| Space { problem: Some(problem), ..Space::default() })
}

fn extent(view: &SurfaceView) -> String {
    let [x, y] = view.places();
    let times = match (view.times.len(), view.recorded) {
        (shown, all) if shown == all => format!("All {all} recorded times"),
        (shown, all) => format!("{shown} of {all} recorded times"),
    };
    format!("{times}, {x} × {y} places")
}
