//! From a results folder to pictures.

use super::animation::Animation;
use super::frame::Renderer;
use super::options::{ImageFormat, RenderOptions};
use crate::view::{Detail, Recording, displacements};
use results::files::{Inside, OutputError, make_folder, write_whole};
use results::folder::RunRecord;
use std::path::Path;

/// In more detail than a page can hold: a place for every few pixels, a time for every picture of an
/// animation of some seconds (chosen: heights take 130 MB at most).
const DETAIL: Detail = Detail { times: 160, places: 100_000, triangles: 60_000 };
/// Pictures per second of an animation, at most.
const MOST_PER_SECOND: f64 = 25.0;

/// Draws the files that are asked for from the field files of a results folder. `drawn` is told how many
/// pictures of how many are done.
///
/// # Errors
/// When the folder holds no result or no field files, a file is damaged, or one cannot be written.
pub fn render(
    dir: &Path,
    options: &RenderOptions,
    drawn: &mut dyn FnMut(usize, usize),
) -> Result<(), OutputError> {
    let record = RunRecord::read(dir)?;
    let Some(recording) = Recording::read(dir, &record, DETAIL)? else {
        return Err(OutputError::content(
            dir,
            "there are no field files to draw from; the case asked for none, or they were removed",
        ));
    };
    let history = record.history(dir, record.statistics.outcome.is_end())?;
    let displacements = displacements(&record, &history, &recording.times);
    let renderer = Renderer::new((&recording, &displacements), &record.title, options);
    let formats = options
        .files
        .iter()
        .map(|path| ImageFormat::of(path).map_err(|problem| OutputError::content(path, problem)))
        .collect::<Result<Vec<_>, _>>()?;
    let frames = chosen(recording.times.len(), options.duration);
    let pictures = |format: &ImageFormat| if *format == ImageFormat::Png { 1 } else { frames.len() };
    let (mut done, all) = (0, formats.iter().map(pictures).sum());
    for (path, format) in options.files.iter().zip(formats) {
        // In the results folder nothing is followed out of it; any other place is the user's.
        let file = path.strip_prefix(dir).map_or_else(|_| Inside::at(path), |name| Inside::of(dir, name));
        make_folder(&file.beside(""))?;
        let mut picture = |frame: usize| {
            let canvas = renderer.picture(frame);
            // The palette of a GIF needs two pictures twice.
            done = (done + 1).min(all);
            drawn(done, all);
            canvas
        };
        if format == ImageFormat::Png {
            let canvas = picture(nearest(&recording.times, options.time));
            write_whole(&file, &canvas.png(options.dark))?;
            continue;
        }
        let mut frame = |n: usize| picture(frames[n]).rgb(options.dark);
        let pause = options.duration / frames.len() as f64;
        let animation = Animation { size: options.size, count: frames.len(), pause, frame: &mut frame };
        if format == ImageFormat::Gif { animation.write_gif(&file)? } else { animation.write_apng(&file)? }
    }
    Ok(())
}

/// The recorded times of an animation that lasts so long [s]: all, or evenly spread ones, the first and the
/// last among them.
fn chosen(recorded: usize, duration: f64) -> Vec<usize> {
    let most = ((MOST_PER_SECOND * duration) as usize).max(2);
    let count = recorded.min(most);
    (0..count).map(|n| n * (recorded - 1) / (count - 1).max(1)).collect()
}

/// The recorded time that is nearest to a time [s]; the last unless one is given.
fn nearest(times: &[f64], time: Option<f64>) -> usize {
    let Some(time) = time else { return times.len() - 1 };
    let away = |n: &usize| (times[*n] - time).abs();
    (0..times.len()).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_chosen_evenly_and_the_nearest_is_found() {
        assert_eq!(chosen(3, 6.0), [0, 1, 2]);
        assert_eq!(chosen(1, 6.0), [0]);
        let many = chosen(1000, 2.0);
        assert_eq!((many.len(), many[0], many[49]), (50, 0, 999));
        let times = [0.0, 1.0, 2.0];
        assert_eq!(
            (nearest(&times, None), nearest(&times, Some(0.7)), nearest(&times, Some(9.0))),
            (2, 1, 2)
        );
    }
}
