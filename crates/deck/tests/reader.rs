//! The reader: lines, includes, generated nodes, instances, and the ledger.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use deck::{Deck, Outcome, read, read_with};

fn deck(text: &str) -> Deck {
    read_with(text, "deck.inp", |name| match name {
        "again.inp" => Ok("*Include, input=again.inp\n".to_owned()),
        "nodes.inp" => Ok("1, 1., 2., 3.\n2, 4., 5., 6.\n".to_owned()),
        _ => Err("there is no such file".to_owned()),
    })
}

fn refused(deck: &Deck) -> Vec<(usize, String)> {
    let entries = deck.ledger.close(&deck.blocks).into_iter();
    let of = |entry: deck::Entry| match entry.outcome {
        Outcome::Refused(text) => Some((entry.place.line, text)),
        _ => None,
    };
    entries.filter_map(of).collect()
}

#[test]
fn keywords_are_read_in_any_case_over_several_lines() {
    let deck = deck("** comment\n*NODE ,\n nset = Tip\n1, 1.d-3, .5,\n*nset, NSET=both, generate\n1, 1\n");
    assert_eq!(deck.regions[0].nodes[&1], [1e-3, 0.5, 0.0]);
    assert_eq!(deck.nodes(0, "tip").unwrap(), deck.nodes(0, "BOTH").unwrap());
    assert!(refused(&deck).is_empty());
}

#[test]
fn includes_are_data_or_blocks_and_end() {
    let included = deck("*Node\n*Include, input=nodes.inp\n3, 0., 0., 1.\n");
    assert_eq!(included.regions[0].nodes.len(), 3);
    let round = deck("*Include, input=again.inp\n");
    assert!(refused(&round).iter().any(|(_, text)| text.contains("levels")), "{:?}", refused(&round));
    assert!(refused(&deck("*Include, input=none.inp\n"))[0].1.contains("no such file"));
}

#[test]
fn only_files_below_the_folder_of_the_deck_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    std::fs::create_dir(&inner).unwrap();
    std::fs::write(folder.path().join("secret.inp"), "*Node\n1, 0., 0., 0.\n").unwrap();
    std::fs::write(inner.join("deck.inp"), "*Include, input=../secret.inp\n*Include, input=/etc/passwd\n")
        .unwrap();
    let deck = read(&inner.join("deck.inp")).unwrap();
    assert_eq!(refused(&deck).len(), 2);
    assert!(deck.regions[0].nodes.is_empty());
}

#[test]
fn an_instance_is_translated_and_then_turned() {
    let deck = deck(
        "*Part, name=P\n*Node\n1, 1., 0., 0.\n*End Part\n*Assembly, name=A\n*Instance, name=I, part=P\n0., 0., 2.\n\
         0., 0., 0., 0., 0., 1., 90.\n*End Instance\n*Nset, nset=ALL, instance=I\n1,\n*End Assembly\n",
    );
    let at = deck.node(deck.nodes(0, "ALL").unwrap()[0]).unwrap();
    assert!((0..3).all(|axis| (at[axis] - [0.0, 1.0, 2.0][axis]).abs() < 1e-12), "{at:?}");
}

#[test]
fn nodes_and_elements_are_generated() {
    let text = "*Node, nset=A\n1, 0., 0., 0.\n*Node, nset=B\n16, 7., 0., 0.\n*Nfill, bias=0.5, nset=ROW\nA, B, 3, 5\n\
                *Node\n101, 0., 1., 0.\n103, 2., 1., 0.\n*Ngen\n101, 103, 1\n*Element, type=R3D3\n1, 1, 2, 3\n\
                *Elgen, elset=SOME\n1, 3, 1, 10\n";
    let deck = deck(text);
    let nodes = &deck.regions[0].nodes;
    assert!((nodes[&6][0] - 1.0).abs() < 1e-12 && (nodes[&11][0] - 3.0).abs() < 1e-12, "{nodes:?}");
    assert_eq!(nodes[&102], [1.0, 1.0, 0.0]);
    assert_eq!(deck.elements(0, "SOME").unwrap().iter().map(|id| id.label).collect::<Vec<_>>(), [1, 11, 21]);
}

#[test]
fn what_nobody_knows_is_refused_at_its_line() {
    let deck = deck("*Heading\nx\n*Nonsense\n*Node, colour=red\n1, 0., 0., 0.\n1, 0.\n*Node\n2, x\n");
    let found = refused(&deck);
    assert_eq!(found.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [3, 4, 8], "{found:?}");
    assert!(found[1].1.contains("COLOUR") && found[2].1.contains("no number"));
}

#[test]
fn huge_counts_are_refused_and_not_made() {
    let found = refused(&deck(
        "*Nset, nset=N, generate\n1, 4294967295, 1\n*Element, type=R3D3\n1, 1, 2, 3\n*Elgen\n1, 99999, 1, 1, 99999, 1, 1\n",
    ));
    assert_eq!(found.len(), 2, "{found:?}");
}
