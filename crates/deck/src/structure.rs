//! Parts, the assembly, instances and where they stand.

use crate::block::{Block, Row, Wrong};
use crate::model::{Id, Region};
use crate::placement::{Moved, about, axes};
use crate::state::{Read, State, Verdict};

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    match block.keyword.as_str() {
        "HEADING" => {
            state.deck.title = block.rows.first().map_or_else(String::new, |row| row.text.clone());
            Ok(Verdict::Settled("title"))
        }
        "INCLUDE" => Ok(Verdict::Settled("the file is read in its place")),
        "PART" => part(state, number, block),
        "END PART" => end_part(state, number),
        "ASSEMBLY" => {
            block.see_all();
            state.is_in_assembly = true;
            Ok(Verdict::Settled("the assembly"))
        }
        "END ASSEMBLY" => {
            state.is_in_assembly = false;
            Ok(Verdict::Settled("the assembly"))
        }
        "INSTANCE" => instance(state, number, block),
        "END INSTANCE" => end_instance(state, number),
        _ => system(state, block),
    }
}

fn part(state: &mut State, number: usize, block: &Block) -> Read {
    if state.part.is_some() || state.is_in_assembly {
        return Err("a part begins within another or within the assembly".into());
    }
    state.part = Some(Region { name: block.required("NAME")?, blocks: vec![number], ..Region::default() });
    state.system = None;
    Ok(Verdict::Settled("a part"))
}

fn end_part(state: &mut State, number: usize) -> Read {
    let mut part = state.part.take().ok_or("no part is open")?;
    part.blocks.push(number);
    state.system = None;
    if let Some(twice) = state.parts.insert(part.name.clone(), part) {
        return Err(format!("there are two parts {}", twice.name).into());
    }
    Ok(Verdict::Settled("a part"))
}

fn instance(state: &mut State, number: usize, block: &Block) -> Read {
    let (name, part) = (block.required("NAME")?, block.word("PART"));
    if state.part.is_some() || state.instance.is_some() {
        return Err("an instance begins within a part or another instance".into());
    }
    if state.deck.regions.iter().any(|region| region.name == name) {
        return Err(format!("there are two instances {name}").into());
    }
    let part = part.ok_or("PART= is missing; instances of results of other runs are not read")?;
    let template = state.parts.get(&part).cloned().ok_or_else(|| format!("there is no part {part}"))?;
    let moved = placement(&block.rows)?;
    let entries =
        |sets: &std::collections::HashMap<String, Vec<Id>>| sets.values().map(Vec::len).sum::<usize>();
    let size = template.nodes.len() + template.elements.len();
    state.grow(size + entries(&template.node_sets) + entries(&template.element_sets))?;
    let mut region = placed(template, &moved, state.deck.regions.len());
    region.name = name;
    region.blocks.push(number);
    (state.instance, state.moved) = (Some(region), moved);
    Ok(Verdict::Settled("an instance of a part, in its place"))
}

/// A part as an instance in its place.
fn placed(mut region: Region, moved: &Moved, number: usize) -> Region {
    region.nodes.values_mut().for_each(|node| *node = moved.point(*node));
    let sets = region.node_sets.values_mut().chain(region.element_sets.values_mut());
    sets.flatten().for_each(|id| id.region = number);
    region.elements.values_mut().flat_map(|element| &mut element.nodes).for_each(|id| id.region = number);
    region.orientations.values_mut().for_each(|(_, axes)| *axes = axes.map(|axis| moved.direction(axis)));
    for (_, surface) in region.surfaces.values_mut() {
        if let crate::model::Surface::Revolution { origin, axis, .. } = surface {
            (*origin, *axis) = (moved.point(*origin), moved.direction(*axis));
        }
    }
    region
}

fn end_instance(state: &mut State, number: usize) -> Read {
    let mut region = state.instance.take().ok_or("no instance is open")?;
    region.blocks.push(number);
    state.deck.regions.push(region);
    state.moved = Moved::default();
    Ok(Verdict::Settled("an instance of a part, in its place"))
}

/// Translation in the first line, and rotation about an axis through two points in the second.
fn placement(rows: &[Row]) -> Result<Moved, Wrong> {
    let mut moved = Moved::default();
    if let Some(row) = rows.first() {
        let numbers = row.numbers()?;
        for (axis, value) in numbers.iter().take(3).enumerate() {
            moved.translation[axis] = *value;
        }
    }
    if let Some(row) = rows.get(1) {
        let [ax, ay, az, bx, by, bz, angle] = row.numbers()?[..] else {
            return Err(Wrong::at(
                row.place,
                "seven numbers were expected: two points of the axis and an angle",
            ));
        };
        let (a, axis) = ([ax, ay, az], [bx - ax, by - ay, bz - az]);
        let rotation =
            about(axis, angle).ok_or_else(|| Wrong::at(row.place, "the two points are the same"))?;
        // The instance is translated first, and then turned about an axis in global coordinates.
        let turn = Moved { rotation, translation: [0.0; 3] };
        let from = [0, 1, 2].map(|n| moved.translation[n] - a[n]);
        let to = turn.direction(from);
        moved = Moved { rotation, translation: [0, 1, 2].map(|n| to[n] + a[n]) };
    }
    if let Some(row) = rows.get(2) {
        return Err(Wrong::at(row.place, "two lines of data were expected at most"));
    }
    Ok(moved)
}

/// The coordinate system of nodes that follow; without data the global one.
fn system(state: &mut State, block: &Block) -> Read {
    let numbers: Vec<f64> =
        block.rows.iter().map(Row::numbers).collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect();
    state.system = match numbers[..] {
        [] => None,
        [x, y, z] => Some(Moved { translation: [x, y, z], ..Moved::default() }),
        [ax, ay, az, bx, by, bz, ref rest @ ..] => {
            let c = match *rest {
                [] => [ax - (by - ay), ay + (bx - ax), az],
                [x, y, z] => [x, y, z],
                _ => return Err("three points were expected at most".into()),
            };
            let axes = axes([bx - ax, by - ay, bz - az], [c[0] - ax, c[1] - ay, c[2] - az]);
            let [first, second, third] = axes.ok_or("the three points lie in a line")?;
            let rotation = [0, 1, 2].map(|n| [first[n], second[n], third[n]]);
            Some(Moved { rotation, translation: [ax, ay, az] })
        }
        _ => return Err("one, two or three points were expected".into()),
    };
    Ok(Verdict::Settled("coordinates of the nodes that follow"))
}
