//! `srt completions`: a shell's completions, from the definition of the command.

use clap::Command;

use super::args::CompletionsArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::output::Output;

/// Prints the completions.
pub(super) fn run(arguments: &CompletionsArguments, mut command: Command) -> CommandResult {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "srt", &mut script);
    Output::stdout().write(|to| to.write_all(&script)).map_err(Failure::from)?;
    Ok(Exit::Fine)
}
