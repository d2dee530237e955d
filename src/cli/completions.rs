//! `srt completions`: a shell's completions, from the definition in `args.rs`.

use clap::Command;

use super::args::CompletionsArguments;
use super::exit::{Exit, Failure, Outcome};
use super::output::Output;

/// Prints the completions.
pub(super) fn run(arguments: &CompletionsArguments, mut command: Command) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "srt", &mut script);
    Output::stdout().write(|to| to.write_all(&script)).map_err(Failure::from)?;
    Ok(Exit::Fine)
}
