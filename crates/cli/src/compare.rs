//! `coulter compare`: runs, closed forms and measurements side by side.

use crate::calibrate::{quantity_named, window};
use crate::common::{choices, refuse_file, say, say_json};
use crate::failure::Failure;
use coulter::output::Inside;
use std::path::{Path, PathBuf};
use studies::comparison::{
    Comparison, ComparisonRequest, Item, Unreadable, compare, comparison_csv, comparison_document,
    comparison_page, comparison_text, read_item,
};
use studies::files;
use studies::measured::refuse_unused;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Results folders of runs, forecast folders or forecast.json, case files (by their closed form),
    /// measured CSV files
    #[arg(required = true, num_args = 2.., value_name = "ITEM")]
    items: Vec<PathBuf>,
    /// The item that the others are compared with [default: the first measured one]
    #[arg(long, value_name = "ITEM")]
    reference: Option<PathBuf>,
    /// Along what: u (displacement), z (sinkage), t (time) or slip [default: what the reference runs along]
    #[arg(long, value_name = "NAME")]
    against: Option<String>,
    /// What is compared, such as drag,vertical [default: what the reference and another have]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    quantity: Vec<String>,
    /// The part of the abscissa that counts, such as "0.4 m".."0.8 m"
    #[arg(long, value_name = "FROM..TO")]
    window: Option<String>,
    /// Move the zero of the abscissa of each curve to where it fits the reference best
    #[arg(long)]
    align: bool,
    /// What a column of a measured file is: COLUMN=QUANTITY, COLUMN="-QUANTITY [UNIT]" of the other sign,
    /// COLUMN=- to leave it out; may be repeated
    #[arg(long = "column", value_name = "COLUMN=QUANTITY")]
    columns: Vec<String>,
    /// The body of runs with several
    #[arg(long, value_name = "NAME")]
    body: Option<String>,
    /// Where to write page, table and document [default: nowhere]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Overwrite an existing comparison
    #[arg(long)]
    force: bool,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

const FILES: [&str; 3] = ["comparison.html", "comparison.csv", "comparison.json"];

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let request = request(arguments)?;
    if let Some(folder) = &arguments.output {
        refuse_existing(folder, arguments.force)?;
    }
    let choices = choices(&arguments.columns)?;
    let read = |path: &PathBuf| read_item(path, arguments.body.as_deref(), &choices);
    let mut items: Vec<Item> =
        arguments.items.iter().map(read).collect::<Result<_, _>>().map_err(|error| match error {
            Unreadable::Case(error) => Failure::Case(error),
            Unreadable::Other(why) => Failure::Request(why),
        })?;
    refuse_unused(&choices, items.iter().map(|item| &item.record)).map_err(Failure::Request)?;
    let comparison = compare(&mut items, &request).map_err(Failure::Request)?;
    if let Some(folder) = &arguments.output {
        write(&items, &comparison, folder)?;
    }
    if arguments.json {
        return say_json(&comparison_document(&items, &comparison));
    }
    say(&comparison_text(&items, &comparison))?;
    arguments.output.as_ref().map_or(Ok(()), |folder| {
        say(&format!(
            "\nwrote {}\n",
            FILES.map(|name| folder.join(name).display().to_string()).join("\n      ")
        ))
    })
}

fn request(arguments: &Arguments) -> Result<ComparisonRequest, Failure> {
    let reference = match &arguments.reference {
        Some(path) => {
            let found = arguments.items.iter().position(|item| item == path);
            Some(found.ok_or_else(|| {
                let shown = path.display();
                Failure::Request(format!(
                    "--reference {shown}: it is none of the items; name it among them as well"
                ))
            })?)
        }
        None => None,
    };
    let against = arguments.against.as_deref().map(quantity_named).transpose()?;
    if let Some(quantity) = against.filter(|quantity| !quantity.is_abscissa()) {
        let name = quantity.name();
        return Err(Failure::Request(format!("--against {name}: curves run along u, z, t or slip")));
    }
    let quantities = arguments.quantity.iter().map(|name| quantity_named(name)).collect::<Result<_, _>>()?;
    let window = arguments.window.as_deref().map(window).transpose()?;
    Ok(ComparisonRequest { reference, against, quantities, window, align: arguments.align })
}

fn refuse_existing(folder: &Path, force: bool) -> Result<(), Failure> {
    refuse_file(folder)?;
    match FILES.iter().map(|name| folder.join(name)).find(|path| Inside::at(path).exists()) {
        Some(path) if !force => Err(Failure::Request(format!(
            "{} exists; use --force to overwrite it, or another folder",
            path.display()
        ))),
        _ => Ok(()),
    }
}

fn write(items: &[Item], comparison: &Comparison, folder: &Path) -> Result<(), Failure> {
    let fail = |error: &dyn std::fmt::Display| Failure::Request(error.to_string());
    let page = comparison_page(items, comparison).map_err(|error| fail(&error))?;
    let document = serde_json::to_string_pretty(&comparison_document(items, comparison));
    let document = document.map_err(|error| fail(&error))? + "\n";
    files::make_folder(&Inside::of(folder, "")).map_err(|error| fail(&error))?;
    for (name, content) in FILES.into_iter().zip([page, comparison_csv(items, comparison), document]) {
        files::write(&Inside::of(folder, name), content.as_bytes()).map_err(|error| fail(&error))?;
    }
    Ok(())
}
