//! The table of indices: what each factor means for each response of each model.

use crate::statistics::regression::Regression;
use crate::statistics::sobol_indices::{Index, SobolIndices};
use crate::table::{Column, Role, Table, Values};

/// A row of the table.
#[derive(Clone, Debug, Default)]
pub(super) struct IndexRow {
    /// Names of model, response and factor.
    pub(super) names: [String; 3],
    /// First-order and total index.
    pub(super) indices: [Option<Index>; 2],
    /// Predictivity of the surrogate behind them [–].
    pub(super) predictivity: Option<f64>,
    /// Width of the swing of the response over its base [–].
    pub(super) swing: Option<f64>,
    /// Coefficient and determination of the linear regression, and of that of ranks [–].
    pub(super) regressions: [Option<[f64; 2]>; 2],
    /// Number of points.
    pub(super) points: usize,
}

impl IndexRow {
    /// Takes over what indices say of factor `k`.
    pub(super) fn set_indices(&mut self, indices: &SobolIndices, k: usize) {
        self.indices = [indices.first_order.get(k).copied(), indices.total.get(k).copied()];
    }

    /// Takes over what a regression says of factor `k`.
    pub(super) fn set_regression(&mut self, which: usize, regression: &Regression, k: usize) {
        let pair = regression.coefficients.get(k).map(|coefficient| [*coefficient, regression.determination]);
        self.regressions[which] = pair;
    }
}

/// The rows as a table.
pub(super) fn index_table(rows: &[IndexRow]) -> Table {
    let words = |name: &str, n: usize| {
        let list =
            rows.iter().map(|row| Some(row.names[n].clone()).filter(|word| !word.is_empty())).collect();
        column(name, name, "", Role::Key, Values::Words(list))
    };
    let numbers = |name: &str, label: &str, value: &dyn Fn(&IndexRow) -> Option<f64>| {
        column(name, label, "-", Role::Response, Values::Numbers(rows.iter().map(value).collect()))
    };
    let mut columns = vec![words("model", 0), words("response", 1), words("factor", 2)];
    for (n, (name, label)) in [("first_order", "first-order S"), ("total", "total T")].into_iter().enumerate()
    {
        columns.push(numbers(name, label, &|row| row.indices[n].map(|index| index.value)));
        for (end, word) in ["low", "high"].into_iter().enumerate() {
            let label = format!("{label}, {word} end");
            columns.push(numbers(&format!("{name}_{word}"), &label, &|row| {
                row.indices[n].map(|i| i.interval[end])
            }));
        }
    }
    columns.push(numbers("predictivity", "predictivity Q²", &|row| row.predictivity));
    columns.push(numbers("swing", "swing over base", &|row| row.swing));
    for (n, (name, label)) in [("linear", "linear"), ("rank", "of ranks")].into_iter().enumerate() {
        let [coefficient, determination] = [format!("{name}_coefficient"), format!("{name}_determination")];
        columns.push(numbers(&coefficient, &format!("coefficient, {label}"), &|row| {
            row.regressions[n].map(|r| r[0])
        }));
        columns
            .push(numbers(&determination, &format!("R², {label}"), &|row| row.regressions[n].map(|r| r[1])));
    }
    columns.push(numbers("points", "points", &|row| Some(row.points as f64)));
    Table { columns }
}

/// A column.
pub(super) fn column(name: &str, label: &str, unit: &str, role: Role, values: Values) -> Column {
    Column { name: name.to_owned(), unit: unit.to_owned(), label: label.to_owned(), role, values }
}
