//! The structures of a world in bytes: those over its meshes, then the one over its objects. What they are over is the
//! scene's, and is saved elsewhere.

use std::io::{self, Read, Write};
use std::sync::Arc;
use std::time::Instant;

use glam::Vec3A;

use crate::accel::{
    Accel, Bounded as _, BuildStages, Decoder, Encoder, Indexed, IntoPrimitives as _, LoadError,
    Portable, PortablePrimitives as _, Primitives as _,
};
use crate::assets::MeshData;
use crate::scene::{ObjectList, ReadError, Scene};
use crate::shapes::{TriangleMesh, TriangleSet};

use super::{World, only_mesh};

impl<O: Portable, T: Portable> World<O, T> {
    /// Writes the structures, without what they are built over: of each mesh, then over the objects.
    pub(in crate::scene) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let out = &mut Encoder::new(out);
        out.u32(self.meshes.len() as u32)?;
        for mesh in &self.meshes {
            let triangles = mesh.primitives();
            let slots = 0..triangles.slots();
            let order: Vec<u32> = slots.map(|slot| triangles.id(slot)).collect();
            out.u32(triangles.count())?;
            out.vec3(triangles.mean_point().into())?;
            mesh.write_structure(&order, out)?;
            out.checksum()?;
        }
        out.u32(self.objects.primitives().count())?;
        self.objects.write_structure(&self.objects.primitives().ids(), out)?;
        out.checksum()
    }

    /// Reads what [`write`](Self::write) has written for the same scene, from so many bytes. They are
    /// checked, so that whatever they are, what is read gives the hits of the scene.
    pub(in crate::scene) fn read(
        scene: &Scene,
        input: &mut dyn Read,
        size: u64,
    ) -> Result<Self, ReadError> {
        let start = Instant::now();
        let input = &mut Decoder::of_size(input, size);
        let mut meshes = Vec::with_capacity(scene.meshes().len());
        let count = input.u32().map_err(ReadError::of_objects)?;
        if count as usize != scene.meshes().len() {
            let other = LoadError::invalid(format!("it is of {count} meshes"));
            return Err(ReadError::of_objects(other));
        }
        for (place, mesh) in scene.meshes().iter().enumerate() {
            let read =
                read_mesh(mesh, input).map_err(|source| ReadError::of_mesh(place, source))?;
            meshes.push(Arc::new(read));
        }
        let objects = read_objects(scene, &meshes, input).map_err(ReadError::of_objects)?;
        let only_mesh = only_mesh(scene).map(|mesh| Arc::clone(&meshes[mesh]));
        let mut stages = BuildStages::default();
        stages.add("reading", start.elapsed());
        Ok(Self { objects, meshes, only_mesh, build_time: start.elapsed(), stages })
    }
}

fn read_mesh<T: Portable>(
    mesh: &MeshData,
    input: &mut Decoder<'_>,
) -> Result<Indexed<TriangleSet, T>, LoadError> {
    let count = input.u32()?;
    let mean_vertex = Vec3A::from(input.vec3()?);
    let triangles = TriangleMesh::try_new(&mesh.positions, &mesh.triangles)
        .map_err(|error| LoadError::invalid(error.to_string()))?;
    if count != triangles.count() || mean_vertex != triangles.mean_point() {
        return Err(LoadError::invalid(format!("it is of {count} triangles, or of others")));
    }
    let arrange = |order: &[u32]| Ok(triangles.into_primitives(Some(order)));
    let read = Indexed::read_structure(count, arrange, input)?;
    input.checksum()?;
    Ok(read)
}

fn read_objects<O: Portable, T: Accel>(
    scene: &Scene,
    meshes: &[Arc<Indexed<TriangleSet, T>>],
    input: &mut Decoder<'_>,
) -> Result<Indexed<ObjectList<T>, O>, LoadError> {
    let count = input.u32()?;
    if count as usize != scene.objects.len() {
        return Err(LoadError::invalid(format!("it is of {count} objects")));
    }
    let arrange = |order: &[u32]| {
        ObjectList::in_order(scene, meshes, order)
            .ok_or_else(|| LoadError::invalid("a transform has no inverse"))
    };
    let read = Indexed::read_structure(count, arrange, input)?;
    input.checksum()?;
    Ok(read)
}
