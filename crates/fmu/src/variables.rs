//! The variables of an FMU: what an importer says of each body, and what it hears.

use coulter::mechanics::{Mobility, Pose, Twist, Wrench};
use coulter::simulation::{Command, Coupled, Reaction};
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// Reference of the time.
pub(crate) const TIME: u32 = 0;
/// Reference of the first text; the others follow.
pub(crate) const FIRST_TEXT: u32 = 1;
/// Names of the texts, all of them parameters, with their meaning.
pub(crate) const TEXTS: [(&str, &str); 2] = [
    ("set", "Keys of the case to set, one in a line, such as soil.friction_angle=38 deg"),
    (
        "output",
        "Folder for the results, as of coulter run; a run in it is replaced. Nothing is written if empty",
    ),
];
/// Which text says what to set.
pub(crate) const SET: usize = 0;
/// Which text names the folder for the results.
pub(crate) const OUTPUT: usize = 1;
/// Reference of the first number; the others follow.
pub(crate) const FIRST_NUMBER: u32 = FIRST_TEXT + TEXTS.len() as u32;

/// How an importer moves a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Steered {
    /// Not at all: it moves as the case says.
    #[default]
    Own,
    /// It says the velocity.
    Velocity,
    /// It says where the body is to be at the end of each step.
    Pose,
    /// It adds a load; the body moves as the case says.
    Load,
    /// The body is one of a mechanism of the importer.
    Coupled,
}

/// A name that is none of those of [`Steered`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is not how a body is steered: velocity, pose, load or coupled")]
pub struct UnknownSteering(String);

impl FromStr for Steered {
    type Err = UnknownSteering;

    fn from_str(name: &str) -> Result<Self, UnknownSteering> {
        match name {
            "velocity" => Ok(Self::Velocity),
            "pose" => Ok(Self::Pose),
            "load" => Ok(Self::Load),
            "coupled" => Ok(Self::Coupled),
            other => Err(UnknownSteering(other.to_owned())),
        }
    }
}

/// Whether an importer says a variable or hears it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Causality {
    Input,
    Output,
}

/// How the numbers of a quantity are told apart.
#[derive(Clone, Copy, Debug)]
enum Parts {
    One,
    Vector,
    Quaternion,
    Mobility,
}

/// A quantity of a body: name, parts, FMU, meaning.
type Quantity = (&'static str, Parts, &'static str, &'static str);

const POSE: [Quantity; 2] = [
    ("command.position", Parts::Vector, "m", "where the reference point is to be"),
    ("command.quaternion", Parts::Quaternion, "1", "the attitude it is to have"),
];
const TWIST: [Quantity; 2] = [
    ("command.velocity", Parts::Vector, "m/s", "velocity of the reference point"),
    ("command.angular_velocity", Parts::Vector, "rad/s", "angular velocity"),
];
const LOAD: [Quantity; 2] = [
    ("command.force", Parts::Vector, "N", "further force on the body"),
    ("command.moment", Parts::Vector, "N.m", "further moment about its reference point"),
];
const MECHANISM: [Quantity; 3] = [
    (
        "command.mobility",
        Parts::Mobility,
        "",
        "velocity and angular velocity per impulse and angular impulse: J M⁻¹ Jᵀ",
    ),
    ("command.acceleration", Parts::Vector, "m/s2", "acceleration of the reference point without the soil"),
    ("command.angular_acceleration", Parts::Vector, "rad/s2", "angular acceleration without the soil"),
];
const OUTPUTS: [Quantity; 8] = [
    ("force", Parts::Vector, "N", "mean force of the soil on the whole body over the last step"),
    ("moment", Parts::Vector, "N.m", "its mean moment about the reference point"),
    ("position", Parts::Vector, "m", "where the reference point is"),
    ("quaternion", Parts::Quaternion, "1", "attitude"),
    ("velocity", Parts::Vector, "m/s", "velocity of the reference point"),
    ("angular_velocity", Parts::Vector, "rad/s", "angular velocity"),
    ("sinkage", Parts::One, "m", "depth of its lowest point below the undisturbed surface"),
    ("work", Parts::One, "J", "work of the soil on the whole body over the last step"),
];

impl Steered {
    fn inputs(self) -> Vec<Quantity> {
        match self {
            Self::Own => Vec::new(),
            Self::Velocity => TWIST.to_vec(),
            Self::Pose => POSE.to_vec(),
            Self::Load => LOAD.to_vec(),
            Self::Coupled => [&POSE[..], &TWIST, &MECHANISM].concat(),
        }
    }

    /// Number of inputs of a body.
    pub(crate) fn number(self) -> usize {
        self.inputs().iter().map(|(_, parts, ..)| parts.names().len()).sum()
    }
}

impl Parts {
    /// What is written behind the name of the quantity.
    fn names(self) -> Vec<String> {
        let letters = |letters: &[&str]| letters.iter().map(|letter| format!(".{letter}")).collect();
        match self {
            Self::One => vec![String::new()],
            Self::Vector => letters(&["x", "y", "z"]),
            Self::Quaternion => letters(&["w", "x", "y", "z"]),
            Self::Mobility => {
                (1..=6).flat_map(|row| (1..=6).map(move |column| format!("[{row},{column}]"))).collect()
            }
        }
    }
}

/// A number of an FMU. Its reference is [`FIRST_NUMBER`] and its place in the list.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Variable {
    pub(crate) name: String,
    pub(crate) causality: Causality,
    pub(crate) unit: &'static str,
    pub(crate) meaning: String,
    /// Its value before the first step.
    pub(crate) start: f64,
}

/// The numbers of an FMU whose bodies, by their names, are steered in this way and stand like this.
pub(crate) fn variables<'a>(
    bodies: impl IntoIterator<Item = (&'a str, Steered, &'a Reaction)>,
) -> Vec<Variable> {
    let mut variables = Vec::new();
    for (name, steered, standing) in bodies {
        let values = starts(steered, standing).into_iter().chain(numbers(standing));
        let inputs = steered.inputs().into_iter().map(|quantity| (Causality::Input, quantity));
        let outputs = OUTPUTS.into_iter().map(|quantity| (Causality::Output, quantity));
        let each = inputs.chain(outputs).flat_map(|(causality, (quantity, parts, unit, meaning))| {
            let named = move |part: String| (causality, format!("{quantity}{part}"), unit, meaning);
            parts.names().into_iter().map(named)
        });
        variables.extend(each.zip(values).map(|((causality, part, unit, meaning), start)| Variable {
            name: format!("{name}.{part}"),
            causality,
            unit,
            meaning: format!("Body {name}: {meaning}"),
            start,
        }));
    }
    variables
}

/// The inputs of a body before they are set: it stays where it is.
fn starts(steered: Steered, standing: &Reaction) -> Vec<f64> {
    let pose = pose_numbers(&standing.pose);
    match steered {
        Steered::Own => Vec::new(),
        Steered::Velocity | Steered::Load => vec![0.0; 6],
        Steered::Pose => pose,
        Steered::Coupled => [pose, vec![0.0; 6 + 36 + 6]].concat(),
    }
}

fn pose_numbers(pose: &Pose) -> Vec<f64> {
    let turned = pose.rotation;
    [&pose.position.to_array()[..], &[turned.w, turned.x, turned.y, turned.z]].concat()
}

/// The outputs of a body, in their order.
pub(crate) fn numbers(body: &Reaction) -> Vec<f64> {
    let Reaction { soil, pose, twist, sinkage, work } = body;
    let of = |a: [f64; 3], b: [f64; 3]| [a, b].concat();
    [
        of(soil.force.into(), soil.moment.into()),
        pose_numbers(pose),
        of(twist.linear.into(), twist.angular.into()),
        vec![*sinkage, *work],
    ]
    .concat()
}

/// Numbers that are read one after another.
struct Reader<'a>(&'a [f64]);

impl Reader<'_> {
    fn next<const N: usize>(&mut self) -> [f64; N] {
        let (first, rest) = self.0.split_at(N);
        self.0 = rest;
        std::array::from_fn(|n| first[n])
    }

    fn pose(&mut self) -> Pose {
        let mut pose = Pose::at(self.next().into());
        let [w, x, y, z] = self.next();
        (pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w) = (x, y, z, w);
        pose
    }

    fn twist(&mut self) -> Twist {
        Twist { linear: self.next().into(), angular: self.next().into() }
    }
}

/// What the inputs of a body, in their order, command.
///
/// # Errors
/// A mobility that is none.
pub(crate) fn command(steered: Steered, inputs: &[f64]) -> Result<Command, String> {
    let mut inputs = Reader(inputs);
    Ok(match steered {
        Steered::Own => Command::Own,
        Steered::Velocity => Command::Twist(inputs.twist()),
        Steered::Pose => Command::Pose(inputs.pose()),
        Steered::Load => Command::Load(Wrench { force: inputs.next().into(), moment: inputs.next().into() }),
        Steered::Coupled => {
            let (pose, twist) = (inputs.pose(), inputs.twist());
            let rows = std::array::from_fn(|_| inputs.next());
            let mobility = Mobility::of(&rows)
                .ok_or("its mobility must be symmetric and positive semi-definite: J M⁻¹ Jᵀ")?;
            Command::Coupled(Coupled { pose, twist, mobility, acceleration: inputs.twist() })
        }
    })
}
