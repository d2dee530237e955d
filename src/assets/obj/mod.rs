//! Wavefront OBJ text → a mesh, through tobj.
//!
//! tobj is fast, but misreads some valid files and accepts some invalid ones: a corner without normal
//! takes that of the corner before, index 0 counts as none, lines (`l`) become triangles, vertices
//! are not shared across groups, comments behind values and a mix of vertices with and without
//! colours are refused, huge normal indices overflow. So it reads from a [`TobjInput`], which passes
//! on only the lines that matter, in a form that tobj reads correctly, and stops at the first face
//! that is wrong. [`explain`] finds the line that tobj itself refuses.
//!
//! Read: `v` (with w, or with colours that are ignored), `vn`, `f` with polygons of any number of
//! corners (as fans, so they should be convex) and negative indices. Everything else is ignored.

mod corner;
mod explain;
mod lines;
mod tobj_input;

use std::ops::Range;

use glam::Vec3;

use super::MeshData;
use explain::explain;
use tobj_input::TobjInput;

/// A line that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fault {
    /// Its number, from 1.
    pub(super) line: usize,
    /// The line.
    pub(super) text: String,
    /// The word of it that is wrong, if it is one.
    pub(super) wrong: Option<Range<usize>>,
    /// What is wrong with it.
    pub(super) what: String,
    /// What would be right.
    pub(super) help: String,
}

/// The mesh in the text of an OBJ file; without triangles if the text has none.
///
/// Vertices and normals are numbered by first use; unused ones are left out. Corners without a
/// normal get one averaged from the faces around the vertex.
pub(super) fn read(text: &str) -> Result<MeshData, Fault> {
    let mut lines = TobjInput::new(text);
    let loaded = tobj::load_obj_buf(
        &mut lines,
        &tobj::LoadOptions { triangulate: true, ..Default::default() },
        |_| Err(tobj::LoadError::OpenFileFailed), // materials are never loaded
    );
    if let Some(fault) = lines.into_fault() {
        return Err(fault);
    }
    let (models, _) = loaded.map_err(|error| explain(text, &error.to_string()))?;
    // One model or none: lines that begin another model never reach tobj.
    let Some(model) = models.into_iter().next() else {
        return Ok(MeshData::default());
    };
    let mesh = model.mesh;
    let positions = vectors(&mesh.positions);
    if !positions.iter().all(|p| p.is_finite()) {
        return Err(explain(text, "a coordinate is not finite"));
    }
    Ok(if mesh.normals.is_empty() {
        MeshData::with_averaged_normals(positions, triples(&mesh.indices))
    } else {
        let (normals, corners) = (vectors(&mesh.normals), triples(&mesh.normal_indices));
        MeshData::with_normals(positions, triples(&mesh.indices), normals, corners)
    })
}

fn vectors(values: &[f32]) -> Vec<Vec3> {
    values.as_chunks().0.iter().copied().map(Vec3::from_array).collect()
}

fn triples(indices: &[u32]) -> Vec<[u32; 3]> {
    indices.as_chunks().0.to_vec()
}

#[cfg(test)]
mod tests;
