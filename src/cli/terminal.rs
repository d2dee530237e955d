//! Text for the person at the terminal: standard error, and whether it is coloured.

use std::ffi::OsStr;
use std::io::{self, IsTerminal, Write};

/// Writes a line to standard error. If that cannot be written, nobody can be informed, and it must
/// not change how the command ends (`eprintln!` would panic).
pub(crate) fn print_message(text: impl std::fmt::Display) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Writes an error: `error: …`, as all errors of the command begin.
pub(crate) fn print_error(message: impl std::fmt::Display) {
    let (bold_red, plain) = if colors() { ("\x1b[1;31m", "\x1b[0m") } else { ("", "") };
    print_message(format_args!("{bold_red}error:{plain} {message}"));
}

/// Writes a warning: `warning: …`, as those of a scene begin.
pub(crate) fn print_warning(message: impl std::fmt::Display) {
    let (bold_yellow, plain) = if colors() { ("\x1b[1;33m", "\x1b[0m") } else { ("", "") };
    print_message(format_args!("{bold_yellow}warning:{plain} {message}"));
}

/// Whether text for standard error may carry colours.
pub(crate) fn colors() -> bool {
    decide(
        std::env::var_os("NO_COLOR").as_deref(),
        std::env::var_os("TERM").as_deref(),
        io::stderr().is_terminal(),
    )
}

/// The rule of <https://no-color.org>: any `NO_COLOR` but an empty one forbids colours; so does
/// `TERM=dumb`, and anything that is no terminal.
fn decide(no_color: Option<&OsStr>, term: Option<&OsStr>, terminal: bool) -> bool {
    let forbidden = no_color.is_some_and(|value| !value.is_empty());
    let dumb = term.is_some_and(|value| value == "dumb");
    terminal && !forbidden && !dumb
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_for_terminals_that_want_them() {
        let text = |s: &'static str| Some(OsStr::new(s));
        assert!(decide(None, text("xterm"), true));
        assert!(decide(text(""), None, true));
        assert!(!decide(text("1"), text("xterm"), true));
        assert!(!decide(None, text("dumb"), true));
        assert!(!decide(None, text("xterm"), false));
    }
}
