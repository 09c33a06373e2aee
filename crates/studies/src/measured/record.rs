//! A record: columns of one measurement, one run or one model, line by line.

use super::Quantity;
use coulter::case::quantity::plain;
use coulter::history::reference::Reference;

/// The reference of which a dimensionless column is a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// The reference length d of the body.
    Length,
    /// Reference force γ t d².
    Force,
}

/// A column of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Quantity of the column.
    pub quantity: Quantity,
    /// Values of the channel, in SI units.
    pub values: Vec<f64>,
    /// Standard deviations of the values, in the same unit, where they are known.
    pub deviations: Option<Vec<f64>>,
    /// The reference of which the values are parts, of a dimensionless column that was not scaled yet.
    pub group: Option<Group>,
    /// Title of the column in its file; empty of a run.
    pub title: String,
    /// Whether the sign of the column was stated, so that it is not to be doubted.
    pub is_stated: bool,
}

/// Columns of equal length, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Name of the record: the path of a file or a folder.
    pub name: String,
    /// Columns of the record.
    pub channels: Vec<Channel>,
    /// Keys of the case that hold for this measurement alone, such as `body.plate.diameter=50 mm`.
    pub settings: Vec<String>,
    /// The line of the file of each row; empty of what is no file.
    pub lines: Vec<usize>,
    /// Titles of the columns in the file; empty of a run.
    pub titles: Vec<String>,
    /// Remarks on how the file was read.
    pub remarks: Vec<String>,
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
        self.channels.push(Channel {
            quantity,
            values,
            deviations: None,
            group: None,
            title: String::new(),
            is_stated: true,
        });
    }

    /// Whether a column is dimensionless, and was not scaled yet.
    #[must_use]
    pub fn has_groups(&self) -> bool {
        self.channels.iter().any(|channel| channel.group.is_some())
    }

    /// Refuses dimensionless columns where nothing says how to scale them.
    ///
    /// # Errors
    /// Which, with a cure.
    pub fn refuse_groups(&self) -> Result<(), String> {
        match self.channels.iter().find(|channel| channel.group.is_some()) {
            Some(channel) => Err(format!(
                "{}: \"{}\" is dimensionless, and only a comparison with a case or a run says what it is a part of; give it as {}",
                self.name,
                channel.title,
                channel.quantity.header()
            )),
            None => Ok(()),
        }
    }

    /// Scales dimensionless columns with the length d and the force γ t d² of a body.
    ///
    /// # Errors
    /// Why a force cannot be.
    pub fn scale(&mut self, reference: &Reference) -> Result<(), String> {
        let force =
            reference.force().ok_or_else(|| format!("{}: weightless soil scales no forces", self.name));
        for channel in &mut self.channels {
            let factor = match channel.group.take() {
                Some(Group::Length) => reference.length,
                Some(Group::Force) => force.clone()?,
                None => continue,
            };
            let deviations = channel.deviations.iter_mut().flatten();
            channel.values.iter_mut().chain(deviations).for_each(|value| *value *= factor);
        }
        self.remarks.push(format!(
            "dimensionless columns were scaled with d = {} m, t = {} m and γ = {} N/m³ of `{}`",
            plain(reference.length),
            plain(reference.width),
            plain(reference.unit_weight),
            reference.name
        ));
        Ok(())
    }

    /// Remarks on the record, each with the name of the file.
    pub fn named_remarks(&self) -> impl Iterator<Item = String> + '_ {
        self.remarks.iter().map(|remark| format!("{}: {remark}", self.name))
    }

    /// The number of lines.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.channels.first().map_or(0, |channel| channel.values.len())
    }

    /// The quantities along which the record has a curve, in the order in which they are preferred as an
    /// abscissa.
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
