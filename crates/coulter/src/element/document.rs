//! Element tests as one JSON document. Its names are a contract on which scripts rely.

use super::path::{Ending, TestKind};
use super::tested::{ElementTests, Tested};
use results::formats;
use serde_json::{Map, Value, json};

impl TestKind {
    /// Name of the kind of test, on the command line and in documents.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Triaxial => "triaxial",
            Self::Oedometer => "oedometer",
            Self::Isotropic => "isotropic",
            Self::Shear => "shear",
        }
    }
}

/// The document of element tests.
#[must_use]
pub fn document(tests: &ElementTests) -> Value {
    json!({
        "format": formats::DOCUMENT,
        "case": tests.case,
        "test": tests.kind.word(),
        "soil": tests.soil,
        "specimens": tests.tested.iter().enumerate().map(specimen).collect::<Vec<_>>(),
        "remarks": tests.remarks,
    })
}

fn specimen((number, tested): (usize, &Tested)) -> Value {
    let mut entry = Map::new();
    entry.insert("specimen".into(), json!(number + 1));
    entry.insert("pressure_Pa".into(), json!(tested.test.pressure));
    entry.insert("density_kg_m3".into(), json!(tested.test.density));
    entry.insert("relative_density".into(), json!(tested.relative_density));
    entry.insert("ending".into(), json!(ending(tested.course.ending)));
    if !tested.test.kind.shears() {
        let moduli = tested.figures.moduli.iter().map(|m| {
            let [from, to] = m.pressures;
            json!({ "from_Pa": from, "to_Pa": to, "modulus_Pa": m.modulus })
        });
        entry.insert("secant_moduli".into(), moduli.collect());
    }
    for figure in &tested.figures.list {
        // What is not a number becomes null.
        entry.insert(figure.key.into(), json!(figure.value));
    }
    Value::Object(entry)
}

fn ending(ending: Ending) -> &'static str {
    match ending {
        Ending::Complete => "complete",
        Ending::Failed => "failed",
        Ending::Crushed => "crushed",
    }
}
