//! `srt completions`: a shell's completions, from the definition in `args.rs`.

use clap::CommandFactory;

use super::args::{Arguments, CompletionsArguments};
use super::exit::{Exit, Failure, Outcome};
use super::output::Output;

/// Prints the completions.
pub(super) fn run(arguments: &CompletionsArguments) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "srt", &mut script);
    Output::stdout().write(|to| to.write_all(&script)).map_err(Failure::from)?;
    Ok(Exit::Fine)
}
