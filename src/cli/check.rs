//! `srt check`: validates scenes without rendering, and lists what is in them. The other layers decide
//! what is valid: whatever they refuse to render is invalid here.

use std::path::Path;

use super::args::CheckArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::inventory;
use super::load::{Described, LoadError, load, print_load_error};
use super::output::print;
use super::source;
use super::terminal::print_message;

/// Checks every scene, also after one that is not valid; the worst decides how the command ends.
pub(super) fn run(arguments: &CheckArguments) -> CommandResult {
    if arguments.scenes.iter().filter(|path| source::is_stdin(path)).count() > 1 {
        return Err(Failure::new("`-` is named twice, and standard input can be read only once"));
    }
    let mut worst = Exit::Fine;
    for path in &arguments.scenes {
        let exit = check(path, arguments.lenient)?;
        if exit.code() > worst.code() {
            worst = exit;
        }
    }
    Ok(worst)
}

fn check(path: &Path, lenient: bool) -> CommandResult {
    let error = match load(path, lenient) {
        Ok(described) => return show(path, &described),
        Err(error) => error,
    };
    print_load_error(&error);
    Ok(match error {
        LoadError::Invalid { .. } => Exit::Negative,
        LoadError::Source(_) => Exit::Trouble,
    })
}

fn show(path: &Path, described: &Described) -> CommandResult {
    let Described { loaded, keyed_frames, description } = described;
    if !loaded.warnings.is_empty() {
        print_message(&loaded.warnings);
    }
    let text = inventory::describe(description, &loaded.scene, *keyed_frames);
    print(&format!("{}: valid\n{text}", source::name(path)))?;
    Ok(Exit::Fine)
}
