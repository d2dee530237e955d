//! The commands of the camera. Every one of them is required; the last one of each counts.

use std::collections::HashSet;

use glam::DVec3;

use crate::description::{Camera, Span};
use crate::scene_file::action::{Row, change};
use crate::scene_file::builder::SceneBuilder;
use crate::scene_file::command::{SceneCommand, ValueKind, XYZ, value};
use crate::scene_file::diagnostic::Diagnostic;
use crate::scene_file::values::Values;

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "eyepos",
            values: XYZ,
            summary: "the eye",
            example: "eyepos 0 -5 1.5",
            also_called: &["eye", "camera", "lookfrom"],
        },
        action: change(|scene, values| scene.camera().set_eye(values.vector(0))),
    },
    Row {
        command: SceneCommand {
            keyword: "eyedir",
            values: XYZ,
            summary: "the direction of view, of any length",
            example: "eyedir 0 1 -0.2",
            also_called: &["lookat"],
        },
        action: change(direction),
    },
    Row {
        command: SceneCommand {
            keyword: "eyeup",
            values: XYZ,
            summary: "what is up in the picture, of any length, not parallel to eyedir",
            example: "eyeup 0 0 1",
            also_called: &["up", "sky"],
        },
        action: change(up),
    },
    Row {
        command: SceneCommand {
            keyword: "wdist",
            values: &[value("distance", ValueKind::Positive)],
            summary: "the distance from the eye to the image plane",
            example: "wdist 1",
            also_called: &[],
        },
        action: change(|scene, values| scene.camera().set_distance(values.number(0))),
    },
    Row {
        command: SceneCommand {
            keyword: "fovy_deg",
            values: &[value("angle", ValueKind::FieldOfView)],
            summary: "the full vertical field of view in degrees",
            example: "fovy_deg 40",
            also_called: &["fov", "fovx_deg", "angle"],
        },
        action: change(|scene, values| scene.camera().set_field_of_view(values.number(0))),
    },
    Row {
        command: SceneCommand {
            keyword: "nx",
            values: &[value("width", ValueKind::Whole(1, Camera::MAX_SIDE))],
            summary: "the width of the picture in pixels",
            example: "nx 600",
            also_called: &["width"],
        },
        action: change(|scene, values| scene.camera().set_width(values.whole(0))),
    },
    Row {
        command: SceneCommand {
            keyword: "ny",
            values: &[value("height", ValueKind::Whole(1, Camera::MAX_SIDE))],
            summary: "the height of the picture in pixels",
            example: "ny 400",
            also_called: &["height"],
        },
        action: change(|scene, values| scene.camera().set_height(values.whole(0))),
    },
];

fn direction(scene: &mut SceneBuilder, values: &Values<'_>) {
    if let Some(direction) = nonzero_vector(scene, values, "the direction of view") {
        scene.camera().set_direction(direction, values.span());
    }
}

fn up(scene: &mut SceneBuilder, values: &Values<'_>) {
    if let Some(up) = nonzero_vector(scene, values, "the direction of up") {
        scene.camera().set_up(up, values.span());
    }
}

/// The vector of a command, if it has a direction; reported otherwise.
fn nonzero_vector(scene: &mut SceneBuilder, values: &Values<'_>, what: &str) -> Option<DVec3> {
    let vector = values.nonzero_vector(0);
    if vector.is_none() {
        scene.report(
            Diagnostic::error(values.span_of(0, 2), format!("{what} must not be the zero vector"))
                .with_label("this points nowhere")
                .with_help("it may have any length but 0"),
        );
    }
    vector
}

/// Whether a word is the keyword of one of these commands.
pub(in crate::scene_file) fn is_keyword(word: &str) -> bool {
    ROWS.iter().any(|row| row.command.keyword == word)
}

/// What is wrong if the camera lacks commands: those that are not among the ones that a scene,
/// which ends at `end`, has written.
pub(in crate::scene_file) fn missing(
    written: &HashSet<&'static str>,
    end: &Span,
) -> Option<Diagnostic> {
    let commands = ROWS.iter().map(|row| &row.command);
    let missing: Vec<_> = commands.filter(|c| !written.contains(c.keyword)).collect();
    let names: Vec<_> = missing.iter().map(|c| format!("`{}`", c.keyword)).collect();
    let examples: Vec<_> =
        missing.iter().map(|c| format!("    {:<18}# {}", c.example, c.summary)).collect();
    let label = match missing.len() {
        0 => return None,
        1 => "the scene ends here without it",
        _ => "the scene ends here without them",
    };
    let error = Diagnostic::error(end.clone(), format!("the camera lacks {}", names.join(", ")));
    Some(error.with_label(label).with_help(format!("add, for example\n{}", examples.join("\n"))))
}
