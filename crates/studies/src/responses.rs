//! The responses of a study: the columns of its table besides the factors.

use serde::{Deserialize, Serialize};

/// What one model says of one body; `null` where it does not.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Figures {
    /// The model: `solver`, or the name of a closed form.
    pub model: String,
    /// The body.
    pub body: String,
    /// Whether it is the recommended closed form, or the first body of a run.
    pub recommended: bool,
    /// Grade of a run: `good` or `doubtful`.
    pub grade: Option<String>,
    /// Mean drag [N].
    #[serde(rename = "drag_N")]
    pub drag: Option<f64>,
    /// Mean vertical force [N].
    #[serde(rename = "vertical_N")]
    pub vertical: Option<f64>,
    /// Mean lateral force [N].
    #[serde(rename = "lateral_N")]
    pub lateral: Option<f64>,
    /// Sinkage [m].
    #[serde(rename = "sinkage_m")]
    pub sinkage: Option<f64>,
    /// Slip.
    pub slip: Option<f64>,
    /// Drawbar pull −F_H, of a run on a slope less the weight along it [N].
    #[serde(rename = "pull_N")]
    pub pull: Option<f64>,
    /// Drawbar pull over the weight that the soil bears.
    pub pull_over_weight: Option<f64>,
    /// Turn ratio ω r / v: 1 rolls, 0 slides.
    pub turn_ratio: Option<f64>,
    /// Power of the pull over that of the axle; of a driven body that pulls.
    pub efficiency: Option<f64>,
    /// Torque about the axle [N m].
    #[serde(rename = "axle_torque_Nm")]
    pub axle_torque: Option<f64>,
    /// Largest drag [N].
    #[serde(rename = "peak_drag_N")]
    pub peak_drag: Option<f64>,
    /// Largest vertical force [N].
    #[serde(rename = "peak_vertical_N")]
    pub peak_vertical: Option<f64>,
    /// Scatter of the drag over its mean.
    pub drag_noise: Option<f64>,
    /// Dimensionless drag F_H/(γ t d²).
    #[serde(rename = "F_H_bar")]
    pub drag_group: Option<f64>,
    /// Dimensionless vertical force F_V/(γ t d²).
    #[serde(rename = "F_V_bar")]
    pub vertical_group: Option<f64>,
    /// Dimensionless sinkage z/d.
    #[serde(rename = "Z")]
    pub sinkage_group: Option<f64>,
    /// Dimensionless thickness t/d.
    pub t_bar: Option<f64>,
    /// Dimensionless weight W/(γ t d²).
    #[serde(rename = "W_bar")]
    pub weight_group: Option<f64>,
    /// Dimensionless stiffness E/(γ d).
    #[serde(rename = "E_bar")]
    pub stiffness_group: Option<f64>,
    /// Dimensionless cohesion c/(γ d).
    #[serde(rename = "c_bar")]
    pub cohesion_group: Option<f64>,
}

impl Figures {
    /// With what follows from drag, vertical force, slip and torque: pull, turn ratio, and, of a body that rolls on a radius [m],
    /// its efficiency P v/(T ω), where the soil resists with the torque T and P is positive.
    #[must_use]
    pub fn with_traction(self, radius: Option<f64>) -> Self {
        let pull = self.pull.or(self.drag.map(|drag| 0.0 - drag));
        let turn_ratio = self.slip.map(analytic::turn_ratio);
        let over = |force: f64| self.vertical.filter(|weight| *weight > 0.0).map(|weight| force / weight);
        let efficiency = || {
            let torque = self.axle_torque.map(|torque| -torque).filter(|torque| *torque > 0.0)?;
            Some(
                pull.filter(|pull| *pull > 0.0)? * radius?
                    / (torque * turn_ratio.filter(|ratio| *ratio > 0.0)?),
            )
        };
        Self { pull, pull_over_weight: pull.and_then(over), turn_ratio, efficiency: efficiency(), ..self }
    }
}

/// A response.
#[derive(Clone, Copy, Debug)]
pub struct ResponseColumn {
    /// The name of its column.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its name in charts.
    pub label: &'static str,
    /// Its value.
    pub of: fn(&Figures) -> Option<f64>,
}

const fn response(
    name: &'static str,
    unit: &'static str,
    label: &'static str,
    of: fn(&Figures) -> Option<f64>,
) -> ResponseColumn {
    ResponseColumn { name, unit, label, of }
}

/// All responses, in the order of the table.
pub const RESPONSES: [ResponseColumn; 20] = [
    response("drag", "N", "drag F_H", |f| f.drag),
    response("vertical", "N", "vertical force F_V", |f| f.vertical),
    response("lateral", "N", "lateral force F_y", |f| f.lateral),
    response("sinkage", "m", "sinkage z", |f| f.sinkage),
    response("slip", "-", "slip s", |f| f.slip),
    response("pull", "N", "drawbar pull P", |f| f.pull),
    response("pull_over_weight", "-", "pull over weight P/F_V", |f| f.pull_over_weight),
    response("turn_ratio", "-", "turn ratio ωr/v", |f| f.turn_ratio),
    response("efficiency", "-", "tractive efficiency η", |f| f.efficiency),
    response("axle_torque", "N m", "axle torque M", |f| f.axle_torque),
    response("peak_drag", "N", "largest drag", |f| f.peak_drag),
    response("peak_vertical", "N", "largest vertical force", |f| f.peak_vertical),
    response("drag_noise", "-", "scatter of the drag over its mean", |f| f.drag_noise),
    response("F_H_bar", "-", "drag F_H/(γtd²)", |f| f.drag_group),
    response("F_V_bar", "-", "vertical force F_V/(γtd²)", |f| f.vertical_group),
    response("Z", "-", "sinkage z/d", |f| f.sinkage_group),
    response("t_bar", "-", "thickness t/d", |f| f.t_bar),
    response("W_bar", "-", "weight W/(γtd²)", |f| f.weight_group),
    response("E_bar", "-", "stiffness E/(γd)", |f| f.stiffness_group),
    response("c_bar", "-", "cohesion c/(γd)", |f| f.cohesion_group),
];

/// The names of the responses.
pub fn names<'a>() -> impl Iterator<Item = &'a str> {
    RESPONSES.iter().map(|response| response.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_wheel_pulls_follows_from_its_forces() {
        let wheel = |drag: f64, slip: f64| Figures {
            drag: Some(drag),
            vertical: Some(100.0),
            slip: Some(slip),
            axle_torque: Some(-10.0),
            ..Figures::default()
        };
        let driven = wheel(-50.0, 0.2).with_traction(Some(0.125));
        assert_eq!(
            (driven.pull, driven.pull_over_weight, driven.turn_ratio),
            (Some(50.0), Some(0.5), Some(1.25))
        );
        // 50 N × v over 10 N m × 1.25 v/0.125 m.
        assert_eq!(driven.efficiency, Some(0.5));
        assert_eq!(wheel(-50.0, 1.0).with_traction(Some(0.125)).efficiency, Some(0.0));
        assert_eq!(wheel(20.0, -0.1).with_traction(Some(0.125)).efficiency, None);
        assert_eq!(Figures::default().with_traction(Some(0.1)), Figures::default());
    }
}
