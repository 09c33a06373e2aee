//! `coulter element`: laboratory tests of the soil of a case, at a point.

use crate::check::describe_soil;
use crate::common::{refuse_file, say, say_json};
use crate::failure::Failure;
use clap::ValueEnum;
use coulter::case;
use coulter::case::quantity::{self, DENSITY, Measure, STRESS};
use coulter::case::resolved::Soil;
use coulter::element::{self, Plan, TestKind};
use coulter::output::write_element_tests;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The test
    #[arg(value_enum)]
    test: TestWord,
    /// A case file, of which only [soil] is used; a file with nothing but [soil] will do
    case: PathBuf,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Pressure at the start, such as "10 kPa": all round, in shear and in the oedometer the vertical one;
    /// may be repeated [default: 1, 10 and 100 kPa in triaxial and shear tests, 1 kPa in compression; of soil
    /// whose strength does not depend on the pressure by its strength]
    #[arg(long = "pressure", value_name = "PRESSURE", allow_hyphen_values = true)]
    pressures: Vec<String>,
    /// Relative density of the specimen, of sand; may be repeated [default: that of the case]
    #[arg(long = "relative-density", value_name = "I_D", allow_hyphen_values = true)]
    relative_densities: Vec<f64>,
    /// Density of the specimen, such as "1550 kg/m^3"; may be repeated [default: that of the case]
    #[arg(
        long = "density",
        value_name = "DENSITY",
        allow_hyphen_values = true,
        conflicts_with = "relative_densities"
    )]
    densities: Vec<String>,
    /// Largest strain of triaxial tests (axial) and shear tests [default: 0.25 and 0.5]
    #[arg(long, value_name = "STRAIN", allow_hyphen_values = true)]
    strain: Option<f64>,
    /// Largest pressure of oedometer and isotropic tests, from which they unload
    /// [default: 100 times the first]
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    largest_pressure: Option<String>,
    /// Where to write curves, key figures and plots [default: nowhere]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Overwrite existing tests
    #[arg(long, requires = "output")]
    force: bool,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

/// The tests.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum TestWord {
    /// Drained triaxial compression at constant lateral stress
    Triaxial,
    /// Vertical compression without lateral strain, and unloading
    Oedometer,
    /// Compression under equal pressure on all sides, and unloading
    Isotropic,
    /// Simple shear at constant vertical stress
    Shear,
}

impl TestWord {
    fn kind(self) -> TestKind {
        match self {
            Self::Triaxial => TestKind::Triaxial,
            Self::Oedometer => TestKind::Oedometer,
            Self::Isotropic => TestKind::Isotropic,
            Self::Shear => TestKind::Shear,
        }
    }
}

pub(super) fn element(arguments: &Arguments) -> Result<(), Failure> {
    refuse_unused_options(arguments)?;
    let (name, soil) = case::load_soil(&arguments.case, &arguments.overrides)?;
    let plan = plan(arguments, &soil)?;
    let tests = plan.run(&name, &soil).map_err(|why| Failure::Request(why.to_string()))?;
    let mut files = Vec::new();
    if let Some(folder) = &arguments.output {
        refuse_file(folder)?;
        files = write_element_tests(folder, &tests, arguments.force)
            .map_err(|why| Failure::Request(why.to_string()))?;
    }
    if arguments.json {
        return say_json(&element::document(&tests));
    }
    let mut text = format!("{name}\n");
    // Writing to a string cannot fail.
    let _ = describe_soil(&mut text, &soil);
    say(&format!("{text}\n{}", element::table(&tests)))?;
    let list: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    match list.is_empty() {
        true => say("\ncurves and plots: add -o DIR\n"),
        false => say(&format!("\nwrote {}\n", list.join("\n      "))),
    }
}

/// Refuses options that would have no effect.
fn refuse_unused_options(arguments: &Arguments) -> Result<(), Failure> {
    let (option, other) = match (arguments.test.kind().shears(), arguments) {
        (true, Arguments { largest_pressure: Some(_), .. }) => {
            ("--largest-pressure", "oedometer and isotropic")
        }
        (false, Arguments { strain: Some(_), .. }) => ("--strain", "triaxial and shear"),
        _ => return Ok(()),
    };
    Err(Failure::Request(format!("{option} applies to {other} tests; remove it")))
}

/// What is asked: the usual plan, with what was given.
fn plan(arguments: &Arguments, soil: &Soil) -> Result<Plan, Failure> {
    let mut plan = Plan::usual(arguments.test.kind(), soil);
    if !arguments.pressures.is_empty() {
        plan.pressures = read("--pressure", &arguments.pressures, &STRESS)?;
        plan.largest_pressure = 100.0 * plan.pressures[0];
    }
    if !arguments.densities.is_empty() {
        plan.densities = read("--density", &arguments.densities, &DENSITY)?;
    }
    if !arguments.relative_densities.is_empty() {
        let density = |relative: &f64| {
            soil.density_at(*relative).ok_or_else(|| {
                let message = "--relative-density applies to law = \"sand\" only; give --density";
                Failure::Request(message.to_owned())
            })
        };
        plan.densities = arguments.relative_densities.iter().map(density).collect::<Result<_, _>>()?;
    }
    plan.largest_strain = arguments.strain.unwrap_or(plan.largest_strain);
    if let Some(text) = &arguments.largest_pressure {
        plan.largest_pressure = quantity_of("--largest-pressure", text, &STRESS)?;
    }
    Ok(plan)
}

fn read(option: &str, texts: &[String], measure: &Measure) -> Result<Vec<f64>, Failure> {
    texts.iter().map(|text| quantity_of(option, text, measure)).collect()
}

fn quantity_of(option: &str, text: &str, measure: &Measure) -> Result<f64, Failure> {
    quantity::parse(text, measure).map_err(|why| {
        Failure::Request(format!("{option} {text}: {why}; write it such as \"{}\"", measure.example))
    })
}
