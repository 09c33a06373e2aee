//! The HTML text of the page, from a template.

use super::gaps::{Gap, gaps};
use super::shown::{ShownTable, shown_table};
use crate::analysis::{Analysis, NamedTable};
use crate::charts::NamedChart;
use crate::table::Table;
use coulter::output::render_page;
use serde::Serialize;

const TEMPLATE: &str = include_str!("../../assets/study.html");

/// The page cannot be made: its template and its content do not agree.
#[derive(Debug, thiserror::Error)]
#[error("the page of the study cannot be made: {0}")]
pub struct PageError(#[from] minijinja::Error);

/// A figure for print on the page.
#[derive(Clone, Debug)]
pub struct PageFigure {
    /// The figure.
    pub chart: NamedChart,
    /// Whether the figure is two columns wide.
    pub is_wide: bool,
}

/// The content of the page.
#[derive(Clone, Debug, Default)]
pub struct Page {
    /// Title.
    pub title: String,
    /// What the study is about; lines are kept.
    pub description: String,
    /// Facts: name and text.
    pub facts: Vec<(String, String)>,
    /// Number of rows of the table of the study.
    pub rows: usize,
    /// Rows whose figures are not used.
    pub gaps: Vec<Gap>,
    /// Warnings, shown above everything else but the gaps.
    pub warnings: Vec<String>,
    /// Remarks on what could not be computed.
    pub remarks: Vec<String>,
    /// Figures for print, with their files in the folder `figures` beside the page.
    pub figures: Vec<PageFigure>,
    /// Charts.
    pub charts: Vec<NamedChart>,
    /// Tables; columns without values are left out, and rows after the first two hundred.
    pub tables: Vec<NamedTable>,
    /// Version of the program.
    pub version: String,
}

impl Page {
    /// The page of a study with its analysis; facts count its rows, warnings are left to the caller.
    #[must_use]
    pub fn of(title: &str, description: &str, table: &Table, analysis: Analysis) -> Self {
        let (rows, gaps) = (table.rows(), gaps(table));
        let without: usize = gaps.iter().map(|gap| gap.count).sum();
        let fact = |name: &str, text: String| (name.to_owned(), text);
        Self {
            title: title.to_owned(),
            description: description.to_owned(),
            facts: vec![fact("rows", rows.to_string()), fact("done", (rows - without).to_string())],
            rows,
            gaps,
            warnings: Vec::new(),
            remarks: analysis.remarks,
            figures: Vec::new(),
            charts: analysis.charts,
            tables: analysis.tables,
            version: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }
}

/// A chart as the template sees it.
#[derive(Serialize)]
struct ShownChart<'a> {
    name: &'a str,
    caption: &'a str,
    svg: &'a str,
    is_wide: bool,
}

impl<'a> ShownChart<'a> {
    fn of(chart: &'a NamedChart) -> Self {
        Self { name: &chart.name, caption: &chart.caption, svg: &chart.svg, is_wide: false }
    }
}

/// The page as the template sees it.
#[derive(Serialize)]
struct Content<'a> {
    title: &'a str,
    description: &'a str,
    facts: &'a [(String, String)],
    rows: usize,
    without: usize,
    gaps: &'a [Gap],
    warnings: &'a [String],
    remarks: &'a [String],
    figures: Vec<ShownChart<'a>>,
    charts: Vec<ShownChart<'a>>,
    tables: Vec<ShownTable>,
    version: &'a str,
}

/// The HTML text of a page. Everything but the charts is escaped.
///
/// # Errors
/// [`PageError`] where template and content do not agree.
pub fn page(page: &Page) -> Result<String, PageError> {
    let content = Content {
        title: &page.title,
        description: &page.description,
        facts: &page.facts,
        rows: page.rows,
        without: page.gaps.iter().map(|gap| gap.count).sum(),
        gaps: &page.gaps,
        warnings: &page.warnings,
        remarks: &page.remarks,
        figures: page
            .figures
            .iter()
            .map(|figure| ShownChart { is_wide: figure.is_wide, ..ShownChart::of(&figure.chart) })
            .collect(),
        charts: page.charts.iter().map(ShownChart::of).collect(),
        tables: page.tables.iter().map(shown_table).collect(),
        version: &page.version,
    };
    Ok(render_page(TEMPLATE, &content, &[])?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{AnalysisRequest, analyse};
    use crate::charts::samples::grid;

    #[test]
    fn the_page_contains_all_and_names_the_gaps_first() {
        let table = grid();
        let analysis = analyse(&table, &AnalysisRequest::default());
        let mut made = Page::of("Angles & <depths>", "First line.\nSecond line.", &table, analysis);
        made.warnings.push("The range is wide.".into());
        let html = page(&made).unwrap();
        assert!(
            html.contains("<h1><bdi>Angles &amp; &lt;depths&gt;</bdi></h1>")
                && html.contains("prefers-color-scheme: dark")
        );
        let [gap, chart] = ["1 of 40 rows are not used", "<svg"].map(|text| html.find(text).unwrap());
        assert!(
            gap < chart && html.contains("The range is wide.") && html.contains("What each factor means")
        );
        assert_eq!(html.matches("<figure").count(), made.charts.len());
        assert!(
            !html.contains("http")
                || html.matches("http").count() == html.matches("http://www.w3.org/2000/svg").count()
        );
        assert_eq!(html, page(&made).unwrap());
    }
}
