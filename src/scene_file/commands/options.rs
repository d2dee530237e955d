//! The commands of the rendering options. All have defaults; the last one of each counts.

use crate::description::Options;
use crate::scene_file::action::{Row, change};
use crate::scene_file::command::{RGB, SceneCommand, ValueKind, value};

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "max_recursion",
            values: &[value("bounces", ValueKind::Whole(0, Options::MAX_RECURSION))],
            summary: "how many mirror bounces a view ray may take; 1 by default",
            example: "max_recursion 4",
            also_called: &["maxdepth", "max_depth", "recursion"],
        },
        action: change(|scene, values| scene.options().max_recursion = values.whole(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "aasample",
            values: &[value("n", ValueKind::Whole(0, Options::MAX_AA))],
            summary: "n × n samples a pixel, or one ray through its centre for 0, the default",
            example: "aasample 4",
            also_called: &["samples"],
        },
        action: change(|scene, values| scene.options().aa = values.whole(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "background",
            values: RGB,
            summary: "what a ray that hits nothing sees; black by default",
            example: "background 0.5 0.7 1",
            also_called: &["bg"],
        },
        action: change(|scene, values| scene.options().background = values.color(0)),
    },
];
