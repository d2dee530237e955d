//! A scene from its file, from standard input, from a pack with all that it names, or built; or a mesh in its place.

use std::borrow::Cow;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::Vec3A;

use super::mesh_scene::{MOST_REACH, NamedMesh};
use super::origin::program;
use crate::assets::{
    FileReader, MeshFiles, MeshLoader, begins_as_obj, expect_memory, other_format, read_file,
    read_stream,
};
use crate::built_file::{BuiltFileError, BuiltScene};
use crate::description::MeshReference;
use crate::math::Aabb;
use crate::pack::{Located, Pack, PackError};

/// Why a scene's text cannot be read.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SourceError {
    /// The system's error.
    #[error("cannot read the scene {}: {source}", quoted(path))]
    Io {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// An archive that is no pack, or no longer one.
    #[error("cannot read the pack {}: {source}", quoted(path))]
    Pack {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: PackError,
    },
    /// A built scene that is none, or no longer one.
    #[error("cannot read the built scene {}: {source}", quoted(path))]
    Built {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: BuiltFileError,
    },
    /// A mesh in a format that is not read, in the place of a scene.
    #[error(
        "{} looks like {format}: it is no scene, and meshes are read as Wavefront OBJ: convert it",
        quoted(path)
    )]
    OtherFormat {
        /// As typed.
        path: PathBuf,
        /// What it looks like.
        format: &'static str,
    },
    /// A mesh from standard input, or from a file that is not called as meshes are.
    #[error(
        "{} looks like a mesh, a Wavefront OBJ file: a mesh is taken for a scene from a file alone, with a name \
         that ends with `.obj` and has no quote in it, as `bunny.obj`",
        quoted(path)
    )]
    Unnamed {
        /// As typed.
        path: PathBuf,
    },
    /// A mesh in the place of a scene that reaches too far for its camera and its lights.
    #[error(
        "the mesh {} reaches to coordinates of {reach:e}, and in the place of a scene {MOST_REACH:e} is the most: \
         scale it down",
        quoted(path)
    )]
    TooFar {
        /// As typed.
        path: PathBuf,
        /// Its largest coordinate.
        reach: f32,
    },
    /// A built scene that moves, in another frame than that for which it was built.
    #[error(
        "{} was built for frame {built}, not for frame {asked}: build it for that frame too",
        quoted(path)
    )]
    Frame {
        /// As typed.
        path: PathBuf,
        /// For which it was built.
        built: u32,
        /// Which is wanted.
        asked: u32,
    },
}

/// A scene and where the files are that it names.
pub(crate) struct Source {
    path: PathBuf,
    from: From,
}

enum From {
    /// The bytes of a scene that stands by itself, or that was made around a mesh.
    Scene(Vec<u8>),
    Pack(Pack),
    Built(Built),
}

/// A built scene, and where its structure follows.
pub(crate) struct Built {
    /// All but the structure.
    pub(crate) scene: BuiltScene,
    /// What is behind it.
    pub(crate) rest: Rest,
}

/// Bytes that are read on from a place.
#[derive(Clone, Debug)]
pub(crate) enum Rest {
    File(FileReader),
    Bytes(Cursor<Arc<[u8]>>),
}

impl Rest {
    /// How many bytes there are, at most.
    pub(crate) fn size(&self) -> u64 {
        match self {
            Self::File(file) => file.size(),
            Self::Bytes(bytes) => bytes.get_ref().len() as u64,
        }
    }
}

impl Read for Rest {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.read(bytes),
            Self::Bytes(own) => own.read(bytes),
        }
    }

    fn read_exact(&mut self, bytes: &mut [u8]) -> io::Result<()> {
        match self {
            Self::File(file) => file.read_exact(bytes),
            Self::Bytes(own) => own.read_exact(bytes),
        }
    }
}

/// Reads a scene, a pack or a built scene from its file, or from standard input if the path is `-`. Of a mesh the scene
/// is made around it, once `meshes` has loaded it.
pub(crate) fn read(path: &Path, meshes: &mut MeshLoader) -> Result<Source, SourceError> {
    if let Some(mesh) = NamedMesh::of(path) {
        let text = around_mesh(mesh, path, meshes)?;
        return Ok(Source { path: path.to_owned(), from: From::Scene(text.into_bytes()) });
    }
    if !is_stdin(path)
        && let Some(file) = begun_as_built(path)
    {
        return built(path, Rest::File(file));
    }
    let read = if is_stdin(path) { read_stream(io::stdin().lock()) } else { read_file(path) };
    let path = path.to_owned();
    match read {
        Ok(bytes) if Pack::is_archive(&bytes) => match Pack::read(bytes) {
            Ok(pack) => Ok(Source { path, from: From::Pack(pack) }),
            Err(source) => Err(SourceError::Pack { path, source }),
        },
        Ok(bytes) if BuiltScene::begins(&bytes) => {
            built(&path, Rest::Bytes(Cursor::new(bytes.into())))
        }
        Ok(bytes) => match other_format(&path, &bytes) {
            Some(format) => Err(SourceError::OtherFormat { path, format }),
            None if begins_as_obj(&bytes) => Err(SourceError::Unnamed { path }),
            None => Ok(Source { path, from: From::Scene(bytes) }),
        },
        Err(source) => Err(SourceError::Io { path, source }),
    }
}

/// The scene around a mesh. What is wrong with the mesh is found when the scene is compiled.
fn around_mesh(
    mesh: NamedMesh<'_>,
    path: &Path,
    meshes: &mut MeshLoader,
) -> Result<String, SourceError> {
    let loaded = meshes.load_each(&[MeshReference::new(mesh.name())], folder_of(path));
    let bounds = loaded.meshes.into_iter().flatten().next().map(|mesh| mesh.bounds());
    let some = bounds.filter(|bounds| bounds.min.cmple(bounds.max).all());
    let bounds = some.unwrap_or(Aabb { min: Vec3A::NEG_ONE, max: Vec3A::ONE });
    mesh.scene(&bounds).ok_or_else(|| {
        let reach = bounds.largest_coordinate();
        SourceError::TooFar { path: path.to_owned(), reach }
    })
}

/// A regular file at its beginning, if that is the one of a built scene.
fn begun_as_built(path: &Path) -> Option<FileReader> {
    let file = FileReader::open(path).ok()??;
    let mut begin = [0; 8];
    file.clone().read_exact(&mut begin).ok()?;
    BuiltScene::begins(&begin).then_some(file)
}

fn built(path: &Path, mut rest: Rest) -> Result<Source, SourceError> {
    let path = path.to_owned();
    let size = rest.size();
    // The meshes take about what they take in the file; what is behind them is not read yet.
    if let Err(shortage) = expect_memory(size) {
        let source = io::Error::new(io::ErrorKind::OutOfMemory, shortage);
        return Err(SourceError::Io { path, source });
    }
    match BuiltScene::read(&program(), &mut rest, size) {
        Ok(scene) => Ok(Source { path, from: From::Built(Built { scene, rest }) }),
        Err(source) => Err(SourceError::Built { path, source }),
    }
}

impl SourceError {
    /// Whether the file can be read, and what is in it is no valid scene.
    pub(crate) fn is_of_contents(&self) -> bool {
        matches!(self, Self::OtherFormat { .. } | Self::Unnamed { .. } | Self::TooFar { .. })
    }
}

impl Source {
    /// The scene as it was in its file.
    pub(crate) fn bytes(&self) -> &[u8] {
        match &self.from {
            From::Scene(bytes) => bytes,
            From::Pack(pack) => pack.scene().1,
            From::Built(built) => &built.scene.text,
        }
    }

    /// What was built, if it was.
    pub(crate) fn built(&self) -> Option<&Built> {
        if let From::Built(built) = &self.from { Some(built) } else { None }
    }

    /// The scene's text. Remarks in it may have any encoding: what is no UTF-8 is replaced.
    pub(crate) fn text(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(self.bytes())
    }

    /// The name of the scene in messages about its text.
    pub(crate) fn name(&self) -> String {
        match &self.from {
            From::Scene(_) if NamedMesh::of(&self.path).is_some() => {
                format!("the scene around {}", name(&self.path))
            }
            From::Scene(_) | From::Built(_) => name(&self.path),
            From::Pack(pack) => name(&self.path.join(pack.scene().0)),
        }
    }

    /// Where the meshes are that it names.
    pub(crate) fn files(&self) -> MeshFiles<'_> {
        match &self.from {
            From::Scene(_) | From::Built(_) => MeshFiles::Folder(folder_of(&self.path)),
            From::Pack(pack) => MeshFiles::Pack(pack, &self.path),
        }
    }

    /// The paths of the files that it names, if they stand by themselves.
    pub(crate) fn paths<'a>(&self, names: impl Iterator<Item = &'a str>) -> Vec<PathBuf> {
        let From::Scene(_) = &self.from else { return Vec::new() };
        let folder = folder_of(&self.path);
        names.map(|name| folder.join(name)).collect()
    }

    /// What the scene and these files are called in the pack that they are from, if they are from one.
    pub(crate) fn located(&self, names: &[&str]) -> Option<Located> {
        let From::Pack(pack) = &self.from else { return None };
        let files: Option<Vec<String>> = names.iter().map(|name| pack.member(name)).collect();
        Some(Located { scene: pack.scene().0.to_owned(), files: files? })
    }

    /// The contents of a file that the scene names.
    pub(crate) fn file(&self, name: &str) -> io::Result<Cow<'_, [u8]>> {
        match &self.from {
            From::Scene(_) => read_file(&folder_of(&self.path).join(name)).map(Cow::Owned),
            From::Built(_) => Err(io::ErrorKind::NotFound.into()),
            From::Pack(pack) => {
                pack.file(name).map(Cow::Borrowed).ok_or_else(|| io::ErrorKind::NotFound.into())
            }
        }
    }
}

/// Whether a path means standard input.
pub(crate) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// The name of a file in messages.
pub(crate) fn name(path: &Path) -> String {
    if is_stdin(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// The same, between backquotes if it was typed.
pub(crate) fn quoted(path: &Path) -> String {
    if is_stdin(path) { name(path) } else { format!("`{}`", name(path)) }
}

/// The folder that the scene's mesh paths are relative to: the working folder for a scene from
/// standard input.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}
