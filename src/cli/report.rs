//! `srt report`: a record → the report again, in all its forms.

use std::collections::BTreeSet;
use std::path::Path;

use super::compare_args::ReportArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::output::{Output, make_folder, print};
use super::result_folder::{ResultFolder, pictures_in, read_record};
use crate::record::Comparison;
use crate::report::Report;

/// Writes the report again.
pub(super) fn run(arguments: &ReportArguments) -> CommandResult {
    let own_folder = match arguments.record.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut comparison = read_record(&arguments.record)?;
    if let Some(base) = &arguments.base {
        comparison.base = measured(base, &comparison)?;
    }
    let folder = ResultFolder::prepare(arguments.out.as_deref().unwrap_or(own_folder))?;
    let report = Report::new(&comparison);
    folder.write(&report, &pictures_in(&comparison, own_folder))?;
    if let Some(plots) = &arguments.plots {
        write_plots(&report, plots)?;
    }
    if !arguments.quiet {
        print(&report.terminal())?;
    }
    Ok(Exit::Fine)
}

/// The name of a structure, if it was measured in any scene or sweep.
fn measured(name: &str, comparison: &Comparison) -> Result<String, Failure> {
    let scenes = comparison.scenes.iter().flat_map(|scene| &scene.structures);
    let points = comparison.sweeps.iter().flat_map(|sweep| &sweep.points);
    let names = scenes.map(|own| &own.name).chain(points.map(|point| &point.structure));
    let names: BTreeSet<&str> = names.map(String::as_str).collect();
    if names.contains(name) {
        return Ok(name.to_owned());
    }
    let names: Vec<&str> = names.into_iter().collect();
    let names = names.join(", ");
    Err(Failure::new(format_args!("the report has no `{name}` to take ratios to: it has {names}")))
}

/// Writes the plots, each to a file.
fn write_plots(report: &Report<'_>, folder: &Path) -> Result<(), Failure> {
    make_folder(folder)?;
    for (name, text) in report.plots() {
        let output = Output::prepare(&folder.join(name))?;
        output.write(|to| to.write_all(text.as_bytes()))?;
    }
    Ok(())
}
