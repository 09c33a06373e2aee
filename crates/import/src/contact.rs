//! Friction of each body against the soil.

use crate::bodies::Body;
use crate::notes::Notes;
use deck::model::Surface;

/// Friction of a body: its coefficient, the largest shear stress, and the block that says so.
pub(super) struct Friction {
    /// Infinite for rough.
    pub(super) coefficient: f64,
    /// In units of the deck.
    pub(super) most_shear: Option<f64>,
    pub(super) block: Option<usize>,
}

/// The friction of all bodies.
pub(super) fn frictions(notes: &mut Notes, bodies: &[Body]) -> Vec<Friction> {
    let deck = notes.deck;
    let found = bodies.iter().map(|body| friction(notes, body)).collect::<Vec<_>>();
    for pairing in &deck.pairings {
        if deck.interactions.iter().any(|interaction| interaction.name == pairing.interaction) {
            notes.understood(pairing.block, "which friction belongs to which surfaces");
        } else {
            notes.refused(pairing.block, format!("there is no surface interaction {}", pairing.interaction));
        }
    }
    for interaction in &deck.interactions {
        let is_used = deck.pairings.iter().any(|pairing| pairing.interaction == interaction.name);
        for block in
            [Some(interaction.block), interaction.friction.map(|(block, _)| block)].into_iter().flatten()
        {
            if is_used {
                notes.understood(block, "friction");
            } else {
                notes.ignored(block, "no contact refers to it");
            }
        }
    }
    found
}

fn friction(notes: &mut Notes, body: &Body) -> Friction {
    let deck = notes.deck;
    let own = deck
        .pairings
        .iter()
        .rev()
        .find(|pairing| pairing.surfaces.iter().any(|name| is_of(notes, body, name)));
    let general = deck.pairings.iter().rev().find(|pairing| pairing.surfaces.iter().all(String::is_empty));
    let name = own.or(general).map(|pairing| pairing.interaction.as_str());
    let interaction = deck.interactions.iter().find(|interaction| Some(interaction.name.as_str()) == name);
    let Some((block, coefficient)) = interaction.and_then(|interaction| interaction.friction) else {
        if !body.is_frame() {
            notes.remark(format!("Nothing gives body {} friction: it is smooth, as in Abaqus.", body.name));
        }
        return Friction { coefficient: 0.0, most_shear: None, block: None };
    };
    Friction { coefficient, most_shear: interaction.and_then(|i| i.most_shear), block: Some(block) }
}

/// Whether a surface is that of a body.
fn is_of(notes: &Notes, body: &Body, name: &str) -> bool {
    if name.is_empty() {
        return false;
    }
    let Some((region, (_, surface))) =
        notes.deck.surface(0, name).or_else(|| notes.deck.surface(body.reference.region, name))
    else {
        return false;
    };
    match surface {
        Surface::Revolution { .. } => {
            body.analytical.as_ref().is_some_and(|(own, _)| name == own || name.ends_with(&format!(".{own}")))
        }
        Surface::Elements(faces) => faces.iter().any(|(set, _)| {
            let first = notes.deck.elements(region, set).and_then(|ids| ids.first().copied());
            first.is_some_and(|id| body.elements.contains(&id))
        }),
        _ => false,
    }
}
