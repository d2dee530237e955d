//! [obvhs](https://github.com/DGriffin91/obvhs) 0.4 as it is shipped: its own traversal and its own triangles, where
//! `bvh` and `cwbvh` take its trees alone.
//!
//! Both trees are built by its `medium_build` preset on all threads. `ray_traverse` takes the nearer child first and
//! passes the best distance on; `ray_traverse_miss` ends at the first triangle. Triangles are its `RtTriangle`, stored
//! in the order of the leaves, as its examples do.

use std::error::Error;
use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::{Bvh2, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::{self, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;

use super::{Found, Triangles};
use crate::accel::Answers;
use crate::math::Ray;
use crate::scene::foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

/// Triangles with one of the library's trees.
struct Indexed<T> {
    triangles: Triangles,
    tree: T,
    /// In the order of the leaves.
    packed: Vec<RtTriangle>,
}

/// obvhs's binary tree.
pub(in crate::scene) struct ObvhsBvh2(Indexed<Bvh2>);

/// obvhs's compressed tree of eight children.
pub(in crate::scene) struct ObvhsCwBvh(Indexed<CwBvh>);

/// What both trees offer.
trait Tree {
    fn order(&self) -> &[u32];
    fn closest(
        &self,
        ray: ray::Ray,
        hit: &mut RayHit,
        test: impl FnMut(&ray::Ray, usize) -> f32,
    ) -> bool;
    fn misses(&self, ray: ray::Ray, test: impl FnMut(&ray::Ray, usize) -> f32) -> bool;
}

macro_rules! tree {
    ($tree:ty) => {
        impl Tree for $tree {
            fn order(&self) -> &[u32] {
                &self.primitive_indices
            }

            fn closest(
                &self,
                ray: ray::Ray,
                hit: &mut RayHit,
                test: impl FnMut(&ray::Ray, usize) -> f32,
            ) -> bool {
                self.ray_traverse(ray, hit, test)
            }

            fn misses(&self, ray: ray::Ray, test: impl FnMut(&ray::Ray, usize) -> f32) -> bool {
                self.ray_traverse_miss(ray, test)
            }
        }
    };
}

tree!(Bvh2);
tree!(CwBvh);

impl<T: Tree> Indexed<T> {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        build: impl FnOnce(&[Triangle]) -> T,
    ) -> Self {
        let triangles = Triangles::of(objects);
        let triangle = |corners: &[glam::Vec3; 3]| {
            let [v0, v1, v2] = corners.map(Vec3A::from);
            Triangle { v0, v1, v2 }
        };
        let own: Vec<Triangle> = triangles.corners.iter().map(triangle).collect();
        let tree = build(&own);
        let packed = tree.order().iter().map(|&n| RtTriangle::from(&own[n as usize])).collect();
        Self { triangles, tree, packed }
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        let prepared = |ray: &Ray| {
            ray::Ray::new(Vec3A::from(ray.origin), Vec3A::from(ray.dir), ray.t_min, ray.end())
        };
        let test = |ray: &ray::Ray, place: usize| self.packed[place].intersect(ray);
        let closest = |ray: &Ray| {
            let mut hit = RayHit::none();
            let found = !self.packed.is_empty() && self.tree.closest(prepared(ray), &mut hit, test);
            let place = || self.tree.order()[hit.primitive_id as usize];
            found.then(|| Found { place: place(), t: hit.t })
        };
        let any = |ray: &Ray| !self.packed.is_empty() && !self.tree.misses(prepared(ray), test);
        self.triangles.answer(rays, answers, closest, any);
    }

    fn bytes(&self, nodes: usize) -> ForeignBytes {
        ForeignBytes {
            index: (nodes + size_of_val(self.tree.order())) as u64,
            triangles: size_of_val(&self.packed[..]) as u64 + self.triangles.bytes(),
        }
    }
}

impl ForeignTracer for ObvhsBvh2 {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        _: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let preset = BvhBuildParams::medium_build();
        let build = |own: &[Triangle]| build_bvh2_from_tris(own, preset, &mut Duration::default());
        Ok(Self(Indexed::build(objects, build)))
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        self.0.trace(rays, answers);
    }

    fn bytes(&self) -> ForeignBytes {
        self.0.bytes(size_of_val(&self.0.tree.nodes[..]))
    }
}

impl ForeignTracer for ObvhsCwBvh {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        _: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let preset = BvhBuildParams::medium_build();
        let build = |own: &[Triangle]| build_cwbvh_from_tris(own, preset, &mut Duration::default());
        Ok(Self(Indexed::build(objects, build)))
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        self.0.trace(rays, answers);
    }

    fn bytes(&self) -> ForeignBytes {
        self.0.bytes(size_of_val(&self.0.tree.nodes[..]))
    }
}
