//! The table of commands: one file a group, each with its rows and what they do.
//!
//! The parser and its messages read this table. To add a command, add a row to the file of its
//! group. The order is that of the format's description.

pub(super) mod camera;
mod deformation;
mod lights;
mod material;
mod motion;
mod objects;
mod options;
mod structure;
mod transform;

use super::action::Row;
use super::command::SceneCommand;

/// Commands that belong together.
pub(super) struct CommandGroup {
    pub(super) name: &'static str,
    pub(super) rows: &'static [Row],
}

/// All commands.
pub(super) const GROUPS: [CommandGroup; 9] = [
    CommandGroup { name: "camera", rows: camera::ROWS },
    CommandGroup { name: "options", rows: options::ROWS },
    CommandGroup { name: "structure", rows: structure::ROWS },
    CommandGroup { name: "material", rows: material::ROWS },
    CommandGroup { name: "transform", rows: transform::ROWS },
    CommandGroup { name: "deforming", rows: deformation::ROWS },
    CommandGroup { name: "motion", rows: motion::ROWS },
    CommandGroup { name: "objects", rows: objects::ROWS },
    CommandGroup { name: "lights", rows: lights::ROWS },
];

/// Every command, in the order of the format's description.
pub fn commands() -> impl Iterator<Item = &'static SceneCommand> {
    rows().map(|row| &row.command)
}

/// Every row of the table.
pub(super) fn rows() -> impl Iterator<Item = &'static Row> {
    GROUPS.iter().flat_map(|group| group.rows)
}

/// The row with a keyword.
pub(super) fn find(keyword: &str) -> Option<&'static Row> {
    rows().find(|row| row.command.keyword == keyword)
}

/// Whether a word is a keyword.
pub(super) fn is_keyword(word: &str) -> bool {
    find(word).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene_file::command::ValueKind;

    #[test]
    fn keywords_are_different_and_examples_are_of_their_command() {
        let all: Vec<_> = commands().collect();
        for (i, command) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|c| c.keyword != command.keyword));
            let words: Vec<_> = command.example.split_whitespace().collect();
            assert_eq!(words[0], command.keyword);
            match command.values.last().map(|value| value.kind) {
                Some(ValueKind::Command) => {
                    let inner = find(words[command.values.len()]).expect("it is a command");
                    let after = words.len() - 1 - command.values.len();
                    assert_eq!(after, inner.command.values.len(), "{}", command.example);
                }
                _ => assert_eq!(words.len() - 1, command.values.len(), "{}", command.example),
            }
            assert!(command.also_called.iter().all(|word| !is_keyword(word)));
        }
    }
}
