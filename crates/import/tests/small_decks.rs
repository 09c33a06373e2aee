//! A small deck, changed: connectors, orientations, masses, amplitudes that swing, and what is refused.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod small;

use coulter_import::{Imported, Refused, import};
use deck::Outcome;

fn of(assembly: &str, model: &str, step: &str) -> Result<Imported, Box<Refused>> {
    import(
        &deck::read_with(&small::deck(assembly, model, step), "two.inp", |_| Err(String::new())),
        None,
        "two",
    )
}

/// The case, which must be read without a problem, and the import.
fn case(assembly: &str, model: &str, step: &str) -> Imported {
    loaded(of(assembly, model, step).unwrap_or_else(|refused| panic!("{:?}", texts(&refused))))
}

/// An import whose case is read without a problem.
fn loaded(imported: Imported) -> Imported {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("two.toml");
    std::fs::write(&file, &imported.case).unwrap();
    for (name, bytes) in &imported.files {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    coulter::case::load(&file, &[]).unwrap_or_else(|error| panic!("{error:?}\n{}", imported.case));
    imported
}

fn texts(refused: &Refused) -> Vec<String> {
    let of = |entry: &deck::Entry| match &entry.outcome {
        Outcome::Refused(text) => Some(format!("{} {}: {text}", entry.place.line, entry.keyword)),
        _ => None,
    };
    refused.missing.iter().cloned().chain(refused.entries.iter().filter_map(of)).collect()
}

/// What is refused: these words, and nothing else.
fn refused(assembly: &str, model: &str, step: &str, words: &str) {
    let found = texts(&of(assembly, model, step).map(|done| done.case).unwrap_err());
    assert!(found.iter().any(|text| text.contains(words)), "{words}: {found:?}");
    assert_eq!(found.len(), 1, "{found:?}");
}

fn has(imported: &Imported, lines: &[&str]) {
    lines.iter().for_each(|line| assert!(imported.case.contains(line), "{line}\n{}", imported.case));
}

const CONNECTOR: &str = "*Element, type=CONN3D2, elset=LINK\n9, A.9, B.9\n*Connector Section, elset=LINK";
const TOW: &str = "*Boundary, type=velocity\nA.RP, 1, 1, 0.1\n*Boundary\nA.RP, 2, 2\nA.RP, 4, 6\n";
/// First axis along y.
const ACROSS: &str = "*Orientation, name=\"Datum 1\"\n0., 1., 0., 0., 0., 1.\n1, 0.\n";

#[test]
fn a_hinge_has_the_axis_of_its_orientation_and_the_towed_body_carries() {
    let assembly = format!("{ACROSS}{}\nHinge,\n\"Datum 1\",\n", CONNECTOR.replace("A.9, B.9", "B.9, A.9"));
    let imported = case(&assembly, "", TOW);
    has(
        &imported,
        &[
            "kind = \"hinge\"",
            "bodies = [\"a-block\", \"b-block\"]",
            "axis = [0, 1, 0]",
            "at = [\"-0.75 m\", \"0 m\", \"0.35 m\"]",
        ],
    );
    has(&imported, &["spin = \"free\"", "[joint.link]"]);
}

#[test]
fn pairs_of_basic_types_are_the_joints_that_they_make() {
    for (types, kind) in [
        ("Join", "ball"),
        ("Join, Cardan", "ball"),
        ("Join, Revolute", "hinge"),
        ("Slot, Align", "slider"),
        ("Translator", "slider"),
    ] {
        let imported = case(&format!("{ACROSS}{CONNECTOR}\n{types}\n\"Datum 1\"\n"), "", TOW);
        has(&imported, &[&format!("kind = \"{kind}\"")]);
    }
    let ground = format!("{CONNECTOR}\nJoin\n").replace("A.9, B.9", "B.9,");
    has(
        &case(&ground, "", TOW),
        &["bodies = [\"ground\", \"b-block\"]", "at = [\"0.75 m\", \"0 m\", \"0.35 m\"]"],
    );
    let imported = case(&format!("{CONNECTOR}\nBeam,\n"), "", TOW);
    has(&imported, &["welded_to = \"a-block\""]);
    assert!(!imported.case.contains("[joint."));
}

#[test]
fn orientations_are_turned_and_may_be_given_by_nodes() {
    let turned =
        "*Orientation, name=O\n1., 0., 0., 0., 1., 0.\n3, 90.\n".to_owned() + CONNECTOR + "\nHinge\nO\n";
    has(&case(&turned, "", TOW), &["axis = [0, 1, 0]"]);
    let nodes =
        "*Orientation, name=O, definition=nodes\nA.4, A.5, A.1\n".to_owned() + CONNECTOR + "\nHinge\nO\n";
    has(&case(&nodes, "", TOW), &["axis = [0, 1, 0]"]);
    let line = "*Orientation, name=O\n1., 0., 0., 2., 0., 0.\n".to_owned() + CONNECTOR + "\nJoin\n";
    refused(&line, "", TOW, "lie in a line");
    let unused = case(
        "*Orientation, name=O\n1., 0., 0., 0., 1., 0.\n",
        "",
        &(TOW.to_owned() + &TOW.replace("A.", "B.")),
    );
    assert!(unused.entries.iter().any(|entry| entry.keyword == "ORIENTATION"
        && matches!(&entry.outcome, Outcome::Ignored(text) if text.contains("isotropic"))));
    refused("*Orientation, name=O, system=cylindrical\n0., 0., 0., 0., 0., 1.\n", "", TOW, "rectangular");
    refused(&format!("{CONNECTOR}\nHinge\nNONE\n"), "", TOW, "no orientation \"NONE\"");
    refused(&format!("{CONNECTOR}\nHinge\n"), "", TOW, "orientation is missing");
}

const SPRING: &str = "*Connector Behavior, name=LINE\n*Connector Elasticity, component=1\n2000.,\n*Connector Damping, component=1\n30.,\n";
/// A node alone that is towed, and a connector from it to A.
const WINCH: &str = "*Node\n7, 1.9, 0., 0.35\n*Nset, nset=WINCH\n7,\n*Element, type=CONN3D2, elset=LINK\n9, 7, B.9\n*Connector Section, elset=LINK, behavior=LINE\nAxial,\n";
const PULL: &str = "*Boundary, type=velocity\nWINCH, 1, 1, 0.1\n*Boundary\nWINCH, 2, 3\nA.RP, 1, 6\nB.RP, 2, 2\nB.RP, 4, 6\n";

#[test]
fn an_axial_connector_is_a_spring_or_a_cable_and_a_node_alone_a_frame() {
    let imported = case(WINCH, SPRING, PULL);
    has(
        &imported,
        &[
            "kind = \"spring\"",
            "bodies = [\"point-7\", \"b-block\"]",
            "stiffness = \"2000 N/m\"",
            "damping = \"30 N*s/m\"",
            "length = \"1.15 m\"",
            "shape = \"frame\"",
        ],
    );
    let cable = "*Connector Behavior, name=LINE\n*Connector Elasticity, component=1, nonlinear\n0., -1.\n0., 0.1\n200., 0.2\n*Connector Constitutive Reference\n1.2,\n";
    has(&case(WINCH, cable, PULL), &["kind = \"cable\"", "stiffness = \"2000 N/m\"", "length = \"1.3 m\""]);
    let bent = "*Connector Behavior, name=LINE\n*Connector Elasticity, component=1, nonlinear\n-1., -1.\n0., 0.\n20., 0.2\n";
    refused(WINCH, bent, PULL, "straight line");
    let plain = WINCH.replace("CONN3D2", "SpringA");
    let plain =
        plain.replace("*Connector Section, elset=LINK, behavior=LINE\nAxial,", "*Spring, elset=LINK\n\n500.");
    has(&case(&plain, "", PULL), &["kind = \"spring\"", "stiffness = \"500 N/m\""]);
    refused(&plain.replace("500.", "500., 0.1"), "", PULL, "one stiffness");
    let stop = SPRING.to_owned() + "*Connector Stop, component=1\n0., 1.\n";
    refused(WINCH, &stop, PULL, "reference length are represented");
    refused(
        WINCH,
        "*Connector Behavior, name=LINE\n*Connector Damping, component=1\n3.,\n",
        PULL,
        "a spring was expected",
    );
    refused(WINCH, "", PULL, "no connector behaviour LINE");
    let measuring = WINCH.replace(", behavior=LINE", "");
    let idle = of(&measuring, "", PULL).unwrap();
    assert!(
        idle.entries
            .iter()
            .any(|entry| matches!(&entry.outcome, Outcome::Ignored(text) if text.contains("only measures")))
    );
    refused(
        WINCH,
        SPRING,
        &PULL.replace("WINCH, 2, 3", "WINCH, 2, 2"),
        "point-7 moves freely and has no mass",
    );
}

#[test]
fn a_beam_to_a_node_that_is_moved_moves_the_body_itself() {
    let assembly = "*Element, type=CONN3D2, elset=LINK\n9, 1, A.9\n*Connector Section, elset=LINK\nBeam,\n*Nset, nset=TOP\n1,\n";
    let step = "*Boundary, type=velocity\nTOP, 3, 3, -0.1\n*Boundary\nTOP, 1, 2\nTOP, 4, 6\nB.RP, 1, 6\n";
    let imported = case(assembly, "", step);
    has(&imported, &["heave = { speed = \"-0.1 m/s\""]);
    assert!(!imported.case.contains("point-1"));
    refused(assembly, "", &step.replace("TOP, 4, 6", "TOP, 4, 6\nA.RP, 1, 1"), "one of them was expected");
}

#[test]
fn a_driven_hinge_turns_the_body_and_a_driven_translator_moves_it() {
    let hinge = format!("{ACROSS}{CONNECTOR}\nHinge,\n\"Datum 1\",\n");
    let step = TOW.to_owned() + "*Connector Motion, type=velocity\nLINK, 4, 3.\n";
    has(&case(&hinge, "", &step), &["spin = { speed = \"3 rad/s\""]);
    has(&case(&hinge, "", &step.replace("Motion, type=velocity", "Load")), &["spin = { load = \"3 N*m\""]);
    refused(&hinge, "", &step.replace("4, 3.", "1, 3."), "can be driven");
    let turning = step.replace("A.RP, 4, 6", "A.RP, 4, 5");
    refused(&hinge, "", &turning, "hold one of them");
    has(&case(&hinge, "", &turning.replace("Motion, type=velocity", "Load")), &["drive_torque = \"3 N*m\""]);
    refused(&hinge, "", &step.replace("LINK, 4", "NONE, 4"), "no connector \"NONE\"");
    let slider =
        hinge.replace("Hinge", "Translator").replace("0., 1., 0., 0., 0., 1.", "0., 0., 1., 1., 0., 0.");
    let step = "*Boundary\nA.RP, 1, 6\n*Connector Motion, type=velocity\nLINK, 1, -0.2\n";
    has(&case(&slider, "", step), &["heave = { speed = \"-0.2 m/s\"", "axis = [0, 0, 1]"]);
}

#[test]
fn what_no_joint_represents_is_refused_at_its_line() {
    for types in ["Link", "Cylindrical", "UJoint", "Bushing", "Slot", "Planar", "Join, Universal", "Nonsense"]
    {
        refused(&format!("{CONNECTOR}\n{types}\n"), "", TOW, "are represented, not");
    }
    refused("*Element, type=CONN3D2\n9, A.9, B.9\n", "", TOW, "has no *Connector Section");
    refused(
        &format!("{CONNECTOR}, behavior=LINE\nJoin\n"),
        "*Connector Behavior, name=LINE\n*Connector Lock\n1,\n",
        TOW,
        "only springs",
    );
    refused(&format!("{CONNECTOR}\nWeld\n").replace("A.9, B.9", ", B.9"), "", TOW, "welded to the ground");
    refused(&format!("{CONNECTOR}\nJoin\n").replace("A.9, B.9", "A.9, A.3"), "", TOW, "belong to one body");
    let unused = case("", SPRING, &(TOW.to_owned() + &TOW.replace("A.", "B.")));
    assert!(unused.report.contains("no connector refers to it"));
}

/// A deck of the folder, with replaced parts, as a case.
fn changed(name: &str, parts: &[[&str; 2]]) -> Imported {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("decks").join(format!("{name}.inp"));
    let mut text = std::fs::read_to_string(path).unwrap();
    for [from, to] in parts {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let imported = import(&deck::read_with(&text, "changed.inp", |_| Err(String::new())), None, name);
    loaded(imported.unwrap_or_else(|refused| panic!("{:?}", texts(&refused))))
}

const ANCHOR: &str = "*Node, nset=ANCHOR\n7, -0.2, 0., 0.12\n*Element, type=CONN3D2, elset=LINE\n9, 7, GEAR-1.1\n\
    *Connector Section, elset=LINE, behavior=LINE\nAxial,\n*End Assembly\n";

#[test]
fn a_spring_of_a_half_counts_twice_and_one_in_plane_strain_per_metre() {
    let end = format!("{ANCHOR}{SPRING}*Boundary\nANCHOR, ENCASTRE\n");
    let again = ", 1.3\n*Boundary, op=new\n";
    let imported =
        changed("disc", &[["*End Assembly\n", &end], [again, &format!("{again}ANCHOR, ENCASTRE\n")]]);
    has(&imported, &["symmetric = true", "stiffness = \"4000 N/m\"", "damping = \"60 N*s/m\""]);
    let low = end.replace("7, -0.2, 0., 0.12", "7, -0.4, 0.3, -0.01").replace("GEAR-1.1", "GEAR-1.9");
    has(&changed("plough", &[["*End Assembly\n", &low]]), &["plane_strain = true", "kind = \"spring\""]);
}

#[test]
fn masses_at_nodes_of_a_body_are_summed() {
    let more = "*Element, type=MASS, elset=CORNERS\n21, A.1\n22, A.7\n*Mass, elset=CORNERS\n20.\n";
    let imported = case(more, "", &(TOW.to_owned() + &TOW.replace("A.", "B.")));
    has(&imported, &["mass = \"140 kg\""]);
    assert!(imported.report.contains("as if it were at the reference node"));
}

#[test]
fn an_amplitude_that_swings_is_a_table() {
    let swing = "*Amplitude, name=SWING, definition=periodic\n2, 6.283185307, 0., 0.5\n0., 1., 0.25, 0.\n";
    let step = TOW.replace("type=velocity", "type=velocity, amplitude=SWING") + &TOW.replace("A.", "B.");
    let imported = case("", swing, &step);
    let (_, bytes) = &imported.files[0];
    let text = String::from_utf8(bytes.clone()).unwrap();
    // 0.1 m/s times 0.5 + 1 + 0.25 cos π at a quarter of a second.
    assert_eq!(text.lines().count(), 66);
    assert!(text.contains("\n0.25,0.125\n"), "{text}");
    refused("", &swing.replace("6.283185307", "6.3e9"), &step, "more often than a table");
    let found = texts(&of("", &swing.replace("2, 6.2", "3, 6.2"), &step).map(|done| done.case).unwrap_err());
    assert!(found.iter().any(|text| text.contains("two factors for each term")), "{found:?}");
}

#[test]
fn a_condition_without_data_ends_what_acted_before() {
    let both =
        TOW.to_owned() + &TOW.replace("A.", "B.") + "*End Step\n*Step, name=REST\n*Dynamic, Explicit\n, 1.\n";
    let imported = case("", "", &(both.clone() + "*Boundary, op=new\n*Cload, op=new\n"));
    has(&imported, &["a-block.forward = \"free\"", "a-block.tilt_motion = \"free\""]);
    refused("", "", &(both + "*Dload, op=new\n"), "DLOAD");
}

#[test]
fn what_is_known_and_not_represented_has_a_reason() {
    let user = "*Material, name=OTHER\n*User Material, constants=1\n1.\n*Depvar\n3\n";
    let found = texts(&of("", user, TOW).map(|done| done.case).unwrap_err());
    assert_eq!(found.iter().filter(|text| text.contains("user subroutines")).count(), 2, "{found:?}");
    refused("*Tie, name=T\nX, Y\n", "", &(TOW.to_owned() + &TOW.replace("A.", "B.")), "by connectors");
}

#[test]
fn joints_lie_in_the_plane_of_symmetry() {
    let quarter = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/decks/cone.inp")).unwrap();
    let end =
        format!("{}{SPRING}*Boundary\nANCHOR, ENCASTRE\n", ANCHOR.replace("-0.2, 0., 0.12", "0., 0., 0.4"));
    let text = quarter.replace("*End Assembly\n", &end);
    let deck = deck::read_with(&text, "cone.inp", |_| Err(String::new()));
    let found = texts(&import(&deck, None, "cone").map(|done| done.case).unwrap_err());
    assert!(found.iter().any(|text| text.contains("symmetric about x = 0")), "{found:?}");
}
