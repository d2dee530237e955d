//! [bvh](https://github.com/svenstaro/bvh) 0.13, by its author's name, since `bvh` is taken.
//!
//! A binary tree by the surface area heuristic, built on all threads by its `build_par`. The closest triangle is
//! searched by its iterator in the order of distance, which ends once a box begins beyond the best triangle; whether a
//! ray is blocked by its plain iterator, which is faster and ends at the first triangle. Triangles are tested by its
//! `intersects_triangle`, which takes front faces alone, so each is tested from both sides. That test misses triangles
//! whose determinant is below 1.2 × 10⁻⁷. Its rays have no smallest parameter, so they begin where they count.
//! Its tree under this project's walk and formula is `accel/builder/svenstaro.rs`.

use std::error::Error;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::Bvh;
use bvh::ray;
use nalgebra::{Point3, Vector3};

use super::{Found, Triangles, from_start};
use crate::accel::Answers;
use crate::math::Ray;
use crate::scene::foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

/// Triangles in a tree of the crate `bvh`.
pub(in crate::scene) struct Svenstaro {
    triangles: Triangles,
    shapes: Vec<Shape>,
    tree: Bvh<f32, 3>,
}

/// A triangle as the library stores it.
struct Shape {
    corners: [Point3<f32>; 3],
    place: u32,
    node: usize,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        let [a, b, c] = self.corners;
        Aabb::with_bounds(a.inf(&b).inf(&c), a.sup(&b).sup(&c))
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Shape {
    /// The parameter at which a ray meets it from either side; infinite if it does not.
    fn distance(&self, ray: &ray::Ray<f32, 3>) -> f32 {
        let [a, b, c] = &self.corners;
        let front = ray.intersects_triangle(a, b, c).distance;
        if front.is_finite() { front } else { ray.intersects_triangle(a, c, b).distance }
    }
}

impl ForeignTracer for Svenstaro {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        _: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let triangles = Triangles::of(objects);
        let shape = |(place, corners): (u32, &[glam::Vec3; 3])| {
            let corners = corners.map(|corner| Point3::from(corner.to_array()));
            Shape { corners, place, node: 0 }
        };
        let mut shapes: Vec<Shape> = (0..).zip(&triangles.corners).map(shape).collect();
        let tree = <Bvh<f32, 3> as BoundingHierarchy<f32, 3>>::build_par(&mut shapes);
        Ok(Self { triangles, shapes, tree })
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        let prepared = |ray: &Ray| {
            let (origin, length) = from_start(ray);
            let (origin, dir) =
                (Point3::from(origin.to_array()), Vector3::from(ray.dir.to_array()));
            // Its own constructor would give the direction unit length, and distances another unit.
            let inv_direction = dir.map(|x| 1.0 / x);
            (ray::Ray { origin, direction: dir, inv_direction }, length)
        };
        let closest = |ray: &Ray| {
            let (own, length) = prepared(ray);
            let (mut best, mut found) = (length, None);
            for shape in self.tree.nearest_traverse_iterator(&own, &self.shapes) {
                let distance = shape.distance(&own);
                if (0.0..=best).contains(&distance) {
                    (best, found) = (distance, Some(shape.place));
                } else if let Some((begin, _)) = own.intersection_slice_for_aabb(&shape.aabb())
                    && begin > best
                {
                    break;
                }
            }
            found.map(|place| Found { place, t: best + ray.t_min })
        };
        let any = |ray: &Ray| {
            let (own, length) = prepared(ray);
            let mut shapes = self.tree.traverse_iterator(&own, &self.shapes);
            shapes.any(|shape| (0.0..=length).contains(&shape.distance(&own)))
        };
        self.triangles.answer(rays, answers, closest, any);
    }

    fn bytes(&self) -> ForeignBytes {
        ForeignBytes {
            index: size_of_val(&self.tree.nodes[..]) as u64,
            triangles: size_of_val(&self.shapes[..]) as u64 + self.triangles.bytes(),
        }
    }
}
