//! The table of a body: steady means with their intervals, what moving it costs, its rim, its rut, the
//! largest values.

use super::rows::{NONE, TableRow, bare, symbol, value};
use super::summary::{BodySummary, RimSummary};
use input::readable::{Unit, digits};
use results::confidence::BodyConfidence;
use results::history::RutSection;
use results::history::quantities::{NO_DRAG, Quantity, Steady, Traction};
use results::history::reference::Reference;
use results::history::rim::{RimPlace, SlipReversal};

/// Collects the rows of one body: a quantity with its unit, and its dimensionless group.
struct BodyRows<'a> {
    reference: &'a Reference,
    confidence: Option<&'a BodyConfidence>,
    rows: Vec<TableRow>,
}

impl BodyRows<'_> {
    fn push(&mut self, name: &str, symbol: &str, [value, group]: [String; 2], note: &str) {
        let (symbol, interval) = (symbol.to_owned(), String::new());
        self.rows.push(TableRow { name: name.into(), symbol, value, interval, group, note: note.into() });
    }

    /// Gives the last row its interval.
    fn bound(&mut self, interval: Option<[f64; 2]>, unit: impl Fn(f64) -> Unit) {
        if let (Some(row), Some([low, high])) = (self.rows.last_mut(), interval) {
            let unit = unit(low.abs().max(high.abs()));
            let text = format!("{} … {} {}", digits(low / unit.size), digits(high / unit.size), unit.name);
            row.interval = text.trim_end().to_owned();
        }
    }

    /// What the rim bears, and where its slip changes sign: by angle of a body that can roll, otherwise by
    /// arc.
    fn push_rim(&mut self, rim: &RimSummary) {
        self.push("Drag on the rim", "", self.shown("N", rim.drag), "steady mean; the rest is on the flanks");
        self.push("Vertical force on the rim", "", self.shown("N", rim.vertical), "steady mean");
        // A body without friction has none.
        if let Some(mobilised) = rim.mobilised_friction {
            let value = [NONE.into(), bare(Some(mobilised))];
            self.push("Mobilised friction", "", value, "on the rim, over its limit; steady mean");
        }
        let place = |angle: f64, arc: f64| match self.reference.radius {
            Some(_) => format!("{}°", digits(angle.to_degrees())),
            None => format!("{} mm", digits(1e3 * arc)),
        };
        let slip =
            |r: &SlipReversal| format!("{} … {}", place(r.from_rad, r.from_m), place(r.to_rad, r.to_m));
        let shear = |r: &RimPlace| place(r.angle_rad, r.arc_m);
        let slips = rim.slip_reversals.iter().map(|r| (slip(r), "slip", "; in between the soil sticks"));
        let shears = rim.shear_reversals.iter().map(|r| (shear(r), "shear stress", ""));
        let reversals: Vec<_> = slips.chain(shears).collect();
        for (at, what, addition) in reversals {
            let note = format!("{what} along the rim; from straight below, front positive{addition}");
            self.push("Change of sign", "", [at, NONE.into()], &note);
        }
    }

    /// The steady mean of a quantity, with its interval.
    fn mean(&mut self, quantity: Quantity, steady: &Steady) {
        let (unit, figure) = (quantity.column.unit, quantity.figure);
        self.push(&quantity.title(), &symbol(quantity), self.shown(unit, quantity.mean(steady)), figure.note);
        let interval = self.confidence.and_then(|body| body.figures.get(&quantity.key()));
        self.bound(interval.map(|figure| figure.interval), |size| Unit::of(unit, size));
    }

    /// A value of this unit and its dimensionless group.
    fn shown(&self, unit: &'static str, number: Option<f64>) -> [String; 2] {
        let group = number.and_then(|number| self.reference.group(unit, number));
        let number = number.filter(|_| unit != "-");
        [value(number, |size| Unit::of(unit, size)), bare(group)]
    }
}

/// Torque over drag times rolling radius below which a body that turns is as good as free of it (chosen).
const NO_TORQUE: f64 = 0.02;
/// Depth over the deepest one from which on a body has kept its depth (chosen: round-off).
const SAME_DEPTH: f64 = 1.0 - 1e-6;

/// Steady means and largest values of a body: those that matter in its kind of motion, and further ones. What
/// has no value is left out.
pub(super) fn body_rows(
    reference: &Reference,
    (body, confidence): (&BodySummary, Option<&BodyConfidence>),
    rut: Option<&RutSection>,
) -> [Vec<TableRow>; 2] {
    let steady = &body.steady;
    let new = || BodyRows { reference, confidence, rows: Vec::new() };
    let (mut key, mut further) = (new(), new());
    let (forces, others): (Vec<_>, Vec<_>) = Quantity::all().into_iter().partition(|q| q.column.unit == "N");
    mean_rows([&mut key, &mut further], forces, steady);
    water_rows(&mut key, steady);
    mean_rows([&mut key, &mut further], others, steady);
    if reference.towed {
        traction_rows([&mut key, &mut further], &steady.traction);
    }
    peak_rows(&mut key, body);
    rut_rows(&mut further, rut);
    further.push_rim(&body.rim);
    let noise = steady.drag_noise.map_or(NONE.to_owned(), |n| format!("{} %", digits(100.0 * n)));
    let note = "rms about a moving mean over 0.02 d, over the mean drag (at least a tenth of the force, or the thrust)";
    further.push("Drag noise", "", [noise, NONE.into()], note);
    [key, further].map(|table| {
        table
            .rows
            .into_iter()
            .filter(|row| [&row.value, &row.group].iter().any(|text| *text != NONE))
            .collect()
    })
}

/// Steady means, and after the turn ratio the slip.
fn mean_rows([key, further]: [&mut BodyRows<'_>; 2], quantities: Vec<Quantity>, steady: &Steady) {
    for quantity in quantities {
        let Some(matters) = matters(quantity, key.reference, steady) else { continue };
        if matters { &mut *key } else { &mut *further }.mean(quantity, steady);
        if quantity.figure.name == "turn_ratio" {
            key.push("Slip", "s", key.shown("-", steady.slip), "−1 locked, 0 rolls, above 0 driven");
        }
    }
}

/// Whether the mean of a quantity of this body is one of those that matter; `None` where it says nothing.
fn matters(quantity: Quantity, reference: &Reference, steady: &Steady) -> Option<bool> {
    let bears = steady.vertical.map_or(0.0, f64::abs);
    match quantity.figure.name {
        "vertical" | "sinkage" => Some(true),
        // A body that is pressed straight down has no drag but noise.
        "drag" => (reference.towed || steady.drag?.abs() > NO_DRAG * bears).then_some(true),
        // Half models and bodies without a yaw have none.
        "lateral" => (steady.lateral? != 0.0).then_some(true),
        "turn_ratio" => (reference.radius.is_some() && reference.turns).then_some(true),
        "axle_torque" => {
            let of_drag = steady.drag.map_or(0.0, f64::abs) * NO_TORQUE * reference.radius?;
            let moves = reference.towed || reference.turns;
            Some(moves && steady.axle_torque.is_some_and(|torque| torque.abs() > of_drag))
        }
        _ => Some(false),
    }
}

/// The forces of water.
fn water_rows(table: &mut BodyRows<'_>, steady: &Steady) {
    if steady.water_drag.is_some() {
        let note = "steady mean; not part of the drag, which is that of the soil";
        table.push("Drag of the water", "", table.shown("N", steady.water_drag), note);
    }
    if let Some([drag, vertical]) = steady.pore_pressure {
        let note = "steady mean; the portion of the drag that excess pore pressure exerts on the body";
        table.push("Pore pressure drag", "", table.shown("N", Some(drag)), note);
        let note = "the same of the vertical force; negative where suction holds the body down";
        table.push("Pore pressure vertical", "", table.shown("N", Some(vertical)), note);
    }
}

/// The largest values of a run.
fn peak_rows(table: &mut BodyRows<'_>, BodySummary { steady, peak, .. }: &BodySummary) {
    if table.reference.towed {
        let at = peak.at_m.map_or(String::new(), |u| format!("at u = {} m", digits(u)));
        table.push("Peak drag", "", table.shown("N", peak.drag), &at);
    }
    table.push("Peak vertical force", "", table.shown("N", peak.vertical), "");
    // A body that is held has one depth.
    if !steady.sinkage.zip(peak.sinkage).is_some_and(|(mean, most)| mean.abs() >= SAME_DEPTH * most.abs()) {
        table.push("Deepest sinkage", "", table.shown("m", peak.sinkage), "");
    }
}

/// What it costs to move a body that is towed, and what a driven one pulls.
fn traction_rows([key, further]: [&mut BodyRows<'_>; 2], traction: &Traction) {
    let pull = key.shown("N", traction.drawbar_pull);
    if let Some(weight) = key.reference.weight_along {
        key.push(
            "Weight along the slope",
            "",
            key.shown("N", Some(weight)),
            "against the tow positive; less buoyancy",
        );
        let note = "−F<sub>H</sub> less the weight along the slope, steady mean; below 0 it has to be held";
        key.push("Drawbar pull", "", pull, note);
    } else if traction.drawbar_pull.is_some_and(|pull| pull > 0.0) {
        key.push("Drawbar pull", "−F<sub>H</sub>", pull, "what it can tow, steady mean");
    }
    if traction.tractive_efficiency.is_some() {
        let note = "power of the drawbar pull over that of the axle";
        key.push("Tractive efficiency", "", [NONE.into(), bare(traction.tractive_efficiency)], note);
    }
    let resistance = [NONE.into(), bare(traction.specific_resistance)];
    further.push("Specific resistance", "F<sub>H</sub>/F<sub>V</sub>", resistance, "");
    let per_width = traction.drag_per_width.map_or(NONE.to_owned(), |f| format!("{} N/m", digits(f)));
    further.push("Drag per width", "", [per_width, NONE.into()], "over the width across the tow");
    let power =
        |power: Option<f64>| [power.map_or(NONE.to_owned(), |p| format!("{} W", digits(p))), NONE.into()];
    further.push("Tow power", "F<sub>H</sub> v", power(traction.tow_power), "negative where it pulls");
    if traction.axle_power.is_some_and(|power| power > 0.0) {
        let note = "torque on the axle times the rate of rotation";
        further.push("Axle power", "", power(traction.axle_power), note);
    }
}

/// What a body leaves behind, as means over the last part of its rut.
fn rut_rows(table: &mut BodyRows<'_>, rut: Option<&RutSection>) {
    let Some(rut) = rut else { return };
    let millimetres = |x: f64| format!("{} mm", digits(1e3 * x));
    let area = |x: f64| format!("{} cm²", digits(1e4 * x));
    let groups = |x: f64| bare(table.reference.length_group(x));
    let (width, depth) = (groups(rut.width), groups(rut.depth));
    let berms = format!("{}, {}", millimetres(rut.high_berm), millimetres(rut.low_berm));
    let none = || NONE.to_owned();
    table.push("Width of the rut", "", [millimetres(rut.width), width], "behind the body, mean");
    table.push("Depth of the rut", "", [millimetres(rut.depth), depth], "the same");
    table.push("Berms beside it", "", [berms, none()], "on the side of larger y, and on the other");
    table.push(
        "Displaced per metre",
        "",
        [area(rut.area), none()],
        "area of the rut; 1 cm² is 0.1 dm³ per metre",
    );
    table.push(
        "Disturbed per metre",
        "",
        [area(rut.disturbed), none()],
        "equivalent plastic strain above 0.1",
    );
    let to = millimetres(rut.disturbed_depth);
    table.push("Disturbed down to", "", [to, none()], "below the undisturbed surface");
    table.push("Mixed per metre", "", [area(rut.mixed), none()], "equivalent plastic strain above 1");
}
