//! What the processor touches of what a device holds.

/// What the processor touches in a step: contact nodes, and cells whose stress it changes; indices in memory,
/// none of them twice.
#[derive(Debug)]
pub struct Touched {
    pub(crate) nodes: Vec<u32>,
    pub(crate) cells: Vec<u32>,
}

impl Touched {
    /// These nodes and cells, in the order of the memory.
    pub(crate) fn of(nodes: impl Iterator<Item = usize>, cells: impl Iterator<Item = usize>) -> Self {
        Self { nodes: sorted(nodes), cells: sorted(cells) }
    }
}

fn sorted(entries: impl Iterator<Item = usize>) -> Vec<u32> {
    let mut all: Vec<u32> = entries.map(|n| n as u32).collect();
    all.sort_unstable();
    all.dedup();
    all
}
