//! A self-contained HTML page of tables and charts, in the look of the report of a run; tables as text for a
//! terminal.

pub(crate) use coulter::case::quantity::short;
use coulter::output::render_page;
use serde::Serialize;

const TEMPLATE: &str = include_str!("../assets/sheet.html");

/// A page.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Sheet {
    /// Title of the sheet.
    pub title: String,
    /// Facts at the head of the sheet: name and text.
    pub facts: Vec<[String; 2]>,
    /// Warnings: what is the matter, and what to do.
    pub warnings: Vec<[String; 2]>,
    /// Sections of the sheet.
    pub sections: Vec<SheetSection>,
    /// Text at the foot of the sheet.
    pub footer: String,
}

/// A section.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SheetSection {
    /// Title of the section.
    pub title: String,
    /// Note on the section; empty for none.
    pub note: String,
    /// Tables of the section.
    pub tables: Vec<SheetTable>,
    /// Charts of the section.
    pub figures: Vec<SheetFigure>,
}

/// A table of texts.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SheetTable {
    /// Names of the columns.
    pub head: Vec<String>,
    /// Rows, each with a cell for every column.
    pub rows: Vec<Vec<String>>,
}

/// A chart with its caption.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SheetFigure {
    /// The chart as SVG.
    pub svg: String,
    /// Caption of the chart.
    pub caption: String,
}

impl Sheet {
    /// The page as HTML.
    ///
    /// # Errors
    /// What the template engine says; only a defect of the program can cause it.
    pub fn html(&self) -> Result<String, String> {
        render_page(TEMPLATE, self, &[]).map_err(|error| error.to_string())
    }
}

impl SheetTable {
    /// The table as text: the first column to the left, the others to the right.
    #[must_use]
    pub fn text(&self) -> String {
        let lines: Vec<&Vec<String>> = std::iter::once(&self.head).chain(&self.rows).collect();
        let width =
            |n: usize| lines.iter().filter_map(|l| l.get(n)).map(|c| c.chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..self.head.len()).map(width).collect();
        let padded = |(n, cell): (usize, &String)| {
            let blanks = " ".repeat(widths.get(n).map_or(0, |w| w.saturating_sub(cell.chars().count())));
            if n == 0 { format!("{cell}{blanks}") } else { format!("{blanks}{cell}") }
        };
        let line = |cells: &&Vec<String>| {
            let text = cells.iter().enumerate().map(padded).collect::<Vec<_>>().join("  ");
            format!("{}\n", text.trim_end())
        };
        lines.iter().map(line).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_aligned_and_pages_escaped() {
        let cells = |list: [&str; 2]| list.map(str::to_owned).to_vec();
        let table = SheetTable { head: cells(["what", "N"]), rows: vec![cells(["a<b", "1234"])] };
        assert_eq!(table.text(), "what     N\na<b   1234\n");
        let section = SheetSection { title: "T".into(), tables: vec![table], ..SheetSection::default() };
        let html = Sheet { sections: vec![section], ..Sheet::default() }.html().unwrap();
        assert!(html.contains("a&lt;b") && html.ends_with("</html>"));
    }
}
