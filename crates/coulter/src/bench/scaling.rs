//! How a case scales over processes: what was measured, and what a model of latency and bandwidth makes of it
//! for more of them.
//!
//! A step takes what every process does for all (contact, bodies), its share of the cells with the ghost
//! layers that it strains, and communication:
//!
//! T = T_contact + T_cells s + m (α + b/(m β)) + c α_c log₂ P + B/β
//!
//! with s the strained rows of the largest block over all rows, m messages of b bytes in all, c operations of
//! all P processes together, B the bytes that these put into them, and latency α, bandwidth β and α_c of
//! [`Network`]. T_contact and T_cells are those of one process, m, b, c and B those of the largest measured
//! number of processes, per cut and per row at a cut. Cells are taken to be shared evenly. Communication
//! counts in full, though most of that of a step is under way while there is something to compute.

use super::network::Network;
use super::ranks::RankMeasurement;
use serde::Serialize;
use std::fmt::Write as _;

/// Numbers of processes that are predicted.
const PREDICTED: [usize; 3] = [10, 100, 1000];

/// Least layers of a block.
const LEAST: usize = solver::grid::GHOSTS;

/// What a case does on a number of processes, measured and predicted.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// Version of the document.
    pub format: u32,
    /// What was measured, one process first.
    pub measured: Vec<RankMeasurement>,
    /// The network of the predictions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub network: Option<Network>,
    /// What the model makes of the numbers of processes that were measured, and of more.
    pub modelled: Vec<Modelled>,
}

/// What the model says of a number of processes.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Modelled {
    /// Number of processes.
    pub ranks: usize,
    /// Time of a step of the case [s]; none where its grid has too few layers for so many blocks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strong_s: Option<f64>,
    /// Portion of the time of a step of the case that is communication.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strong_communication: Option<f64>,
    /// Time of a step of a case so many times as large, in which each process has as many cells as the case
    /// [s].
    pub weak_s: f64,
    /// Portion of the time of a step of the larger case that is communication.
    pub weak_communication: f64,
}

/// The scaling of a case; `network` in place of the one that was measured.
#[must_use]
pub fn scaling(measured: Vec<RankMeasurement>, network: Option<Network>) -> Scaling {
    let most = measured.iter().filter(|own| own.network.is_some()).max_by_key(|own| own.ranks);
    let network = network.or_else(|| most.and_then(|own| own.network));
    let alone = measured.iter().find(|own| own.ranks == 1);
    let modelled = match (alone, most, network) {
        (Some(alone), Some(most), Some(network)) => {
            let model = Model { alone, most, network };
            let counts = measured.iter().map(|own| own.ranks).filter(|ranks| *ranks > 1).chain(PREDICTED);
            counts.map(|ranks| model.of(ranks)).collect()
        }
        _ => Vec::new(),
    };
    Scaling { format: results::formats::DOCUMENT, measured, network, modelled }
}

struct Model<'a> {
    alone: &'a RankMeasurement,
    most: &'a RankMeasurement,
    network: Network,
}

/// A block in the midst of others: rows of cells that it strains, cuts round it, and rows along these.
#[derive(Clone, Copy)]
struct BlockSize {
    strained: usize,
    cuts: usize,
    cut_rows: usize,
}

impl Model<'_> {
    fn of(&self, ranks: usize) -> Modelled {
        let [_, rows, planes] = self.alone.cells;
        let strong = cut([rows, planes], ranks).map(|block| self.step(ranks, block));
        let [along_y, along_z] = factors(ranks);
        let weak = largest([rows * along_y, planes * along_z], [along_y, along_z]);
        let weak = self.step(ranks, weak);
        Modelled {
            ranks,
            strong_s: strong.map(|[all, _]| all),
            strong_communication: strong.map(|[all, communication]| communication / all),
            weak_s: weak[0],
            weak_communication: weak[1] / weak[0],
        }
    }

    /// Time of a step, and of communication in it [s].
    fn step(&self, ranks: usize, block: BlockSize) -> [f64; 2] {
        let Self { alone, most, network } = self;
        let [_, rows, planes] = alone.cells;
        let share = block.strained as f64 / (rows * planes) as f64;
        let compute = alone.compute_s[0] * (alone.contact + (1.0 - alone.contact) * share);
        let messages = most.messages_per_cut * block.cuts as f64;
        let bytes = most.bytes_per_cut_row * block.cut_rows as f64;
        let together = most.collectives * network.collective_s * (ranks as f64).log2();
        let communication =
            messages * network.latency_s + (bytes + most.collective_bytes) / network.bandwidth + together;
        [compute + communication, communication]
    }
}

/// The largest block of a grid that is cut so that it strains the fewest rows.
fn cut(layers: [usize; 2], ranks: usize) -> Option<BlockSize> {
    let ways = (1..=ranks).filter(|along_y| ranks.is_multiple_of(*along_y)).map(|y| [y, ranks / y]);
    let fit = ways.filter(|ways| (0..2).all(|axis| ways[axis] == 1 || layers[axis] >= ways[axis] * LEAST));
    fit.map(|ways| largest(layers, ways)).min_by_key(|block| (block.strained, block.cut_rows))
}

/// The largest block of a grid that is cut into so many along y and z.
fn largest(layers: [usize; 2], ways: [usize; 2]) -> BlockSize {
    let own = [0, 1].map(|axis| layers[axis].div_ceil(ways[axis]));
    let cuts = ways.map(|ways| (ways - 1).min(2));
    BlockSize {
        strained: (own[0] + cuts[0]) * (own[1] + cuts[1]),
        cuts: cuts[0] + cuts[1],
        cut_rows: cuts[0] * own[1] + cuts[1] * own[0],
    }
}

/// Two factors of a number that differ little.
fn factors(number: usize) -> [usize; 2] {
    let low = (1..=number.isqrt()).rev().find(|low| number.is_multiple_of(*low)).unwrap_or(1);
    [number / low, low]
}

/// The scaling as text, of a machine with so many processors.
#[must_use]
pub fn scaling_table(scaling: &Scaling, processors: usize) -> String {
    let Scaling { measured, network, modelled, .. } = scaling;
    let mut text = String::new();
    if let Some(first) = measured.first() {
        let [nx, ny, nz] = first.cells;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{}, {} precision, {nx} × {ny} × {nz} cells, {} with soil, {} steps; per step:\n",
            first.case, first.precision, first.filled_cells, first.steps
        );
    }
    let _ = writeln!(
        text,
        "{:>6}{:>9}{:>11}{:>12}{:>11}{:>10}{:>10}{:>13}{:>11}",
        "ranks", "threads", "time", "computing", "imbalance", "messages", "kB", "collectives", "efficiency"
    );
    let one = measured.iter().find(|own| own.ranks == 1).map(|own| own.step_s);
    for own in measured {
        let [slowest, mean] = own.compute_s;
        let efficiency = one
            .map_or(String::new(), |one| format!("{:.0} %", 100.0 * one / (own.ranks as f64 * own.step_s)));
        let _ = writeln!(
            text,
            "{:>6}{:>9}{:>8.2} ms{:>9.2} ms{:>9.1} %{:>10.1}{:>10.1}{:>13.1}{efficiency:>11}{}",
            own.ranks,
            own.threads,
            1e3 * own.step_s,
            1e3 * slowest,
            100.0 * (slowest / mean - 1.0),
            own.messages,
            1e-3 * own.message_bytes,
            own.collectives,
            if own.ranks * own.threads > processors { "  more than processors" } else { "" }
        );
    }
    if let Some(network) = network {
        let _ = writeln!(
            text,
            "\nPrediction, not measured, with {:.1} µs + bytes / ({:.1} GB/s) for a message and {:.1} µs log₂ P for a collective operation of P:\n",
            1e6 * network.latency_s,
            1e-9 * network.bandwidth,
            1e6 * network.collective_s
        );
        text.push_str(&modelled_table(modelled, one.unwrap_or_default()));
    }
    text
}

fn modelled_table(modelled: &[Modelled], one: f64) -> String {
    let mut text = format!(
        "{:>6}{:>14}{:>12}{:>8}{:>20}{:>12}{:>8}\n",
        "ranks", "this case", "efficiency", "comm.", "as many cells each", "efficiency", "comm."
    );
    for own in modelled {
        let strong = own.strong_s.zip(own.strong_communication).map_or_else(
            || format!("{:>14}{:>12}{:>8}", "too few layers", "", ""),
            |(seconds, talk)| {
                let efficiency = 100.0 * one / (own.ranks as f64 * seconds);
                format!("{:>11.2} ms{efficiency:>10.0} %{:>6.0} %", 1e3 * seconds, 100.0 * talk)
            },
        );
        let efficiency = 100.0 * one / own.weak_s;
        let _ = writeln!(
            text,
            "{:>6}{strong}{:>17.2} ms{efficiency:>10.0} %{:>6.0} %",
            own.ranks,
            1e3 * own.weak_s,
            100.0 * own.weak_communication
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_as_square_as_the_grid_allows() {
        assert_eq!((factors(10), factors(100), factors(7)), ([5, 2], [10, 10], [7, 1]));
        let block = cut([40, 60], 4).expect("there are layers enough");
        assert_eq!((block.strained, block.cuts, block.cut_rows), (21 * 31, 2, 50));
        assert!(cut([40, 60], 1000).is_none());
    }
}
