//! The shapes of bodies in a case: a file for each, which reads its keys and answers what the program asks of
//! a shape.

mod bevel;
mod blade;
mod block;
mod cells_across;
mod cone;
mod cylinder;
mod disc;
mod frame;
mod keys;
mod mesh;
pub(super) mod slab;
mod sphere;
mod traits;
mod wedge;
mod wheel;
mod widths;

pub use blade::{Blade, CuttingEdge};
pub use block::Block;
pub(crate) use cells_across::{FineCells, cells_across};
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use frame::Frame;
pub(crate) use keys::KEYS;
pub use mesh::MeshBody;
pub use sphere::Sphere;
pub use traits::{CaseShape, ClosedForm, Conflict, Size};
pub use wedge::Wedge;
pub use wheel::Wheel;

use crate::key::missing;
use input::key::{Numbers, numbers};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;
use slab::Slab;

macro_rules! shapes {
    ($($name:ident: $word:literal, $about:literal;)*) => {
        /// The shape of a body.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        pub enum Shape {
            $(#[doc = $about] #[serde(rename = $word)] $name($name),)*
        }

        /// Words of the shapes, each with the names of its keys.
        fn names() -> Vec<(&'static str, Vec<&'static str>)> {
            vec![$(($word, $name::FIELDS.iter().map(|field| field.key.name).collect())),*]
        }

        impl Shape {
            /// Word of the shape in a case file.
            #[must_use]
            pub fn kind(&self) -> &'static str {
                match self {
                    $(Self::$name(_) => $word,)*
                }
            }

            /// The numbers that describe the shape, each with its key.
            #[must_use]
            pub fn numbers(&self) -> Numbers {
                let placed = match self {
                    $(Self::$name(shape) => numbers($name::FIELDS, shape),)*
                };
                placed.into_iter().chain(self.other_numbers()).collect()
            }

            fn read(word: &str, section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
                match word {
                    $($word => $name::read(section, slab, problems).map(Self::$name),)*
                    _ => None,
                }
            }
        }

        impl Shape {
            /// File of a mesh; `None` for other shapes.
            #[must_use]
            pub fn mesh(&self) -> Option<&MeshBody> {
                if let Self::MeshBody(mesh) = self { Some(mesh) } else { None }
            }

            /// Forgets the name of the file, so that shapes can be compared.
            pub(super) fn forget_file(&mut self) {
                if let Self::MeshBody(mesh) = self {
                    mesh.file.clear();
                }
            }
        }

        impl std::ops::Deref for Shape {
            type Target = dyn CaseShape;

            fn deref(&self) -> &Self::Target {
                match self {
                    $(Self::$name(shape) => shape,)*
                }
            }
        }
    };
}

shapes! {
    Disc: "disc", "A disc, axle along y.";
    Block: "block", "A rectangular block.";
    Cylinder: "cylinder", "A cylinder.";
    Sphere: "sphere", "A sphere.";
    Cone: "cone", "A cone on a shaft, tip down.";
    Wheel: "wheel", "A wheel with grousers, axle along y.";
    Blade: "blade", "An upright blade across the tow.";
    Wedge: "wedge", "A wedge with its edge in front at the bottom.";
    MeshBody: "mesh", "A solid whose surface is in a file.";
    Frame: "frame", "A frame: mass and motion without a surface.";
}

/// The shape that a section asks for; `slab` is that of a plane strain case.
pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Shape> {
    missing(KEYS, section, "shape", problems);
    let kind = section.text("shape")?;
    let names = names();
    let allowed = names.iter().find(|(word, _)| *word == kind).map_or(&[][..], |(_, keys)| keys);
    let measures = names.iter().flat_map(|(_, keys)| keys.iter().copied());
    // Several shapes have a diameter.
    let mut refused = Vec::new();
    for key in measures.filter(|key| section.has(key) && !allowed.contains(key)) {
        if !refused.contains(&key) {
            let message = format!("`{key}` does not apply to shape = \"{kind}\"");
            problems.add(section.at(key), message, "remove it, or choose another shape");
            refused.push(key);
        }
    }
    Shape::read(&kind, section, slab, problems)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::words::SHAPES;

    #[test]
    fn every_word_is_a_shape() {
        let words: Vec<&str> = names().iter().map(|(word, _)| *word).collect();
        assert_eq!(words, SHAPES);
    }
}
