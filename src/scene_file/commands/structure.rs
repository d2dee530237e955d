//! The commands that structure a scene: they save and restore material and transform, repeat lines,
//! and end the scene.

use crate::scene_file::action::{Action, Row, change};
use crate::scene_file::command::{SceneCommand, ValueKind, value};
use crate::scene_file::repeat::MOST_ENTITIES;

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "{",
            values: &[],
            summary: "saves the material and the transform",
            example: "{",
            also_called: &[],
        },
        action: change(|scene, values| scene.open_brace(values.keyword())),
    },
    Row {
        command: SceneCommand {
            keyword: "}",
            values: &[],
            summary: "restores the material and the transform",
            example: "}",
            also_called: &[],
        },
        action: change(|scene, values| scene.close_brace(&values.keyword())),
    },
    Row {
        command: SceneCommand {
            keyword: "push_matrix",
            values: &[],
            summary: "saves the transform",
            example: "push_matrix",
            also_called: &["push"],
        },
        action: change(|scene, values| scene.push_matrix(values.keyword())),
    },
    Row {
        command: SceneCommand {
            keyword: "pop_matrix",
            values: &[],
            summary: "restores the transform",
            example: "pop_matrix",
            also_called: &["pop"],
        },
        action: change(|scene, values| scene.pop_matrix(&values.keyword())),
    },
    Row {
        command: SceneCommand {
            keyword: "repeat",
            values: &[value("count", ValueKind::Whole(1, MOST_ENTITIES))],
            summary: "carries out the lines up to its end_repeat so many times; the transform carries \
                      over from one iteration to the next",
            example: "repeat 1000",
            also_called: &["for", "loop", "times"],
        },
        action: Action::Repeat,
    },
    Row {
        command: SceneCommand {
            keyword: "end_repeat",
            values: &[],
            summary: "ends the lines of the innermost repeat",
            example: "end_repeat",
            also_called: &["endrepeat", "end_for", "end_loop"],
        },
        action: Action::EndRepeat,
    },
    Row {
        command: SceneCommand {
            keyword: "end",
            values: &[],
            summary: "ends the scene; what follows is not read",
            example: "end",
            also_called: &["quit", "exit"],
        },
        action: Action::End,
    },
];
