//! [parry3d](https://parry.rs) 0.31: the collision library of the Rapier engine.
//!
//! Its `TriMesh` is used as documented: built by its own binned builder, on one thread (it has no other), searched by
//! best first for the closest triangle. `CompositeShapeRef` is that search with the triangle's number, which a hit
//! needs. Whether a ray is blocked is asked by `intersects_local_ray`. Its rays have no smallest parameter, so they
//! begin where they count. Its tree under this project's walk and formula is `accel/builder/parry.rs`.

use std::error::Error;

use parry3d::math::Vector;
use parry3d::query::{self, RayCast};
use parry3d::shape::{CompositeShapeRef, TriMesh};

use super::{Found, Triangles, from_start};
use crate::accel::Answers;
use crate::math::Ray;
use crate::scene::foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

/// Triangles in parry's mesh; none if there are no triangles, which it refuses.
pub(in crate::scene) struct Parry {
    triangles: Triangles,
    mesh: Option<TriMesh>,
}

impl ForeignTracer for Parry {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        _: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let triangles = Triangles::of(objects);
        let vector = |corner: &glam::Vec3| Vector::from_array(corner.to_array());
        let vertices = triangles.corners.as_flattened().iter().map(vector).collect();
        let indices: Vec<[u32; 3]> =
            (0..triangles.corners.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        let mesh = match indices.is_empty() {
            true => None,
            false => Some(TriMesh::new(vertices, indices)?),
        };
        Ok(Self { triangles, mesh })
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        let prepared = |ray: &Ray| {
            let (origin, length) = from_start(ray);
            let vector = |v: glam::Vec3| Vector::from_array(v.to_array());
            (query::Ray::new(vector(origin), vector(ray.dir)), length)
        };
        let closest = |ray: &Ray| {
            let (own, length) = prepared(ray);
            let mesh = CompositeShapeRef(self.mesh.as_ref()?);
            let (place, t) = mesh.cast_local_ray(&own, length, false)?;
            Some(Found { place, t: t + ray.t_min })
        };
        let any = |ray: &Ray| {
            let (own, length) = prepared(ray);
            self.mesh.as_ref().is_some_and(|mesh| mesh.intersects_local_ray(&own, length))
        };
        self.triangles.answer(rays, answers, closest, any);
    }

    fn bytes(&self) -> ForeignBytes {
        let (index, all) = self
            .mesh
            .as_ref()
            .map_or((0, 0), |mesh| (mesh.bvh().total_memory_size(), mesh.total_memory_size()));
        ForeignBytes {
            index: index as u64,
            triangles: all.saturating_sub(index) as u64 + self.triangles.bytes(),
        }
    }
}
