//! The meshes of a built scene: each one's lists as they are in memory.

use std::io;
use std::sync::Arc;

use glam::Vec3;
use rayon::prelude::*;

use super::BuiltFileError;
use crate::accel::{Decoder, Encoder, LoadError};
use crate::assets::MeshData;

/// What stands for the list of normals' indices where it is that of the triangles.
const SAME: u32 = u32::MAX;

/// Writes a length of 32 bits.
pub(super) fn write_length(length: usize, out: &mut Encoder<'_>) -> io::Result<()> {
    let too_long = |_| io::Error::other(format!("{length} elements are too many for a file"));
    out.u32(u32::try_from(length).map_err(too_long)?)
}

pub(super) fn write(meshes: &[Arc<MeshData>], out: &mut Encoder<'_>) -> io::Result<()> {
    write_length(meshes.len(), out)?;
    for (place, mesh) in meshes.iter().enumerate() {
        // A mesh that was there before is named by its place.
        let first = meshes[..place].iter().position(|other| Arc::ptr_eq(other, mesh));
        write_length(first.unwrap_or(place), out)?;
        if first.is_none() {
            write_mesh(mesh, out)?;
        }
    }
    out.checksum()
}

fn write_mesh(mesh: &MeshData, out: &mut Encoder<'_>) -> io::Result<()> {
    let MeshData { positions, triangles, normals, normal_indices, dropped } = mesh;
    let is_same = normal_indices == triangles;
    write_length(positions.len(), out)?;
    write_length(triangles.len(), out)?;
    write_length(normals.len(), out)?;
    write_length(if is_same { SAME as usize } else { normal_indices.len() }, out)?;
    write_length(*dropped, out)?;
    out.checksum()?;
    for vectors in [positions, normals] {
        out.list(vectors, |vector| vector.to_array().map(f32::to_bits))?;
    }
    out.list(triangles, |&triangle| triangle)?;
    if !is_same {
        out.list(normal_indices, |&triangle| triangle)?;
    }
    out.checksum()
}

/// Reads all meshes; what is wrong with one is an error with its number.
pub(super) fn read(input: &mut Decoder<'_>) -> Result<Vec<Arc<MeshData>>, BuiltFileError> {
    let in_list = |source| BuiltFileError::part("the list of meshes", source);
    let count = input.u32().map_err(in_list)? as usize;
    let mut meshes: Vec<Arc<MeshData>> = Vec::new();
    for place in 0..count {
        let first = input.u32().map_err(in_list)? as usize;
        let mesh =
            match meshes.get(first) {
                Some(mesh) => Arc::clone(mesh),
                None if first == place => Arc::new(read_mesh(input).map_err(|source| {
                    BuiltFileError::part(format!("mesh {}", place + 1), source)
                })?),
                None => {
                    return Err(in_list(LoadError::invalid(format!("there is no mesh {first}"))));
                }
            };
        meshes.push(mesh);
    }
    input.checksum().map_err(in_list)?;
    Ok(meshes)
}

fn read_mesh(input: &mut Decoder<'_>) -> Result<MeshData, LoadError> {
    let mut lengths = [0; 5];
    for length in &mut lengths {
        *length = input.u32()?;
    }
    input.checksum()?;
    let [positions, triangles, normals, normal_indices, dropped] = lengths;
    let vector = |words: [u32; 3]| Vec3::from_array(words.map(f32::from_bits));
    let positions = input.list(positions, "vertices", vector)?;
    let normals = input.list(normals, "normals", vector)?;
    let triangles = input.list(triangles, "triangles", |triangle: [u32; 3]| triangle)?;
    let normal_indices = match normal_indices {
        SAME => triangles.clone(),
        length => input.list(length, "indices of normals", |triangle: [u32; 3]| triangle)?,
    };
    input.checksum()?;
    let mesh =
        MeshData { positions, triangles, normals, normal_indices, dropped: dropped as usize };
    match fault(&mesh) {
        Some(what) => Err(LoadError::invalid(what)),
        None => Ok(mesh),
    }
}

/// What a mesh has that none should have.
fn fault(mesh: &MeshData) -> Option<&'static str> {
    let MeshData { positions, triangles, normals, normal_indices, dropped: _ } = mesh;
    let are_within = |list: &[[u32; 3]], length: usize| {
        list.par_iter().with_min_len(1 << 12).all(|indices| {
            let [a, b, c] = *indices;
            (a.max(b).max(c) as usize) < length
        })
    };
    let are_finite =
        |list: &[Vec3]| list.par_iter().with_min_len(1 << 12).all(|vector| vector.is_finite());
    if triangles.is_empty() || triangles.len() != normal_indices.len() {
        Some("it has no triangles, or other indices of normals")
    } else if !are_within(triangles, positions.len()) {
        Some("a triangle has a vertex that is not there")
    } else if !are_within(normal_indices, normals.len()) {
        Some("a triangle has a normal that is not there")
    } else if !are_finite(positions) || !are_finite(normals) {
        Some("a vertex or a normal is not finite")
    } else {
        None
    }
}
