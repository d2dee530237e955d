//! A scene from its file: read, parsed, its meshes loaded, compiled; or the errors in it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::source::{self, Built, Rest, Source, SourceError};
use super::terminal::{print_error, print_message};
use super::{diagnose, fingerprint, terminal};
use crate::assets::{
    AssetError, LoadedMeshes, MeshData, MeshFiles, MeshLoader, Problem, available_memory,
    check_meshes,
};
use crate::built_file::BuiltFileError;
use crate::description::{MeshReference, SceneDescription, Shape};
use crate::scene::Scene;
use crate::scene_file::{
    Diagnostic, Invalid, ParseOptions, Parsed, parse_to_meshes, render_diagnostics, summarize,
};
use crate::sealed::Hash;

/// A scene that can be traced.
pub(crate) struct Loaded {
    /// The text of the scene's file.
    pub(crate) text: String,
    /// The frame that it was read for.
    pub(crate) frame: u32,
    /// The scene as traced.
    pub(crate) scene: Scene,
    /// Warnings, as text without a last line end; empty if there are none.
    pub(crate) warnings: String,
    /// The files of meshes that were read for it.
    pub(crate) mesh_files: Vec<PathBuf>,
    /// The structure that was built over it, if it is from a built scene.
    pub(crate) built: Option<SavedStructure>,
}

/// The same, with the scene as written.
pub(crate) struct Described {
    /// What can be traced.
    pub(crate) loaded: Loaded,
    /// The first and the last frame of all keys, if the scene moves.
    pub(crate) keyed_frames: Option<[f64; 2]>,
    /// The scene as written.
    pub(crate) description: SceneDescription,
}

/// A structure that was built over a scene and can be read.
#[derive(Clone, Debug)]
pub(crate) struct SavedStructure {
    /// The file, as typed.
    pub(crate) path: PathBuf,
    /// The structure, with its options.
    pub(crate) structure: String,
    /// The quality of its build.
    pub(crate) quality: String,
    /// The hash that files of parts have of the scene in this frame, if it is written down.
    pub(crate) hash: Option<Hash>,
    /// Where it is.
    pub(crate) bytes: Rest,
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
        let mut meshes = MeshLoader::default();
        let source = source::read(path, &mut meshes)?;
        Ok(Self { source, path: path.to_owned(), lenient, colors: terminal::colors(), meshes })
    }

    /// The same, for what is no terminal.
    pub(crate) fn without_colors(self) -> Self {
        Self { colors: false, ..self }
    }

    /// What was read.
    pub(crate) fn source(&self) -> &Source {
        &self.source
    }

    /// The scene in a frame, on the threads of the current rayon pool. One that was built is read as it was compiled;
    /// what it was warned of is not said again.
    pub(crate) fn frame(&mut self, frame: u32) -> Result<Loaded, LoadError> {
        match self.source.built() {
            None => Ok(self.described(frame)?.loaded),
            Some(built) => self.compiled(built, frame),
        }
    }

    fn compiled(&self, built: &Built, frame: u32) -> Result<Loaded, LoadError> {
        self.expect_frame(frame)?;
        let Built { scene: built, rest } = built;
        let mut bytes = rest.clone();
        let size = bytes.size();
        let scene = Scene::read(built.meshes.clone(), &mut bytes, size).map_err(|source| {
            let source = BuiltFileError::part("the compiled scene", source);
            SourceError::Built { path: self.path.clone(), source }
        })?;
        Ok(Loaded {
            text: self.source.text().into_owned(),
            frame,
            scene,
            warnings: String::new(),
            mesh_files: Vec::new(),
            built: Some(SavedStructure {
                path: self.path.clone(),
                structure: built.structure.clone(),
                quality: built.quality.clone(),
                hash: (built.frame == frame).then_some(built.hash),
                bytes,
            }),
        })
    }

    /// A built scene that moves is that of one frame.
    fn expect_frame(&self, asked: u32) -> Result<(), SourceError> {
        match self.source.built() {
            Some(Built { scene, .. }) if scene.moves && scene.frame != asked => {
                let (path, built) = (self.path.clone(), scene.frame);
                Err(SourceError::Frame { path, built, asked })
            }
            _ => Ok(()),
        }
    }

    /// The scene in a frame with its meshes, parsed and compiled on the threads of the current rayon pool.
    pub(crate) fn described(&mut self, frame: u32) -> Result<Described, LoadError> {
        self.expect_frame(frame)?;
        let written = self.source.text();
        let memory = available_memory();
        let built = self.source.built();
        let lenient = self.lenient || built.is_some_and(|built| built.scene.lenient);
        let options = ParseOptions { lenient, memory, frame };
        let say =
            |diagnostics: &[Diagnostic]| text(diagnostics, &written, &self.source, self.colors);
        let meshes = match built {
            Some(built) => Meshes::Built(&built.scene.meshes),
            None => Meshes::Files(self.source.files(), &mut self.meshes),
        };
        match compile(&written, meshes, &options) {
            Ok((parsed, scene)) => {
                let warnings = say(&parsed.warnings);
                let mesh_files = self.source.paths(fingerprint::files(&parsed.description));
                let text = written.into_owned();
                Ok(Described {
                    loaded: Loaded { text, frame, scene, warnings, mesh_files, built: None },
                    keyed_frames: parsed.keyed_frames,
                    description: parsed.description,
                })
            }
            Err(Uncompiled { diagnostics, meshes }) => Err(LoadError::Invalid {
                path: self.path.clone(),
                meshes,
                text: say(&diagnostics),
                summary: summarize(&diagnostics),
            }),
        }
    }

    /// The scene in the frame that it was built for, or in the first.
    pub(crate) fn usual_frame(&mut self) -> Result<Described, LoadError> {
        self.described(self.built_frame().unwrap_or(0))
    }

    /// The frame that it was built for, if it was.
    pub(crate) fn built_frame(&self) -> Option<u32> {
        self.source.built().map(|built| built.scene.frame)
    }
}

/// Loads a scene with its meshes, on the threads of the current rayon pool: as it is in its first frame, or in that for
/// which it was built.
pub(crate) fn load(path: &Path, lenient: bool) -> Result<Described, LoadError> {
    SceneFile::read(path, lenient)?.usual_frame()
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

/// Where the meshes of a scene are.
enum Meshes<'a> {
    Files(MeshFiles<'a>, &'a mut MeshLoader),
    /// In memory, in the order in which the scene names them.
    Built(&'a [Arc<MeshData>]),
}

impl Meshes<'_> {
    fn check(&self, references: &[MeshReference]) -> Vec<AssetError> {
        match self {
            Self::Files(files, _) => check_meshes(references, *files),
            Self::Built(_) => Vec::new(),
        }
    }

    fn load(self, references: &[MeshReference]) -> LoadedMeshes {
        match self {
            Self::Files(files, loader) => loader.load_each(references, files),
            Self::Built(meshes) => {
                let built = |place: usize| meshes.get(place).cloned();
                let missing = (meshes.len()..references.len()).map(|reference| AssetError {
                    reference,
                    problem: Problem::Missing { path: references[reference].name.clone().into() },
                    place: None,
                    help: Some("the built scene is of another text: build it again".to_owned()),
                });
                let meshes = (0..references.len()).map(built).collect();
                LoadedMeshes { meshes, errors: missing.collect() }
            }
        }
    }
}

/// The scene as written, with all warnings, and as traced; or all that is wrong with it.
fn compile(
    source: &str,
    meshes: Meshes<'_>,
    options: &ParseOptions,
) -> Result<(Parsed, Scene), Uncompiled> {
    let parsed = parse_to_meshes(source, options).map_err(|invalid| {
        let Invalid { mut diagnostics, meshes: references } = invalid;
        let errors = meshes.check(&references);
        let meshes = references;
        diagnostics.extend(errors.iter().map(|error| diagnose::mesh(error, &meshes)));
        Uncompiled { diagnostics: in_order(diagnostics), meshes }
    })?;
    let Parsed { mut description, keyed_frames, warnings: mut diagnostics } = parsed;
    let LoadedMeshes { meshes, errors } = meshes.load(&description.meshes);
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
