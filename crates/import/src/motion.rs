//! The motions of a body as keys of a case.

use crate::amplitude::{Course, course};
use crate::case_text::{digits, quantity};
use crate::frame::Frame;
use crate::moves::{Dof, Move};
use crate::notes::Notes;
use crate::units::Units;

/// Keys of the motions along and about the axes of the case.
pub(super) const KEYS: [&str; 6] = ["forward", "lateral", "heave", "tilt_motion", "spin", "yaw_motion"];

/// A step of the deck as the motions see it.
#[derive(Clone, Copy)]
pub(super) struct Span {
    /// When it begins, in units of the deck.
    pub(super) begin: f64,
    /// How long it lasts, in units of the deck.
    pub(super) duration: f64,
    /// Whether another follows.
    pub(super) goes_on: bool,
}

/// What a motion needs besides the deck.
pub(super) struct Mover<'a> {
    pub(super) units: &'a Units,
    pub(super) frame: &'a Frame,
    /// By what loads are multiplied: planes of symmetry, width.
    pub(super) share: f64,
    /// Weight that gravity gives the body here and not in the deck [N].
    pub(super) extra_weight: f64,
    /// Name of tables: of the body and the step.
    pub(super) table: String,
    /// The step.
    pub(super) span: Span,
}

/// A motion as it is written.
pub(super) struct Written {
    /// Its value.
    pub(super) value: String,
    /// Block that it comes from.
    pub(super) block: Option<usize>,
    /// Name and text of its table.
    pub(super) file: Option<(String, String)>,
}

/// One of six motions of the case: the move, with the sense that its axis has here.
pub(super) fn of_axis<'m>(moves: &'m [Move; 6], frame: &Frame, number: usize) -> (&'m Move, f64) {
    let (axis, same) = frame.axes[number % 3];
    (&moves[axis + if number < 3 { 0 } else { 3 }], if same { 1.0 } else { -1.0 })
}

/// The value of a motion; `None` where it was refused.
pub(super) fn written(notes: &mut Notes, moves: &[Move; 6], number: usize, mover: &Mover) -> Option<Written> {
    let (own, sense) = of_axis(moves, mover.frame, number);
    let is_turn = number >= 3;
    let plain = |value: String| Some(Written { value, block: own.block, file: None });
    match &own.dof {
        Dof::Held if is_turn => plain("\"locked\"".to_owned()),
        Dof::Held => plain("\"fixed\"".to_owned()),
        Dof::Free => free(notes, own, sense, number, mover),
        Dof::Velocity(value, amplitude) => {
            let unit = if is_turn { 1.0 / mover.units.time } else { mover.units.speed() };
            let found = find(notes, amplitude.as_deref(), own.block, mover.span)?;
            Some(speed(notes, own.block, sense * value * unit, found, number, mover))
        }
        Dof::Displacement(value, amplitude) => {
            let unit = if is_turn { 1.0 } else { mover.units.length };
            let found = find(notes, amplitude.as_deref(), own.block, mover.span)?;
            displacement(notes, own.block, sense * value * unit, found, number, mover)
        }
    }
}

fn find(notes: &mut Notes, name: Option<&str>, block: Option<usize>, span: Span) -> Option<Course> {
    let Some(name) = name else { return Some(Course::Constant(1.0)) };
    let Some(amplitude) = notes.deck.amplitudes.get(name) else {
        block.into_iter().for_each(|block| notes.refused(block, format!("there is no amplitude {name}")));
        return None;
    };
    notes.understood(amplitude.block, "course of a motion or a load over time");
    let course = course(amplitude, span.begin, span.duration);
    if course.is_none() {
        notes.refused(amplitude.block, "it swings more often than a table has points for");
    }
    course
}

fn smooth(notes: &mut Notes, block: Option<usize>) {
    let text = "the smooth ramp is 3τ² − 2τ³, that of Abaqus τ³(10 − 15τ + 6τ²): the same ends, the largest slope 1.5 instead of 1.9";
    block.into_iter().for_each(|block| notes.approximated(block, text));
}

fn seconds(value: f64, mover: &Mover) -> String {
    quantity(value * mover.units.time, "s")
}

/// Start and duration of a ramp, after another key.
fn ramped(start: f64, ramp: f64, mover: &Mover) -> String {
    format!(", start = {}, ramp = {}", seconds(start, mover), seconds(ramp, mover))
}

fn speed(
    notes: &mut Notes,
    block: Option<usize>,
    value: f64,
    found: Course,
    number: usize,
    mover: &Mover,
) -> Written {
    let unit = if number >= 3 { "rad/s" } else { "m/s" };
    let (text, file) = match found {
        Course::Constant(factor) => {
            (format!("{{ speed = {}, ramp = \"0 s\" }}", quantity(value * factor, unit)), None)
        }
        Course::Smooth { start, ramp, to } => {
            smooth(notes, block);
            (format!("{{ speed = {}{} }}", quantity(value * to, unit), ramped(start, ramp, mover)), None)
        }
        Course::Straight { start, ramp, to } => {
            let points = [[0.0, 0.0], [start, 0.0], [start + ramp, to]];
            table(&points, value, ("speed", unit), number, mover)
        }
        Course::Points { points, .. } => table(&points, value, ("speed", unit), number, mover),
    };
    Written { value: text, block, file }
}

/// A table of a motion, times that increase.
fn table(
    points: &[[f64; 2]],
    value: f64,
    column: (&str, &str),
    number: usize,
    mover: &Mover,
) -> (String, Option<(String, String)>) {
    let name = format!("{}-{}.csv", mover.table, KEYS[number]);
    let mut text = format!("time [s],{} [{}]\n", column.0, column.1);
    let mut before = f64::NEG_INFINITY;
    for [time, factor] in points {
        if *time > before {
            text.push_str(&format!("{},{}\n", digits(time * mover.units.time), digits(value * factor)));
            before = *time;
        }
    }
    (format!("{{ table = \"{name}\" }}"), Some((name, text)))
}

fn displacement(
    notes: &mut Notes,
    block: Option<usize>,
    value: f64,
    found: Course,
    number: usize,
    mover: &Mover,
) -> Option<Written> {
    let (length, rate) = if number >= 3 { ("rad", "rad/s") } else { ("m", "m/s") };
    let (text, file) = match found {
        Course::Constant(_) => {
            let text = "a displacement that does not begin at 0 is a jump, which Abaqus/Explicit leaves out";
            block.into_iter().for_each(|block| notes.refused(block, text));
            return None;
        }
        Course::Smooth { start, ramp, to } => {
            smooth(notes, block);
            let to = quantity(value * to, length);
            (format!("{{ displacement = {to}{} }}", ramped(start, ramp, mover)), None)
        }
        Course::Straight { start, ramp, to } => {
            let pace = quantity(value * to / (ramp * mover.units.time), rate);
            let end = start + ramp;
            let end = if end < mover.span.duration || mover.span.goes_on {
                format!(", end = {}", seconds(end, mover))
            } else {
                String::new()
            };
            (format!("{{ speed = {pace}, start = {}, ramp = \"0 s\"{end} }}", seconds(start, mover)), None)
        }
        Course::Points { points, is_smooth } => {
            if !is_smooth {
                let text = "between the points of the amplitude the displacement is a smooth curve without overshoot";
                block.into_iter().for_each(|block| notes.approximated(block, text));
            }
            table(&points, value, ("displacement", length), number, mover)
        }
    };
    Some(Written { value: text, block, file })
}

fn free(notes: &mut Notes, own: &Move, sense: f64, number: usize, mover: &Mover) -> Option<Written> {
    let (unit, size) = if number >= 3 {
        ("N*m", mover.units.force() * mover.units.length)
    } else {
        ("N", mover.units.force())
    };
    let extra = if number == 2 { mover.extra_weight } else { 0.0 };
    let (mut load, mut times) = (0.0, String::new());
    let block = own.load_block.or(own.block);
    if let Some((value, amplitude)) = &own.load {
        load = sense * value * size * mover.share;
        let found = find(notes, amplitude.as_deref(), own.load_block, mover.span)?;
        match found {
            Course::Constant(factor) => {
                load *= factor;
                times = ", ramp = \"0 s\"".to_owned();
            }
            Course::Smooth { start, ramp, to } | Course::Straight { start, ramp, to } => {
                load *= to;
                times = ramped(start, ramp, mover);
                let text = "the load rises smoothly, 3τ² − 2τ³, between the same ends; the weight of a free body with it";
                own.load_block.into_iter().for_each(|block| notes.approximated(block, text));
            }
            Course::Points { .. } => {
                let text = "a load that goes up and down is not represented: one ramp was expected";
                own.load_block.into_iter().for_each(|block| notes.refused(block, text));
                return None;
            }
        }
    }
    load += extra;
    let value = if load == 0.0 {
        "\"free\"".to_owned()
    } else {
        format!("{{ load = {}{times} }}", quantity(load, unit))
    };
    Some(Written { value, block, file: None })
}
