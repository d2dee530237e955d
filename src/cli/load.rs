//! A scene from its file: read, parsed, its meshes loaded, compiled; or the errors in it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::source::{self, Source, SourceError};
use super::terminal::{print_error, print_message};
use super::{diagnose, terminal};
use crate::assets::{
    LoadedMeshes, MeshData, MeshFiles, MeshLoader, available_memory, check_meshes,
};
use crate::description::{MeshReference, SceneDescription, Shape};
use crate::scene::Scene;
use crate::scene_file::{
    Diagnostic, Invalid, ParseOptions, Parsed, parse_to_meshes, render_diagnostics, summarize,
};

/// A scene that can be traced.
pub(crate) struct Loaded {
    /// The text of the scene's file.
    pub(crate) text: String,
    /// The frame that it was read for.
    pub(crate) frame: u32,
    /// The first and the last frame of all keys, if the scene moves.
    pub(crate) keyed_frames: Option<[f64; 2]>,
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
        /// The meshes that it names, as far as it can be read.
        meshes: Vec<MeshReference>,
        /// All that is wrong with it, without a last line end.
        text: String,
        /// How much that is.
        summary: String,
    },
}

/// A scene's file that was read, for one frame after the other.
pub(crate) struct SceneFile {
    source: Source,
    path: PathBuf,
    lenient: bool,
    /// Whether what is said of it has colours.
    colors: bool,
    meshes: MeshLoader,
}

impl SceneFile {
    /// Reads the file, or the pack.
    pub(crate) fn read(path: &Path, lenient: bool) -> Result<Self, LoadError> {
        let (source, path, colors) = (source::read(path)?, path.to_owned(), terminal::colors());
        Ok(Self { source, path, lenient, colors, meshes: MeshLoader::default() })
    }

    /// The same, for what is no terminal.
    pub(crate) fn without_colors(self) -> Self {
        Self { colors: false, ..self }
    }

    /// What was read.
    pub(crate) fn source(&self) -> &Source {
        &self.source
    }

    /// The scene in a frame with its meshes, loaded on the threads of the current rayon pool.
    pub(crate) fn frame(&mut self, frame: u32) -> Result<Loaded, LoadError> {
        let written = self.source.text();
        let memory = available_memory();
        let options = ParseOptions { lenient: self.lenient, memory, frame };
        let say =
            |diagnostics: &[Diagnostic]| text(diagnostics, &written, &self.source, self.colors);
        match compile(&written, self.source.files(), &options, &mut self.meshes) {
            Ok((parsed, scene)) => Ok(Loaded {
                warnings: say(&parsed.warnings),
                text: written.into_owned(),
                frame,
                keyed_frames: parsed.keyed_frames,
                description: parsed.description,
                scene,
            }),
            Err(Uncompiled { diagnostics, meshes }) => Err(LoadError::Invalid {
                path: self.path.clone(),
                meshes,
                text: say(&diagnostics),
                summary: summarize(&diagnostics),
            }),
        }
    }
}

/// Loads a scene with its meshes as it is in a frame, on the threads of the current rayon pool.
pub(crate) fn load(path: &Path, lenient: bool, frame: u32) -> Result<Loaded, LoadError> {
    SceneFile::read(path, lenient)?.frame(frame)
}

/// Prints why there is no scene: all that is wrong with it, then how much that is.
pub(crate) fn print_load_error(error: &LoadError) {
    if let LoadError::Invalid { text, .. } = error {
        print_message(format_args!("{text}\n"));
    }
    print_error(error);
}

/// All that is wrong with a scene, in the order of its text, and the meshes that it names.
struct Uncompiled {
    diagnostics: Vec<Diagnostic>,
    meshes: Vec<MeshReference>,
}

/// The scene as written, with all warnings, and as traced; or all that is wrong with it.
fn compile(
    source: &str,
    files: MeshFiles<'_>,
    options: &ParseOptions,
    loader: &mut MeshLoader,
) -> Result<(Parsed, Scene), Uncompiled> {
    let parsed = parse_to_meshes(source, options).map_err(|invalid| {
        let Invalid { mut diagnostics, meshes } = invalid;
        let errors = check_meshes(&meshes, files);
        diagnostics.extend(errors.iter().map(|error| diagnose::mesh(error, &meshes)));
        Uncompiled { diagnostics: in_order(diagnostics), meshes }
    })?;
    let Parsed { mut description, keyed_frames, warnings: mut diagnostics } = parsed;
    let LoadedMeshes { meshes, errors } = loader.load_each(&description.meshes, files);
    if !errors.is_empty() {
        let errors = errors.iter().map(|error| diagnose::mesh(error, &description.meshes));
        diagnostics.extend(errors);
        leave_out_what_has_no_mesh(&mut description, &meshes);
    }
    let complete = errors.is_empty();
    let meshes: Vec<_> = meshes.into_iter().map(Option::unwrap_or_default).collect();
    diagnostics.extend(diagnose::dropped(&description, &meshes));
    match Scene::new(&description, meshes) {
        Ok(scene) if complete => {
            diagnostics.extend(diagnose::eye_in_the_dark(&description));
            Ok((Parsed { description, keyed_frames, warnings: in_order(diagnostics) }, scene))
        }
        Ok(_) => Err(Uncompiled { diagnostics: in_order(diagnostics), meshes: description.meshes }),
        Err(errors) => {
            diagnostics.extend(errors.iter().map(|error| diagnose::scene(error, &description)));
            Err(Uncompiled { diagnostics: in_order(diagnostics), meshes: description.meshes })
        }
    }
}

/// Takes the objects away whose meshes could not be loaded, so that the others can be checked.
fn leave_out_what_has_no_mesh(
    description: &mut SceneDescription,
    meshes: &[Option<Arc<MeshData>>],
) {
    description.objects.retain(|object| match object.shape {
        Shape::Mesh { mesh, .. } => meshes[mesh].is_some(),
        Shape::Single(_) => true,
    });
}

/// In the order of the scene's text; those of one place stay in their order.
fn in_order(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.sort_by_key(|diagnostic| diagnostic.span.start);
    diagnostics
}

fn text(diagnostics: &[Diagnostic], text_of_scene: &str, source: &Source, colors: bool) -> String {
    let name = source.name();
    let mut text = render_diagnostics(diagnostics, text_of_scene, &name, colors);
    text.truncate(text.trim_end().len());
    text
}
