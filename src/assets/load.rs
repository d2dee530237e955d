//! The meshes that a scene names, each read or generated once.

use std::collections::HashMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use super::deform::{BYTES_OF_TRIANGLE, deform};
use super::generate::{Recipe, generate};
use super::{
    AssetError, FileLine, MemoryShortage, MeshData, Problem, expect_memory, obj, read_file,
};
use crate::description::MeshReference;
use crate::pack::Pack;

/// Where the files are that a scene names.
#[derive(Clone, Copy, Debug)]
pub enum MeshFiles<'a> {
    /// Their paths are relative to this folder, which is the scene's.
    Folder(&'a Path),
    /// In a pack; errors call them by its path and theirs in it.
    Pack(&'a Pack, &'a Path),
}

impl<'a> From<&'a Path> for MeshFiles<'a> {
    fn from(folder: &'a Path) -> Self {
        Self::Folder(folder)
    }
}

/// Loads the meshes of a scene: the i-th of the result is that of the i-th reference.
///
/// Names of the same file, or of the same generated mesh, share one mesh. Any file is read as a
/// Wavefront OBJ, whatever its extension; names that start with `generate:` are [recipes](Recipe).
///
/// ```
/// use srt::{assets::load_meshes, description::MeshReference};
///
/// let knot = MeshReference::new("generate:torus-knot:5000");
/// let missing = MeshReference::new("missing.obj");
/// let folder = std::path::Path::new("scenes");
/// assert_eq!(load_meshes(std::slice::from_ref(&knot), folder).unwrap().len(), 1);
/// assert_eq!(load_meshes(&[knot, missing], folder).unwrap_err()[0].reference, 1);
/// ```
///
/// # Errors
/// One for every mesh that cannot be loaded, at the first reference to it, in the order of the
/// references.
pub fn load_meshes<'a>(
    references: &[MeshReference],
    files: impl Into<MeshFiles<'a>>,
) -> Result<Vec<Arc<MeshData>>, Vec<AssetError>> {
    let LoadedMeshes { meshes, errors } = load_each_mesh(references, files);
    if errors.is_empty() { Ok(meshes.into_iter().flatten().collect()) } else { Err(errors) }
}

/// What came of the meshes of a scene.
#[derive(Clone, Debug, Default)]
pub struct LoadedMeshes {
    /// That of each reference; `None` where it cannot be loaded.
    pub meshes: Vec<Option<Arc<MeshData>>>,
    /// One for every mesh that cannot be loaded, at the first reference to it.
    pub errors: Vec<AssetError>,
}

/// Loads the meshes of a scene as [`load_meshes`] does, and keeps those that can be loaded beside the
/// errors of the others.
#[must_use]
pub fn load_each_mesh<'a>(
    references: &[MeshReference],
    files: impl Into<MeshFiles<'a>>,
) -> LoadedMeshes {
    MeshLoader::default().load_each(references, files)
}

/// Loads the meshes of one frame of a scene after the other. What was loaded once is kept: files are not read again,
/// nothing is generated again, and meshes that are not deformed are the same in memory.
#[derive(Debug, Default)]
pub struct MeshLoader {
    loaded: HashMap<Key, Arc<MeshData>>,
}

impl MeshLoader {
    /// As [`load_each_mesh`].
    pub fn load_each<'a>(
        &mut self,
        references: &[MeshReference],
        files: impl Into<MeshFiles<'a>>,
    ) -> LoadedMeshes {
        let load = |source: &Source<'_>| match self.loaded.get(&source.key()) {
            Some(mesh) => Ok((source.key(), Arc::clone(mesh))),
            None => source.load().map(|mesh| (source.key(), Arc::new(mesh))),
        };
        let bytes = |source: &Source<'_>| {
            if self.loaded.contains_key(&source.key()) { 0 } else { source.bytes() }
        };
        let (loaded, mut errors) = each(references, files.into(), bytes, load);
        let mut keep = |(key, mesh): (Key, Arc<MeshData>)| {
            self.loaded.insert(key, Arc::clone(&mesh));
            mesh
        };
        let undeformed = loaded.into_iter().map(|mesh| mesh.map(&mut keep)).collect();
        let (meshes, deformed) = deform_each(references, undeformed);
        errors.extend(deformed);
        errors.sort_by_key(|error| error.reference);
        LoadedMeshes { meshes, errors }
    }
}

/// Deforms the meshes that are to be, each once in each way.
fn deform_each(
    references: &[MeshReference],
    mut meshes: Vec<Option<Arc<MeshData>>>,
) -> (Vec<Option<Arc<MeshData>>>, Vec<AssetError>) {
    let mut slots = HashMap::new();
    let mut distinct = Vec::new();
    let mut slot_of = Vec::new();
    for (reference, mesh) in meshes.iter().enumerate() {
        let deformation = &references[reference].deformation;
        let Some(mesh) = mesh.as_ref().filter(|_| !deformation.is_none()) else { continue };
        let slot = *slots.entry((Arc::as_ptr(mesh), deformation.key())).or_insert_with(|| {
            distinct.push((reference, Arc::clone(mesh)));
            distinct.len() - 1
        });
        slot_of.push((reference, slot));
    }
    let mut needed = 0u64;
    let shortages: Vec<_> = distinct
        .iter()
        .map(|(_, mesh)| {
            needed = needed.saturating_add(BYTES_OF_TRIANGLE * mesh.triangles.len() as u64);
            expect_memory(needed).err()
        })
        .collect();
    let act = |(&(reference, ref mesh), shortage): (&(usize, Arc<MeshData>), _)| {
        let MeshReference { name, deformation, .. } = &references[reference];
        if let Some(shortage) = shortage {
            let failure = too_large(name.clone(), shortage);
            return Err(Box::new(failure.for_reference(reference)));
        }
        deform(mesh, deformation).map(Arc::new).ok_or_else(|| {
            let (name, deformation) = (name.clone(), format!("`{deformation}`"));
            let problem = Problem::Deformed { name, deformation };
            let failure = LoadFailure::new(problem, Some("deform it less".to_owned()));
            Box::new(failure.for_reference(reference))
        })
    };
    let done: Vec<_> = distinct.par_iter().zip(shortages).map(act).collect();
    for (reference, slot) in slot_of {
        meshes[reference] = done[slot].as_ref().ok().cloned();
    }
    let errors = done.into_iter().filter_map(Result::err).map(|error| *error);
    (meshes, errors.collect())
}

/// What is wrong with the meshes of a scene that will not be traced: its files are read and forgotten,
/// and nothing is generated, since only the name of a generated mesh, and its size, can be wrong.
#[must_use]
pub fn check_meshes<'a>(
    references: &[MeshReference],
    files: impl Into<MeshFiles<'a>>,
) -> Vec<AssetError> {
    each(references, files.into(), |source| source.bytes(), |source| source.check()).1
}

/// Does something with each mesh once: what came of each reference, and the errors, at the first
/// reference to a mesh.
fn each<T: Clone + Send + Sync>(
    references: &[MeshReference],
    files: MeshFiles<'_>,
    bytes: impl Fn(&Source<'_>) -> u64,
    act: impl Fn(&Source<'_>) -> Result<T, Box<LoadFailure>> + Sync,
) -> (Vec<Option<T>>, Vec<AssetError>) {
    let sources: Vec<_> = references.iter().map(|r| Source::of(&r.name, files)).collect();
    let mut slots = HashMap::new();
    let mut distinct = Vec::new();
    let slot_of: Vec<usize> = sources
        .iter()
        .enumerate()
        .map(|(reference, source)| {
            *slots.entry(source.key()).or_insert_with(|| {
                distinct.push((reference, source));
                distinct.len() - 1
            })
        })
        .collect();
    let act =
        |(&(reference, source), shortage): (&(usize, &Source<'_>), Option<MemoryShortage>)| {
            let done = match shortage {
                Some(shortage) => Err(source.too_large(shortage)),
                None => act(source),
            };
            done.map_err(|failure| Box::new(failure.for_reference(reference)))
        };
    let done: Vec<_> = distinct.par_iter().zip(shortages(&distinct, bytes)).map(act).collect();
    let results = slot_of.into_iter().map(|slot| done[slot].as_ref().ok().cloned()).collect();
    (results, done.into_iter().filter_map(|done| done.err().map(|error| *error)).collect())
}

/// For each source, whether it and those before it take more memory than there is.
fn shortages(
    sources: &[(usize, &Source<'_>)],
    bytes: impl Fn(&Source<'_>) -> u64,
) -> Vec<Option<MemoryShortage>> {
    let mut needed = 0u64;
    let shortage = |(_, source): &(usize, &Source<'_>)| {
        let own = bytes(source);
        needed = needed.saturating_add(own);
        // What takes nothing is not at fault.
        if own == 0 { None } else { expect_memory(needed).err() }
    };
    sources.iter().map(shortage).collect()
}

/// Where a mesh comes from.
enum Source<'a> {
    /// A file: its path as written, and the one that all names of the file share.
    File { path: PathBuf, canonical: PathBuf },
    /// A file in a pack: what errors call it, and its contents.
    Packed { path: PathBuf, contents: &'a [u8] },
    /// A generated mesh.
    Recipe(Recipe),
    /// There is none.
    Nothing { name: String, failure: Box<LoadFailure> },
}

/// What makes two sources one.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Key {
    File(PathBuf),
    Recipe(Recipe),
    Nothing(String),
}

/// An [`AssetError`] without its reference.
#[derive(Clone)]
struct LoadFailure {
    problem: Problem,
    place: Option<FileLine>,
    help: Option<String>,
}

impl LoadFailure {
    fn new(problem: Problem, help: Option<String>) -> Box<Self> {
        Box::new(Self { problem, place: None, help })
    }

    fn for_reference(self, reference: usize) -> AssetError {
        AssetError { reference, problem: self.problem, place: self.place, help: self.help }
    }
}

impl<'a> Source<'a> {
    fn of(name: &str, files: MeshFiles<'a>) -> Self {
        let found = match Recipe::parse(name) {
            Some(recipe) => recipe.map(Self::Recipe).map_err(|error| {
                let help = error.help();
                LoadFailure::new(error.into(), Some(help))
            }),
            None => match files {
                MeshFiles::Folder(folder) => find_file(folder.join(name)),
                MeshFiles::Pack(pack, path) => find_packed(pack, path, name),
            },
        };
        found.unwrap_or_else(|failure| Self::Nothing { name: name.to_owned(), failure })
    }

    fn key(&self) -> Key {
        match self {
            Self::File { canonical: path, .. } | Self::Packed { path, .. } => {
                Key::File(path.clone())
            }
            Self::Recipe(recipe) => Key::Recipe(*recipe),
            Self::Nothing { name, .. } => Key::Nothing(name.clone()),
        }
    }

    /// What it takes to make the mesh in memory, roughly.
    fn bytes(&self) -> u64 {
        /// The text, and about as much again for what is read from it.
        const OF_FILE: u64 = 2;
        match self {
            Self::File { path, .. } => {
                let is_file = |metadata: &fs::Metadata| metadata.is_file();
                fs::metadata(path).ok().filter(is_file).map_or(0, |file| OF_FILE * file.len())
            }
            Self::Packed { contents, .. } => OF_FILE * contents.len() as u64,
            Self::Recipe(recipe) => recipe.bytes(),
            Self::Nothing { .. } => 0,
        }
    }

    fn too_large(&self, shortage: MemoryShortage) -> Box<LoadFailure> {
        let name = match self {
            Self::File { path, .. } | Self::Packed { path, .. } => path.display().to_string(),
            Self::Recipe(recipe) => recipe.to_string(),
            Self::Nothing { name, .. } => name.clone(),
        };
        too_large(name, shortage)
    }

    fn load(&self) -> Result<MeshData, Box<LoadFailure>> {
        match self {
            Self::File { path, .. } => read_mesh(path),
            Self::Packed { path, contents } => mesh_of_bytes(contents.to_vec(), path),
            Self::Recipe(recipe) => Ok(generate(recipe.kind, recipe.triangles, recipe.seed)),
            Self::Nothing { failure, .. } => Err(failure.clone()),
        }
    }

    /// Whether the mesh can be loaded.
    fn check(&self) -> Result<(), Box<LoadFailure>> {
        match self {
            Self::Recipe(_) => Ok(()),
            Self::File { .. } | Self::Packed { .. } | Self::Nothing { .. } => self.load().map(drop),
        }
    }
}

fn too_large(name: String, shortage: MemoryShortage) -> Box<LoadFailure> {
    let help = "use a mesh of fewer triangles, or let the program use more memory".to_owned();
    LoadFailure::new(Problem::NoMemory { name, shortage }, Some(help))
}

fn find_packed<'a>(
    pack: &'a Pack,
    path: &Path,
    name: &str,
) -> Result<Source<'a>, Box<LoadFailure>> {
    let path = path.join(pack.member(name).unwrap_or_else(|| name.to_owned()));
    match pack.file(name) {
        Some(contents) => Ok(Source::Packed { path, contents }),
        None => {
            let help = "the pack is of another version of the scene: pack it again".to_owned();
            Err(LoadFailure::new(Problem::Missing { path }, Some(help)))
        }
    }
}

fn find_file(path: PathBuf) -> Result<Source<'static>, Box<LoadFailure>> {
    let canonical = fs::canonicalize(&path).map_err(|error| match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => {
            let help = similar_name(&path);
            LoadFailure::new(Problem::Missing { path: path.clone() }, Some(help))
        }
        _ => unreadable(&path, &error),
    })?;
    if canonical.is_dir() {
        let help = "name the .obj file in it".to_owned();
        return Err(LoadFailure::new(Problem::Directory { path }, Some(help)));
    }
    Ok(Source::File { path, canonical })
}

fn unreadable(path: &Path, error: &std::io::Error) -> Box<LoadFailure> {
    let reason = error.to_string();
    LoadFailure::new(Problem::Unreadable { path: path.to_owned(), reason }, None)
}

/// Suggests the file in the folder of a missing one whose name is most like it, if one is.
fn similar_name(path: &Path) -> String {
    let wanted = path.file_name().map(|n| n.to_string_lossy().to_lowercase()).unwrap_or_default();
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = fs::read_dir(folder) else {
        return format!("there is no folder `{}` either", folder.display());
    };
    let mut names: Vec<String> = entries
        .flatten()
        .filter(|entry| entry.path().is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort(); // the order of a folder is not the same everywhere
    let similarity = |name: &String| strsim::jaro_winkler(&name.to_lowercase(), &wanted);
    let best = names.iter().max_by(|a, b| similarity(a).total_cmp(&similarity(b)));
    match best.filter(|name| similarity(name) > 0.8) {
        Some(name) => format!("did you mean `{name}`?"),
        None => "mesh paths are relative to the folder of the scene file".to_owned(),
    }
}

/// The mesh in the bytes of a Wavefront OBJ file, which errors call by `path`. Reads no file.
///
/// ```
/// use srt::assets::read_obj;
///
/// let name = std::path::Path::new("corner.obj");
/// let mesh = read_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec(), name).unwrap();
/// assert_eq!(mesh.triangles, [[0, 1, 2]]);
/// let error = read_obj(b"v 0 0 0\nf 1 2 3\n".to_vec(), name).unwrap_err();
/// assert_eq!(error.place.unwrap().line, 2);
/// ```
///
/// # Errors
/// As of [`load_meshes`], of the only reference.
pub fn read_obj(bytes: Vec<u8>, path: &Path) -> Result<MeshData, Box<AssetError>> {
    mesh_of_bytes(bytes, path).map_err(|failure| Box::new(failure.for_reference(0)))
}

fn read_mesh(path: &Path) -> Result<MeshData, Box<LoadFailure>> {
    let bytes = read_file(path).map_err(|error| unreadable(path, &error))?;
    mesh_of_bytes(bytes, path)
}

fn mesh_of_bytes(bytes: Vec<u8>, path: &Path) -> Result<MeshData, Box<LoadFailure>> {
    if let Some(format) = other_format(path, &bytes) {
        let help = "meshes are read as Wavefront OBJ: convert it".to_owned();
        return Err(LoadFailure::new(
            Problem::OtherFormat { path: path.to_owned(), format },
            Some(help),
        ));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = first_bad_line(error.as_bytes(), error.utf8_error().valid_up_to());
        Box::new(LoadFailure {
            problem: Problem::NotText { path: path.to_owned() },
            place: Some(FileLine { path: path.to_owned(), ..line }),
            help: Some("a mesh file is Wavefront OBJ, in UTF-8".to_owned()),
        })
    })?;
    let mesh = obj::read(&text).map_err(|fault| {
        let problem = Problem::Malformed { path: path.to_owned(), what: fault.what };
        let place = FileLine {
            path: path.to_owned(),
            line: fault.line,
            text: fault.text,
            wrong: fault.wrong,
        };
        Box::new(LoadFailure { problem, place: Some(place), help: Some(fault.help) })
    })?;
    if !mesh.triangles.is_empty() {
        return Ok(mesh);
    }
    let path = path.to_owned();
    let (problem, help) = match mesh.dropped {
        0 => (
            Problem::NoFaces { path, empty: text.trim().is_empty() },
            "a mesh is a Wavefront OBJ file: `v x y z` lines, then `f a b c` lines",
        ),
        dropped => (
            Problem::OnlyDegenerate { path, dropped },
            "the corners of each face lie on one line, or in one point, in single precision: \
             look at the vertices that the faces name, and at the digits they are written with",
        ),
    };
    Err(LoadFailure::new(problem, Some(help.to_owned())))
}

/// What a file that is no OBJ is, where it begins like one of the common other formats. Binary STL
/// begins with anything, but states its length.
fn other_format(path: &Path, bytes: &[u8]) -> Option<&'static str> {
    let is_stl = || {
        let named = path.extension().is_some_and(|name| name.eq_ignore_ascii_case("stl"));
        let count = bytes.get(80..84)?.first_chunk().copied().map(u32::from_le_bytes)?;
        Some(named && bytes.len() as u64 == 84 + 50 * u64::from(count))
    };
    match bytes {
        _ if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") => Some("PLY"),
        _ if bytes.starts_with(b"glTF") => Some("glTF"),
        _ if bytes.starts_with(b"solid ") || bytes.starts_with(b"solid\n") => Some("STL"),
        _ if is_stl() == Some(true) => Some("STL"),
        _ => None,
    }
}

/// The line that contains the byte at `offset`, up to that byte; the path is left empty.
fn first_bad_line(bytes: &[u8], offset: usize) -> FileLine {
    let line = 1 + bytes[..offset].iter().filter(|&&b| b == b'\n').count();
    let start = bytes[..offset].iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
    let mut text: String =
        String::from_utf8_lossy(&bytes[start..offset]).chars().take(200).collect();
    // In a longer line the byte is not shown.
    let wrong = (text.len() == offset - start).then(|| {
        text.push(char::REPLACEMENT_CHARACTER);
        offset - start..text.len()
    });
    FileLine { path: PathBuf::new(), line, text, wrong }
}

#[cfg(test)]
mod tests;
