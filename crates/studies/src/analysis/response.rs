//! A response of one model: its effects, its surrogate, its indices.

use super::factors::VariedFactor;
use super::indices::IndexRow;
use super::sample::Sample;
use super::space::fills_space;
use crate::charts::{
    FactorEffect, NamedChart, main_effects_chart, plain_label, sobol_chart, surrogate_chart, tornado_chart,
};
use crate::statistics::effects::{LevelMean, main_effect};
use crate::statistics::gaussian_process::{GaussianProcess, fit};
use crate::statistics::regression::{linear_regression, rank_regression};
use crate::statistics::sobol_indices::{ROWS, SobolIndices, sobol_indices_of_surrogate};
use crate::statistics::tornado::tornado;
use crate::table::Column;

/// What is analysed.
pub(super) struct Question<'a> {
    /// The response.
    pub(super) response: &'a Column,
    /// Name of the model; empty where the table has one only.
    pub(super) model: &'a str,
    /// The factors of the inputs of the sample.
    pub(super) factors: &'a [VariedFactor<'a>],
    /// Seed of the random numbers.
    pub(super) seed: u64,
}

/// What came out.
#[derive(Debug, Default)]
pub(super) struct Answer {
    pub(super) charts: Vec<NamedChart>,
    pub(super) rows: Vec<IndexRow>,
    /// Main effects: number of the factor, its levels.
    pub(super) effects: Vec<(usize, Vec<LevelMean>)>,
    pub(super) remarks: Vec<String>,
}

impl Question<'_> {
    /// Effects, surrogate and indices from a sample in which the response varies.
    pub(super) fn answer(&self, sample: &Sample) -> Answer {
        let mut answer = Answer::default();
        for k in 0..self.factors.len() {
            // A factor may be constant over the points that have a result.
            if let Ok(levels) = main_effect(&sample.column(k), &sample.values) {
                answer.effects.push((k, levels));
            }
        }
        let effect = |(k, levels): &(usize, Vec<LevelMean>)| FactorEffect {
            factor: self.factors[*k].column,
            words: &self.factors[*k].words,
            levels: levels.clone(),
        };
        let effects: Vec<FactorEffect<'_>> = answer.effects.iter().map(effect).collect();
        if !effects.is_empty() {
            answer.charts.push(main_effects_chart(self.response, self.model, &effects));
        }
        // A single factor cannot be ranked.
        if self.factors.len() < 2 {
            return answer;
        }
        let named = |k: usize| IndexRow {
            names: [self.model, &self.response.name, &self.factors[k].column.name].map(str::to_owned),
            points: sample.values.len(),
            ..IndexRow::default()
        };
        answer.rows = (0..self.factors.len()).map(named).collect();
        let surrogate = self.surrogate(sample, &mut answer);
        self.tornado(sample, surrogate.as_ref(), &mut answer);
        self.regressions(sample, &mut answer);
        answer
    }

    /// The surrogate where the design bears one, with its chart, and the indices where it predicts.
    fn surrogate(&self, sample: &Sample, answer: &mut Answer) -> Option<GaussianProcess> {
        let fitted = fills_space(sample, self.factors)
            .and_then(|()| fit(&sample.inputs, &sample.values).map_err(|error| error.to_string()));
        let surrogate = match fitted {
            Ok(surrogate) => surrogate,
            Err(why) => {
                answer.remarks.push(self.said(&format!("Sobol indices are not computed: {why}")));
                return None;
            }
        };
        answer.charts.push(surrogate_chart(self.response, self.model, &surrogate));
        answer.rows.iter_mut().for_each(|row| row.predictivity = Some(surrogate.predictivity()));
        let ranges: Vec<[f64; 2]> = (0..self.factors.len()).map(|k| sample.range(k)).collect();
        match sobol_indices_of_surrogate(&surrogate, &ranges, ROWS, self.seed) {
            Ok(indices) => self.indices(&indices, answer),
            Err(why) => answer.remarks.push(self.said(&format!("Sobol indices are not computed: {why}"))),
        }
        Some(surrogate)
    }

    fn indices(&self, indices: &SobolIndices, answer: &mut Answer) {
        let columns: Vec<&Column> = self.factors.iter().map(|factor| factor.column).collect();
        answer.charts.push(sobol_chart(self.response, self.model, &columns, indices));
        for (k, row) in answer.rows.iter_mut().enumerate() {
            row.set_indices(indices, k);
        }
    }

    fn tornado(&self, sample: &Sample, surrogate: Option<&GaussianProcess>, answer: &mut Answer) {
        match tornado(&sample.inputs, &sample.values, surrogate) {
            Ok(found) => {
                let factors: Vec<(&Column, &[String])> =
                    self.factors.iter().map(|factor| (factor.column, factor.words.as_slice())).collect();
                answer.charts.insert(
                    answer.charts.len().min(1),
                    tornado_chart(self.response, self.model, &found, &factors),
                );
                for swing in &found.swings {
                    let width = (swing.responses[1] - swing.responses[0]).abs() / found.base.abs();
                    answer.rows[swing.factor].swing = Some(width).filter(|width| width.is_finite());
                }
            }
            Err(why) => answer.remarks.push(self.said(&format!("there is no tornado: {why}"))),
        }
    }

    fn regressions(&self, sample: &Sample, answer: &mut Answer) {
        // Words that have no order have no slope either.
        if self.factors.iter().any(|factor| factor.words.len() > 2) {
            return;
        }
        let found =
            [linear_regression, rank_regression].map(|regression| regression(&sample.inputs, &sample.values));
        for (which, result) in found.iter().enumerate() {
            match result {
                Ok(regression) => {
                    let rows = answer.rows.iter_mut().enumerate();
                    rows.for_each(|(k, row)| row.set_regression(which, regression, k));
                }
                Err(why) if which == 0 => {
                    answer.remarks.push(self.said(&format!("there is no regression: {why}")))
                }
                Err(_) => {}
            }
        }
    }

    /// A remark with what it is about.
    pub(super) fn said(&self, text: &str) -> String {
        let of = if self.model.is_empty() { String::new() } else { format!(" ({})", self.model) };
        format!("{}{of}: {text}.", plain_label(self.response))
    }
}
