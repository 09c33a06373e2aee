//! Sobol indices of a response as bars.

use super::effects::titled;
use super::label::plain_label;
use super::named::{NamedChart, file_name};
use crate::statistics::sobol_indices::{Index, SobolIndices};
use crate::table::Column;
use coulter::output::plots::{Bar, BarGroup, Bars};

/// First-order and total indices of the factors, the largest total first, with their 90 % intervals.
#[must_use]
pub fn sobol_chart(
    response: &Column,
    model: &str,
    factors: &[&Column],
    indices: &SobolIndices,
) -> NamedChart {
    let title = titled("portions of the variance", response, model);
    let mut order: Vec<usize> = (0..factors.len().min(indices.total.len())).collect();
    order.sort_by(|a, b| indices.total[*b].value.total_cmp(&indices.total[*a].value).then(a.cmp(b)));
    let bar = |index: Index, colour| Bar {
        value: index.value,
        interval: Some(index.interval),
        colour,
        note: String::new(),
    };
    let group = |k: usize| BarGroup {
        label: plain_label(factors[k]),
        bars: vec![bar(indices.first_order[k], 0), bar(indices.total[k], 1)],
    };
    let chart = Bars {
        title: title.clone(),
        x_label: "Sobol index S, T [–]".into(),
        base: 0.0,
        shared: false,
        names: vec![("first-order S".into(), 0), ("total T".into(), 1)],
        groups: order.into_iter().map(group).collect(),
    };
    let from = match indices.predictivity {
        Some(q2) => format!(
            " They are those of a surrogate with predictivity Q² = {q2:.3}, whose error the intervals contain."
        ),
        None => String::new(),
    };
    let caption = format!(
        "First-order index: portion of the variance of {} that vanishes when this factor is known; total index: portion that remains when all others are. Factors are even over their ranges and independent. Lines: 90 % intervals.{from}",
        plain_label(response)
    );
    NamedChart { name: file_name(&["sobol", &response.name, model]), title, caption, svg: chart.svg() }
}

#[cfg(test)]
mod tests {
    use super::super::samples::grid;
    use super::*;
    use crate::statistics::sobol_indices::sobol_indices;

    #[test]
    fn the_factor_that_matters_most_comes_first() {
        let table = grid();
        let [angle, depth, drag] = ["angle", "depth", "drag"].map(|name| table.column(name).unwrap());
        let indices = sobol_indices(|x| x[0] + 3.0 * x[1], 2, 256, 1).unwrap();
        let chart = sobol_chart(drag, "", &[angle, depth], &indices);
        assert!(chart.svg.find(">depth<").unwrap() < chart.svg.find(">angle<").unwrap());
        assert!(!chart.caption.contains("surrogate"));
    }
}
