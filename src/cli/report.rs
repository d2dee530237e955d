//! `srt report`: a record → the report again, in all its forms.

use std::path::Path;

use super::compare_args::ReportArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::output::{Output, make_folder, print};
use super::result_folder::{ResultFolder, pictures_in, read_record};
use crate::report::Report;

/// Writes the report again.
pub(super) fn run(arguments: &ReportArguments) -> CommandResult {
    let own_folder = match arguments.record.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let comparison = read_record(&arguments.record)?;
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

/// Writes the plots, each to a file.
fn write_plots(report: &Report<'_>, folder: &Path) -> Result<(), Failure> {
    make_folder(folder)?;
    for (name, text) in report.plots() {
        let output = Output::prepare(&folder.join(name))?;
        output.write(|to| to.write_all(text.as_bytes()))?;
    }
    Ok(())
}
