//! What a looker asks for, as JSON: `{"id": 7, "do": {"turn": [0.1, 0.0]}}`.

use serde::Deserialize;

use crate::render::View;

/// The most structures that are looked at side by side.
pub const MOST_LANES: usize = 2;

/// The farthest that one command moves the picture, in its heights.
const FARTHEST: f64 = 10.0;

/// The largest factor of one command.
const LARGEST_FACTOR: f64 = 100.0;

/// A command with its number, which the updates that follow it name.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Numbered {
    /// Chosen by the one who asks, larger each time.
    pub(super) id: u64,
    /// What to do.
    #[serde(rename = "do")]
    pub(super) command: Command,
}

/// What to do.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Command {
    /// Turn the scene, by parts of the picture's height to the right and down; a whole one is half a turn.
    Turn([f64; 2]),
    /// Move the scene by parts of the picture's height to the right and down.
    Pan([f64; 2]),
    /// Bring what is looked at nearer, by a factor.
    Zoom(f64),
    /// Take the camera of the scene again.
    Reset,
    /// Trace with this structure, or with these side by side: names with options, as `--accel` takes them.
    Structures(Vec<String>),
    /// Show this of the scene.
    View(String),
}

/// Why a command was not understood.
#[derive(Debug, thiserror::Error)]
pub enum CommandError {
    /// Not JSON, or not a command.
    #[error("not a command: {0}")]
    Form(#[from] serde_json::Error),
    /// A number that no hand makes.
    #[error(
        "`{0}` is too far: at most {FARTHEST} heights of the picture, or a factor of {LARGEST_FACTOR}"
    )]
    TooFar(f64),
    /// Too few structures, or too many.
    #[error("{0} structures: from 1 to {MOST_LANES} are looked at side by side")]
    Lanes(usize),
    /// No such view.
    #[error("there is no view `{0}`")]
    View(String),
    /// Commands come faster than they can be carried out.
    #[error("too many commands at once")]
    TooMany,
}

impl Numbered {
    /// Reads a command, and checks what can be checked without a scene.
    pub(super) fn read(text: &str) -> Result<Self, CommandError> {
        let numbered: Self = serde_json::from_str(text)?;
        match &numbered.command {
            Command::Turn(by) | Command::Pan(by) => {
                if let Some(far) = by.iter().find(|part| part.abs() > FARTHEST) {
                    return Err(CommandError::TooFar(*far));
                }
            }
            Command::Zoom(factor) => {
                if !(LARGEST_FACTOR.recip()..=LARGEST_FACTOR).contains(factor) {
                    return Err(CommandError::TooFar(*factor));
                }
            }
            Command::Structures(names) => {
                if !(1..=MOST_LANES).contains(&names.len()) {
                    return Err(CommandError::Lanes(names.len()));
                }
            }
            Command::View(name) => {
                view_named(name).ok_or_else(|| CommandError::View(name.clone()))?;
            }
            Command::Reset => {}
        }
        Ok(numbered)
    }
}

/// The view of a name.
pub(super) fn view_named(name: &str) -> Option<View> {
    View::ALL.into_iter().find(|view| view.name() == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_read() {
        let read = |text: &str| Numbered::read(text).unwrap().command;
        assert_eq!(read(r#"{"id": 1, "do": {"turn": [0.1, -0.2]}}"#), Command::Turn([0.1, -0.2]));
        assert_eq!(read(r#"{"id": 2, "do": "reset"}"#), Command::Reset);
        let two = read(r#"{"id": 3, "do": {"structures": ["bvh8:leaf=4", "none"]}}"#);
        assert_eq!(two, Command::Structures(vec!["bvh8:leaf=4".to_owned(), "none".to_owned()]));
    }

    #[test]
    fn what_is_no_command_is_refused_in_words() {
        for (text, part) in [
            ("", "not a command"),
            (r#"{"id": 1, "do": {"fly": 1}}"#, "unknown variant `fly`"),
            (r#"{"id": 1, "do": "reset", "and": 2}"#, "unknown field `and`"),
            (r#"{"id": 1, "do": {"turn": [11, 0]}}"#, "`11` is too far"),
            (r#"{"id": 1, "do": {"turn": [1e999, 0]}}"#, "not a command"),
            (r#"{"id": 1, "do": {"zoom": 0}}"#, "`0` is too far"),
            (r#"{"id": 1, "do": {"zoom": -1}}"#, "`-1` is too far"),
            (r#"{"id": 1, "do": {"structures": []}}"#, "0 structures"),
            (r#"{"id": 1, "do": {"structures": ["a", "b", "c"]}}"#, "3 structures"),
            (r#"{"id": 1, "do": {"view": "colour"}}"#, "no view `colour`"),
        ] {
            let error = Numbered::read(text).unwrap_err().to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
