//! What a reader of element tests should know about them.

use super::figures::peak;
use super::path::{Ending, TestKind};
use super::shown::{decimals, stress};
use super::tested::Tested;
use case::resolved::{Law, Sand, Soil};
use std::collections::BTreeMap;

/// Mean pressure from which grains of sand are crushed [Pa] (chosen: quartz sands bend in the oedometer from
/// some 1 MPa on).
const CRUSHING: f64 = 5e5;

/// What a reader should know about tests of a soil.
pub(super) fn remarks(kind: TestKind, soil: &Soil, tested: &[Tested]) -> Vec<String> {
    let mut remarks = of_law(kind, soil, tested);
    // Specimens of which the same is to be said share a remark.
    let mut endings: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (n, tested) in tested.iter().enumerate() {
        if let Some(text) = ending(kind, tested) {
            endings.entry(text).or_default().push((n + 1).to_string());
        }
    }
    let line = |(text, numbers): (String, Vec<String>)| {
        let plural = if numbers.len() > 1 { "s" } else { "" };
        format!("specimen{plural} {}: {text}", numbers.join(", "))
    };
    remarks.extend(endings.into_iter().map(line));
    remarks
}

fn of_law(kind: TestKind, soil: &Soil, tested: &[Tested]) -> Vec<String> {
    let mut remarks = Vec::new();
    match soil.law {
        Law::Tresca(_) => remarks.push(
            "undrained soil: stresses are total ones, its volume changes elastically only; consolidation is not described"
                .to_owned(),
        ),
        Law::MohrCoulomb(law) if law.cohesion > 0.0 && kind.shears() => remarks.push(
            "angles are those of a soil without cohesion that bears the same stresses: they fall with the pressure".to_owned(),
        ),
        Law::Sand(Sand { stiffness_limit, .. }) => {
            let all = tested.iter().flat_map(|t| &t.course.points);
            let largest = all.map(|point| point.pressure).fold(0.0, f64::max);
            // The last decimals of a constant pressure do not count.
            if largest > 1.001 * stiffness_limit {
                remarks.push(format!(
                    "the elastic moduli do not grow beyond p = {} (soil.stiffness_limit): at larger pressures stiffness, of unloading above \
                     all, is too small",
                    stress(stiffness_limit)
                ));
            }
            if largest > CRUSHING {
                remarks.push(format!(
                    "beyond p = {} grains are crushed, which the law does not describe",
                    stress(CRUSHING)
                ));
            }
        }
        _ => {}
    }
    remarks
}

/// What is unusual about the end of a test.
fn ending(kind: TestKind, tested: &Tested) -> Option<String> {
    let points = &tested.course.points;
    let last = points.last()?;
    match tested.course.ending {
        Ending::Failed => {
            let strain = 100.0 * if kind == TestKind::Shear { last.strain } else { last.axial_strain() };
            let at = decimals(strain, 3);
            Some(format!(
                "ended early, at a strain of {at} %: no further strain keeps the stress that is held; its strength is lost"
            ))
        }
        Ending::Crushed => Some(format!(
            "ended early: compressed by {} % of its volume at {}, before the largest pressure",
            decimals(100.0 * last.volume_change(), 0),
            stress(last.vertical)
        )),
        Ending::Complete if kind.shears() => {
            let at = match kind {
                TestKind::Shear => peak(points, |point| point.shear),
                _ => peak(points, |point| point.vertical - point.lateral),
            };
            let rises = at + 1 == points.len();
            rises.then(|| {
                "the stress still rises at the largest strain, whose value is given as the peak".to_owned()
            })
        }
        Ending::Complete => None,
    }
}
