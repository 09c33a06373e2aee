//! The result quantities of a body, each declared here: a number of [`BodySample`], its line in [`FORCES`],
//! and, where its mean over the steady window is a figure of the run, a number of [`Steady`] and a [`Figure`]
//! in that line. From these follow the columns of `forces.csv`, the steady means, their intervals, and what
//! summary, report, studies and forecasts call them.

use super::blocks::{BLOCKS, block_averages};
use super::reference::Reference;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;

/// Ratio of drag to vertical force below which a body that is not towed has no noticeable drag.
pub const NO_DRAG: f64 = 1e-3;
/// Part of the whole force on a body with which a smaller component is compared: relative to itself, what is
/// almost zero is all noise.
pub(crate) const LEAST_SCALE: f64 = 0.1;
/// Part of the reference force γ t d² below which a force is none: the weight of the soil in some cells.
const NO_FORCE: f64 = 1e-4;

type Text = &'static str;
type MeanPlace = fn(&mut Steady) -> &mut Option<f64>;

/// A column of a history file.
#[derive(Debug)]
pub struct Column<S: 'static> {
    /// Name of the column, without the unit.
    pub name: &'static str,
    /// Unit of the column; `-` for a number without one.
    pub unit: &'static str,
    /// Meaning of the column, for the documentation.
    pub meaning: &'static str,
    /// Where the values of the column come from.
    pub source: Source<S>,
    /// Whether every line of a sound history has a finite number here.
    pub is_required: bool,
    /// The figure that the mean over the steady window is, of a quantity that has one.
    pub figure: Option<Figure>,
}

/// Where the values of a column come from.
#[derive(Debug)]
pub enum Source<S: 'static> {
    /// A number of the sample; reading the file back fills it.
    Sampled(fn(&mut S) -> &mut f64),
    /// A number that follows from the sample and the reference quantities of its body; none where it is not
    /// defined.
    Derived(Derived<S>),
}

impl<S> Source<S> {
    /// Where a sample has the number; `None` of one that is derived.
    pub(super) fn place(&self) -> Option<fn(&mut S) -> &mut f64> {
        match self {
            Self::Sampled(place) => Some(*place),
            Self::Derived(_) => None,
        }
    }
}

type Derived<S> = fn(&S, &Reference) -> Option<f64>;

const fn column<S>(name: Text, unit: Text, meaning: Text, source: Source<S>) -> Column<S> {
    Column { name, unit, meaning, source, is_required: false, figure: None }
}

pub(super) const fn sampled<S>(
    name: Text,
    unit: Text,
    meaning: Text,
    at: fn(&mut S) -> &mut f64,
) -> Column<S> {
    column(name, unit, meaning, Source::Sampled(at))
}

pub(super) const fn derived<S>(name: Text, unit: Text, meaning: Text, of: Derived<S>) -> Column<S> {
    column(name, unit, meaning, Source::Derived(of))
}

impl<S: Copy> Column<S> {
    pub(super) const fn required(mut self) -> Self {
        self.is_required = true;
        self
    }

    /// Makes the column a quantity with a steady mean: names, symbol, what the report says beside the mean,
    /// and where the mean stands.
    const fn figure(mut self, name: Text, words: Text, symbol: Text, note: Text, mean: MeanPlace) -> Self {
        self.figure = Some(Figure { name, words, symbol, note, mean, scale: None });
        self
    }

    /// Gives the mean intervals: what half-widths are compared with.
    const fn interval(mut self, scale: Scale) -> Self {
        if let Some(figure) = &mut self.figure {
            figure.scale = Some(scale);
        }
        self
    }

    /// Header of the column: name and unit.
    #[must_use]
    pub fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }

    /// Value of the column in a line; not-a-number where it is not defined.
    #[must_use]
    pub fn value(&self, sample: &S, reference: &Reference) -> f64 {
        match self.source {
            Source::Sampled(number) => *number(&mut { *sample }),
            Source::Derived(number) => number(sample, reference).unwrap_or(f64::NAN),
        }
    }
}

/// The header line of a file.
#[must_use]
pub fn header<S: Copy>(columns: &[Column<S>]) -> String {
    columns.iter().map(Column::header).collect::<Vec<_>>().join(",")
}

/// What a quantity with a steady mean is called, and where its mean and interval stand.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Name of the quantity in tables of studies and in Python, such as `vertical`; with the unit its key in
    /// `summary.json`.
    pub name: &'static str,
    /// Name of the quantity in sentences, such as `vertical force`.
    pub words: &'static str,
    /// Symbol of the quantity, such as `F_V`; empty for none.
    pub symbol: &'static str,
    /// What the report says beside the mean.
    pub note: &'static str,
    /// Where the mean stands.
    pub(crate) mean: MeanPlace,
    /// What half-widths of the intervals are compared with; `None` where the quantity has no intervals.
    pub(crate) scale: Option<Scale>,
}

/// What the half-widths of intervals of a quantity are compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scale {
    /// The drag, or the thrust of a body that turns: [`Steady::drag_scale`].
    Drag,
    /// The force, or a tenth of the whole force: [`Steady::scale`].
    Force,
    /// The depth; it is known where it is prescribed.
    Depth,
    /// One.
    One,
}

/// A quantity with a steady mean: a column of `forces.csv`, and what is made of it.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// The column.
    pub column: &'static Column<BodySample>,
    /// Names of the quantity, and where its mean and interval stand.
    pub figure: &'static Figure,
}

/// The key in JSON documents of a number with this name and unit, such as `vertical_N`.
#[must_use]
pub fn key(name: &str, unit: &str) -> String {
    match unit {
        "-" => name.to_owned(),
        unit => format!("{name}_{}", unit.replace(' ', "").replace('/', "_")),
    }
}

impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        self.figure.name == other.figure.name
    }
}

impl Quantity {
    /// All quantities: forces, lengths, ratios, torques, and what has another unit, each in the order of the
    /// columns.
    #[must_use]
    pub fn all() -> Vec<Self> {
        const ORDER: [&str; 4] = ["N", "m", "-", "N m"];
        let quantity =
            |column: &'static Column<BodySample>| Some(Self { column, figure: column.figure.as_ref()? });
        let mut all: Vec<Self> = FORCES.iter().filter_map(quantity).collect();
        all.sort_by_key(|q| ORDER.iter().position(|unit| *unit == q.column.unit).unwrap_or(ORDER.len()));
        all
    }

    /// The quantities that have intervals.
    pub fn with_intervals() -> impl Iterator<Item = Self> {
        Self::all().into_iter().filter(|quantity| quantity.figure.scale.is_some())
    }

    /// The quantity with this name, such as `vertical`.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|quantity| quantity.figure.name == name)
    }

    /// The quantity with this key.
    pub fn keyed(key: &str) -> Option<Self> {
        Self::all().into_iter().find(|quantity| quantity.key() == key)
    }

    /// Key of the quantity in `summary.json`, such as `vertical_N`.
    #[must_use]
    pub fn key(&self) -> String {
        key(self.figure.name, self.column.unit)
    }

    /// Name of the quantity in charts, such as `vertical force F_V`.
    #[must_use]
    pub fn label(&self) -> String {
        format!("{} {}", self.figure.words, self.figure.symbol.replace(' ', "")).trim_end().to_owned()
    }

    /// Name of the quantity as a heading, such as `Vertical force`.
    pub fn title(&self) -> String {
        let mut letters = self.figure.words.chars();
        letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
    }

    /// Mean of the quantity, in its unit.
    #[must_use]
    pub fn mean(&self, steady: &Steady) -> Option<f64> {
        *(self.figure.mean)(&mut steady.clone())
    }

    /// Averages of the quantity over the blocks of a window; `None` if there are too few samples, or where it
    /// is not defined.
    pub(crate) fn blocks(&self, inside: &[BodySample], reference: &Reference) -> Option<[f64; BLOCKS]> {
        let averages = |place: fn(&mut BodySample) -> &mut f64| {
            block_averages(&inside.iter().map(|sample| *place(&mut { *sample })).collect::<Vec<_>>())
        };
        let number = match self.column.source {
            Source::Sampled(place) => return averages(place),
            Source::Derived(number) => number,
        };
        let mut blocks = [BodySample::default(); BLOCKS];
        for place in FORCES.iter().filter_map(|column| column.source.place()) {
            blocks.iter_mut().zip(averages(place)?).for_each(|(block, average)| *place(block) = average);
        }
        let mut values = [0.0; BLOCKS];
        for (value, block) in values.iter_mut().zip(&blocks) {
            *value = number(block, reference)?;
        }
        Some(values)
    }
}

/// Something of each of some quantities, in JSON by their keys.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures<T>(Vec<(Quantity, T)>);

impl<T> Figures<T> {
    /// What `value` makes of each force.
    pub fn of_forces(value: impl Fn(Quantity) -> T) -> Self {
        let forces = Quantity::all().into_iter().filter(|quantity| quantity.column.unit == "N");
        Self(forces.map(|quantity| (quantity, value(quantity))).collect())
    }

    /// The quantities and what there is of them.
    pub fn iter(&self) -> impl Iterator<Item = (Quantity, &T)> {
        self.0.iter().map(|(quantity, value)| (*quantity, value))
    }
}

impl<T: Copy> Figures<Option<T>> {
    /// What there is of a quantity by its name, such as `drag`.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<T> {
        self.iter().find(|(quantity, _)| quantity.figure.name == name).and_then(|(_, value)| *value)
    }
}

impl<T: Serialize> Serialize for Figures<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter().map(|(quantity, value)| (quantity.key(), value)))
    }
}

impl<'de, T: DeserializeOwned> Deserialize<'de> for Figures<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut found = BTreeMap::<String, Value>::deserialize(deserializer)?;
        let value = |quantity: Quantity| {
            let value = serde_json::from_value(found.remove(&quantity.key())?).map_err(D::Error::custom);
            Some(value.map(|value| (quantity, value)))
        };
        Ok(Self(Quantity::all().into_iter().filter_map(value).collect::<Result<_, _>>()?))
    }
}

/// One line of a body's history. Forces are the soil's on the whole body, averaged over the interval that
/// ends at `time` (impulse over time, so nothing is lost between two lines).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BodySample {
    /// Time [s].
    pub time: f64,
    /// Displacement u along the tow [m]. The tow is that of the body: see [`case::tow::TowDirection`].
    pub displacement: f64,
    /// Sinkage z_s of the lowest point below the undisturbed surface [m], positive downwards.
    pub sinkage: f64,
    /// Drag F_H: horizontal force against the tow [N].
    pub drag: f64,
    /// Lateral force across the tow [N], to the left positive (0 in a symmetric case).
    pub lateral: f64,
    /// Vertical force F_V: positive when the soil pushes the body up [N].
    pub vertical: f64,
    /// Drag due to pressure normal to the surface [N]; the rest is friction.
    pub drag_normal: f64,
    /// Vertical force due to pressure normal to the surface [N]; the rest is friction.
    pub vertical_normal: f64,
    /// Torque of the soil about the axle [N m], positive when it makes the body roll forward.
    pub axle_torque: f64,
    /// Rotation Ω of the body [rad], positive when it rolls forward.
    pub rotation: f64,
    /// Rate of rotation ω [rad/s].
    pub spin: f64,
    /// Speed v along the tow [m/s].
    pub speed: f64,
    /// Velocity in the direction in which the body rolls: level, and across its axle [m/s].
    pub rolling_speed: f64,
    /// Heave velocity, positive upwards [m/s].
    pub heave_speed: f64,
    /// Displacement across the tow, to the left [m].
    pub lateral_displacement: f64,
    /// Yaw: rotation of the axle about z, from y [rad].
    pub yaw: f64,
    /// Tilt: inclination of the axle, positive when its left end is raised [rad].
    pub tilt: f64,
    /// Moment of the soil about the x axis of space through the reference point [N m].
    pub moment_x: f64,
    /// Moment of the soil about the y axis of space through the reference point [N m].
    pub moment_y: f64,
    /// Moment of the soil about the z axis of space through the reference point [N m].
    pub moment_z: f64,
    /// Drag of the water against the tow [N], which is not part of `drag`.
    pub water_drag: f64,
    /// Portion of the drag that excess pore pressure exerts [N].
    pub pore_drag: f64,
    /// Portion of the vertical force that excess pore pressure exerts [N].
    pub pore_vertical: f64,
    /// Soil inside the body [m³] (a measure of leakage).
    pub leaked_volume: f64,
    /// Volume of the body below the undisturbed surface [m³].
    pub embedded_volume: f64,
}

impl BodySample {
    /// Turn ratio ω r / v of a body with these reference quantities; `None` at rest, and where it cannot
    /// roll.
    #[must_use]
    pub fn turn_ratio(&self, reference: &Reference) -> Option<f64> {
        reference.turn_ratio(self.spin, self.rolling_speed)
    }

    /// Magnitude of the force of the soil [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        self.drag.hypot(self.vertical).hypot(self.lateral)
    }
}

/// Averages over the steady window; `null` in JSON where there is nothing to average.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Steady {
    /// Displacement at which the window begins [m].
    pub from_m: Option<f64>,
    /// Displacement at which the window ends [m].
    pub to_m: Option<f64>,
    /// Time at which the window begins [s].
    pub from_s: Option<f64>,
    /// Time at which the window ends [s].
    pub to_s: Option<f64>,
    /// Mean drag F_H [N].
    #[serde(rename = "drag_N")]
    pub drag: Option<f64>,
    /// Mean vertical force F_V [N].
    #[serde(rename = "vertical_N")]
    pub vertical: Option<f64>,
    /// Mean lateral force [N].
    #[serde(rename = "lateral_N")]
    pub lateral: Option<f64>,
    /// Mean moments of the soil about the axes of space through the reference point [N m].
    #[serde(rename = "moment_Nm")]
    pub moment: Option<[f64; 3]>,
    /// Mean drag of the water against the tow [N], not part of `drag`; `null` on dry ground.
    #[serde(rename = "water_drag_N")]
    pub water_drag: Option<f64>,
    /// Mean portions of `drag` and `vertical` that excess pore pressure exerts [N]; `null` where none is
    /// computed.
    #[serde(rename = "pore_pressure_N")]
    pub pore_pressure: Option<[f64; 2]>,
    /// Mean sinkage [m].
    #[serde(rename = "sinkage_m")]
    pub sinkage: Option<f64>,
    /// Mean turn ratio ω r / v, from the mean rotation rate and speed.
    pub turn_ratio: Option<f64>,
    /// The corresponding slip: 1 − v/(ωr) where ωr > v, otherwise ωr/v − 1.
    pub slip: Option<f64>,
    /// Mean torque about the axle [N m].
    #[serde(rename = "axle_torque_Nm")]
    pub axle_torque: Option<f64>,
    /// What it costs to move the body, and what it pulls.
    pub traction: Traction,
    /// Scatter of the drag: root mean square of the drag less its moving average over 0.02 d (at least five
    /// samples), over [`Steady::drag_scale`].
    pub drag_noise: Option<f64>,
    /// Whether drag and sinkage change by less than their limits over the window; `null` without a tow, and
    /// of too few samples.
    pub is_steady: Option<bool>,
}

impl Steady {
    /// What a component of the force on the body is compared with [N]: itself, or a tenth of the whole force
    /// where that is larger.
    #[must_use]
    pub fn scale(&self, component: Option<f64>) -> f64 {
        component.unwrap_or(0.0).abs().max(LEAST_SCALE * self.whole_force())
    }

    /// What the drag is compared with [N]: as any component, or the thrust of a body that turns, torque over
    /// radius, where that is larger: its pull is the difference of thrust and resistance.
    #[must_use]
    pub fn drag_scale(&self, reference: &Reference) -> f64 {
        let turning = reference.radius.filter(|_| reference.turns);
        let thrust = turning.zip(self.axle_torque).map_or(0.0, |(radius, torque)| (torque / radius).abs());
        let least = NO_FORCE * reference.force().unwrap_or(0.0);
        self.scale(self.drag).max(thrust).max(least)
    }

    /// Magnitude of the mean force [N].
    #[must_use]
    pub fn whole_force(&self) -> f64 {
        let force = [self.drag, self.vertical, self.lateral].map(Option::unwrap_or_default);
        force.iter().map(|f| f * f).sum::<f64>().sqrt()
    }
}

/// Steady means of what it costs to move a body through the soil, and of what a driven body pulls; `null` in
/// JSON where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Traction {
    /// Drawbar pull [N]: −F_H, what the soil pushes the body forwards with, less its weight along a slope;
    /// negative where it resists.
    #[serde(rename = "drawbar_pull_N")]
    pub drawbar_pull: Option<f64>,
    /// Specific resistance F_H/F_V: drag over the vertical force.
    pub specific_resistance: Option<f64>,
    /// Drag over the width of the body across the tow, of one that consists of several over the sum of theirs
    /// [N/m].
    #[serde(rename = "drag_per_width_N_m")]
    pub drag_per_width: Option<f64>,
    /// Power that moves the body against its drag, F_H v [W].
    #[serde(rename = "tow_power_W")]
    pub tow_power: Option<f64>,
    /// Power that turns the body against the torque of the soil, −M ω [W].
    #[serde(rename = "axle_power_W")]
    pub axle_power: Option<f64>,
    /// Tractive efficiency of a driven body: power of −F_H over that of its axle; on a slope climbing counts.
    pub tractive_efficiency: Option<f64>,
}

impl Traction {
    /// Traction from the means of drag and vertical force [N], of the power of the tow and of the axle [W].
    pub(super) fn of(
        reference: &Reference,
        [drag, vertical, tow_power, axle_power]: [Option<f64>; 4],
    ) -> Self {
        // What would be a thousandfold is a quotient of almost nothing.
        let over = |a: Option<f64>, b: Option<f64>| {
            a.zip(b).filter(|(a, b)| *b > NO_DRAG * a.abs()).map(|(a, b)| a / b)
        };
        let axle_power = axle_power.filter(|_| reference.turns);
        Self {
            drawbar_pull: drag.map(|drag| 0.0 - drag - reference.weight_along.unwrap_or(0.0)),
            specific_resistance: over(drag, vertical),
            drag_per_width: drag.and_then(|drag| finite(drag / reference.across)),
            tow_power,
            axle_power,
            tractive_efficiency: over(tow_power.map(|power| -power).filter(|power| *power > 0.0), axle_power),
        }
    }
}

/// A number; `None` for what is none.
pub fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Columns of `forces.csv`.
pub const FORCES: &[Column<BodySample>] = &[
    sampled("time", "s", "time since the start", |s| &mut s.time),
    sampled::<BodySample>(
        "displacement u",
        "m",
        "distance the reference point has travelled along the tow since the start",
        |s| &mut s.displacement,
    )
    .required(),
    sampled::<BodySample>(
        "sinkage z",
        "m",
        "depth of the body's lowest point below the undisturbed surface, positive downwards",
        |s| &mut s.sinkage,
    )
    .required()
    .figure("sinkage", "sinkage", "z", "steady mean", |s| &mut s.sinkage)
    .interval(Scale::Depth),
    sampled::<BodySample>("drag F_H", "N", "horizontal force against the tow", |s| &mut s.drag)
        .required()
        .figure("drag", "drag", "F_H", "steady mean", |s| &mut s.drag)
        .interval(Scale::Drag),
    sampled::<BodySample>("vertical F_V", "N", "vertical force, positive upwards", |s| &mut s.vertical)
        .required()
        .figure("vertical", "vertical force", "F_V", "steady mean, up positive", |s| &mut s.vertical)
        .interval(Scale::Force),
    sampled::<BodySample>(
        "lateral",
        "N",
        "force across the tow, to the left positive; 0 in a symmetric case",
        |s| &mut s.lateral,
    )
    .required()
    .figure("lateral", "lateral force", "", "steady mean, to the left positive", |s| &mut s.lateral)
    .interval(Scale::Force),
    sampled::<BodySample>(
        "axle torque",
        "N m",
        "torque about the axle, positive when it makes the body roll forward",
        |s| &mut s.axle_torque,
    )
    .required()
    .figure(
        "axle_torque",
        "axle torque",
        "M",
        "steady mean; forward positive; group M / (γ t d³)",
        |s| &mut s.axle_torque,
    ),
    sampled("rotation", "rad", "angle of rotation Ω about the axle", |s| &mut s.rotation),
    sampled("spin", "rad/s", "its rate ω", |s| &mut s.spin),
    derived::<BodySample>(
        "turn ratio",
        "-",
        "ω r / v with the rolling speed v (below); empty at rest and for a body that cannot roll",
        BodySample::turn_ratio,
    )
    .figure("turn_ratio", "turn ratio", "ω r / v", "1 rolls, 0 slides", |s| &mut s.turn_ratio)
    .interval(Scale::One),
    sampled("normal drag", "N", "drag due to the pressure normal to the surface", |s| &mut s.drag_normal),
    derived("friction drag", "N", "drag due to friction", |s, _| Some(s.drag - s.drag_normal)),
    sampled("normal vertical", "N", "vertical force due to the pressure normal to the surface", |s| {
        &mut s.vertical_normal
    }),
    derived("friction vertical", "N", "vertical force due to friction", |s, _| {
        Some(s.vertical - s.vertical_normal)
    }),
    sampled(
        "leak",
        "m^3",
        "soil volume inside the body: in the cells that it fills, and what finds no space in those that it cuts",
        |s| &mut s.leaked_volume,
    ),
    sampled("embedded", "m^3", "volume of the body below the undisturbed surface", |s| {
        &mut s.embedded_volume
    }),
    sampled("speed v", "m/s", "velocity along the tow", |s| &mut s.speed),
    sampled("heave speed", "m/s", "velocity upwards", |s| &mut s.heave_speed),
    sampled(
        "rolling speed",
        "m/s",
        "velocity in the direction in which the body rolls: level, and across its axle",
        |s| &mut s.rolling_speed,
    ),
    sampled(
        "lateral displacement",
        "m",
        "distance travelled across the tow since the start, to the left",
        |s| &mut s.lateral_displacement,
    ),
    sampled("yaw", "rad", "rotation of the axle about z, positive to the left", |s| &mut s.yaw),
    sampled("tilt", "rad", "inclination of the axle, positive when its left end is raised", |s| &mut s.tilt),
    sampled("moment x", "N m", "moment of the soil about x through the reference point", |s| &mut s.moment_x),
    sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
    sampled(
        "water drag",
        "N",
        "drag of the water against the tow, ½ρC_dA v²; not part of the drag F_H, which is that of the soil",
        |s| &mut s.water_drag,
    ),
    sampled(
        "pore pressure drag",
        "N",
        "portion of the drag F_H that excess pore pressure exerts on the body; 0 where none is computed",
        |s| &mut s.pore_drag,
    ),
    sampled(
        "pore pressure vertical",
        "N",
        "the same of the vertical force F_V; negative where suction holds the body down",
        |s| &mut s.pore_vertical,
    ),
    derived("Z", "-", "z/d", |s, reference| reference.length_group(s.sinkage)),
    derived("u_bar", "-", "u/d", |s, reference| reference.length_group(s.displacement)),
    derived("F_H_bar", "-", "F_H/(γ t d²); empty for weightless soil", |s, reference| {
        reference.force_group(s.drag)
    }),
    derived("F_V_bar", "-", "F_V/(γ t d²); empty for weightless soil", |s, reference| {
        reference.force_group(s.vertical)
    }),
];

/// Columns of `filtered.csv`.
pub const FILTERED: &[Column<BodySample>] = &[
    sampled("time", "s", "time since the start", |s| &mut s.time),
    sampled("displacement u", "m", "displacement along the tow, not filtered", |s| &mut s.displacement),
    sampled("sinkage z", "m", "depth of the lowest point below the undisturbed surface, not filtered", |s| {
        &mut s.sinkage
    }),
    sampled("drag F_H", "N", "drag", |s| &mut s.drag),
    sampled("vertical F_V", "N", "vertical force", |s| &mut s.vertical),
    sampled("lateral", "N", "lateral force", |s| &mut s.lateral),
    sampled("axle torque", "N m", "torque about the axle", |s| &mut s.axle_torque),
    sampled("moment x", "N m", "moment about the x axis of space", |s| &mut s.moment_x),
    sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
    derived("drawbar pull", "N", "−F_H, less the weight along a slope", |s, r| {
        Some(0.0 - s.drag - r.weight_along.unwrap_or(0.0))
    }),
    derived("tow power", "W", "F_H v, of filtered drag and speed", |s, _| Some(s.drag * s.speed)),
    derived("axle power", "W", "−M ω, of filtered torque and rate", |s, _| Some(-s.axle_torque * s.spin)),
    derived("drag per width", "N/m", "drag over the width across the tow", |s, r| {
        (r.across > 0.0).then(|| s.drag / r.across)
    }),
];
