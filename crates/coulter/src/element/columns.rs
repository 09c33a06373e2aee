//! The columns of the curves of element tests: names, units and values. They are a contract.

use super::path::{PathPoint, TestKind};
use super::tested::Tested;

/// A column: its name with the unit, and its value at a point of a specimen's path.
pub type CurveColumn = (&'static str, fn(&Tested, &PathPoint) -> f64);

/// Columns of every test.
const COMMON: [CurveColumn; 7] = [
    ("volumetric strain [-]", |_, point| point.volume_change()),
    ("vertical stress [Pa]", |_, point| point.vertical),
    ("lateral stress [Pa]", |_, point| point.lateral),
    ("mean pressure p [Pa]", |_, point| point.pressure),
    ("Mises stress q [Pa]", |_, point| point.mises),
    ("density [kg/m^3]", |_, point| point.density),
    ("unloading [-]", |_, point| f64::from(u8::from(point.is_unloading))),
];

/// The columns of the curves of a test, after the number of the specimen.
#[must_use]
pub fn columns(kind: TestKind) -> Vec<CurveColumn> {
    let strain: CurveColumn = match kind {
        TestKind::Shear => ("shear strain [-]", |_, point| point.strain),
        _ => ("axial strain [-]", |_, point| point.axial_strain()),
    };
    let mut columns: Vec<CurveColumn> = vec![
        ("pressure at the start [Pa]", |tested, _| tested.test.pressure),
        ("density at the start [kg/m^3]", |tested, _| tested.test.density),
        strain,
    ];
    columns.extend(COMMON);
    match kind {
        TestKind::Triaxial => {
            columns.push(("mobilised friction angle [rad]", |_, point| point.mobilised_angle()));
        }
        TestKind::Shear => {
            columns.push(("shear stress [Pa]", |_, point| point.shear));
            columns.push(("shear stress over vertical stress [-]", |_, point| point.shear / point.vertical));
        }
        TestKind::Oedometer => {
            columns.push(("lateral over vertical stress [-]", |_, point| point.lateral / point.vertical));
        }
        TestKind::Isotropic => {}
    }
    columns
}
