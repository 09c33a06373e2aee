//! The links between the processes of a run: latency and bandwidth, measured and fitted.

use serde::{Deserialize, Serialize};
use solver::halo::Communicator;
use std::time::Instant;

/// A message of n bytes takes latency + n / bandwidth; an operation of P processes together log₂ P times its
/// latency (Hockney 1994; Thakur, Rabenseifner & Gropp 2005).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Network {
    /// Time that a message of no length takes [s].
    pub latency_s: f64,
    /// Bytes per second of a long message.
    #[serde(rename = "bandwidth_B_per_s")]
    pub bandwidth: f64,
    /// Time that an operation of two processes together takes [s].
    pub collective_s: f64,
}

/// Numbers in the messages that are measured.
const LENGTHS: [usize; 6] = [1, 64, 1 << 10, 1 << 13, 1 << 16, 1 << 18];

/// Times that each message is sent; the shortest time counts, which nothing disturbed.
const ROUNDS: usize = 40;

impl Network {
    /// Measures the links of the processes, each with a partner, all at once; none of one process. The same
    /// in every process.
    pub(super) fn measure(communicator: &mut dyn Communicator) -> Option<Self> {
        let (rank, size) = (communicator.rank(), communicator.size());
        if size < 2 {
            return None;
        }
        let partner = Some(rank ^ 1).filter(|other| *other < size);
        let points = LENGTHS.map(|length| {
            let mut shortest = f64::INFINITY;
            for _ in 0..ROUNDS {
                let values = vec![1.0; length];
                let messages = partner.map(|partner| (partner, values)).into_iter().collect();
                let clock = Instant::now();
                communicator.begin_exchange(messages);
                communicator.end_exchange();
                shortest = shortest.min(clock.elapsed().as_secs_f64());
            }
            [(length * size_of::<f64>()) as f64, shortest]
        });
        let mut collective = f64::INFINITY;
        for _ in 0..ROUNDS {
            let clock = Instant::now();
            communicator.begin_reduction(vec![1], Vec::new());
            communicator.end_reduction();
            collective = collective.min(clock.elapsed().as_secs_f64());
        }
        let [latency, per_byte] = fitted(&points);
        let mut slowest = [latency, per_byte, collective / (size as f64).log2()];
        if partner.is_none() {
            (slowest[0], slowest[1]) = (0.0, 0.0);
        }
        communicator.largest(&mut slowest);
        let [latency_s, per_byte, collective_s] = slowest;
        Some(Self { latency_s, bandwidth: 1.0 / per_byte, collective_s })
    }
}

/// Latency [s] and time per byte [s] of a line through points of bytes and seconds, by least squares of the
/// relative deviation; neither is negative.
fn fitted(points: &[[f64; 2]]) -> [f64; 2] {
    let [mut one, mut x, mut xx, mut y, mut xy] = [0.0; 5];
    for [bytes, seconds] in points {
        let weight = seconds.powi(-2);
        one += weight;
        x += weight * bytes;
        xx += weight * bytes * bytes;
        y += weight * seconds;
        xy += weight * bytes * seconds;
    }
    let determinant = one * xx - x * x;
    let [latency, per_byte] = [(y * xx - x * xy) / determinant, (one * xy - x * y) / determinant];
    if latency < 0.0 {
        [0.0, xy / xx]
    } else if per_byte <= 0.0 {
        [y / one, f64::MIN_POSITIVE]
    } else {
        [latency, per_byte]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_found() {
        let points = [8.0, 800.0, 8e4, 8e6].map(|bytes| [bytes, 2e-6 + bytes / 5e9]);
        let [latency, per_byte] = fitted(&points);
        assert!((latency / 2e-6 - 1.0).abs() < 1e-9 && (per_byte * 5e9 - 1.0).abs() < 1e-9);
        assert!(fitted(&[[8.0, 1e-6], [8e6, 1e-1], [8e7, 2.0]])[0] >= 0.0);
    }
}
