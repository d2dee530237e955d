//! Wavefront OBJ text → a mesh, through tobj.
//!
//! tobj reads what it is given fast, but some valid files not as they are meant and some invalid
//! ones without complaint: a corner without normal takes that of the corner before, index 0 counts
//! as none, lines (`l`) become triangles, groups part vertices that faces share, remarks behind
//! values and vertices with and without colours are refused, huge normal indices overflow. So it
//! reads through [`Faithful`], which passes on only the lines that matter, in words that tobj
//! understands as they are meant, and stops at the first face that is wrong. What tobj itself
//! refuses, [`explain`] finds the line of.
//!
//! Read: `v` (with w, or with colours that are ignored), `vn`, `f` with polygons of any number of
//! corners (as fans, so they should be convex) and negative indices. Everything else is passed over.

mod corner;
mod explain;
mod faithful;
mod lines;

use glam::Vec3;

use super::MeshData;
use explain::explain;
use faithful::Faithful;

/// A line that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fault {
    /// Its number, from 1.
    pub(super) line: usize,
    /// Itself.
    pub(super) text: String,
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
    let mut lines = Faithful::new(text);
    let loaded = tobj::load_obj_buf(
        &mut lines,
        &tobj::LoadOptions { triangulate: true, ..Default::default() },
        |_| Err(tobj::LoadError::OpenFileFailed), // materials are never asked for
    );
    if let Some(fault) = lines.into_fault() {
        return Err(fault);
    }
    let (models, _) = loaded.map_err(|error| explain(text, &error.to_string()))?;
    // One model or none: the lines that would part them never reach tobj.
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
