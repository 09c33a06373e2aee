//! Curves of single runs over their history.

use super::family::ToldFigure;
use coulter::output::figure::{Figure, FigureAxis, FigurePoint, FigureSeries, SeriesKind};

/// The history of a run along two columns.
#[derive(Clone, Debug, PartialEq)]
pub struct RunCurve {
    /// The level of the family, or what tells the run from others.
    pub level: String,
    /// Grade of the run.
    pub grade: String,
    /// Values on both axes; not-a-number where one is not defined.
    pub points: Vec<[f64; 2]>,
}

/// The figure of curves over two axes: one line for each level and grade, with a gap between runs.
///
/// # Errors
/// A sentence where there is no run.
pub fn history_figure(name: &str, axes: [FigureAxis; 2], curves: &[RunCurve]) -> Result<ToldFigure, String> {
    let mut series: Vec<FigureSeries> = Vec::new();
    for curve in curves {
        let is_doubtful = curve.grade == "doubtful";
        let level = if is_doubtful && !curve.level.is_empty() {
            format!("{} (doubtful)", curve.level)
        } else {
            curve.level.clone()
        };
        let point =
            |at: &[f64; 2]| FigurePoint { at: *at, grade: curve.grade.clone(), ..FigurePoint::default() };
        let points = curve.points.iter().map(point);
        match series.iter_mut().find(|other| other.level == level) {
            Some(same) => {
                same.points.push(FigurePoint { at: [f64::NAN; 2], ..FigurePoint::default() });
                same.points.extend(points);
            }
            None => {
                let (kind, source) = (SeriesKind::Line, "solver".to_owned());
                series.push(FigureSeries { kind, level, source, points: points.collect() });
            }
        }
    }
    if series.is_empty() {
        return Err("no run of the solver is done".to_owned());
    }
    let runs = if curves.len() == 1 { "one run".to_owned() } else { format!("{} runs", curves.len()) };
    let [x, y] = axes;
    let words = |label: &str| label.split(" [").next().unwrap_or_default().to_owned();
    let caption = format!("{} over {} of {runs}.", words(&y.label), words(&x.label));
    Ok(ToldFigure { figure: Figure { name: name.to_owned(), x, y, series, ..Figure::default() }, caption })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_one_level_are_one_series_with_a_gap() {
        let curve = |level: &str, grade: &str| RunCurve {
            level: level.into(),
            grade: grade.into(),
            points: vec![[0.0, 1.0], [1.0, 2.0]],
        };
        let curves =
            [curve("φ = 30 deg", "good"), curve("φ = 35 deg", "doubtful"), curve("φ = 30 deg", "good")];
        let told = history_figure("h", [FigureAxis::default(), FigureAxis::default()], &curves).unwrap();
        let levels: Vec<&str> = told.figure.series.iter().map(|one| one.level.as_str()).collect();
        assert_eq!(levels, ["φ = 30 deg", "φ = 35 deg (doubtful)"]);
        assert_eq!(told.figure.series[0].points.len(), 5);
        assert!(told.figure.series[0].points[2].at[0].is_nan() && told.caption.contains("3 runs"));
        assert!(history_figure("h", [FigureAxis::default(), FigureAxis::default()], &[]).is_err());
    }
}
