//! Where a mesh comes from: a file, a pack, or a recipe.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::error::LoadFailure;
use super::generate::{Recipe, generate};
use super::mesh_file::{mesh_of_bytes, read_mesh};
use super::{MemoryShortage, MeshData, Problem};
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

/// Where a mesh comes from.
pub(super) enum Source<'a> {
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
pub(super) enum Key {
    File(PathBuf),
    Recipe(Recipe),
    Nothing(String),
}

impl<'a> Source<'a> {
    pub(super) fn of(name: &str, files: MeshFiles<'a>) -> Self {
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

    pub(super) fn key(&self) -> Key {
        match self {
            Self::File { canonical: path, .. } | Self::Packed { path, .. } => {
                Key::File(path.clone())
            }
            Self::Recipe(recipe) => Key::Recipe(*recipe),
            Self::Nothing { name, .. } => Key::Nothing(name.clone()),
        }
    }

    /// What it takes to make the mesh in memory, roughly.
    pub(super) fn bytes(&self) -> u64 {
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

    pub(super) fn too_large(&self, shortage: MemoryShortage) -> Box<LoadFailure> {
        let name = match self {
            Self::File { path, .. } | Self::Packed { path, .. } => path.display().to_string(),
            Self::Recipe(recipe) => recipe.to_string(),
            Self::Nothing { name, .. } => name.clone(),
        };
        LoadFailure::too_large(name, shortage)
    }

    pub(super) fn load(&self) -> Result<MeshData, Box<LoadFailure>> {
        match self {
            Self::File { path, .. } => read_mesh(path),
            Self::Packed { path, contents } => mesh_of_bytes(contents.to_vec(), path),
            Self::Recipe(recipe) => Ok(generate(recipe.kind, recipe.triangles, recipe.seed)),
            Self::Nothing { failure, .. } => Err(failure.clone()),
        }
    }

    /// Whether the mesh can be loaded.
    pub(super) fn check(&self) -> Result<(), Box<LoadFailure>> {
        match self {
            Self::Recipe(_) => Ok(()),
            Self::File { .. } | Self::Packed { .. } | Self::Nothing { .. } => self.load().map(drop),
        }
    }
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
        _ => LoadFailure::unreadable(&path, &error),
    })?;
    if canonical.is_dir() {
        let help = "name the .obj file in it".to_owned();
        return Err(LoadFailure::new(Problem::Directory { path }, Some(help)));
    }
    Ok(Source::File { path, canonical })
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
