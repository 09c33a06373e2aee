//! What a calibration fits: points of measured curves, few enough to be independent.

use crate::measured::{Channel, Quantity, Record};
use crate::sources::{LeftOut, rising_rows, says_nothing};
use coulter::history::blocks::{block_averages, standard_error};

/// One curve: values of a quantity along an abscissa, or one steady mean.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    /// Number of the measurement that the curve is from.
    pub record: usize,
    /// Name of the curve, for people.
    pub name: String,
    /// The quantity that was measured.
    pub quantity: Quantity,
    /// The quantity along which the curve runs; `None` for the steady mean of a tow.
    pub abscissa: Option<Quantity>,
    /// Places along the abscissa, in SI units; one for a steady mean: the middle of the window.
    pub at: Vec<f64>,
    /// Values [SI].
    pub values: Vec<f64>,
    /// Standard deviations of the values [SI], where they are known.
    pub deviations: Option<Vec<f64>>,
    /// Whether residuals are those of logarithms: of values that are all positive.
    pub is_logarithmic: bool,
    /// What residuals are relative to where they are not logarithms, by point [SI].
    pub scales: Vec<f64>,
}

/// Points of a curve at most; more are averaged, since neighbours are not independent.
const MOST_POINTS: usize = 20;
/// The part of a tow that counts as steady, at its end.
const STEADY: f64 = 0.4;
/// Fraction of the largest value below which noise no longer falls with the value, of curves that change
/// their sign (chosen).
const FLOOR: f64 = 0.1;

/// How curves are taken from measurements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// The quantities to be fitted; empty for all that are forces, pressures or torques, or the sinkage of a
    /// tow.
    pub quantities: Vec<Quantity>,
    /// The part of the abscissa that counts [SI].
    pub window: Option<[f64; 2]>,
    /// Whether curves follow the sinkage: the body is pressed down, or its model is one of the sinkage.
    pub is_pressed: bool,
}

/// Curves, and what was left out of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Taken {
    /// The curves.
    pub curves: Vec<MeasuredCurve>,
    /// The points that say nothing.
    pub left_out: Vec<LeftOut>,
}

/// For the abscissae of a measurement why a model says nothing there: from the number of the measurement, the
/// quantity along which they run, and the abscissae.
pub type Judge<'a> = dyn Fn(usize, Quantity, &[f64]) -> Vec<Option<String>> + 'a;

impl Selection {
    /// The curves of the measurements, without rows that say nothing by construction.
    ///
    /// # Errors
    /// Which measurement has none, and why.
    pub fn curves(&self, records: &[Record]) -> Result<Taken, String> {
        self.curves_where(records, &|_, _, at| vec![None; at.len()])
    }

    /// The curves of the measurements where a model says something.
    ///
    /// # Errors
    /// Which measurement has none, and why.
    pub fn curves_where(&self, records: &[Record], judge: &Judge<'_>) -> Result<Taken, String> {
        let mut taken = Taken::default();
        for (number, record) in records.iter().enumerate() {
            let before = taken.curves.len();
            let (abscissa, is_steady) = self.abscissa(record)?;
            for quantity in self.wanted(record, abscissa) {
                let said = |at: &[f64]| judge(number, abscissa, at);
                let found = self.curve(record, quantity, (abscissa, is_steady), &said);
                let (mut curve, left_out) =
                    found.map_err(|why| format!("{}: {}: {why}", record.name, quantity.name()))?;
                curve.record = number;
                taken.curves.push(curve);
                taken.left_out.extend(left_out);
            }
            if taken.curves.len() == before {
                return Err(format!(
                    "{}: it has no column to be fitted; add drag [N], vertical [N], pressure [kPa] or axle torque [N m]",
                    record.name
                ));
            }
        }
        Ok(taken)
    }

    /// Along what the curves of a record run, and whether only their steady mean counts.
    fn abscissa(&self, record: &Record) -> Result<(Quantity, bool), String> {
        let found: Vec<Quantity> = record.abscissae().collect();
        let has = |quantity: Quantity| found.contains(&quantity);
        match found.first() {
            Some(Quantity::Slip) => Ok((Quantity::Slip, false)),
            _ if self.is_pressed && has(Quantity::Sinkage) => Ok((Quantity::Sinkage, false)),
            Some(first) if !self.is_pressed => Ok((*first, *first != Quantity::Sinkage)),
            _ => Err(format!(
                "{}: the body is pressed down, and the file has no sinkage along which its force could be fitted; add the column sinkage [mm]",
                record.name
            )),
        }
    }

    fn wanted(&self, record: &Record, abscissa: Quantity) -> Vec<Quantity> {
        let usual = [
            Quantity::Drag,
            Quantity::Vertical,
            Quantity::Pressure,
            Quantity::Torque,
            Quantity::MomentX,
            Quantity::MomentY,
            Quantity::MomentZ,
        ];
        let is_wanted = |quantity: &Quantity| {
            if self.quantities.is_empty() {
                usual.contains(quantity)
            } else {
                self.quantities.contains(quantity)
            }
        };
        record.ordinates(abscissa).filter(is_wanted).collect()
    }

    fn curve(
        &self,
        record: &Record,
        quantity: Quantity,
        (abscissa, is_steady): (Quantity, bool),
        said: &dyn Fn(&[f64]) -> Vec<Option<String>>,
    ) -> Result<(MeasuredCurve, Vec<LeftOut>), String> {
        let (Some(x), Some(channel)) = (record.values(abscissa), record.channel(quantity)) else {
            return Err("it has no such column".to_owned());
        };
        let [from, to] = self.window.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let mut rows = rising_rows(x, &channel.values);
        rows.retain(|row| x[*row] >= from && x[*row] <= to);
        if rows.len() < 2 {
            return Err("fewer than two of its points lie in the window".to_owned());
        }
        let (rows, left_out) = self.telling(record, (abscissa, quantity), &rows, said)?;
        let points: Vec<[f64; 2]> = rows.iter().map(|row| [x[*row], channel.values[*row]]).collect();
        let deviations = deviations_at(channel, &rows);
        let (at, values, deviations) = if is_steady {
            steady(&points, self.window.is_some())
        } else {
            averaged(&points, deviations.as_deref())
        };
        let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if largest == 0.0 {
            return Err("all its values are 0".to_owned());
        }
        let curve = MeasuredCurve {
            record: 0,
            name: format!("{} of {}", quantity.name(), record.name),
            quantity,
            abscissa: (!is_steady).then_some(abscissa),
            is_logarithmic: values.iter().all(|value| *value > 0.0),
            scales: values.iter().map(|value| value.abs().max(FLOOR * largest)).collect(),
            at,
            values,
            deviations,
        };
        Ok((curve, left_out))
    }

    /// The rows that say something of a model, and the others with the reason.
    fn telling(
        &self,
        record: &Record,
        (abscissa, quantity): (Quantity, Quantity),
        rows: &[usize],
        said: &dyn Fn(&[f64]) -> Vec<Option<String>>,
    ) -> Result<(Vec<usize>, Vec<LeftOut>), String> {
        let [x, y] = [abscissa, quantity].map(|quantity| record.values(quantity).unwrap_or_default());
        let nothing = |row: &usize| {
            says_nothing(self.is_pressed, (abscissa, x[*row]), (quantity, y[*row])).map(str::to_owned)
        };
        let speaking: Vec<usize> = rows.iter().copied().filter(|row| nothing(row).is_none()).collect();
        let at: Vec<f64> = speaking.iter().map(|row| x[*row]).collect();
        let refused: Vec<(usize, Option<String>)> = speaking.into_iter().zip(said(&at)).collect();
        let kept: Vec<usize> = refused.iter().filter(|(_, why)| why.is_none()).map(|(row, _)| *row).collect();
        let mut silent: Vec<(usize, f64, String)> = rows
            .iter()
            .filter_map(|row| Some((*row, x[*row], nothing(row)?)))
            .chain(refused.into_iter().filter_map(|(row, why)| Some((row, x[row], why?))))
            .collect();
        silent.sort_by_key(|(row, ..)| *row);
        let left_out = LeftOut::of(record, (abscissa, quantity), &silent);
        if kept.is_empty() {
            let all: Vec<String> = left_out.iter().map(LeftOut::text).collect();
            return Err(format!("no point is left: {}", all.join("; ")));
        }
        Ok((kept, left_out))
    }
}

impl MeasuredCurve {
    /// A value as residuals see it: its logarithm, or its part of the scale; `None` of one that has no
    /// logarithm.
    #[must_use]
    pub fn seen(&self, point: usize, value: f64) -> Option<f64> {
        let seen = if self.is_logarithmic { value.ln() } else { value / self.scales[point] };
        seen.is_finite().then_some(seen)
    }

    /// The value that is seen so [SI].
    #[must_use]
    pub fn unseen(&self, point: usize, seen: f64) -> f64 {
        if self.is_logarithmic { seen.exp() } else { seen * self.scales[point] }
    }

    /// The known standard deviation of a point as residuals see it.
    #[must_use]
    pub fn seen_deviation(&self, point: usize) -> Option<f64> {
        self.deviations.as_ref().map(|deviations| deviations[point] / self.scales[point])
    }
}

/// The standard deviations of the rows that are left.
fn deviations_at(channel: &Channel, rows: &[usize]) -> Option<Vec<f64>> {
    let all = channel.deviations.as_ref()?;
    rows.iter().map(|row| all.get(*row).copied()).collect()
}

type Points = (Vec<f64>, Vec<f64>, Option<Vec<f64>>);

/// One point: the mean over the end of the tow, or over the window, with the standard error of its blocks.
fn steady(points: &[[f64; 2]], has_window: bool) -> Points {
    let (first, last) = (points[0][0], points[points.len() - 1][0]);
    let begin = if has_window { first } else { last - STEADY * (last - first) };
    let values: Vec<f64> = points.iter().filter(|p| p[0] >= begin).map(|p| p[1]).collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let error = block_averages(&values).map(|blocks| standard_error(&blocks)).filter(|error| *error > 0.0);
    (vec![0.5 * (begin + last)], vec![mean], error.map(|error| vec![error]))
}

/// The points, or, of many, their means over even parts of the abscissa. What is known of their deviations is
/// kept: neighbours may be off by the same.
fn averaged(points: &[[f64; 2]], deviations: Option<&[f64]>) -> Points {
    if points.len() <= MOST_POINTS {
        let (at, values) = points.iter().map(|[x, y]| (*x, *y)).unzip();
        return (at, values, deviations.map(<[f64]>::to_vec));
    }
    let (first, last) = (points[0][0], points[points.len() - 1][0]);
    let part = |x: f64| (((x - first) / (last - first) * MOST_POINTS as f64) as usize).min(MOST_POINTS - 1);
    let (mut at, mut values, mut kept) = (Vec::new(), Vec::new(), Vec::new());
    for n in 0..MOST_POINTS {
        let inside: Vec<usize> = (0..points.len()).filter(|m| part(points[*m][0]) == n).collect();
        if inside.is_empty() {
            continue;
        }
        let mean =
            |of: &dyn Fn(usize) -> f64| inside.iter().map(|m| of(*m)).sum::<f64>() / inside.len() as f64;
        at.push(mean(&|m| points[m][0]));
        values.push(mean(&|m| points[m][1]));
        kept.extend(deviations.map(|all| mean(&|m| all[m])));
    }
    (at, values, deviations.map(|_| kept))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::parse;

    #[test]
    fn plates_follow_the_sinkage_and_tows_have_a_steady_mean() {
        let plate = parse("depth [mm],force [N],drag [N]\n5,10,0\n10,30,0\n15,60,0\n", "p").unwrap();
        let pressed =
            Selection { quantities: vec![Quantity::Vertical], is_pressed: true, ..Selection::default() };
        let curves = pressed.curves(&[plate]).unwrap().curves;
        assert_eq!(curves[0].values, [10.0, 30.0, 60.0]);
        assert!(curves[0].is_logarithmic && curves[0].abscissa == Some(Quantity::Sinkage));
        let line = |n: u32| format!("{},{}\n", 0.01 * f64::from(n), if n < 50 { n } else { 50 });
        let tow = format!("u [m],drag [N]\n{}", (0..=100).map(line).collect::<String>());
        let curves = Selection::default().curves(&[parse(&tow, "t").unwrap()]).unwrap().curves;
        assert_eq!((curves[0].values.as_slice(), curves[0].abscissa), (&[50.0][..], None));
    }

    #[test]
    fn long_curves_are_averaged_and_what_cannot_be_fitted_is_refused() {
        let line = |n: u32| format!("{n},{},2\n", 1 + n);
        let text = format!("z [mm],force [N],force sd [N]\n{}", (0..400).map(line).collect::<String>());
        let pressed = Selection { is_pressed: true, ..Selection::default() };
        let curves = pressed.curves(&[parse(&text, "p").unwrap()]).unwrap().curves;
        assert_eq!(curves[0].at.len(), MOST_POINTS);
        assert_eq!(curves[0].deviations.as_deref(), Some(&[2.0; MOST_POINTS][..]));
        let timed = parse("t [s],force [N]\n1,2\n2,3\n", "p").unwrap();
        assert!(pressed.curves(&[timed]).unwrap_err().contains("sinkage [mm]"));
        let lifted = parse("z [mm],force [N]\n0,0\n5,10\n8,0\n10,30\n15,60\n", "p").unwrap();
        let taken = pressed.curves(&[lifted]).unwrap();
        assert_eq!(taken.curves[0].values, [10.0, 30.0, 60.0]);
        assert!(taken.curves[0].is_logarithmic && taken.left_out.len() == 2);
        assert_eq!(taken.left_out[1].lines, [4]);
        let none = parse("z [mm],speed [m/s]\n1,2\n2,3\n", "p").unwrap();
        assert!(pressed.curves(&[none]).unwrap_err().contains("no column to be fitted"));
    }
}
