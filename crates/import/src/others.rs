//! Keywords that give the case little or nothing: output requests, and what a case does in a way of its own.

use crate::notes::Notes;
use deck::block::Block;

/// What the output requests ask for, in units of time of the deck.
#[derive(Debug, Default)]
pub(super) struct Asked {
    /// Between fields, with its block.
    pub(super) field: Option<(f64, usize)>,
    /// Between lines of the history, with its block.
    pub(super) history: Option<(f64, usize)>,
    /// Coefficients of bulk viscosity that are not those of every deck, with their block.
    pub(super) viscosity: Option<([f64; 2], usize)>,
}

/// Keywords that mean what a case does anyway.
const USUAL: [(&str, &str); 13] = [
    ("CONTACT", "soil meets every body"),
    (
        "CONTACT INCLUSIONS",
        "soil meets every body; bodies meet one another only by joints of kind contact, to be added",
    ),
    ("SURFACE BEHAVIOR", "surfaces do not enter one another"),
    ("NODE OUTPUT", "forces.csv: RF (with the other sign), U, V, VR of every body, always"),
    ("ELEMENT OUTPUT", "soil.pvd: EVF, S, PEEQ, density; joint_NAME.csv: forces of connectors; always"),
    ("ENERGY OUTPUT", "energy.csv, always"),
    ("CONTACT OUTPUT", "the force of the soil on every body is in forces.csv"),
    ("RESTART", "checkpoints are written always"),
    ("INCREMENTATION OUTPUT", "run.log"),
    ("MONITOR", "the lines in the terminal"),
    ("EULERIAN BOUNDARY", "see the walls of the box"),
    ("NODE FILE", "forces.csv"),
    ("EL FILE", "soil.pvd"),
];

/// Keywords that are left out, and what that may change.
const LEFT_OUT: [(&str, &str); 27] = [
    ("PREPRINT", "nothing: what Abaqus prints"),
    ("PRINT", "nothing: what Abaqus prints"),
    ("FILE OUTPUT", "nothing: what Abaqus writes"),
    ("NODE PRINT", "nothing: what Abaqus prints"),
    ("EL PRINT", "nothing: what Abaqus prints"),
    ("CONTROLS", "nothing: of implicit steps"),
    ("FILTER", "histories are means over their interval, and filtered.csv is filtered"),
    (
        "FIXED MASS SCALING",
        "run time; the soil keeps its own mass, so that inertia is smaller and steps are shorter than in Abaqus",
    ),
    (
        "VARIABLE MASS SCALING",
        "run time; the soil keeps its own mass, so that inertia is smaller and steps are shorter than in Abaqus",
    ),
    ("SECTION CONTROLS", "hourglass control is that of the case ([numerics])"),
    ("HOURGLASS STIFFNESS", "hourglass control is that of the case ([numerics])"),
    ("CONTACT CONTROLS ASSIGNMENT", "contact by impulses has no stiffness to scale"),
    ("CONTACT FORMULATION", "contact by impulses has one formulation"),
    ("CONTACT CONTROLS", "contact by impulses has no stiffness to scale"),
    ("CONTACT DAMPING", "contact by impulses has no damping"),
    ("SURFACE PROPERTY ASSIGNMENT", "thickness and offsets of surfaces count for nothing"),
    ("CONTACT EXCLUSIONS", "soil meets every body all the same"),
    ("DIAGNOSTICS", "nothing: what Abaqus prints"),
    ("DAMPING", "the soil has no Rayleigh damping: waves last longer"),
    ("EXPANSION", "nothing without temperatures"),
    ("CONDUCTIVITY", "nothing without temperatures"),
    ("SPECIFIC HEAT", "nothing without temperatures"),
    ("INELASTIC HEAT FRACTION", "nothing without temperatures"),
    ("PHYSICAL CONSTANTS", "nothing of it is used"),
    ("PARAMETER", "nothing where no value refers to it"),
    ("TIME POINTS", "output is written at even intervals"),
    ("CONTACT CLEARANCE ASSIGNMENT", "bodies stand where the deck puts them"),
];

/// Keywords that are known and not represented, and why.
const REFUSED: [(&str, &str); 37] = [
    ("USER MATERIAL", SUBROUTINE),
    ("DEPVAR", SUBROUTINE),
    ("USER DEFINED FIELD", SUBROUTINE),
    ("USER ELEMENT", SUBROUTINE),
    ("EOS", "of soil Mohr–Coulomb, Drucker–Prager and von Mises are represented: a fluid has no law here"),
    (
        "VISCOSITY",
        "of soil Mohr–Coulomb, Drucker–Prager and von Mises are represented: a fluid has no law here",
    ),
    ("HYPERELASTIC", "the elasticity of soil is linear"),
    (
        "CLAY PLASTICITY",
        "of soil Mohr–Coulomb, Drucker–Prager and von Mises are represented; undrained clay as Mohr–Coulomb with φ = 0",
    ),
    ("CAP PLASTICITY", "of soil Mohr–Coulomb, Drucker–Prager and von Mises are represented"),
    ("PERMEABILITY", "pore water is that of a case: add [water]"),
    ("STATIC", IMPLICIT),
    ("GEOSTATIC", "no step of a case: the ground begins in equilibrium under its weight; leave it out"),
    ("SOILS", IMPLICIT),
    ("FREQUENCY", IMPLICIT),
    ("VISCO", IMPLICIT),
    ("HEAT TRANSFER", TEMPERATURE),
    ("COUPLED TEMPERATURE-DISPLACEMENT", TEMPERATURE),
    ("DYNAMIC TEMPERATURE-DISPLACEMENT", TEMPERATURE),
    ("TEMPERATURE", TEMPERATURE),
    ("SRADIATE", TEMPERATURE),
    ("SFILM", TEMPERATURE),
    ("DSFLUX", TEMPERATURE),
    ("BUCKLE", IMPLICIT),
    ("ADAPTIVE MESH", "soil flows through a mesh that stands still: *Eulerian Section was expected"),
    (
        "ADAPTIVE MESH CONSTRAINT",
        "soil flows through a mesh that stands still: *Eulerian Section was expected",
    ),
    ("FIELD", "predefined fields are not represented"),
    ("DSLOAD", "pressure on surfaces is not represented: put its sum on the reference node by *Cload"),
    ("TIE", "bodies are joined by connectors, BEAM for one that moves as one with another"),
    ("MPC", "bodies are joined by connectors, BEAM for one that moves as one with another"),
    ("COUPLING", "a reference node moves what *Rigid Body gives it"),
    ("KINEMATIC", "a reference node moves what *Rigid Body gives it"),
    ("EQUATION", "a reference node moves what *Rigid Body gives it"),
    ("TRANSFORM", "motions and loads along the axes of the deck were expected"),
    ("BEAM SECTION", DEFORMS),
    ("BEAM GENERAL SECTION", DEFORMS),
    ("MEMBRANE SECTION", DEFORMS),
    ("DASHPOT", "a damper is a connector of type AXIAL with *Connector Elasticity and *Connector Damping"),
];
const SUBROUTINE: &str = "user subroutines are not run: choose a law of the case, law = \"sand\" for strength that follows density";
const IMPLICIT: &str = "an implicit step: *Dynamic, explicit was expected";
const TEMPERATURE: &str = "there are no temperatures in a case";
const DEFORMS: &str = "elements that deform are not represented; make the body rigid with *Rigid Body";

/// Enters what becomes of the blocks that the reader left alone.
pub(super) fn others(notes: &mut Notes) -> Asked {
    let deck = notes.deck;
    let mut asked = Asked::default();
    for number in &deck.others {
        let block = &deck.blocks[*number];
        let keyword = block.keyword.as_str();
        let find = |table: &[(&str, &'static str)]| {
            table.iter().find(|(name, _)| *name == keyword).map(|(_, text)| *text)
        };
        match keyword {
            "OUTPUT" => output(notes, *number, block, &mut asked),
            "BULK VISCOSITY" => viscosity(notes, *number, block, &mut asked),
            "SURFACE BEHAVIOR" if !is_hard(block) => {
                notes.refused(*number, "of surface behaviour hard contact that opens freely is represented");
            }
            "EULERIAN BOUNDARY" => {
                let text = "closed walls: soil neither flows in nor out, and waves return from them";
                block.see_all();
                notes.approximated(*number, text);
            }
            _ => match (find(&USUAL), find(&LEFT_OUT)) {
                (Some(text), _) => {
                    block.see_all();
                    notes.understood(*number, text);
                }
                (_, Some(text)) => notes.ignored(*number, text),
                // Where nothing is entered the ledger refuses it.
                _ => find(&REFUSED).into_iter().for_each(|text| notes.refused(*number, text)),
            },
        }
    }
    asked
}

fn is_hard(block: &Block) -> bool {
    let soft = ["NO SEPARATION", "AUGMENTED LAGRANGE", "PENALTY"];
    block.word("PRESSURE-OVERCLOSURE").is_none_or(|kind| kind == "HARD") && !block.has(soft[0])
}

fn output(notes: &mut Notes, number: usize, block: &Block, asked: &mut Asked) {
    let deck = notes.deck;
    let duration = deck.steps.iter().map(|step| step.duration).fold(0.0, f64::max);
    let get = |name: &str| block.value(name).and_then(deck::block::number).filter(|value| *value > 0.0);
    let interval = get("TIME INTERVAL").or_else(|| get("NUMBER INTERVAL").map(|count| duration / count));
    let is_history = block.has("HISTORY");
    let is_field = block.has("FIELD");
    block.see_all();
    let slot = if is_history { &mut asked.history } else { &mut asked.field };
    match interval.filter(|_| is_history || is_field) {
        Some(interval) => {
            *slot = Some((slot.map_or(interval, |(before, _)| before.min(interval)), number));
            notes.understood(number, "how often results are written; the smallest interval of several");
        }
        None => notes.understood(number, "results are written at the usual intervals of a case"),
    }
}

/// Every deck states the coefficients of Abaqus; a case has its own unless others are asked for.
fn viscosity(notes: &mut Notes, number: usize, block: &Block, asked: &mut Asked) {
    let get = |field: usize, usual: f64| match block.rows.first().map(|row| row.number(field)) {
        Some(Ok(Some(value))) if value >= 0.0 => Some(value),
        None | Some(Ok(None)) => Some(usual),
        _ => None,
    };
    match (get(0, 0.06), get(1, 1.2)) {
        (Some(linear), Some(quadratic)) if linear == 0.06 && quadratic == 1.2 => {
            let text = "the usual values of Abaqus: frictional soil has 0.02 here, where 0.06 adds to the force, clay 0.06";
            notes.ignored(number, text);
        }
        (Some(linear), Some(quadratic)) => {
            asked.viscosity = Some(([linear, quadratic], number));
            notes.understood(number, "bulk viscosity");
        }
        _ => notes.refused(number, "two numbers of 0 or more were expected"),
    }
}
