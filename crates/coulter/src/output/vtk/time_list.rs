//! `.pvd`: the list of the files of a series by time, which ParaView opens.

use crate::output::files::{Named, OutputError, write_whole};
use std::fmt::Write as _;
use std::path::Path;

/// One line of a time list: when, which part, which file (relative to the list).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frame {
    /// Time [s].
    pub(super) time: f64,
    /// Number of the part (body).
    pub(super) part: usize,
    /// File, relative to the list.
    pub(super) file: String,
}

/// Writes a list.
pub(super) fn write_time_list(path: &Path, frames: &[Frame]) -> Result<(), OutputError> {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for Frame { time, part, file } in frames {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\" file=\"{file}\"/>");
    }
    text.push_str("</Collection>\n</VTKFile>\n");
    write_whole(path, text.as_bytes())
}

/// Reads back a list that [`write_time_list`] wrote; none when there is no such file.
pub(super) fn read_time_list(path: &Path) -> Result<Vec<Frame>, OutputError> {
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let text = std::fs::read_to_string(path).named("read", path)?;
    let lines = text.lines().filter(|line| line.starts_with("<DataSet "));
    lines
        .map(|line| {
            let attribute = |name: &str| {
                let start = line.find(&format!("{name}=\""))? + name.len() + 2;
                line[start..].split('"').next()
            };
            let parse = || {
                Some(Frame {
                    time: attribute("timestep")?.parse().ok()?,
                    part: attribute("part")?.parse().ok()?,
                    file: attribute("file")?.to_owned(),
                })
            };
            parse().ok_or_else(|| OutputError::content(path, format!("cannot make sense of `{line}`")))
        })
        .collect()
}
