//! The reference lengths and force that make a body's results dimensionless, and its rolling radius.

use case::path::fastest;
use case::resolved::{Body, Case, Motion};
use case::tow::{TowDirection, squared};
use serde::{Deserialize, Serialize};

/// Speeds below this [m/s] count as rest, where the turn ratio is not defined.
const REST: f64 = 1e-6;

/// The sign of what drives a motion; 0 without a drive.
fn drive(motion: &Motion, duration: f64) -> f64 {
    let drive = match motion {
        Motion::Prescribed { speed, .. } => *speed,
        Motion::Course(course) => course.displacement(duration),
        Motion::Free { load, .. } => *load,
        Motion::Fixed => 0.0,
    };
    if drive == 0.0 { 0.0 } else { drive.signum() }
}

/// Reference width of a body that is towed in a direction [m].
fn width(body: &Body, tow: TowDirection) -> f64 {
    let [x, y] = tow.components();
    let stands = body.attitude.tilt == 0.0 && body.attitude.pitch == 0.0;
    let yaw = if stands { body.attitude.yaw - y.atan2(x) } else { 0.0 };
    squared(body.main_shape(), yaw).0.reference_width()
}

/// Component of the weight of a body against its tow, uphill positive [N].
fn weight_along(case: &Case, body: &Body, tow: TowDirection) -> Option<f64> {
    let rise = -tow.turned(case.slope.down()).x;
    (rise != 0.0).then(|| rise * case.weight(body))
}

/// Dimensionless groups of one body, as far as they are known before a run; `None` where the soil is
/// weightless.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Groups {
    /// Width t̄ = t/d.
    pub t_bar: f64,
    /// Weight and load that press the body down, W̄ = W/(γ t d²); `None` also where it is held.
    #[serde(rename = "W_bar")]
    pub w_bar: Option<f64>,
    /// Stiffness Ē = E/(γ d).
    #[serde(rename = "E_bar")]
    pub e_bar: Option<f64>,
    /// Cohesion c̄ = c/(γ d), or s_u/(γ d).
    pub c_bar: Option<f64>,
    /// Froude number v²/(g d), of the fastest prescribed motion.
    pub froude: Option<f64>,
}

impl Groups {
    /// The groups of one body of a case.
    #[must_use]
    pub fn of(case: &Case, body: &Body) -> Self {
        let reference = Reference::of(case, body);
        let (d, gamma) = (reference.length, case.soil.unit_weight);
        let over_weight = |x: f64| (gamma > 0.0).then_some(x / gamma);
        let speed = body.guided().translation.iter().map(fastest).fold(0.0, f64::max);
        let pressed = body.pressing_force(case.normal_weight(body));
        Self {
            t_bar: reference.width / d,
            w_bar: pressed.and_then(|weight| reference.force_group(weight)),
            e_bar: over_weight(case.soil.young_modulus / d),
            c_bar: case.soil.law.cohesion().and_then(|c| over_weight(c / d)),
            froude: (case.gravity > 0.0).then_some(speed.powi(2) / (case.gravity * d)),
        }
    }
}

/// The reference quantities of a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Name of the body.
    pub name: String,
    /// Kind of the body: "disc", "block", "cylinder", "sphere", "frame".
    pub kind: String,
    /// Reference length d [m]: the diameter, a block's height; 0 of a frame, which has no surface.
    pub length: f64,
    /// Reference width t [m]: a disc's thickness, the edge of a block across the tow, the length of a
    /// cylinder across it, otherwise the diameter; in plane strain a metre.
    pub width: f64,
    /// Width of all surfaces of the body across the tow at the start [m]; in plane strain a metre.
    #[serde(default)]
    pub across: f64,
    /// Unit weight γ of the soil [N/m³]; 0 when it is weightless.
    pub unit_weight: f64,
    /// Rolling radius r [m]; `None` for a body that cannot roll.
    pub radius: Option<f64>,
    /// Whether the body moves along x or y, prescribed or free.
    pub towed: bool,
    /// Whether nothing moves the body in the whole run: it is an obstacle to others.
    #[serde(default)]
    pub still: bool,
    /// Direction of the tow of the body.
    #[serde(default)]
    pub tow: TowDirection,
    /// Weight of the body against its tow along the slope of the ground [N], negative downhill; `None` where
    /// the tow is level.
    #[serde(default)]
    pub weight_along: Option<f64>,
    /// 1 of a body that is driven in yaw to the left and does not turn about an axle, −1 to the right; 0 of
    /// any other.
    #[serde(default)]
    pub yaw_drive: f64,
    /// Whether the body rotates about its axle.
    pub turns: bool,
}

impl Reference {
    /// The reference of one body of a case.
    #[must_use]
    pub fn of(case: &Case, body: &Body) -> Self {
        let tow = TowDirection::of(case, body);
        Self {
            name: body.name.clone(),
            kind: body.main_shape().kind().to_owned(),
            length: body.main_shape().reference_length(),
            width: case.domain.width_of_body(width(body, tow)),
            across: case
                .domain
                .width_of_body(body.surfaces().iter().map(|surface| tow.width_across(surface)).sum()),
            unit_weight: case.soil.unit_weight,
            radius: body.wheel_diameter().map(|diameter| 0.5 * diameter),
            towed: body.guided().translation[..2].iter().any(Motion::may_move),
            still: body.is_still(),
            tow,
            weight_along: weight_along(case, body, tow),
            yaw_drive: if *body.spin() == Motion::Fixed {
                drive(&body.guided().rotation[0], case.duration)
            } else {
                0.0
            },
            turns: !matches!(body.spin(), Motion::Fixed),
        }
    }

    /// The references of all bodies of a case, in its order.
    #[must_use]
    pub fn all(case: &Case) -> Vec<Self> {
        case.bodies.iter().map(|body| Self::of(case, body)).collect()
    }

    /// Whether the body has a surface that the soil can touch.
    #[must_use]
    pub fn has_surface(&self) -> bool {
        self.length > 0.0
    }

    /// Reference force γ t d² [N]; `None` for weightless soil.
    #[must_use]
    pub fn force(&self) -> Option<f64> {
        analytic::reference_force(self.unit_weight, self.width, self.length)
    }

    /// A force [N] over the reference force.
    #[must_use]
    pub fn force_group(&self, force: f64) -> Option<f64> {
        self.force().map(|reference| force / reference)
    }

    /// A length [m] over the reference length.
    #[must_use]
    pub fn length_group(&self, length: f64) -> Option<f64> {
        (self.length > 0.0).then(|| length / self.length)
    }

    /// A number of this SI unit, made dimensionless: a force, a length or a torque over its reference, a
    /// ratio as it is; `None` without a reference.
    #[must_use]
    pub fn group(&self, unit: &str, number: f64) -> Option<f64> {
        match unit {
            "N" => self.force_group(number),
            "N m" => self.force_group(number / self.length),
            "m" => self.length_group(number),
            "-" => Some(number),
            _ => None,
        }
    }

    /// Turn ratio ω r / v with v in the direction in which the body rolls: 1 rolls without slip, 0 slides
    /// without rotation; `None` at rest or without a radius.
    #[must_use]
    pub fn turn_ratio(&self, spin: f64, speed: f64) -> Option<f64> {
        self.radius.filter(|_| speed.abs() > REST).map(|radius| spin * radius / speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use case::parse;

    const BLOCK: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
         [grid]\ncell = '20 mm'\n[body.a]\nshape = 'block'\nsize = ['0.1 m', '0.2 m', '0.3 m']\nfriction = 0.3\nsinkage = '50 mm'\n[run]\n\
         duration = '1 s'\n";

    /// Direction, width across and reference width of the block with these changes.
    fn tow(sets: &[&str]) -> ([f64; 2], f64, f64) {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        let case = parse(BLOCK, "case.toml", &sets).unwrap();
        let Reference { tow, across, width, .. } = Reference::of(&case, &case.bodies[0]);
        (tow.components(), across, width)
    }

    #[test]
    fn the_weight_along_a_slope_counts_against_the_tow() {
        let along = |sets: &[&str]| {
            let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
            let case = parse(BLOCK, "case.toml", &sets).unwrap();
            Reference::of(&case, &case.bodies[0]).weight_along
        };
        let (weight, ahead, back) = (
            "body.a.weight=200 N",
            "body.a.forward={ speed = '0.3 m/s' }",
            "body.a.forward={ speed = '-0.3 m/s' }",
        );
        assert_eq!(along(&[weight, ahead]), None);
        assert_eq!(along(&[weight, ahead, "ground.cross_slope=15 deg"]), None);
        let up = along(&[weight, ahead, "ground.slope=15 deg"]).unwrap();
        assert!((up - 200.0 * 15_f64.to_radians().sin()).abs() < 1e-9, "{up}");
        assert!((along(&[weight, back, "ground.slope=15 deg"]).unwrap() + up).abs() < 1e-9);
    }

    #[test]
    fn the_tow_follows_the_prescribed_motion() {
        let [forward, lateral] =
            ["forward", "lateral"].map(|key| move |motion: &str| format!("body.a.{key}={motion}"));
        let (ahead, back) = ("{ speed = '0.3 m/s' }", "{ speed = '-0.3 m/s' }");
        assert_eq!(tow(&[]), ([1.0, 0.0], 0.2, 0.2));
        assert_eq!(tow(&[&forward(ahead)]), ([1.0, 0.0], 0.2, 0.2));
        assert_eq!(tow(&[&forward(back)]), ([-1.0, 0.0], 0.2, 0.2));
        assert_eq!(tow(&[&lateral(ahead)]), ([0.0, 1.0], 0.1, 0.1));
        assert_eq!(tow(&[&lateral(back)]), ([0.0, -1.0], 0.1, 0.1));
        assert_eq!(tow(&[&lateral("{ displacement = '-0.2 m' }")]).0, [0.0, -1.0]);
        // Pulled by a load.
        assert_eq!(tow(&["body.a.mass=2 kg", &forward("{ load = '-5 N' }")]).0, [-1.0, 0.0]);
        // Turned to one side and towed there: its front is where it goes.
        assert_eq!(tow(&[&lateral(ahead), "body.a.yaw=90 deg"]).2, 0.2);
        let ([x, y], across, _) = tow(&[&forward(ahead), &lateral("{ speed = '0.4 m/s' }")]);
        assert!((x - 0.6).abs() < 1e-15 && (y - 0.8).abs() < 1e-15);
        assert!((across - (0.1 * 0.8 + 0.2 * 0.6)).abs() < 1e-12, "{across}");
    }
}
