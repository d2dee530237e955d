//! The commands of motion: keys of other commands' values, and the clock that they are read by.
//!
//! Which values lie between two keys is for `keys`, and the lines of keys are joined by the parser.

use crate::scene_file::action::{Action, KeyPlace, Row, change_always};
use crate::scene_file::command::{SceneCommand, Value, ValueKind, number, value};

/// A frame, and the command that has its values then.
const KEY: &[Value] = &[number("frame"), value("command", ValueKind::Command)];

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "at",
            values: KEY,
            summary: "a command with its values at a frame; lines with `to` go on with it",
            example: "at 0 rotate 0 0 0 1",
            also_called: &["key", "keyframe"],
        },
        action: Action::Key(KeyPlace::First),
    },
    Row {
        command: SceneCommand {
            keyword: "to",
            values: KEY,
            summary: "the values of the command of the line before at a later frame, evenly reached",
            example: "to 30 rotate 90 0 0 1",
            also_called: &["then", "until"],
        },
        action: Action::Key(KeyPlace::Later),
    },
    Row {
        command: SceneCommand {
            keyword: "delay",
            values: &[number("frames")],
            summary: "what follows moves so many frames later; delays add up",
            example: "delay 5",
            also_called: &["wait", "shift", "offset"],
        },
        action: change_always(|scene, values| scene.delay(values.number(0))),
    },
    Row {
        command: SceneCommand {
            keyword: "every",
            values: &[value("frames", ValueKind::Positive)],
            summary: "what follows moves as in the first so many frames, again and again",
            example: "every 30",
            also_called: &["cycle", "period"],
        },
        action: change_always(|scene, values| scene.recur(values.number(0))),
    },
];
