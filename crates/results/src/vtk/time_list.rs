//! `.pvd`: the list of the files of a series by time, which ParaView opens.

use crate::files::{Inside, OutputError, read_text, write_whole};
use std::fmt::Write as _;

/// One line of a time list: when, which part, which file (relative to the list).
#[derive(Clone, Debug, PartialEq)]
pub struct TimedFile {
    /// Time [s].
    pub time: f64,
    /// Number of the part (body).
    pub part: usize,
    /// File, relative to the list.
    pub file: String,
}

/// Writes a list.
pub(super) fn write_time_list(to: &Inside, frames: &[TimedFile]) -> Result<(), OutputError> {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for TimedFile { time, part, file } in frames {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\" file=\"{file}\"/>");
    }
    text.push_str("</Collection>\n</VTKFile>\n");
    write_whole(to, text.as_bytes())
}

/// Reads back a list that `write_time_list` wrote; none when there is no such file.
pub fn read_time_list(from: &Inside) -> Result<Vec<TimedFile>, OutputError> {
    if !from.exists() {
        return Ok(Vec::new());
    }
    let text = read_text(from)?;
    let lines = text.lines().filter(|line| line.starts_with("<DataSet "));
    lines
        .map(|line| {
            let attribute = |name: &str| {
                let start = line.find(&format!("{name}=\""))? + name.len() + 2;
                line[start..].split('"').next()
            };
            let parse = || {
                Some(TimedFile {
                    time: attribute("timestep")?.parse().ok()?,
                    part: attribute("part")?.parse().ok()?,
                    file: attribute("file")?.to_owned(),
                })
            };
            parse()
                .ok_or_else(|| OutputError::content(&from.path(), format!("cannot make sense of `{line}`")))
        })
        .collect()
}
