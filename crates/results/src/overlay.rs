//! Curves that are overlaid on the plots of a run.

use serde::{Deserialize, Serialize};

/// Which plot an overlay belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlotKind {
    /// Forces [N] against displacement [m].
    ForceDisplacement,
    /// Forces [N] against sinkage [m].
    ForceSinkage,
    /// Sinkage [m] against displacement [m].
    SinkageDisplacement,
    /// Turn ratio against displacement [m].
    TurnRatio,
    /// Axle torque [N m] against displacement [m].
    AxleTorque,
}

/// A curve overlaid on a plot: a forecast, a measurement, another run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Overlay {
    /// Name in the legend.
    pub name: String,
    /// The plot that the overlay belongs to.
    pub plot: PlotKind,
    /// The body that the overlay belongs to; `None` for all bodies.
    pub body: Option<String>,
    /// Whether the overlay was measured: then it is drawn as dots, not as a line.
    #[serde(default)]
    pub measured: bool,
    /// Points in SI units. A single point is drawn as a level across the plot.
    pub points: Vec<[f64; 2]>,
}
