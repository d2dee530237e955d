//! How the command ends: exit codes, and the one place that prints an error.

use std::process::ExitCode;

use super::terminal::tell_error;

/// The exit codes, as the help and the man page list them.
pub(crate) const EXIT_CODES: &str = "\
Exit codes:
  0    done; for `diff`: equal; for `check`: all scenes are valid
  1    `diff`: the pictures differ; `check`: a scene is invalid; `compare`, `conformance`: a
       structure's answers differ or it failed; `compare`: something became slower than the baseline
  2    trouble: bad arguments, a scene or file that cannot be read, an output that cannot be written;
       `compare`: the baseline has nothing in common
  130  interrupted by Ctrl-C
  141  whoever read the output stopped reading";

/// An end without trouble, or one whose trouble has been told already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// All is well.
    Fine = 0,
    /// The answer is no: pictures differ, a scene is invalid.
    Negative = 1,
    /// Something went wrong and was explained.
    Trouble = 2,
    /// Ctrl-C: 128 + SIGINT, as shells count.
    Interrupted = 130,
}

/// An end in trouble that is still to be told.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// What to tell after `error: `.
    #[error("{0}")]
    Message(String),
    /// The reader of a pipe went away. It asked for silence by doing so.
    #[error("broken pipe")]
    BrokenPipe,
}

impl Failure {
    /// A failure that explains itself.
    pub(crate) fn new(message: impl std::fmt::Display) -> Self {
        Self::Message(message.to_string())
    }
}

/// What every subcommand returns.
pub(crate) type Outcome = Result<Exit, Failure>;

/// The shells' code for a process that ended by SIGPIPE: 128 + 13.
const BROKEN_PIPE: u8 = 141;

/// Tells what is still to be told, and makes the code of the process.
pub(super) fn conclude(outcome: Outcome) -> ExitCode {
    match outcome {
        Ok(exit) => ExitCode::from(exit as u8),
        Err(Failure::Message(message)) => {
            tell_error(message);
            ExitCode::from(Exit::Trouble as u8)
        }
        Err(Failure::BrokenPipe) => ExitCode::from(BROKEN_PIPE),
    }
}
