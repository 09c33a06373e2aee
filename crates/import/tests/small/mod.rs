//! A small deck in three places that tests fill.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use std::fmt::Write;

/// A box of sand with two blocks above it, each with a mass, and a node alone.
pub(super) fn deck(assembly: &str, model: &str, step: &str) -> String {
    let mut text = "*Heading\nTwo blocks\n*Part, name=SOIL\n*Node\n".to_owned();
    let label = |x: usize, y: usize, z: usize| 1 + x + 10 * y + 100 * z;
    for (x, y, z) in (0..9).flat_map(|x| (0..5).flat_map(move |y| (0..6).map(move |z| (x, y, z)))) {
        let at = [x, y, z].map(|n| n as f64 * 0.5);
        writeln!(text, "{}, {}, {}, {}", label(x, y, z), at[0] - 2.0, at[1] - 1.0, at[2] - 1.5).unwrap();
    }
    text.push_str("*Element, type=EC3D8R\n");
    for (x, y, z) in (0..8).flat_map(|x| (0..4).flat_map(move |y| (0..5).map(move |z| (x, y, z)))) {
        let corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
        let of = |up: usize| corners.map(|[a, b]| label(x + a, y + b, z + up).to_string()).join(", ");
        writeln!(text, "{}, {}, {}", label(x, y, z), of(0), of(1)).unwrap();
    }
    for (set, layers) in [("ALL", 5), ("SOIL", 3)] {
        writeln!(text, "*Elset, elset={set}").unwrap();
        for (x, y, z) in (0..8).flat_map(|x| (0..4).flat_map(move |y| (0..layers).map(move |z| (x, y, z)))) {
            writeln!(text, "{}", label(x, y, z)).unwrap();
        }
    }
    text + "*Eulerian Section, elset=ALL\nSAND, SAND-1\n*End Part\n\
        *Part, name=BLOCK\n*Node\n1, -0.5, -0.5, 0.\n2, 0.5, -0.5, 0.\n3, 0.5, 0.5, 0.\n4, -0.5, 0.5, 0.\n\
        5, -0.5, -0.5, 0.5\n6, 0.5, -0.5, 0.5\n7, 0.5, 0.5, 0.5\n8, -0.5, 0.5, 0.5\n9, 0., 0., 0.25\n\
        *Element, type=C3D8R, elset=BLOCK\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*Element, type=MASS, elset=M\n2, 9\n\
        *Mass, elset=M\n100.\n*Nset, nset=RP\n9,\n*Solid Section, elset=BLOCK, material=SAND\n,\n*End Part\n*Assembly, name=A\n\
        *Instance, name=SOIL, part=SOIL\n*End Instance\n\
        *Instance, name=A, part=BLOCK\n-0.75, 0., 0.1\n*End Instance\n\
        *Instance, name=B, part=BLOCK\n0.75, 0., 0.1\n*End Instance\n\
        *Node\n1, -0.75, 0., 0.85\n\
        *Rigid Body, ref node=A.RP, elset=A.BLOCK\n*Rigid Body, ref node=B.RP, elset=B.BLOCK\n"
        + assembly
        + "*End Assembly\n*Material, name=SAND\n*Density\n1600.,\n*Elastic\n1.e7, 0.3\n*Mohr Coulomb\n32., 0.1\n\
           *Mohr Coulomb Hardening\n100., 0.\n*Initial Conditions, type=volume fraction\nSOIL.SOIL, SAND-1, 1.\n"
        + model
        + "*Step, name=GO\n*Dynamic, Explicit\n, 1.\n*Dload\n, grav, 9.81, 0., 0., -1.\n"
        + step
        + "*End Step\n"
}
