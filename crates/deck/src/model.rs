//! The model of a deck: what its blocks say, in the units and axes of the deck.

use crate::block::{Block, Place, Row, Source};
use crate::ledger::Ledger;
use std::collections::{BTreeMap, HashMap};

/// A node or an element: its region, and its label there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id {
    /// Number of the region in [`Deck::regions`].
    pub region: usize,
    /// Label in it.
    pub label: u32,
}

/// An element.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Type in capitals, such as `EC3D8R`.
    pub kind: String,
    /// Its nodes; a connector to the ground has a 0.
    pub nodes: Vec<Id>,
}

/// A surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// Faces of elements: names of sets or elements, with the word for the face.
    Elements(Vec<(String, String)>),
    /// A profile in radius and height turned about an axis.
    Revolution {
        /// A point of the axis, where the height is 0.
        origin: [f64; 3],
        /// Direction of the axis, of length 1.
        axis: [f64; 3],
        /// Points of the profile: radius and height; arcs in small steps.
        profile: Vec<[f64; 2]>,
    },
    /// An Eulerian material: its name.
    Eulerian(String),
    /// Another kind, by its word.
    Other(String),
}

/// A rigid body constraint.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidBody {
    /// Its block.
    pub block: usize,
    /// Reference node, as it is named.
    pub reference: String,
    /// Element set, if any.
    pub elements: Option<String>,
    /// Analytical surface, if any.
    pub surface: Option<String>,
    /// Set of nodes that are tied to it, if any.
    pub tied: Option<String>,
}

/// A section or another property of an element set.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Its block; the keyword says what it is.
    pub block: usize,
    /// Element set.
    pub elements: String,
    /// Material, where it names one.
    pub material: Option<String>,
    /// Its data.
    pub rows: Vec<Row>,
}

/// The assembly itself, region 0, or an instance of a part, in global coordinates. A part has the same form.
#[derive(Clone, Debug, Default)]
pub struct Region {
    /// Name in capitals; empty for the assembly.
    pub name: String,
    /// Coordinates of the nodes by label.
    pub nodes: BTreeMap<u32, [f64; 3]>,
    /// Elements by label.
    pub elements: BTreeMap<u32, Element>,
    /// Node sets.
    pub node_sets: HashMap<String, Vec<Id>>,
    /// Element sets.
    pub element_sets: HashMap<String, Vec<Id>>,
    /// Surfaces, with their blocks.
    pub surfaces: HashMap<String, (usize, Surface)>,
    /// Rigid bodies.
    pub rigid_bodies: Vec<RigidBody>,
    /// Sections, masses, rotary inertias, connector sections.
    pub sections: Vec<Section>,
    /// Orientations, with their blocks: the directions of their three axes.
    pub orientations: HashMap<String, (usize, [[f64; 3]; 3])>,
    /// Blocks that made it, in the order of the deck.
    pub blocks: Vec<usize>,
}

/// A table of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Its block; the keyword says what it is.
    pub block: usize,
    /// Its rows of numbers.
    pub rows: Vec<Vec<f64>>,
}

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name in capitals.
    pub name: String,
    /// Its block.
    pub block: usize,
    /// Its properties by keyword.
    pub properties: BTreeMap<String, Property>,
}

/// An amplitude.
#[derive(Clone, Debug, PartialEq)]
pub struct Amplitude {
    /// Its block.
    pub block: usize,
    /// Word of its definition: `TABULAR`, `SMOOTH STEP`, ….
    pub definition: String,
    /// Whether its time is that of the whole run.
    pub is_total_time: bool,
    /// Times and factors; none of one that swings.
    pub points: Vec<[f64; 2]>,
    /// How it swings, if it does.
    pub periodic: Option<Periodic>,
}

/// An amplitude that swings: a mean, from a time on with cosines and sines of a frequency and its multiples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Periodic {
    /// Circular frequency of the first term.
    pub frequency: f64,
    /// When it begins.
    pub start: f64,
    /// Mean, and value before the start.
    pub mean: f64,
    /// Factors of cosine and sine of each multiple.
    pub terms: Vec<[f64; 2]>,
}

impl Periodic {
    /// Its value at a time.
    pub fn value(&self, time: f64) -> f64 {
        let angle = self.frequency * (time - self.start);
        let term = |(n, [a, b]): (usize, &[f64; 2])| {
            let (sin, cos) = (angle * (n as f64 + 1.0)).sin_cos();
            a * cos + b * sin
        };
        if time < self.start {
            self.mean
        } else {
            self.mean + self.terms.iter().enumerate().map(term).sum::<f64>()
        }
    }
}

/// A block of a step or of the model that acts on something: `BOUNDARY`, `CLOAD`, `DLOAD`,
/// `CONNECTOR MOTION`, `CONNECTOR LOAD`.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// Its block; the keyword says what it is.
    pub block: usize,
    /// Its data.
    pub rows: Vec<Row>,
    /// Name of its amplitude.
    pub amplitude: Option<String>,
    /// Word of `TYPE`, `DISPLACEMENT` unless given.
    pub kind: String,
    /// Whether all earlier actions of its keyword end (`OP=NEW`).
    pub replaces: bool,
}

/// A step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Step {
    /// Name in capitals.
    pub name: String,
    /// Its block.
    pub block: usize,
    /// Duration, in the unit of time of the deck; 0 until a procedure gives it.
    pub duration: f64,
    /// Block of the procedure.
    pub procedure: Option<usize>,
    /// What acts in it.
    pub actions: Vec<Action>,
}

/// A surface interaction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Interaction {
    /// Name in capitals.
    pub name: String,
    /// Its block.
    pub block: usize,
    /// Coefficient of friction, with its block; infinite for rough.
    pub friction: Option<(usize, f64)>,
    /// Largest shear stress of friction.
    pub most_shear: Option<f64>,
}

/// The part of a contact property assignment.
#[derive(Clone, Debug, PartialEq)]
pub struct Pairing {
    /// Its block.
    pub block: usize,
    /// The two surfaces; empty for all.
    pub surfaces: [String; 2],
    /// Name of the interaction.
    pub interaction: String,
}

/// A deck as it was read.
#[derive(Debug, Default)]
pub struct Deck {
    /// The files, the deck itself first.
    pub sources: Vec<Source>,
    /// All blocks in the order in which they are read.
    pub blocks: Vec<Block>,
    /// What became of them: until now of those that only give the deck its form, and of what is wrong.
    pub ledger: Ledger,
    /// First line of the heading.
    pub title: String,
    /// The assembly, and the instances.
    pub regions: Vec<Region>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Amplitudes by name.
    pub amplitudes: HashMap<String, Amplitude>,
    /// Blocks of initial conditions, with the word of their type.
    pub initial: Vec<(usize, String)>,
    /// What acts before the first step.
    pub always: Vec<Action>,
    /// Steps.
    pub steps: Vec<Step>,
    /// Surface interactions.
    pub interactions: Vec<Interaction>,
    /// Which interaction belongs to which surfaces.
    pub pairings: Vec<Pairing>,
    /// Blocks of connector behaviours by their name: that of the name, and its tables.
    pub behaviours: HashMap<String, Vec<usize>>,
    /// Blocks that the reader knows nothing of, and output requests: whoever uses the deck must say what
    /// becomes of them.
    pub others: Vec<usize>,
}

impl Deck {
    /// The place of a block, as `file:line`.
    pub fn place(&self, place: Place) -> String {
        let name = self.sources.get(place.file).map_or("", |source| source.name.as_str());
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        format!("{name}:{}", place.line)
    }

    /// Coordinates of a node.
    pub fn node(&self, id: Id) -> Option<[f64; 3]> {
        self.regions.get(id.region)?.nodes.get(&id.label).copied()
    }

    /// An element.
    pub fn element(&self, id: Id) -> Option<&Element> {
        self.regions.get(id.region)?.elements.get(&id.label)
    }

    /// A surface by its name, seen from a region, with the region that has it.
    pub fn surface(&self, region: usize, name: &str) -> Option<(usize, &(usize, Surface))> {
        let (region, name) = self.local(region, &name.to_uppercase());
        [region, 0].into_iter().find_map(|r| Some((r, self.regions.get(r)?.surfaces.get(&name)?)))
    }

    /// The nodes of a set, or the node of a label, seen from a region; `INSTANCE.NAME` for those of another.
    pub fn nodes(&self, region: usize, name: &str) -> Option<Vec<Id>> {
        let (region, name) = self.local(region, &name.to_uppercase());
        self.found(region, &name, |r| &r.node_sets, |r, label| r.nodes.contains_key(&label))
    }

    /// The elements of a set, or the element of a label, likewise.
    pub fn elements(&self, region: usize, name: &str) -> Option<Vec<Id>> {
        let (region, name) = self.local(region, &name.to_uppercase());
        self.found(region, &name, |r| &r.element_sets, |r, label| r.elements.contains_key(&label))
    }

    fn found(
        &self,
        region: usize,
        name: &str,
        sets: impl Fn(&Region) -> &HashMap<String, Vec<Id>>,
        has: impl Fn(&Region, u32) -> bool,
    ) -> Option<Vec<Id>> {
        let own = self.regions.get(region)?;
        if let Some(label) = crate::block::label(name) {
            return has(own, label).then(|| vec![Id { region, label }]);
        }
        let set = sets(own).get(name).or_else(|| sets(self.regions.first()?).get(name));
        set.cloned()
    }

    /// The region and the name there that `INSTANCE.NAME` stands for.
    fn local(&self, region: usize, name: &str) -> (usize, String) {
        let split = name.rsplit_once('.').and_then(|(instance, rest)| {
            let number = self.regions.iter().position(|r| !r.name.is_empty() && r.name == instance)?;
            Some((number, rest.to_owned()))
        });
        split.unwrap_or_else(|| (region, name.to_owned()))
    }
}
