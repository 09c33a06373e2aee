//! The curves of element tests as plots.

use crate::element::{ElementTests, PathPoint, TestKind, Tested};
use input::readable::{Unit, digits, largest};
use report::plots::{Chart, Curve};

/// File name and SVG text of every plot.
pub(super) fn plots(tests: &ElementTests) -> Vec<(&'static str, String)> {
    match tests.kind {
        TestKind::Triaxial | TestKind::Shear => {
            vec![("strength.svg", strength(tests).svg()), ("volume.svg", volume(tests).svg())]
        }
        TestKind::Oedometer | TestKind::Isotropic => vec![("compression.svg", compression(tests).svg())],
    }
}

/// One curve for each specimen.
fn curves(tests: &ElementTests, at: impl Fn(&PathPoint) -> [f64; 2]) -> Vec<Curve> {
    let curve = |(colour, tested): (usize, &Tested)| {
        Curve::solid(&name(tested), colour, tested.course.points.iter().map(&at).collect())
    };
    tests.tested.iter().enumerate().map(curve).collect()
}

/// Pressure and density at the start.
fn name(tested: &Tested) -> String {
    let unit = Unit::stress(tested.test.pressure);
    let pressure = format!("{} {}", digits(tested.test.pressure / unit.size), unit.name);
    match tested.relative_density {
        Some(relative) => format!("{pressure}, I_D = {}", digits(relative)),
        None => pressure,
    }
}

/// Abscissa of tests that shear [%], and its label.
fn strain(kind: TestKind) -> (fn(&PathPoint) -> f64, &'static str) {
    match kind {
        TestKind::Shear => (|point| 100.0 * point.strain, "shear strain γ [%]"),
        _ => (|point| 100.0 * point.axial_strain(), "axial strain ε₁ [%]"),
    }
}

fn strength(tests: &ElementTests) -> Chart {
    let (strain, x_label) = strain(tests.kind);
    let stress = |point: &PathPoint| match tests.kind {
        TestKind::Shear => point.shear,
        _ => point.vertical - point.lateral,
    };
    let (title, y_label, curves) = match (tests.kind, tests.soil.law.friction_angle()) {
        (TestKind::Shear, Some(_)) => (
            "Simple shear: shear stress over vertical stress",
            "τ/σ_v [–]".to_owned(),
            curves(tests, |point| [strain(point), point.shear / point.vertical]),
        ),
        (_, Some(_)) => (
            "Triaxial compression: mobilised friction angle",
            "φ mobilised [deg]".to_owned(),
            curves(tests, |point| [strain(point), point.mobilised_angle().to_degrees()]),
        ),
        (kind, None) => {
            let unit = Unit::stress(largest(tests.tested.iter().flat_map(|t| &t.course.points).map(stress)));
            let (title, symbol) = match kind {
                TestKind::Shear => ("Simple shear: shear stress", "τ"),
                _ => ("Triaxial compression: deviatoric stress", "q"),
            };
            let curves = curves(tests, |point| [strain(point), stress(point) / unit.size]);
            (title, format!("{symbol} [{}]", unit.name), curves)
        }
    };
    Chart {
        title: title.to_owned(),
        x_label: x_label.to_owned(),
        y_label,
        with_zero: true,
        curves,
        ..Chart::default()
    }
}

fn volume(tests: &ElementTests) -> Chart {
    let (strain, x_label) = strain(tests.kind);
    Chart {
        title: "Volume of the specimen: compaction downwards".to_owned(),
        x_label: x_label.to_owned(),
        y_label: "volumetric strain ε_v [%]".to_owned(),
        y_down: true,
        with_zero: true,
        curves: curves(tests, |point| [strain(point), 100.0 * point.volume_change()]),
        ..Chart::default()
    }
}

fn compression(tests: &ElementTests) -> Chart {
    let is_isotropic = tests.kind == TestKind::Isotropic;
    let (title, pressure, strain) = match is_isotropic {
        true => ("Isotropic compression and unloading", "mean pressure p", "volumetric strain ε_v [%]"),
        false => ("Oedometric compression and unloading", "vertical stress σ_v", "vertical strain ε_v [%]"),
    };
    let of = |point: &PathPoint| if is_isotropic { point.pressure } else { point.vertical };
    let unit = Unit::stress(largest(tests.tested.iter().flat_map(|t| &t.course.points).map(of)));
    let at = |point: &PathPoint| {
        let strain = if is_isotropic { point.volume_change() } else { point.axial_strain() };
        [of(point) / unit.size, 100.0 * strain]
    };
    Chart {
        title: title.to_owned(),
        x_label: format!("{pressure} [{}]", unit.name),
        y_label: strain.to_owned(),
        y_down: true,
        with_zero: true,
        logarithmic_x: true,
        curves: curves(tests, at),
        ..Chart::default()
    }
}
