//! The description of an FMU, `modelDescription.xml`.

use crate::fmu::{Fmu, FmuError};
use crate::variables::{Causality, FIRST_NUMBER, FIRST_TEXT, TEXTS, TIME, Variable};
use std::fmt::Write;

/// What an FMU calls its library.
pub(crate) const IDENTIFIER: &str = "coulter";

/// Units by their base units.
const UNITS: [(&str, &str); 9] = [
    ("s", r#"s="1""#),
    ("m", r#"m="1""#),
    ("m/s", r#"m="1" s="-1""#),
    ("m/s2", r#"m="1" s="-2""#),
    ("rad/s", r#"rad="1" s="-1""#),
    ("rad/s2", r#"rad="1" s="-2""#),
    ("N", r#"kg="1" m="1" s="-2""#),
    ("N.m", r#"kg="1" m="2" s="-2""#),
    ("J", r#"kg="1" m="2" s="-2""#),
];

/// The categories of messages.
pub(crate) const CATEGORIES: [(&str, &str); 2] =
    [("logErrors", "What has gone wrong"), ("logVerdict", "What the result is worth")];

/// The description of an FMU.
///
/// # Errors
/// A case that cannot be simulated.
pub(crate) fn description(fmu: &Fmu) -> Result<String, FmuError> {
    let start = fmu.at_start()?;
    let (case, dt) = (&fmu.case, start.time_step);
    let variables = fmu.variables(&start);
    // Steps of the importer that are whole steps of the solver, about as long as a sample.
    let step = dt * (case.output.history_interval / dt).round().max(1.0);
    let units = UNITS.map(|(name, base)| format!("    <Unit name=\"{name}\"><BaseUnit {base}/></Unit>\n"));
    let categories =
        CATEGORIES.map(|(name, about)| format!("    <Category name=\"{name}\" description=\"{about}\"/>\n"));
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"3.0\" modelName=\"{name}\" instantiationToken=\"{token}\"\n  \
         description=\"{title}\" generationTool=\"Coulter {version}\" variableNamingConvention=\"structured\">\n  \
         <CoSimulation modelIdentifier=\"{IDENTIFIER}\" canHandleVariableCommunicationStepSize=\"true\"\n    \
         fixedInternalStepSize=\"{dt:?}\" canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"/>\n  \
         <UnitDefinitions>\n{units}  </UnitDefinitions>\n  \
         <LogCategories>\n{categories}  </LogCategories>\n  \
         <DefaultExperiment startTime=\"0\" stopTime=\"{stop:?}\" stepSize=\"{step:?}\"/>\n  \
         <ModelVariables>\n{variables}  </ModelVariables>\n  \
         <ModelStructure>\n{structure}  </ModelStructure>\n\
         </fmiModelDescription>\n",
        name = escaped(&case.name),
        token = fmu.token(),
        title = escaped(&case.title),
        version = env!("CARGO_PKG_VERSION"),
        units = units.concat(),
        categories = categories.concat(),
        stop = case.duration,
        variables = declared(&variables),
        structure = structure(&variables),
    ))
}

fn declared(variables: &[Variable]) -> String {
    let mut text = format!(
        "    <Float64 name=\"time\" valueReference=\"{TIME}\" causality=\"independent\" variability=\"continuous\" \
         unit=\"s\" description=\"Simulation time\"/>\n"
    );
    for ((name, about), reference) in TEXTS.iter().zip(FIRST_TEXT..) {
        put(
            &mut text,
            format_args!(
                "    <String name=\"{name}\" valueReference=\"{reference}\" causality=\"parameter\" variability=\"fixed\" \
             description=\"{about}\"><Start value=\"\"/></String>\n"
            ),
        );
    }
    for (variable, reference) in variables.iter().zip(FIRST_NUMBER..) {
        let Variable { name, causality, unit, meaning, start } = variable;
        let causality = match causality {
            Causality::Input => format!("causality=\"input\" start=\"{start:?}\""),
            Causality::Output => "causality=\"output\" initial=\"calculated\"".to_owned(),
        };
        let unit = if UNITS.iter().any(|(known, _)| known == unit) {
            format!(" unit=\"{unit}\"")
        } else {
            String::new()
        };
        put(
            &mut text,
            format_args!(
                "    <Float64 name=\"{}\" valueReference=\"{reference}\" {causality} variability=\"continuous\"{unit} \
             description=\"{}\"/>\n",
                escaped(name),
                escaped(meaning)
            ),
        );
    }
    text
}

/// Outputs follow from the inputs of the step before.
fn structure(variables: &[Variable]) -> String {
    let outputs = || {
        let each = variables.iter().zip(FIRST_NUMBER..);
        each.filter(|(variable, _)| variable.causality == Causality::Output).map(|(_, reference)| reference)
    };
    let mut text = String::new();
    for (kind, reference) in outputs().map(|n| ("Output", n)).chain(outputs().map(|n| ("InitialUnknown", n)))
    {
        put(&mut text, format_args!("    <{kind} valueReference=\"{reference}\" dependencies=\"\"/>\n"));
    }
    text
}

fn put(text: &mut String, what: std::fmt::Arguments) {
    // A text takes whatever is written to it.
    let _ = text.write_fmt(what);
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
