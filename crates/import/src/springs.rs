//! Springs with dampers, from the behaviour of an AXIAL connector.

use crate::notes::Notes;
use deck::block::{Row, Wrong};

/// A spring with a damper.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Spring {
    pub(super) stiffness: f64,
    pub(super) damping: f64,
    /// Length without force; that at the start where it is not given.
    pub(super) length: Option<f64>,
    /// By how much more than this length a cable is slack.
    pub(super) slack: f64,
    pub(super) is_cable: bool,
}

/// A spring from the tables of a behaviour: the block of its name, and those of the tables.
pub(super) fn of_behaviour(notes: &mut Notes, behaviour: &[usize]) -> Result<Spring, Wrong> {
    let (mut spring, mut is_refused) = (Spring::default(), false);
    for number in behaviour.iter().skip(1) {
        match take(notes, &mut spring, *number, behaviour) {
            Ok(()) => notes.understood(*number, "a spring with a damper"),
            Err(wrong) => {
                notes.refused(*number, wrong);
                is_refused = true;
            }
        }
    }
    behaviour.iter().take(1).for_each(|block| notes.understood(*block, "behaviour of a connector"));
    if spring.stiffness > 0.0 || is_refused {
        Ok(spring)
    } else {
        Err("a spring was expected: give it *Connector Elasticity".into())
    }
}

const REPRESENTED: &str = "of an AXIAL connector linear elasticity, damping (component=1) and reference length are represented, and elasticity that only pulls";

/// Takes a table.
fn take(notes: &mut Notes, spring: &mut Spring, number: usize, behaviour: &[usize]) -> Result<(), Wrong> {
    let blocks = &notes.deck.blocks;
    let (block, rows) = (&blocks[number], blocks[number].rows.as_slice());
    let is_along = block.word("COMPONENT").is_some_and(|component| component == "1");
    match block.keyword.as_str() {
        "CONNECTOR ELASTICITY" if is_along && block.has("NONLINEAR") => {
            (spring.stiffness, spring.slack, spring.is_cable) = table(rows)?;
            let mut words =
                behaviour.iter().take(1).chain([&number]).map(|block| blocks[*block].word("EXTRAPOLATION"));
            if !words.any(|word| word.is_some_and(|word| word == "LINEAR")) {
                let text = "beyond its last point the stiffness goes on, where Abaqus keeps the force";
                notes.approximated(number, text);
            }
        }
        "CONNECTOR ELASTICITY" if is_along && !block.has("RIGID") => {
            spring.stiffness = only(rows, "one stiffness above 0 was expected", |value| value > 0.0)?;
        }
        "CONNECTOR DAMPING" if is_along && !block.has("NONLINEAR") => {
            spring.damping = only(rows, "one damping of 0 or more was expected", |value| value >= 0.0)?;
        }
        "CONNECTOR CONSTITUTIVE REFERENCE" => {
            spring.length = Some(only(rows, "one length above 0 was expected", |value| value > 0.0)?);
        }
        _ => return Err(REPRESENTED.into()),
    }
    Ok(())
}

/// The only number of some data.
pub(super) fn only(rows: &[Row], expected: &str, is_right: impl Fn(f64) -> bool) -> Result<f64, Wrong> {
    let wrong = || rows.first().map_or_else(|| Wrong::from(expected), |row| Wrong::at(row.place, expected));
    match rows {
        [row] if row.fields().len() == 1 => row.number(0)?.filter(|value| is_right(*value)).ok_or_else(wrong),
        _ => Err(wrong()),
    }
}

/// Stiffness, slack, and whether it only pulls, from pairs of force and extension.
fn table(rows: &[Row]) -> Result<(f64, f64, bool), Wrong> {
    let mut points = Vec::new();
    for row in rows {
        let [force, extension] = row.numbers()?[..] else {
            return Err(Wrong::at(row.place, "a force and an extension were expected"));
        };
        points.push([force, extension]);
    }
    let taut = points.iter().position(|[force, _]| *force > 0.0).unwrap_or(0);
    let is_cable = taut > 0 && points[..taut].iter().all(|[force, _]| *force == 0.0);
    let slack = if is_cable { points[taut - 1][1] } else { 0.0 };
    let [force, extension] = points.last().copied().unwrap_or_default();
    let stiffness = force / (extension - slack);
    let straight = if is_cable { &points[taut..] } else { &points[..] };
    let scale = 1e-9 * stiffness * (extension - slack);
    let is_on =
        |[force, at]: &[f64; 2]| (force - stiffness * (at - slack)).abs() <= scale.max(1e-6 * force.abs());
    let is_rising = points.len() >= 2 && points.windows(2).all(|pair| pair[1][1] > pair[0][1]);
    if is_rising && stiffness > 0.0 && stiffness.is_finite() && straight.iter().all(is_on) {
        return Ok((stiffness, slack, is_cable));
    }
    Err("a straight line through 0 was expected, or no force up to an extension and a straight line beyond it".into())
}
