//! The objects of a scene as primitives: the upper of the two levels.
//!
//! An object takes the ray to its own space, without renormalising, and asks its formula, or its
//! mesh's own structure. A hit counts only within the interval of the object's box in the world,
//! which is what a structure over the objects prunes by. The list itself prunes nothing, so that
//! `none` means none.

use std::ops::Range;
use std::sync::Arc;

use glam::Vec3A;

use crate::accel::{Accel, Bounded, Indexed, NoPacks, Primitives};
use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Hit, NONE, Padding, Ray, RayToObject};
use crate::shapes::{Ball, Cylinder, Triangle, TriangleSet};

use super::{Form, Scene, object_slices};

/// Paddings grow with how much a transform amplifies rounding, up to this: beyond, an object is so
/// nearly flat that its own hits are noise.
const LARGEST_AMPLIFICATION: f64 = 1e4;

/// The objects of a scene, their meshes indexed by `A`. Empty slots are not supported, and not
/// needed: objects are tested one by one.
#[derive(Clone, Debug)]
pub struct ObjectList<A> {
    pub(super) objects: Vec<Placed<A>>,
    padding: Padding,
}

/// An object as a ray meets it.
#[derive(Clone, Debug)]
pub(super) struct Placed<A> {
    bounds: Aabb,
    pub(super) to_object: Option<Box<RayToObject>>,
    pub(super) form: PlacedForm<A>,
    pub(super) id: u32,
}

#[derive(Clone, Debug)]
pub(super) enum PlacedForm<A> {
    Ball(Ball),
    Cylinder,
    Triangle(Triangle),
    Mesh(Arc<Indexed<TriangleSet, A>>),
}

impl<A: Accel> ObjectList<A> {
    /// The objects of a scene; `meshes` are the scene's, indexed, in its order.
    ///
    /// # Panics
    /// If there are 2³² − 1 objects or more.
    #[must_use]
    pub fn new(scene: &Scene, meshes: &[Arc<Indexed<TriangleSet, A>>]) -> Self {
        assert!(scene.objects.len() < NONE as usize, "fewer than 2^32 - 1 objects");
        let amplification = scene
            .objects
            .iter()
            .filter_map(|object| object.transform.as_ref())
            .map(|transform| transform.amplification())
            .fold(1.0, f64::max)
            .min(LARGEST_AMPLIFICATION);
        let place = |(id, object): (usize, &super::Object)| Placed {
            bounds: object.bounds,
            to_object: object.transform.as_ref().map(|t| Box::new(t.ray_to_object())),
            form: match object.form {
                Form::Ball(ball) => PlacedForm::Ball(ball),
                Form::Cylinder => PlacedForm::Cylinder,
                Form::Triangle(triangle) => PlacedForm::Triangle(triangle),
                Form::Mesh { mesh, .. } => PlacedForm::Mesh(Arc::clone(&meshes[mesh])),
            },
            id: id as u32,
        };
        Self {
            objects: scene.objects.iter().enumerate().map(place).collect(),
            padding: Padding {
                largest: scene.bounds().largest_coordinate(),
                factor: amplification as f32,
            },
        }
    }
}

impl<A: Accel> Bounded for ObjectList<A> {
    fn count(&self) -> u32 {
        self.objects.len() as u32
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.objects[index as usize].bounds
    }

    fn mean_point(&self) -> Vec3A {
        let sum = self.objects.iter().map(|object| object.bounds.center()).sum::<Vec3A>();
        sum / self.objects.len().max(1) as f32
    }
}

impl<A: Accel> Primitives for ObjectList<A> {
    type Packs = NoPacks;

    fn packs(&self) -> Option<&NoPacks> {
        None
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        let mut old: Vec<_> = std::mem::take(&mut self.objects).into_iter().map(Some).collect();
        self.objects = order.iter().filter_map(|&from| old[from as usize].take()).collect();
    }

    #[inline]
    fn intersect<C: Counters>(
        &self,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        best: &mut Hit,
        counters: &mut C,
    ) {
        for object in &self.objects[slots.start as usize..slots.end as usize] {
            if let Some(hit) = object.closest(ray, box_ray, best.t, counters)
                && hit.precedes(best)
            {
                *best = hit;
            }
        }
    }

    #[inline]
    fn occluded<C: Counters>(
        &self,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
    ) -> bool {
        self.objects[slots.start as usize..slots.end as usize]
            .iter()
            .any(|object| object.blocks(ray, box_ray, counters))
    }

    fn intersect_all<C: Counters>(&self, rays: &[Ray], hits: &mut [Hit], counters: &mut C) -> bool {
        let few = object_slices::suits(self);
        if few {
            object_slices::closest(self, rays, hits, counters);
        }
        few
    }

    fn occluded_all<C: Counters>(
        &self,
        rays: &[Ray],
        answers: &mut [bool],
        counters: &mut C,
    ) -> bool {
        let few = object_slices::suits(self);
        if few {
            object_slices::blocked(self, rays, answers, counters);
        }
        few
    }
}

impl<A: Accel> Placed<A> {
    /// The first hit on this object up to `t_max`.
    #[inline]
    pub(super) fn closest<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        t_max: f32,
        counters: &mut C,
    ) -> Option<Hit> {
        if let PlacedForm::Mesh(mesh) = &self.form {
            let hit = mesh.closest(&self.cut_own_ray(ray, box_ray, t_max), counters);
            return hit.is_hit().then_some(Hit { object: self.id, ..hit });
        }
        counters.primitives(1);
        let own = self.own_ray(&Ray { t_max, ..*ray });
        if let PlacedForm::Triangle(triangle) = &self.form {
            let (t, u, v) = triangle.intersect(&own)?;
            let hit = Hit { t, object: self.id, prim: 0, u, v };
            return box_ray.accepts(&self.bounds, t).then_some(hit);
        }
        let (t, prim) = self.first_crossing(&own, box_ray)?;
        Some(Hit { t, object: self.id, prim, u: 0.0, v: 0.0 })
    }

    /// Whether this object has a hit on the ray.
    #[inline]
    pub(super) fn blocks<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
    ) -> bool {
        if let PlacedForm::Mesh(mesh) = &self.form {
            return mesh.blocked(&self.cut_own_ray(ray, box_ray, ray.t_max), counters);
        }
        counters.primitives(1);
        let own = self.own_ray(ray);
        if let PlacedForm::Triangle(triangle) = &self.form {
            return triangle
                .intersect(&own)
                .is_some_and(|(t, ..)| box_ray.accepts(&self.bounds, t));
        }
        self.first_crossing(&own, box_ray).is_some()
    }

    /// The ray in the object's own space.
    #[inline(always)]
    fn own_ray(&self, ray: &Ray) -> Ray {
        match &self.to_object {
            Some(to_object) => to_object.apply(ray),
            None => *ray,
        }
    }

    /// The ray in the object's own space, cut to the interval of the object's box: what a mesh's
    /// own structure is asked.
    ///
    /// The interval may be empty; then nothing counts, but the structure is asked all the same:
    /// what to skip is a structure's to decide.
    #[inline(always)]
    pub(super) fn cut_own_ray(&self, ray: &Ray, box_ray: &BoxRay, t_max: f32) -> Ray {
        let (near, far) = box_ray.interval(&self.bounds);
        self.own_ray(&Ray { t_min: ray.t_min.max(near), t_max: far.min(t_max), ..*ray })
    }

    /// The first of the two crossings of a closed shape that lies in the interval of the ray and
    /// of the object's box, and the part of the shape that is crossed.
    #[inline(always)]
    fn first_crossing(&self, own: &Ray, box_ray: &BoxRay) -> Option<(f32, u32)> {
        let crossings = match &self.form {
            PlacedForm::Ball(ball) => {
                let (enter, leave) = ball.crossing(own)?;
                [(enter, 0), (leave, 0)]
            }
            PlacedForm::Cylinder => Cylinder::crossing(own)?,
            PlacedForm::Triangle(_) | PlacedForm::Mesh(_) => return None,
        };
        crossings
            .into_iter()
            .find(|&(t, _)| own.t_min <= t && t <= own.t_max && box_ray.accepts(&self.bounds, t))
    }
}
