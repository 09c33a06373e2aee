//! Resistive force theory: the published stiffnesses and the table of the disc.

use analytic::disc::{Disc, Drive};
use analytic::resistive::{
    Motion, PlanarLaw, SpatialLaw, Traction, at_depth, facets_of_triangles, stiffness_per_unit_weight,
    under_weight, wrench,
};

const DISC: Disc = Disc { diameter: 0.2, thickness: 0.05 };

#[test]
fn stiffness_row_matches() {
    let rows = [(0.3, 16.1), (0.4, 31.1), (0.5, 59.8), (0.6, 107.5), (0.7, 179.8)];
    for (mu, want) in rows {
        assert!((stiffness_per_unit_weight(f64::atan(mu)).unwrap() - want).abs() < 0.06, "{mu}");
    }
    assert!((stiffness_per_unit_weight(29_f64.to_radians()).unwrap() - 83.0).abs() < 0.06);
    assert!((stiffness_per_unit_weight(30_f64.to_radians()).unwrap() - 94.8).abs() < 0.06);
    assert!(stiffness_per_unit_weight(45_f64.to_radians()).is_err());
}

#[test]
fn a_level_plate_pushed_down_matches() {
    let down = [0.0, 0.0, -1.0];
    let alpha = SpatialLaw::generic(down, down);
    println!("3D-RFT level plate: {alpha:?}");
    assert!((alpha[2] - 0.875).abs() < 6e-4);
    let (back, up) = PlanarLaw::generic(0.0, std::f64::consts::FRAC_PI_2);
    assert!((up - 1.0).abs() < 1e-9 && back.abs() < 1e-9);
    let law = PlanarLaw::new(1e6).unwrap();
    let force = law.traction(0.01, [0.0, 0.0, -1.0], down);
    assert!((force[2] - 1e4).abs() < 1e-6);
}

#[test]
fn the_disc_matches() {
    // φ, Z, rolling F_H, F_V, locked F_H, F_V [N]
    let rows = [
        (30., 0.05, [1.6, 19.9, 2.5, 4.6]),
        (30., 0.10, [6.5, 56.3, 9.8, 14.8]),
        (30., 0.20, [27.4, 157., 37.7, 46.0]),
        (30., 0.30, [63.8, 279., 80.2, 86.2]),
        (30., 0.40, [114., 414., 134., 131.]),
        (35., 0.05, [3.1, 37.7, 4.7, 8.8]),
        (35., 0.10, [12.3, 107., 18.6, 28.1]),
        (35., 0.20, [52.1, 298., 71.6, 87.4]),
        (35., 0.30, [121., 530., 152., 164.]),
        (35., 0.40, [216., 785., 254., 249.]),
    ];
    let mut worst = 0.0_f64;
    for (phi, z, row) in rows {
        let law = SpatialLaw::new(f64::to_radians(phi), 16e3, 0.3).unwrap();
        let rolling = at_depth(&law, &DISC, z * 0.2, Drive::Slip(0.0)).unwrap();
        let locked = at_depth(&law, &DISC, z * 0.2, Drive::Locked).unwrap();
        let found = [rolling.drag, rolling.vertical, locked.drag, locked.vertical];
        println!("φ={phi} Z={z}: {found:.2?} for {row:?}");
        for (got, want) in found.into_iter().zip(row) {
            let last = if want < 100.0 { 0.05 } else { 0.5 };
            worst = worst.max((got / want - 1.0).abs());
            assert!((got - want).abs() < last + 2e-3 * want, "φ={phi} Z={z}: {got} for {want}");
        }
    }
    println!("worst {worst:.1e}");
}

#[test]
fn the_cmu_wheel_skids_a_little() {
    let wheel = Disc { diameter: 0.116, thickness: 0.05 };
    let law = SpatialLaw::new(29_f64.to_radians(), 13.03e3, 0.4).unwrap();
    let free = under_weight(&law, &wheel, 24.0, Drive::Free).unwrap();
    assert!((free.vertical / 24.0 - 1.0).abs() < 1e-6 && free.torque.abs() < 1e-6, "{free:?}");
    assert!(
        (free.drag - 8.1).abs() < 0.08
            && (free.sinkage / 0.116 - 0.162).abs() < 1.5e-3
            && (free.slip + 0.08).abs() < 5e-3
    );
    // With the sign change of the friction resolved: 8.11 N, Z = 0.1631, slip −0.084 (the derivation: 8.1,
    // 0.162, −0.08).
    println!("free {:.4} N, Z {:.4}, slip {:.4}", free.drag, free.sinkage / 0.116, free.slip);
    let locked = under_weight(&law, &wheel, 19.5, Drive::Locked).unwrap();
    assert!((locked.drag - 18.5).abs() < 0.05 && (locked.sinkage - 0.0336).abs() < 1e-4);
}

#[test]
fn the_planar_law_drags_and_lifts_a_disc() {
    let law = PlanarLaw::new(1e6).unwrap();
    let free = under_weight(&law, &DISC, 50.0, Drive::Free).unwrap();
    let locked = under_weight(&law, &DISC, 50.0, Drive::Locked).unwrap();
    println!("2-D RFT: free {free:?}, locked {locked:?}");
    assert!(free.drag > 0.0 && locked.drag > free.drag && locked.sinkage > free.sinkage && free.slip < 0.0);
}

/// A closed box of triangles moved downwards has at least the force on its bottom.
#[test]
fn a_box_of_triangles_has_the_force_on_its_bottom() {
    let corner = |n: u32| [0, 1, 2].map(|bit| if n & (1 << bit) == 0 { -0.05 } else { 0.05 });
    let points: Vec<[f64; 3]> = (0..8).map(corner).collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles: Vec<[u32; 3]> =
        faces.iter().flat_map(|f: &[u32; 4]| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect();
    let facets = facets_of_triangles(&points, &triangles).unwrap();
    assert!((facets.iter().map(|f| f.area).sum::<f64>() - 0.06).abs() < 1e-12);
    let law = SpatialLaw::new(30_f64.to_radians(), 16e3, 0.3).unwrap();
    let motion = Motion { height: 0.03, velocity: [0.0, 0.0, -1.0], spin: [0.0; 3] };
    let found = wrench(&law, &facets, &motion);
    // The sides move in their own plane and contribute as vertical walls, the bottom 0.875 ξ z A.
    let bottom = 0.875 * law.stiffness * 0.02 * 0.01;
    println!("{found:?}, bottom alone {bottom:.3} N");
    assert!(found.force[2] > bottom && found.force[2] < 1.5 * bottom);
    assert!(found.force[0].abs() < 1e-9 * bottom && found.torque.iter().all(|t| t.abs() < 1e-9));
    assert!(facets_of_triangles(&points, &[[0, 1, 9]]).is_err());
}
