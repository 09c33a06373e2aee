//! What is asked of a chart.

/// A chart that a study asks for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChartRequest {
    /// Name of the file of the chart; made from the columns where it is empty.
    pub name: String,
    /// Name of the column of the x axis, of numbers or of words.
    pub x: String,
    /// Name of the column of the y axis, of numbers.
    pub y: String,
    /// Name of the column whose levels, or ranges where it has many, have a curve each.
    pub family: Option<String>,
    /// Whether both axes are logarithmic.
    pub logarithmic: bool,
    /// Whether the x axis alone is logarithmic.
    pub logarithmic_x: bool,
    /// Whether to say how well all points fall onto one curve: dots, and their scatter about a running
    /// median.
    pub collapse: bool,
}
