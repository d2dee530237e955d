//! `srt report`: a record → the report again, in all its forms.

use std::path::Path;

use super::compare_args::ReportArguments;
use super::exit::{CommandResult, Exit};
use super::output::print;
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
    if !arguments.quiet {
        print(&report.terminal())?;
    }
    Ok(Exit::Fine)
}
