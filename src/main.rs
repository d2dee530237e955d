//! The command `srt`: see [`srt::cli`].

use std::process::ExitCode;

fn main() -> ExitCode {
    srt::cli::run()
}
