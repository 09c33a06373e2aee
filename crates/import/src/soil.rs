//! Materials as soils: the law of each, with what was approximated.

use crate::case_text::{digits, quantity};
use crate::notes::Notes;
use crate::units::Units;
use deck::model::{Material, Property};

/// A key of a soil: its name, its value, and the block that it comes from.
pub(super) type Key = (&'static str, String, usize);

/// What else decides how a material is represented.
pub(super) struct Setting<'a> {
    pub(super) units: &'a Units,
    pub(super) in_plane_strain: bool,
    pub(super) k0: Option<(f64, usize)>,
}

/// Density of a material, in units of the deck.
pub(super) fn density(material: &Material) -> Option<f64> {
    material.properties.get("DENSITY")?.rows.first()?.first().copied().filter(|density| *density > 0.0)
}

/// The keys of a soil; `None` where the material was refused.
pub(super) fn soil(notes: &mut Notes, material: &Material, setting: &Setting) -> Option<Vec<Key>> {
    let mut keys = law(notes, material, setting)?;
    notes.understood(material.block, "a soil");
    match (density(material), material.properties.get("DENSITY")) {
        (Some(density), Some(property)) if property.rows.len() == 1 => {
            keys.push(("density", quantity(density * setting.units.density(), "kg/m^3"), property.block));
            notes.understood(property.block, "density");
        }
        _ => {
            notes.refused(material.block, "one density above 0 was expected");
            return None;
        }
    }
    match material.properties.get("ELASTIC").map(|property| (property, property.rows.as_slice())) {
        Some((property, [row]))
            if row.len() <= 2
                && row.first().is_some_and(|modulus| *modulus > 0.0)
                && is_isotropic(notes, property.block) =>
        {
            keys.push(("young_modulus", stress(row[0], setting.units), property.block));
            keys.push(("poisson_ratio", digits(row.get(1).copied().unwrap_or(0.0)), property.block));
            notes.understood(property.block, "elastic moduli");
        }
        Some((property, _)) => {
            notes.refused(property.block, "one modulus and one Poisson's ratio were expected")
        }
        None => notes.refused(material.block, "*Elastic is missing"),
    }
    if let Some((k0, block)) = setting.k0 {
        keys.push(("k0", digits(k0), block));
    }
    Some(keys)
}

fn is_isotropic(notes: &Notes, block: usize) -> bool {
    notes.deck.blocks.get(block).and_then(|b| b.word("TYPE")).is_none_or(|kind| kind == "ISOTROPIC")
}

fn stress(value: f64, units: &Units) -> String {
    quantity(value * units.stress(), "Pa")
}

fn word(law: &str) -> String {
    format!("\"{law}\"")
}

fn law(notes: &mut Notes, material: &Material, setting: &Setting) -> Option<Vec<Key>> {
    let get = |keyword: &str| material.properties.get(keyword);
    match (get("MOHR COULOMB"), get("DRUCKER PRAGER"), get("PLASTIC")) {
        (Some(angles), None, None) => mohr_coulomb(notes, material, angles, setting),
        (None, Some(angles), None) => drucker_prager(notes, material, angles, setting),
        (None, None, Some(table)) => von_mises(notes, table, setting),
        (None, None, None) => {
            let block = get("ELASTIC").map_or(material.block, |property| property.block);
            Some(vec![("law", word("elastic"), block)])
        }
        _ => {
            notes.refused(material.block, "it has several yield laws: one was expected");
            None
        }
    }
}

/// The only row of a table with at least so many numbers.
fn row<'a>(notes: &mut Notes, property: &'a Property, least: usize) -> Option<&'a [f64]> {
    match property.rows.as_slice() {
        [row] if row.len() >= least => Some(row),
        _ => {
            notes.refused(
                property.block,
                format!("one line with {least} numbers or more was expected, no table"),
            );
            None
        }
    }
}

fn mohr_coulomb(
    notes: &mut Notes,
    material: &Material,
    angles: &Property,
    setting: &Setting,
) -> Option<Vec<Key>> {
    let (units, block) = (setting.units, angles.block);
    let first = row(notes, angles, 1)?;
    let (friction, dilation) = (first[0], first.get(1).copied().unwrap_or(0.0));
    let Some(hardening) = material.properties.get("MOHR COULOMB HARDENING") else {
        notes.refused(block, "*Mohr Coulomb Hardening with the cohesion is missing");
        return None;
    };
    let cohesions: Vec<[f64; 2]> = hardening
        .rows
        .iter()
        .map(|row| [row.first().copied().unwrap_or(0.0), row.get(1).copied().unwrap_or(0.0)])
        .collect();
    let (Some([first, _]), Some([last, _])) = (cohesions.first().copied(), cohesions.last().copied()) else {
        notes.refused(hardening.block, "a line with the cohesion was expected");
        return None;
    };
    if friction == 0.0 {
        return tresca(notes, (block, dilation), hardening.block, &cohesions, units);
    }
    // What the soil has lost or won after large strains: it flows through far larger ones than those
    // of the table.
    if first == last {
        notes.understood(hardening.block, "cohesion");
    } else {
        let text = format!("constant cohesion of {last}, the last of the table; the first is {first}");
        notes.approximated(hardening.block, text);
    }
    notes.understood(block, "friction and dilation, with the smooth flow potential of Abaqus");
    let mut keys = vec![
        ("law", word("mohr-coulomb"), block),
        ("friction_angle", quantity(friction, "deg"), block),
        ("dilation_angle", quantity(dilation, "deg"), block),
        ("flow_potential", word("menetrey-willam"), block),
        ("cohesion", stress(last, units), hardening.block),
    ];
    for (parameter, key) in
        [("ECCENTRICITY", "meridional_eccentricity"), ("DEVIATORIC ECCENTRICITY", "deviatoric_eccentricity")]
    {
        if let Some(text) = notes.deck.blocks[block].value(parameter) {
            match deck::block::number(text) {
                Some(value) => keys.push((key, digits(value), block)),
                None => notes.refused(block, format!("{parameter}= is no number")),
            }
        }
    }
    keys.push(cutoff(notes, material, (last, friction), hardening.block, units)?);
    Some(keys)
}

/// The largest tension: that of the deck, or the apex of the pyramid.
fn cutoff(
    notes: &mut Notes,
    material: &Material,
    strength: (f64, f64),
    block: usize,
    units: &Units,
) -> Option<Key> {
    let (cohesion, friction) = strength;
    // A little inside, so that rounding does not put it beyond.
    let apex = cohesion / friction.to_radians().tan() * (1.0 - 1e-9);
    let Some(property) = material.properties.get("TENSION CUTOFF") else {
        return Some(("tension_cutoff", stress(apex, units), block));
    };
    let first = property.rows.first().and_then(|row| row.first()).copied();
    let Some(tension) = first.filter(|tension| *tension >= 0.0) else {
        notes.refused(property.block, "a tensile strength of 0 or more was expected");
        return None;
    };
    if property.rows.len() > 1 {
        notes.approximated(
            property.block,
            format!("constant tensile strength of {tension}, the first of the table"),
        );
    } else if tension > apex {
        notes.approximated(property.block, "no more than the apex of the yield surface, c cot φ");
    } else {
        notes.understood(property.block, "largest tension");
    }
    Some(("tension_cutoff", stress(tension.min(apex), units), property.block))
}

/// φ = 0: undrained strength, and, where the cohesion falls with strain, its loss.
fn tresca(
    notes: &mut Notes,
    angles: (usize, f64),
    hardening: usize,
    cohesions: &[[f64; 2]],
    units: &Units,
) -> Option<Vec<Key>> {
    let (block, dilation) = angles;
    if dilation != 0.0 {
        notes.refused(block, "dilation without friction is not represented");
        return None;
    }
    notes.understood(block, "undrained strength (Tresca), flow normal to it");
    let ([first, _], [last, _]) = (cohesions.first()?, cohesions.last()?);
    let mut keys = vec![("law", word("tresca"), block), ("shear_strength", stress(*first, units), hardening)];
    if last < first && *last > 0.0 {
        let target = last + 0.05 * (first - last);
        let piece = cohesions.windows(2).find(|pair| pair[1][0] <= target);
        let strain = piece.map_or(0.0, |pair| {
            pair[0][1] + (pair[0][0] - target) / (pair[0][0] - pair[1][0]) * (pair[1][1] - pair[0][1])
        });
        keys.push(("sensitivity", digits(first / last), hardening));
        keys.push(("remoulding_strain", digits(strain), hardening));
        let text = format!(
            "exponential loss of strength between the same ends, 95 % of it at a plastic shear strain of {strain:.4}"
        );
        notes.approximated(hardening, text);
    } else if last != first {
        notes.approximated(
            hardening,
            format!("constant strength of {first}, the first of the table; the last is {last}"),
        );
    } else {
        notes.understood(hardening, "undrained shear strength");
    }
    Some(keys)
}

fn von_mises(notes: &mut Notes, table: &Property, setting: &Setting) -> Option<Vec<Key>> {
    let block = table.block;
    if let Some(kind) = notes.deck.blocks[block].word("HARDENING").filter(|kind| kind != "ISOTROPIC") {
        notes.refused(block, format!("{kind} hardening is not represented"));
        return None;
    }
    let pairs: Vec<[f64; 2]> = table
        .rows
        .iter()
        .map(|row| [row.first().copied().unwrap_or(0.0), row.get(1).copied().unwrap_or(0.0)])
        .collect();
    let (Some([first, _]), Some([last, strain])) = (pairs.first().copied(), pairs.last().copied()) else {
        notes.refused(block, "a line with the yield stress was expected");
        return None;
    };
    let modulus = if strain > 0.0 { (last - first) / strain } else { 0.0 };
    if modulus < 0.0 || first <= 0.0 {
        notes.refused(block, "a yield stress above 0 that does not fall was expected");
        return None;
    }
    match pairs.len() {
        0..=2 => notes.understood(block, "von Mises yield stress, with linear hardening"),
        _ => notes.approximated(
            block,
            "one line through the first and the last point of the table, and on beyond it",
        ),
    }
    Some(vec![
        ("law", word("von-mises"), block),
        ("yield_stress", stress(first, setting.units), block),
        ("hardening_modulus", stress(modulus, setting.units), block),
    ])
}

/// Matched with Mohr–Coulomb: in plane strain without dilation, tan β = √3 sin φ, d = √3 c cos φ; otherwise
/// in triaxial compression, tan β = 6 sin φ/(3 − sin φ), d = 6 c cos φ/(3 − sin φ) (Abaqus Theory Manual
/// 4.4.4; Chen and Han, Plasticity for Structural Engineers, 1988).
fn drucker_prager(
    notes: &mut Notes,
    material: &Material,
    angles: &Property,
    setting: &Setting,
) -> Option<Vec<Key>> {
    let block = angles.block;
    if let Some(kind) = notes.deck.blocks[block].word("SHEAR CRITERION").filter(|kind| kind != "LINEAR") {
        notes.refused(block, format!("of shear criteria LINEAR is represented, not {kind}"));
        return None;
    }
    let first = row(notes, angles, 1)?;
    let at = |n: usize, other: f64| first.get(n).copied().filter(|x| *x != 0.0).unwrap_or(other);
    let (beta, flow, psi) = (first[0].to_radians().tan(), at(1, 1.0), at(2, 0.0).to_radians().tan());
    let (strength, hardening) = intercept(notes, material, beta, flow)?;
    if beta == 0.0 {
        notes.understood(block, "without friction it is von Mises");
        return Some(vec![
            ("law", word("von-mises"), block),
            ("yield_stress", stress(strength, setting.units), hardening),
        ]);
    }
    let (sine, dilation, how) = if setting.in_plane_strain {
        (beta / 3_f64.sqrt(), psi / 3_f64.sqrt(), "plane strain without dilation")
    } else {
        (3.0 * beta / (6.0 + beta), 3.0 * psi / (6.0 + psi), "triaxial compression")
    };
    if !(0.0..0.99).contains(&sine) || !(0.0..=sine).contains(&dilation) {
        notes.refused(
            block,
            format!("matched in {how} it has a friction angle beyond 80° or more dilation than friction"),
        );
        return None;
    }
    let cosine = (1.0 - sine * sine).sqrt();
    let cohesion = if setting.in_plane_strain {
        strength / (3_f64.sqrt() * cosine)
    } else {
        strength * (3.0 - sine) / (6.0 * cosine)
    };
    let (friction, dilation) = (sine.asin().to_degrees(), dilation.asin().to_degrees());
    notes.approximated(block, format!(
        "Mohr–Coulomb with φ = {friction:.3}°, ψ = {dilation:.3}°, c = {cohesion:.6e}, matched in {how}; in other states of stress the strength differs"
    ));
    Some(vec![
        ("law", word("mohr-coulomb"), block),
        ("friction_angle", quantity(friction, "deg"), block),
        ("dilation_angle", quantity(dilation, "deg"), block),
        ("flow_potential", word("menetrey-willam"), block),
        ("cohesion", stress(cohesion, setting.units), hardening),
        cutoff(notes, material, (cohesion, friction), hardening, setting.units)?,
    ])
}

/// The intercept d of t = p tan β + d, with the block of the hardening.
fn intercept(notes: &mut Notes, material: &Material, beta: f64, flow: f64) -> Option<(f64, usize)> {
    let Some(table) = material.properties.get("DRUCKER PRAGER HARDENING") else {
        notes.refused(material.block, "*Drucker Prager Hardening is missing");
        return None;
    };
    let kind = notes.deck.blocks[table.block].word("TYPE").unwrap_or_else(|| "COMPRESSION".to_owned());
    let (Some(first), Some(last)) =
        (table.rows.first().and_then(|row| row.first()), table.rows.last().and_then(|row| row.first()))
    else {
        notes.refused(table.block, "a line with the strength was expected");
        return None;
    };
    if first == last {
        notes.understood(table.block, "cohesion");
    } else {
        notes.approximated(
            table.block,
            format!("constant strength of {last}, the last of the table; the first is {first}"),
        );
    }
    let factor = match kind.as_str() {
        "COMPRESSION" => 1.0 - beta / 3.0,
        "TENSION" => 1.0 / flow + beta / 3.0,
        "SHEAR" => 0.5 * 3_f64.sqrt() * (1.0 + 1.0 / flow),
        _ => {
            notes.refused(table.block, format!("TYPE={kind}: COMPRESSION, TENSION or SHEAR were expected"));
            return None;
        }
    };
    Some((last * factor, table.block))
}
