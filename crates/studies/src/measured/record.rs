//! A record: columns of one measurement, one run or one model, line by line.

use super::Quantity;

/// A column of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// What it is.
    pub quantity: Quantity,
    /// Its values, in SI units.
    pub values: Vec<f64>,
    /// Their standard deviations, in the same unit, where they are known.
    pub deviations: Option<Vec<f64>>,
}

/// Columns of equal length, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// What to call it: the path of a file or a folder.
    pub name: String,
    /// Its columns.
    pub channels: Vec<Channel>,
    /// Keys of the case that hold for this measurement alone, such as `body.plate.diameter=50 mm`.
    pub settings: Vec<String>,
    /// The line of the file of each row; empty of what is no file.
    pub lines: Vec<usize>,
}

impl Record {
    /// The column of a quantity.
    #[must_use]
    pub fn channel(&self, quantity: Quantity) -> Option<&Channel> {
        self.channels.iter().find(|channel| channel.quantity == quantity)
    }

    /// The values of a quantity.
    #[must_use]
    pub fn values(&self, quantity: Quantity) -> Option<&[f64]> {
        self.channel(quantity).map(|channel| channel.values.as_slice())
    }

    /// Adds a column without standard deviations.
    pub fn push(&mut self, quantity: Quantity, values: Vec<f64>) {
        self.channels.push(Channel { quantity, values, deviations: None });
    }

    /// The number of lines.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.channels.first().map_or(0, |channel| channel.values.len())
    }

    /// The quantities along which it has a curve, in the order in which they are preferred as an abscissa.
    pub fn abscissae(&self) -> impl Iterator<Item = Quantity> + '_ {
        const PREFERRED: [Quantity; 4] =
            [Quantity::Slip, Quantity::Displacement, Quantity::Sinkage, Quantity::Time];
        PREFERRED.into_iter().filter(|quantity| self.values(*quantity).is_some_and(spreads))
    }

    /// The quantities that are no abscissa, and the sinkage where it is not the one.
    pub fn ordinates(&self, abscissa: Quantity) -> impl Iterator<Item = Quantity> + '_ {
        let is_shown = move |quantity: &Quantity| {
            !quantity.is_abscissa() || (*quantity == Quantity::Sinkage && abscissa != Quantity::Sinkage)
        };
        self.channels.iter().map(|channel| channel.quantity).filter(is_shown)
    }
}

/// Whether there are two values or more that differ.
fn spreads(values: &[f64]) -> bool {
    values.first().is_some_and(|first| values.iter().any(|value| value != first))
}
