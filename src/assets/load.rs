//! The meshes that a scene names, each read or generated once.

use std::collections::HashMap;
use std::sync::Arc;

use rayon::prelude::*;

use super::deform::{BYTES_OF_TRIANGLE, deform};
use super::error::LoadFailure;
use super::source::{Key, Source};
use super::{AssetError, MemoryShortage, MeshData, MeshFiles, Problem, expect_memory};
use crate::description::MeshReference;
use crate::parallel::values;

/// Loads the meshes of a scene: the i-th of the result is that of the i-th reference.
///
/// Names of the same file, or of the same generated mesh, share one mesh. Any file is read as a
/// Wavefront OBJ, whatever its extension; names that start with `generate:` are
/// [recipes](super::generate::Recipe).
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
            let failure = LoadFailure::too_large(name.clone(), shortage);
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
    let shortages = shortages(&distinct, bytes);
    let done = values(distinct.len(), &|place| {
        let (reference, source) = distinct[place];
        let done = match shortages[place] {
            Some(shortage) => Err(source.too_large(shortage)),
            None => act(source),
        };
        done.map_err(|failure| Box::new(failure.for_reference(reference)))
    });
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

#[cfg(test)]
mod tests;
