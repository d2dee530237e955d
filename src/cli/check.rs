//! `srt check`: validates scenes without rendering. What is valid is the parser's to say.

use std::path::Path;

use super::args::CheckArguments;
use super::exit::{Exit, Outcome};
use super::pending::NotYet;
use super::source;
use super::terminal::tell_error;

/// Checks every scene, also after one that is not valid; the worst decides how the command ends.
pub(super) fn run(arguments: &CheckArguments) -> Outcome {
    let mut worst = Exit::Fine;
    for path in &arguments.scenes {
        let exit = check(path, arguments.lenient)?;
        if exit as u8 > worst as u8 {
            worst = exit;
        }
    }
    Ok(worst)
}

fn check(path: &Path, _lenient: bool) -> Outcome {
    match source::read(path) {
        Ok(_) => tell_error(format_args!("`{}` cannot be checked: {NotYet}", path.display())),
        Err(error) => tell_error(error),
    }
    Ok(Exit::Trouble)
}
