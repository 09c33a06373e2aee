//! The ground that a body leaves behind: the books of rut, berms and compaction close, and the sections agree
//! with the whole.
use super::{SAND, read};
use coulter::output::fields::{HeightMap, ruts};
use solver::halo::Halo;

#[test]
fn what_is_missing_in_the_rut_is_in_the_berms_or_compacted() {
    let block = |name: &str, y: &str| {
        format!(
            "[body.{name}]\nshape = \"block\"\nsize = [\"40 mm\", \"40 mm\", \"60 mm\"]\nfriction = 0.3\nsinkage = \"20 mm\"\ny = \"{y}\"\n\
             x = \"-0.1 m\"\nforward = {{ speed = \"1 m/s\", ramp = \"10 ms\" }}\n"
        )
    };
    let text = format!(
        "format = 2\n[soil]\nyoung_modulus = \"5 MPa\"\n{}[domain]\nx = [\"-0.2 m\", \"0.24 m\"]\ny = [\"-0.12 m\", \"0.12 m\"]\nz = [\"-0.1 m\", \"0.08 m\"]\n\
         [grid]\ncell = \"10 mm\"\n{}{}[run]\nduration = \"0.2 s\"\n",
        SAND.replace("0.5", "0.1"),
        block("left", "0.05 m"),
        block("right", "-0.05 m")
    );
    let case = read(&text).unwrap();
    let simulation = super::run(&case);
    let (state, history) = (&simulation.state, &simulation.history);
    let map =
        HeightMap::of(&case, (&simulation.model.grid, &Halo::whole()), state, &history.ground_left).unwrap();
    // The blocks start in holes.
    let whole = map.figures(2.0 * 0.04 * 0.04 * 0.02);
    assert!(
        whole.rut_volume_m3 > 1e-4 && whole.berm_volume_m3 > 0.0 && whole.compaction_m3 > 0.0,
        "{whole:?}"
    );
    assert!(whole.unexplained.abs() < 0.005, "{} of the rut", whole.unexplained);
    // Loose sand is disturbed farther than it is displaced.
    assert!(whole.disturbed_m3 > whole.mixed_m3 && whole.mixed_m3 > 0.0);
    let all = ruts(&case, &map, state, &history.bodies);
    let volume = |value: fn(&coulter::history::RutSection) -> f64| {
        let widths: Vec<f64> = map.edges[0].windows(2).map(|edges| edges[1] - edges[0]).collect();
        let each = all.iter().flat_map(|rut| rut.sections.iter().zip(&widths));
        each.map(|(section, width)| value(section) * width).sum::<f64>()
    };
    for (sum, expected) in [
        (volume(|s| s.area), whole.rut_volume_m3),
        (volume(|s| s.berm_area), whole.berm_volume_m3),
        (volume(|s| s.compaction), whole.compaction_m3),
        (volume(|s| s.disturbed), whole.disturbed_m3),
    ] {
        assert!((sum / expected - 1.0).abs() < 1e-9, "{sum} m³, not {expected}");
    }
    // Two equal bodies side by side leave the same rut, mirrored.
    let [left, right] = [0, 1].map(|n| all[n].mean.unwrap());
    assert!((left.depth / right.depth - 1.0).abs() < 0.1 && left.depth > 0.005, "{left:?} {right:?}");
    assert!((left.high_berm / right.low_berm - 1.0).abs() < 0.2, "{left:?} {right:?}");
    assert!(left.width > 0.03 && left.width < 0.1 && left.disturbed_depth >= left.depth);
}

#[test]
fn a_body_that_has_not_moved_has_left_nothing() {
    let text = format!(
        "format = 2\n[soil]\nyoung_modulus = \"5 MPa\"\n{SAND}[domain]\nx = [\"-0.1 m\", \"0.1 m\"]\ny = [\"-0.1 m\", \"0.1 m\"]\nz = [\"-0.1 m\", \"0.08 m\"]\n\
         [grid]\ncell = \"10 mm\"\n[body.block]\nshape = \"block\"\nsize = [\"40 mm\", \"40 mm\", \"40 mm\"]\nfriction = 0.3\n[run]\nduration = \"2 ms\"\n"
    );
    let case = read(&text).unwrap();
    let simulation = super::run(&case);
    let map = HeightMap::of(&case, (&simulation.model.grid, &Halo::whole()), &simulation.state, &[]).unwrap();
    let found = ruts(&case, &map, &simulation.state, &simulation.history.bodies);
    assert!(found[0].mean.is_none() && found[0].sections.iter().all(|s| s.disturbed == 0.0 && s.area < 1e-9));
}
