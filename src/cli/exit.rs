//! How the command ends: exit codes, and the one place that prints an error.

use std::process::ExitCode;

use super::terminal::print_error;

/// The exit codes, as the help and the man page list them.
pub(crate) const EXIT_CODES: &str = "\
Exit codes:
  0    done; for `diff`: the pictures are equal; for `check`: all scenes are valid
  1    `diff`: the pictures differ; `check`: a scene is invalid; `compare`, `conformance`,
       `animate`: the results of a structure differ, or it failed; `compare`: something became
       slower than the baseline
  2    trouble: bad arguments, a scene or file that cannot be read, an output that cannot be
       written; `compare`: the baseline has nothing in common with the comparison
  130  interrupted by Ctrl-C; by another signal n: 128 + n, as 143 by SIGTERM
  141  the reader of the output closed it";

/// An end without an error, or one whose error has been printed already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// All is well.
    Fine,
    /// The answer is no: pictures differ, a scene is invalid.
    Negative,
    /// Something went wrong and was explained.
    Trouble,
    /// A signal of this number.
    Interrupted(u8),
}

impl Exit {
    /// The code of the process.
    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Fine => 0,
            Self::Negative => 1,
            Self::Trouble => 2,
            // As shells count.
            Self::Interrupted(signal) => 128 + signal,
        }
    }
}

/// An error that is still to be printed.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// What to print after `error: `.
    #[error("{0}")]
    Message(String),
    /// The reader of a pipe closed it, and expects no message.
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
pub(crate) type CommandResult = Result<Exit, Failure>;

/// The shells' code for a process that ended by SIGPIPE: 128 + 13.
const BROKEN_PIPE: u8 = 141;

/// Prints the error, if there is one, and makes the code of the process.
pub(super) fn conclude(result: CommandResult) -> ExitCode {
    match result {
        Ok(exit) => ExitCode::from(exit.code()),
        Err(Failure::Message(message)) => {
            print_error(message);
            ExitCode::from(Exit::Trouble.code())
        }
        Err(Failure::BrokenPipe) => ExitCode::from(BROKEN_PIPE),
    }
}
