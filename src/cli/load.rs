//! A scene from its file: read, parsed, its meshes loaded, compiled; or the errors in it.

use std::path::{Path, PathBuf};

use super::source::{self, SourceError};
use super::terminal::{print_error, print_message};
use super::{diagnose, terminal};
use crate::assets::{available_memory, load_meshes};
use crate::description::SceneDescription;
use crate::scene::Scene;
use crate::scene_file::{Diagnostic, ParseOptions, parse, render_diagnostics, summarize};

/// A scene that can be traced.
pub(crate) struct Loaded {
    /// The scene as written.
    pub(crate) description: SceneDescription,
    /// The scene as traced.
    pub(crate) scene: Scene,
    /// Warnings, as text without a last line end; empty if there are none.
    pub(crate) warnings: String,
}

/// Why there is no scene.
#[derive(Debug, thiserror::Error)]
pub(crate) enum LoadError {
    /// The file cannot be read.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// The scene is wrong.
    #[error("{} is not a valid scene: {summary}", source::quoted(path))]
    Invalid {
        /// As typed.
        path: PathBuf,
        /// All that is wrong with it, without a last line end.
        text: String,
        /// How much that is.
        summary: String,
    },
}

/// Loads a scene with its meshes, on the threads of the current rayon pool.
pub(crate) fn load(path: &Path, lenient: bool) -> Result<Loaded, LoadError> {
    let source = source::read(path)?;
    match compile(&source, path, lenient) {
        Ok((description, scene, warnings)) => {
            Ok(Loaded { description, scene, warnings: text(&warnings, &source, path) })
        }
        Err(diagnostics) => Err(LoadError::Invalid {
            path: path.to_owned(),
            text: text(&diagnostics, &source, path),
            summary: summarize(&diagnostics),
        }),
    }
}

/// Prints why there is no scene: all that is wrong with it, then how much that is.
pub(crate) fn print_load_error(error: &LoadError) {
    if let LoadError::Invalid { text, .. } = error {
        print_message(format_args!("{text}\n"));
    }
    print_error(error);
}

/// The scene as written and as traced, and its warnings; or all that is wrong with it.
fn compile(
    source: &str,
    path: &Path,
    lenient: bool,
) -> Result<(SceneDescription, Scene, Vec<Diagnostic>), Vec<Diagnostic>> {
    let parsed = parse(source, &ParseOptions { lenient, memory: available_memory() })?;
    let (description, mut warnings) = (parsed.description, parsed.warnings);
    let meshes = match load_meshes(&description.meshes, folder_of(path)) {
        Ok(meshes) => meshes,
        Err(errors) => {
            warnings.extend(errors.iter().map(|error| diagnose::mesh(error, &description)));
            return Err(in_order(warnings));
        }
    };
    warnings.extend(diagnose::dropped(&description, &meshes));
    let compiled = Scene::new(&description, meshes);
    match compiled {
        Ok(scene) => {
            warnings.extend(diagnose::eye_in_the_dark(&description));
            Ok((description, scene, in_order(warnings)))
        }
        Err(errors) => {
            warnings.extend(errors.iter().map(|error| diagnose::scene(error, &description)));
            Err(in_order(warnings))
        }
    }
}

/// The folder that the scene's mesh paths are relative to: the working folder for a scene from
/// standard input.
fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// In the order of the scene's text; those of one place stay in their order.
fn in_order(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.sort_by_key(|diagnostic| diagnostic.span.start);
    diagnostics
}

fn text(diagnostics: &[Diagnostic], text_of_scene: &str, path: &Path) -> String {
    let name = source::name(path);
    let mut text = render_diagnostics(diagnostics, text_of_scene, &name, terminal::colors());
    text.truncate(text.trim_end().len());
    text
}
