//! `srt check`: validates scenes without rendering, and tells what is in them. What is valid is for
//! the other layers to say: whatever they refuse to render is invalid here.

use std::path::Path;

use super::args::CheckArguments;
use super::exit::{Exit, Failure, Outcome};
use super::inventory;
use super::load::{LoadError, Loaded, load};
use super::output::print;
use super::source;
use super::terminal::{tell, tell_error};

/// Checks every scene, also after one that is not valid; the worst decides how the command ends.
pub(super) fn run(arguments: &CheckArguments) -> Outcome {
    if arguments.scenes.iter().filter(|path| source::is_stdin(path)).count() > 1 {
        return Err(Failure::new("`-` is named twice, and standard input can be read only once"));
    }
    let mut worst = Exit::Fine;
    for path in &arguments.scenes {
        let exit = check(path, arguments.lenient)?;
        if exit as u8 > worst as u8 {
            worst = exit;
        }
    }
    Ok(worst)
}

fn check(path: &Path, lenient: bool) -> Outcome {
    let error = match load(path, lenient) {
        Ok(loaded) => return show(path, &loaded),
        Err(error) => error,
    };
    let exit = match &error {
        LoadError::Invalid { text, .. } => {
            tell(format_args!("{text}\n"));
            Exit::Negative
        }
        LoadError::Source(_) => Exit::Trouble,
    };
    tell_error(error);
    Ok(exit)
}

fn show(path: &Path, loaded: &Loaded) -> Outcome {
    if !loaded.warnings.is_empty() {
        tell(&loaded.warnings);
    }
    let text = inventory::describe(&loaded.description, &loaded.scene);
    print(&format!("{}: valid\n{text}", source::name(path)))?;
    Ok(Exit::Fine)
}
