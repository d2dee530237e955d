//! What a command does, and its row in the table: the command and its action.

use super::builder::SceneBuilder;
use super::command::SceneCommand;
use super::values::Values;

/// A row of the table of commands.
pub(super) struct Row {
    pub(super) command: SceneCommand,
    pub(super) action: Action,
}

/// What a command does.
#[derive(Clone, Copy)]
pub(super) enum Action {
    /// Acts on the scene.
    Scene(SceneAction),
    /// Gives another command values at a frame.
    Key(KeyPlace),
    /// Begins lines that are carried out several times: its value is how often.
    Repeat,
    /// Ends the lines of the innermost `Repeat`.
    EndRepeat,
    /// Ends the scene.
    End,
}

/// Where a key stands among those of its command.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum KeyPlace {
    First,
    Later,
}

/// What a command does to the scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneAction {
    /// What it adds, if its values are right.
    pub(super) adds: Addition,
    /// Whether its values may depend on the frame.
    pub(super) is_keyed: bool,
    pub(super) apply: fn(&mut SceneBuilder, &Values<'_>),
}

/// What a command adds to the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Addition {
    Nothing,
    Object,
    /// As many objects as its value says.
    Scattered,
    Light,
}

/// Changes the camera, the options, or what is in force.
pub(super) const fn change(apply: fn(&mut SceneBuilder, &Values<'_>)) -> Action {
    Action::Scene(SceneAction { adds: Addition::Nothing, is_keyed: true, apply })
}

/// Changes the same in every frame.
pub(super) const fn change_always(apply: fn(&mut SceneBuilder, &Values<'_>)) -> Action {
    Action::Scene(SceneAction { adds: Addition::Nothing, is_keyed: false, apply })
}

/// Adds an object.
pub(super) const fn add_object(apply: fn(&mut SceneBuilder, &Values<'_>)) -> Action {
    Action::Scene(SceneAction { adds: Addition::Object, is_keyed: true, apply })
}

/// Adds as many objects as its value says.
pub(super) const fn add_scattered(apply: fn(&mut SceneBuilder, &Values<'_>)) -> Action {
    Action::Scene(SceneAction { adds: Addition::Scattered, is_keyed: false, apply })
}

/// Adds a light.
pub(super) const fn add_light(apply: fn(&mut SceneBuilder, &Values<'_>)) -> Action {
    Action::Scene(SceneAction { adds: Addition::Light, is_keyed: true, apply })
}
