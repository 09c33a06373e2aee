//! What a checkpoint is made of: a file of another layout cannot be read, whatever version it says.

use xxhash_rust::xxh3::xxh3_64;

/// The history variables of a cell, and every type in a checkpoint with its fields, as a test writes them.
const LAYOUT: &str = include_str!("layout.txt");

/// Hash of the layout, which every checkpoint states.
pub(super) fn hash() -> [u8; 8] {
    xxh3_64(LAYOUT.as_bytes()).to_le_bytes()
}

#[cfg(test)]
mod tests {
    use super::LAYOUT;
    use crate::checkpoint::Checkpoint;
    use mechanics::Motion;
    use serde_reflection::{Tracer, TracerConfig};
    use solver::fields::HISTORY;
    use solver::portion::Portion;

    /// With `COULTER_UPDATE=1` the layout is written instead.
    #[test]
    fn the_layout_is_that_of_the_types() {
        let mut tracer = Tracer::new(TracerConfig::default());
        tracer.trace_simple_type::<Checkpoint>().unwrap();
        tracer.trace_simple_type::<Portion<f64>>().unwrap();
        tracer.trace_simple_type::<Motion>().unwrap();
        let names: Vec<&str> = HISTORY.iter().map(|variable| variable.name).collect();
        let mut layout = format!("history variables: {}\n", names.join(", "));
        for (name, format) in tracer.registry().unwrap() {
            layout += &format!("{name}: {}\n", serde_json::to_string(&format).unwrap());
        }
        if std::env::var_os("COULTER_UPDATE").is_some() {
            let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/checkpoint/layout.txt");
            std::fs::write(path, layout).unwrap();
        } else {
            assert_eq!(layout, LAYOUT, "COULTER_UPDATE=1 cargo test -p coulter-results writes it anew");
        }
    }
}
