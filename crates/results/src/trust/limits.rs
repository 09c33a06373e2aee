//! The table of limits: up to where a figure is good or doubtful, and why.

use super::verdict::Verdict;
use case::ClosedBox;
use case::resolved::{Output, Water};

/// The limits of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Name of the check.
    pub name: &'static str,
    /// Unit of figure and limits.
    pub unit: &'static str,
    /// Limit of good: an upper bound, or a lower one where more is better.
    pub good: f64,
    /// Limit of doubtful, beyond which the run is broken; infinite for never broken.
    pub doubtful: f64,
    /// Whether larger is better.
    pub more_is_better: bool,
    /// Definition of the figure.
    pub meaning: &'static str,
    /// Reason for the limits.
    pub reason: &'static str,
    /// What to do when the figure is not good.
    pub advice: &'static str,
}

impl Limit {
    /// The verdict on a figure; what is not a number is broken.
    #[must_use]
    pub fn verdict(&self, value: f64) -> Verdict {
        let sign = if self.more_is_better { -1.0 } else { 1.0 };
        // A figure that lies on its limit but for round-off is within it.
        let within = |limit: f64| sign * value <= sign * limit + 1e-9 * limit.abs();
        if value.is_nan() {
            Verdict::Broken
        } else if within(self.good) {
            Verdict::Good
        } else if self.doubtful.is_infinite() || within(self.doubtful) {
            Verdict::Doubtful
        } else {
            Verdict::Broken
        }
    }
}

const NEVER: f64 = f64::INFINITY;

/// Whether the run reached its end without a breakdown.
pub const COMPLETED: Limit = Limit {
    name: "completed",
    unit: "",
    good: 0.0,
    doubtful: 0.0,
    more_is_better: false,
    meaning: "1 if the run was stopped because its results could no longer be trusted",
    reason: "a run that broke down has no valid result",
    advice: "",
};

/// Error of the energy balance.
pub const ENERGY_BALANCE: Limit = Limit {
    name: "energy balance",
    unit: "%",
    good: 1.0,
    doubtful: 5.0,
    more_is_better: false,
    meaning: "unexplained energy, beyond what rounding of the soil's elastic energy leaves, over the largest of external work, plastic dissipation and kinetic energy",
    reason: "runs of the verification suite that agree with exact solutions stay below 1 %; 5 % is the accuracy required of forces",
    advice: "use a smaller numerics.courant, a slower motion or a finer grid",
};

/// Work of hourglass viscosity.
pub const HOURGLASS: Limit = Limit {
    name: "hourglass energy",
    unit: "%",
    good: 2.0,
    doubtful: 10.0,
    more_is_better: false,
    meaning: "work of hourglass viscosity over the external work",
    reason: "a force that does this fraction of the work affects the result; 10 % is the customary bound in finite-element practice",
    advice: "use a finer grid, or a smaller numerics.hourglass_yielding",
};

/// Work of bulk viscosity.
pub const VISCOUS: Limit = Limit {
    name: "viscous energy",
    unit: "%",
    good: 5.0,
    doubtful: 20.0,
    more_is_better: false,
    meaning: "work of bulk viscosity over the external work",
    reason: "as for hourglass energy; bulk viscosity also damps physical waves, so that more of it is harmless",
    advice: "move more slowly, or use a smaller numerics.bulk_viscosity_linear",
};

/// Energy lost in remaps.
pub const REMAP_LOSS: Limit = Limit {
    name: "remap loss",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "kinetic and elastic energy lost (or, with ψ > 0, gained) in remaps over the external work",
    reason: "energy that mixing dissipates does no work on the body; the loss falls with the cell size",
    advice: "use a finer grid; with ψ > 0 set soil.critical_density",
};

/// Energy of the contact method.
pub const CONTACT_ENERGY: Limit = Limit {
    name: "contact energy",
    unit: "%",
    good: 5.0,
    doubtful: 20.0,
    more_is_better: false,
    meaning: "energy that the contact method itself stores, dissipates or adds over the external work",
    reason: "it belongs to corrections of overlap and gap, not to the soil; 5 % is the accuracy required of forces",
    advice: "use a finer grid, or move more slowly",
};

/// Soil volume.
pub const VOLUME: Limit = Limit {
    name: "soil volume",
    unit: "%",
    good: 0.5,
    doubtful: 2.0,
    more_is_better: false,
    meaning: "change of the soil volume since the start that the pressure does not account for by elastic compression (with ψ > 0 only its loss; not of sand, whose law changes it)",
    reason: "0.5 % is the tolerance of the verification suite (C3)",
    advice: "use a finer grid",
};

/// Soil that is denser than it can be.
pub const OVERDENSE: Limit = Limit {
    name: "overdense soil",
    unit: "%",
    good: 0.1,
    doubtful: 5.0,
    more_is_better: false,
    meaning: "largest portion of the soil's mass at any time in cells denser than 1.1 times its densest state (for sand I_D = 1.2), as far as elastic compression under its pressure does not account for it",
    reason: "this is soil whose volume was lost, and the surface above it falls; all runs of the verification suite stay below 0.1 %",
    advice: "use a finer grid, and look at the density in the fields: the soil there is not to be trusted, forces elsewhere may be",
};

/// Soil inside a body.
pub const LEAK: Limit = Limit {
    name: "leak",
    unit: "%",
    good: 0.5,
    doubtful: 1.0,
    more_is_better: false,
    meaning: "soil inside the body (all in the cells that it fills; in those that it cuts what is compressed by more than a tenth for want of space) over its volume below the surface, at least a layer of one cell over its base, averaged over the steady window, or at the end where that is more; of a body that was never below the surface, the most at any time over its whole volume",
    reason: "soil that leaks into a body exerts no force on it; footings, walls and inclined plates of the verification suite with 0.1 to 0.7 % agree with exact solutions within their tolerance (the aim of the suite is 0.1 %, C4); what cut cells have no space for is compressed as the body moves on: two random cases with 2.5 and 3.0 % of it were within 13 % of cells half as wide",
    advice: "use a finer grid, or a body with fewer sharp edges oblique to the grid; cells that are long and flat leak more than cubes",
};

/// Voids under soil.
pub const VOID: Limit = Limit {
    name: "void under soil",
    unit: "%",
    good: 0.5,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "volume at the end of voids under soil at rest (0.7 cells of it or more) over that of disturbed soil; where neither a body nor a cohesion of c > γ b/2 over a cell's width b carries the soil",
    reason: "the tolerance of the soil volume: a void is volume without soil, by which the surface stands too high (a light disc on sand without cohesion left 1 %, a column that had collapsed 2 %, before enclosed voids were closed)",
    advice: "cells that are filled in part bear sand over a void: do not trust depth and shape of ruts and heaps; forces may be used",
};

/// Whether a body meets soil.
pub const CONTACT: Limit = Limit {
    name: "contact",
    unit: "",
    good: 1.0,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "largest force on the body in the steady window over the weight of the soil in one cell and its cohesion over the cell's face; a body that bears less than a hundredth of what another bears in the same gear, joined by hinges, balls or sliders, has none of the checks of a body",
    reason: "a body that bears less than one cell of soil has none to speak of, and what is said of its force is said of nothing",
    advice: "look where its motion leads: upwards, past the soil, or through a body thinner than a cell",
};

/// Whether anything moves.
pub const MOTION: Limit = Limit {
    name: "motion",
    unit: "cells",
    good: 0.01,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "longest way of a body, or of all soil with the kinetic energy there was, over the cell height",
    reason: "contact alone settles within some hundredths of a cell: nothing has moved that the grid can resolve",
    advice: "look at run.duration and at when the motions begin; a run of a few steps says nothing",
};

/// Froude number.
pub const INERTIA: Limit = Limit {
    name: "inertia (Froude number)",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "momentum of the soil set in motion, 2 ρ v² on the embedded front, over the force on the body; of a passive wedge 4 Fr/K_p with Fr = v²/(g z)",
    reason: "inertia is physical, not an error, but a force with more than a tenth of it is not quasi-static",
    advice: "tow more slowly for a quasi-static force",
};

/// Whether water can follow as the soil is sheared.
pub const DRAINAGE: Limit = Limit {
    name: "drainage number",
    unit: "",
    good: Water::DRAINED[0],
    doubtful: Water::DRAINED[1],
    more_is_better: false,
    meaning: "(γ_w/γ′) v ε/k with the mean speed of the body, the volume strain ε of failing soil and its permeability k",
    reason: "the run has drained soil; in closed form with suction a free disc sinks some 4 % less at 0.5 and 28 % less at 5; beyond, only with --accept-drained, and then doubtful",
    advice: "move more slowly; forecast with `coulter forecast`, which has a suction term",
};

/// Noise of the drag.
pub const NOISE: Limit = Limit {
    name: "drag noise",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "scatter of the drag about its moving average over 0.02 d, over the same",
    reason: "the mean over a window of ten independent fluctuations is then known to 3 %",
    advice: "use a finer grid or a longer tow",
};

/// Samples of the steady window, where they are too few for any statistics.
pub const SAMPLES: Limit = Limit {
    name: "samples",
    unit: "",
    good: Output::FEWEST_SAMPLES as f64,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "lines of the history in the steady window, where they are too few for eight averages",
    reason: "of fewer neither a trend nor a scatter is known, and the mean is that of some moments",
    advice: "use a shorter output.history_interval or a longer run",
};

/// Trend of the drag.
pub const STEADY_DRAG: Limit = Limit {
    name: "steady drag",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "change of the drag over the steady window: the trend of eight block averages, over their mean, over a tenth of the whole force or over the thrust of a body that turns, whichever is largest",
    reason: "the mean over a window in which the force changes by 10 % is within 5 % of both ends; a pull is the difference of thrust and resistance, and may be almost zero",
    advice: "tow farther; the force is still changing",
};

/// Noise of the vertical force.
pub const VERTICAL_NOISE: Limit = Limit {
    name: "vertical noise",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "scatter of the vertical force of a body that is held or moved vertically about its moving average over 0.02 d (at least a cell) of its way, over its mean or 0.3 of the whole force",
    reason: "as for the drag; forces jump as cells fill and empty, once in a cell",
    advice: "use a finer grid or a longer motion; of a body that is pressed, move more slowly",
};

/// Trend of the vertical force.
pub const STEADY_VERTICAL: Limit = Limit {
    name: "steady vertical force",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "change of the vertical force of a towed body that is held vertically over the steady window, as for the drag, over its mean or 0.3 of the whole force",
    reason: "as for the drag",
    advice: "tow farther; the force is still changing",
};

/// Noise of the lateral force.
pub const LATERAL_NOISE: Limit = Limit {
    name: "lateral noise",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "as vertical noise, of the lateral force of a towed body where that is more than 0.3 of the whole force",
    reason: "as for the drag",
    advice: "use a finer grid or a longer tow",
};

/// Trend of the lateral force.
pub const STEADY_LATERAL: Limit = Limit {
    name: "steady lateral force",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "as for the vertical force, of the lateral force where that is more than 0.3 of the whole force",
    reason: "as for the drag",
    advice: "tow farther; the force is still changing",
};

/// Noise of the torque.
pub const TORQUE_NOISE: Limit = Limit {
    name: "torque noise",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "as vertical noise, of the torque about the axis about which a prescribed motion turns the body, over its mean or a tenth of the whole force on its arm",
    reason: "as for the drag",
    advice: "use a finer grid or a longer motion",
};

/// Trend of the torque.
pub const STEADY_TORQUE: Limit = Limit {
    name: "steady torque",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "change of this torque over the steady window, as for the drag, over the same; not of a body that is moved vertically as well",
    reason: "as for the drag",
    advice: "turn farther; the torque is still changing",
};

/// Trend of the sinkage.
pub const STEADY_SINKAGE: Limit = Limit {
    name: "steady sinkage",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "change of the sinkage over the steady window: the trend of eight block averages, over their mean (at least one cell)",
    reason: "as for the drag",
    advice: "tow farther; the body is still sinking or rising",
};

/// Resolution of the sinkage.
pub const SINKAGE_CELLS: Limit = Limit {
    name: "cells over sinkage",
    unit: "cells",
    good: 4.0,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "sinkage in the steady window over the cell height",
    reason: "the sinkage of the shipped disc changes by 20 % while it is about one cell, the drag of embedded bodies by a few per cent from four cells on",
    advice: "make grid.cell smaller",
};

/// Resolution of the contact.
pub const CHORD_CELLS: Limit = Limit {
    name: "cells over contact chord",
    unit: "cells",
    good: 5.0,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "length of the contact with the ground along the tow over the cell width; not for an upright face that is towed",
    reason: "footings, plates and cylinders of the verification suite are within some 5 % from 8 cells on; of sixteen random cases on 3.5 to 7.7 cells all were within 15 % of cells of two thirds the size",
    advice: "make grid.cell smaller",
};

/// Resolution of the sinkage for the vertical force.
pub const VERTICAL_CELLS: Limit = Limit {
    name: "cells for the vertical force",
    unit: "cells",
    good: 8.0,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "sinkage over the cell height, of a towed body that is held or moved vertically, where its vertical force is more than 0.3 of the whole",
    reason: "a rounded disc held 0.22 m deep in dense sand bears 2.14, 2.57 and 2.41 kN on 4.8, 7.1 and 10.7 cells (drag 2.46, 2.69 and 2.56 kN); of fourteen good random cases on cells of two thirds the size no drag moved by more than 10 %, but vertical forces of held bodies by −22 to +20 % in three",
    advice: "make grid.cell smaller, or run --meshes 4 for an interval of the vertical force; the drag is not concerned",
};

/// Resolution of the width.
pub const WIDTH_CELLS: Limit = Limit {
    name: "cells over width",
    unit: "cells",
    good: 4.0,
    doubtful: NEVER,
    more_is_better: true,
    meaning: "width of the body over the cell width, across the tow; of a dished disc its thickness",
    reason: "below 4 cells forces are uncertain by tens of per cent",
    advice: "make grid.cell smaller",
};

/// Whether a free body is lifted off the ground.
pub const RIDING_HEIGHT: Limit = Limit {
    name: "riding height",
    unit: "%",
    good: 5.0,
    doubtful: 25.0,
    more_is_better: false,
    meaning: "height of a free body's lowest point above the undisturbed surface in the steady window, over the body's height",
    reason: "a heavy body sinks; it rides up on a heap by a few per cent of its height at most",
    advice: "look at the pictures: soil with ψ > 0 that dilates without limit, or numerical forces, may lift it",
};

/// Rotation of a free wheel.
pub const FREE_WHEEL: Limit = Limit {
    name: "turn ratio of a free wheel",
    unit: "",
    good: 0.1,
    doubtful: 0.5,
    more_is_better: false,
    meaning: "how far ω r/v of a body that rotates freely lies outside 0 to 1 in the steady window",
    reason: "without a torque on its axle a towed wheel rotates forward and slides: 0 ≤ ω r/v ≤ 1",
    advice: "look at the axle torque; a tow that has just begun or a coarse grid may be the cause",
};

/// Distance between a body and the floor of the box.
pub const BODY_IN_BOX: Limit = Limit {
    name: "clearance from the floor",
    unit: "cells",
    good: 4.0,
    doubtful: 0.0,
    more_is_better: true,
    meaning: "least distance from the floor of a body that moves vertically, over the cell height",
    reason: "closer than a few cells the floor carries the body; below the floor it has left the box",
    advice: "make domain.z deeper",
};

/// Soil at the lid.
pub const LID: Limit = Limit {
    name: "soil at the lid",
    unit: "%",
    good: 0.1,
    doubtful: 2.0,
    more_is_better: false,
    meaning: "largest force of the soil on the lid over the largest force on the bodies; 1 if soil touches it where no body meets soil",
    reason: "the lid is not part of the problem: soil that it holds back loads the soil in front of the body",
    advice: "raise the upper ends of domain.z and of grid.fine_z",
};

/// Soil at a wall that was bare at the start.
pub const WALLS: Limit = Limit {
    name: "soil at bare walls",
    unit: "cm²",
    good: 0.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "largest area of side wall that soil has reached and that was bare at the start",
    reason: "without the wall the soil would have moved on",
    advice: "make domain.x or domain.y larger",
};

/// Stress at the boundaries.
pub const BOUNDARY_STRESS: Limit = Limit {
    name: "stress at the boundaries",
    unit: "%",
    good: 100.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "largest rise of the normal pressure on floor and side walls over the contact pressure (force over the embedded front and the base, at least torque over arm and surface, and a tenth of the vertical pressure at the floor), in the last third of the run",
    reason: "of nine random cases with 42 to 226 % a box half as deep again, or 1.4 times as wide as well, changed the force by −6 to +1 %; of twelve others below 50 % a box 1.7 times as wide and 1.5 times as deep changed it by 0 to 8 % in eleven, by 29 % in one",
    advice: "make the domain larger, above all where `coulter check` warns of a near wall",
};

/// Rise of the pressure in a closed box.
pub const PUMPED: Limit = Limit {
    name: "pressure of displaced volume",
    unit: "%",
    good: ClosedBox::HARMLESS,
    doubtful: 50.0,
    more_is_better: false,
    meaning: "K ΔV/V of the bodies that have entered soil which fills its box up to the lid, over what the soil bears round them (overburden, weight, ten times the strength)",
    reason: "walls, floor and lid do not yield: the pressure everywhere, and with it the resistance, rises by it; a cone in clay in such boxes read 4 % low at 18 %, and 70 % high at 114 %",
    advice: "make the domain larger in every direction; a pressure is a tenth in a box of ten times the volume",
};

/// Values that no soil, body or tow has.
pub const UNUSUAL: Limit = Limit {
    name: "unusual values",
    unit: "",
    good: 0.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "number of values and motions of the case that no soil, body or tow has; `coulter check` names them before the run",
    reason: "a unit or a sign that was mistaken gives a run without any other fault; the usual ranges stand at the keys",
    advice: "check the units and signs",
};

/// Courant number.
pub const STEP_SIZE: Limit = Limit {
    name: "step size",
    unit: "",
    good: 0.6,
    doubtful: 0.9,
    more_is_better: false,
    meaning: "Courant number of the time step",
    reason: "elastic waves are stable up to 1, less a margin for viscosity and partly filled cells",
    advice: "leave numerics.courant at its default, 0.5",
};

/// Contribution of the mesh to an interval.
pub const EFFECT_OF_MESH: Limit = Limit {
    name: "effect of the mesh",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "largest contribution of the mesh to an interval of the body, over the value; only with `--confidence` or `--meshes`, as are the next six",
    reason: "chosen: a grid-convergence index of 10 % is common for forces of contact on eight to sixteen cells, and the safety factor in it is 1.25 at least",
    advice: "make grid.cell smaller",
};

/// Contribution of the domain to an interval.
pub const EFFECT_OF_DOMAIN: Limit = Limit {
    name: "effect of the domain",
    unit: "%",
    good: 5.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "the same of the domain: three times the change in one that ends 1.5 times as far away",
    reason: "5 % is the accuracy required of forces",
    advice: "make the domain larger; if its walls are real (a soil bin), use --without domain",
};

/// Contribution of the speed to an interval.
pub const EFFECT_OF_SPEED: Limit = Limit {
    name: "effect of the speed",
    unit: "%",
    good: 5.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "the same of the speed: twice the change at half of it",
    reason: "as for the domain",
    advice: "move more slowly; if the speed is a part of the problem, use --without speed",
};

/// Contribution of the precision to an interval.
pub const EFFECT_OF_PRECISION: Limit = Limit {
    name: "effect of the precision",
    unit: "%",
    good: 2.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "the same of the precision: 1.25 times the change in the other one",
    reason: "single and double precision agree within 0.5 % in the verification suite (P1); a motion that is sensitive to rounding scatters by more",
    advice: "use numerics.precision = \"double\"; where it is double already, the motion is sensitive to small disturbances, and a longer run averages over more of them",
};

/// Half-width of the widest interval.
pub const CONFIDENCE: Limit = Limit {
    name: "confidence interval",
    unit: "%",
    good: 15.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "half-width of the widest interval of the body (90 %), over its value",
    reason: "chosen: beyond it the sign of a design change of the usual size would be open",
    advice: "reduce what dominates it: see `confidence` in summary.json",
};

/// Whether the force on a body still changes.
pub const LEVEL_FORCE: Limit = Limit {
    name: "level force",
    unit: "%",
    good: 10.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "change of the force over its mean over the window: of a body that is towed, of the drag since the stretch before the window, of the same length; of one that is moved vertically and not towed, of the vertical force along the trend of eight block averages",
    reason: "as for the steady drag: the interval is that of the mean over the window, not of a load that stays",
    advice: "tow or press farther, or use a stiffer soil, for a load that stays; where the resistance grows with depth, read the interval as that of the mean over the window",
};

/// Variations that should have been run, and give nothing.
pub const MISSING_VARIATIONS: Limit = Limit {
    name: "missing variations",
    unit: "",
    good: 0.0,
    doubtful: NEVER,
    more_is_better: false,
    meaning: "number of variations that were not run for lack of budget, are broken, or cannot be compared, and of bodies without statistics",
    reason: "an interval may be too narrow by what was not examined",
    advice: "give more time (--budget) or look at their reports in variations",
};

/// Energy that passes to and from another program.
pub const EXCHANGE: Limit = Limit {
    name: "exchanged energy",
    unit: "%",
    good: 1.0,
    doubtful: 5.0,
    more_is_better: false,
    meaning: "work of the soil on bodies that another program moves, as it follows from the mean force between two exchanges, less the work itself, over the sum of its magnitudes",
    reason: "as for the energy balance: what the exchange adds or takes, neither program knows of",
    advice: "exchange more often",
};

/// Every limit, in the order of the checks.
pub const ALL: [&Limit; 45] = [
    &COMPLETED,
    &ENERGY_BALANCE,
    &HOURGLASS,
    &VISCOUS,
    &REMAP_LOSS,
    &CONTACT_ENERGY,
    &VOLUME,
    &OVERDENSE,
    &VOID,
    &EXCHANGE,
    &MOTION,
    &LEAK,
    &CONTACT,
    &SINKAGE_CELLS,
    &CHORD_CELLS,
    &VERTICAL_CELLS,
    &WIDTH_CELLS,
    &SAMPLES,
    &STEADY_DRAG,
    &STEADY_SINKAGE,
    &NOISE,
    &VERTICAL_NOISE,
    &STEADY_VERTICAL,
    &LATERAL_NOISE,
    &STEADY_LATERAL,
    &TORQUE_NOISE,
    &STEADY_TORQUE,
    &INERTIA,
    &DRAINAGE,
    &RIDING_HEIGHT,
    &FREE_WHEEL,
    &BODY_IN_BOX,
    &LID,
    &WALLS,
    &BOUNDARY_STRESS,
    &PUMPED,
    &UNUSUAL,
    &STEP_SIZE,
    &EFFECT_OF_MESH,
    &EFFECT_OF_DOMAIN,
    &EFFECT_OF_SPEED,
    &EFFECT_OF_PRECISION,
    &CONFIDENCE,
    &LEVEL_FORCE,
    &MISSING_VARIATIONS,
];

/// The limits of the variations of a case, which come after all others.
pub const OF_CONFIDENCE: [&Limit; 7] = [
    &EFFECT_OF_MESH,
    &EFFECT_OF_DOMAIN,
    &EFFECT_OF_SPEED,
    &EFFECT_OF_PRECISION,
    &CONFIDENCE,
    &LEVEL_FORCE,
    &MISSING_VARIATIONS,
];
