//! The box of a case and its cells: `[domain]` and `[grid]`.

use crate::case_text::{CaseText, digits, quantity, range};
use crate::facts::Facts;
use crate::fill::Box3;
use crate::notes::Notes;
use crate::zones;

pub(super) fn domain(notes: &mut Notes, text: &mut CaseText, facts: &Facts, at: &Box3) {
    let (origin, setup) = (notes.origin(facts.mesh.section), &facts.setup);
    for (axis, key) in ["x", "y", "z"].into_iter().enumerate() {
        let planes = &at.faces[axis];
        if axis != 1 || !setup.is_plane_strain {
            let ends = [planes[0], planes[planes.len() - 1]].map(|x| x * facts.units.length);
            text.set("domain", key, range(ends, "m"), &origin);
        }
    }
    for (key, is_set) in [
        ("plane_strain", setup.is_plane_strain),
        ("symmetric", setup.symmetric[0]),
        ("symmetric_x", setup.symmetric[1]),
    ] {
        if is_set {
            text.set("domain", key, "true", "*boundary on faces of the box");
        }
    }
    let mut open = Vec::new();
    for (axis, key) in ["x_walls", "y_walls", "z_walls"].into_iter().enumerate() {
        let (own, same) = setup.frame.axes[axis];
        let wall = |low: bool| {
            let held = facts.held[own][usize::from(low != same)];
            let is_counted =
                |other: &usize| *other != own && !(setup.is_plane_strain && *other == setup.frame.axes[1].0);
            let across = (0..3).filter(is_counted).filter(|other| held[*other]).count();
            (held[own], across)
        };
        let walls = [wall(true), wall(false)];
        let all = if setup.is_plane_strain { 1 } else { 2 };
        let words = walls.map(|(_, across)| if across == all { "fixed" } else { "smooth" });
        let usual = if axis == 2 { ["fixed", "smooth"] } else { ["smooth", "smooth"] };
        if words != usual && !(axis == 1 && setup.is_plane_strain) {
            text.set(
                "domain",
                key,
                format!("[\"{}\", \"{}\"]", words[0], words[1]),
                "*boundary on faces of the box",
            );
        }
        for (side, (normal, across)) in ["low", "high"].into_iter().zip(walls) {
            let is_lid = axis == 2 && side == "high";
            if !(normal || is_lid) || (1..all).contains(&across) {
                open.push(format!("{side} {}", &key[..1]));
            }
        }
    }
    if !open.is_empty() {
        let text = format!(
            "faces that the deck leaves open or holds along one direction are closed smooth walls: {}",
            open.join(", ")
        );
        notes.approximated(facts.mesh.section, text);
    }
}

pub(super) fn grid(notes: &mut Notes, text: &mut CaseText, facts: &Facts, at: &Box3) {
    let (length, flat) = (facts.units.length, facts.setup.is_plane_strain);
    let origin = notes.origin(facts.mesh.section);
    let zones = at.faces.each_ref().map(|planes| zones::zone(planes));
    let axes = || (0..3).filter(|axis| !(flat && *axis == 1));
    let cell = axes().map(|axis| zones[axis].width).fold(f64::INFINITY, f64::min);
    let ratio = |axis: usize| if flat && axis == 1 { 1.0 } else { zones[axis].width / cell };
    let aspect = [0, 1, 2].map(|axis| ratio(axis).clamp(1.0, 4.0));
    let growth = axes().map(|axis| zones[axis].growth).fold(1.0, f64::max);
    let used = growth.clamp(1.02, 1.5);
    text.set("grid", "cell", quantity(cell * length, "m"), &origin);
    if flat && !facts.gear.joints.is_empty() {
        // Joints lie at y = 0, in the middle of the slab.
        text.set("domain", "y", range([-0.5, 0.5].map(|x| x * cell * length), "m"), "");
    }
    if aspect.iter().any(|aspect| (aspect - 1.0).abs() > 1e-3) {
        text.set(
            "grid",
            "aspect",
            format!("[{}]", aspect.map(|x| digits((x * 1000.0).round() / 1000.0)).join(", ")),
            &origin,
        );
    }
    text.set(
        "grid",
        "growth",
        digits((used * 1e4).ceil() / 1e4),
        "largest ratio of neighbouring cells of the deck",
    );
    for (axis, key) in ["fine_x", "fine_y", "fine_z"].into_iter().enumerate() {
        if !(flat && axis == 1) {
            text.set(
                "grid",
                key,
                range(zones[axis].fine.map(|x| x * length), "m"),
                "where the deck has its smallest cells",
            );
        }
    }
    if axes().any(|axis| ratio(axis) > 4.0) || growth > 1.5 {
        let text = format!(
            "cells flatter than 4 to 1 or growing by more than 1.5 ({growth:.2} in the deck): the case has smaller ones there"
        );
        notes.approximated(facts.mesh.section, text);
    }
}
