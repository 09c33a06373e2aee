//! The soil of a case and where it is: `[soil]`, `[layer.NAME]`, `[ground]`.

use crate::bodies;
use crate::case_text::{CaseText, quantity, range};
use crate::facts::Facts;
use crate::fill::{Box3, Ground};
use crate::notes::Notes;
use crate::rest::{self, Site};
use crate::soil::{self, Setting};

pub(super) fn soils(
    notes: &mut Notes,
    text: &mut CaseText,
    facts: &Facts,
    at: &Box3,
    ground: &Ground,
) -> Option<()> {
    let deck = notes.deck;
    let find = |name: &str| deck.materials.iter().find(|material| material.name == name);
    let weight =
        |[_, name]: &[String; 2]| find(name).and_then(soil::density).unwrap_or(0.0) * facts.gravity.size;
    let weight = facts.mesh.materials.iter().map(weight).collect();
    let site = Site { mesh: facts.mesh, at, ground, frame: &facts.setup.frame, weight };
    let rest = rest::rest(notes, &site);
    let length = facts.units.length;
    let mut names: Vec<String> = Vec::new();
    let mut is_sound = true;
    for (number, (material, top)) in ground.layers.iter().enumerate() {
        let name = &facts.mesh.materials[*material][1];
        let Some(own) = find(name) else {
            notes.refused(facts.mesh.section, format!("there is no material {name}"));
            return None;
        };
        let setting = Setting {
            units: &facts.units,
            in_plane_strain: facts.setup.is_plane_strain,
            k0: rest.k0.get(material).copied(),
        };
        let mut section = "soil".to_owned();
        if number > 0 {
            let mut plain = bodies::plain(name);
            while names.contains(&plain) {
                plain.push_str("-b");
            }
            section = format!("layer.{plain}");
            names.push(plain);
            text.set(
                &section,
                "top",
                quantity((ground.surface - top) * length, "m"),
                &notes.origin(ground.block),
            );
        }
        let Some(keys) = soil::soil(notes, own, &setting) else {
            is_sound = false;
            continue;
        };
        keys.into_iter().for_each(|(key, value, block)| text.set(&section, key, value, &notes.origin(block)));
    }
    unused(notes);
    ground_keys(notes, text, facts, ground, &rest);
    is_sound.then_some(())
}

/// Where the ground is, and what presses on it.
fn ground_keys(notes: &Notes, text: &mut CaseText, facts: &Facts, ground: &Ground, rest: &rest::Rest) {
    let length = facts.units.length;
    let origin = notes.origin(ground.block);
    text.set("ground", "surface", quantity(ground.surface * length, "m"), &origin);
    for (key, extent) in ["x", "y"].into_iter().zip(ground.extent) {
        if let Some(extent) = extent.filter(|_| !(key == "y" && facts.setup.is_plane_strain)) {
            text.set("ground", key, range(extent.map(|x| x * length), "m"), &origin);
        }
    }
    if let Some((pressure, block)) = rest.overburden {
        text.set(
            "ground",
            "overburden",
            quantity(pressure * facts.units.stress(), "Pa"),
            &notes.origin(block),
        );
    }
}

/// Materials that no soil has.
fn unused(notes: &mut Notes) {
    let deck = notes.deck;
    for material in &deck.materials {
        for block in
            std::iter::once(material.block).chain(material.properties.values().map(|property| property.block))
        {
            if !notes.ledger.has(block) {
                notes.ignored(
                    block,
                    "no soil is of this material; of that of a rigid body only the density counts",
                );
            }
        }
    }
}
