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
use crate::shapes::{Place, Single, TriangleSet};

use super::{Form, Scene, mesh_stream};

/// Paddings grow with how much a transform amplifies rounding, up to this: beyond, an object is so
/// nearly flat that its own hits are noise.
const LARGEST_AMPLIFICATION: f64 = 1e4;

/// The objects of a scene, their meshes indexed by `A`. Empty slots are not supported, and not
/// needed: objects are tested one by one.
#[derive(Clone, Debug)]
pub struct ObjectList<A> {
    objects: Vec<Placed<A>>,
    padding: Padding,
}

/// An object as a ray meets it.
#[derive(Clone, Debug)]
struct Placed<A> {
    bounds: Aabb,
    to_object: Option<Box<RayToObject>>,
    form: PlacedForm<A>,
    id: u32,
}

#[derive(Clone, Debug)]
enum PlacedForm<A> {
    Single(Single),
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
                Form::Ball(ball) => PlacedForm::Single(Single::Ball(ball)),
                Form::Cylinder => PlacedForm::Single(Single::Cylinder),
                Form::Triangle(triangle) => PlacedForm::Single(Single::Triangle(triangle)),
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
        for object in self.in_slots(slots) {
            let place = object.place(self.padding);
            let hit = match &object.form {
                PlacedForm::Single(single) => {
                    counters.primitives(1);
                    single.closest(&place, &Ray { t_max: best.t, ..*ray }, box_ray)
                }
                PlacedForm::Mesh(mesh) => {
                    let own = place.own_part(ray, box_ray, best.t);
                    let hit = mesh.closest(&own, counters);
                    hit.is_hit().then_some(Hit { object: object.id, ..hit })
                }
            };
            if let Some(hit) = hit.filter(|hit| hit.precedes(best)) {
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
        self.in_slots(slots).iter().any(|object| {
            let place = object.place(self.padding);
            match &object.form {
                PlacedForm::Single(single) => {
                    counters.primitives(1);
                    single.closest(&place, ray, box_ray).is_some()
                }
                PlacedForm::Mesh(mesh) => {
                    let own = place.own_part(ray, box_ray, ray.t_max);
                    mesh.blocked(&own, counters)
                }
            }
        })
    }

    fn intersect_stream<C: Counters>(
        &self,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        best: &mut [Hit],
        counters: &mut C,
    ) {
        for object in self.in_slots(slots) {
            let place = object.place(self.padding);
            match &object.form {
                PlacedForm::Single(single) => {
                    counters.primitives(which.len() as u32);
                    single.closest_of_many(&place, rays, which, best);
                }
                PlacedForm::Mesh(mesh) => {
                    mesh_stream::closest(mesh, &place, rays, which, best, counters);
                }
            }
        }
    }

    fn occluded_stream<C: Counters>(
        &self,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        blocked: &mut [bool],
        counters: &mut C,
    ) {
        for object in self.in_slots(slots) {
            let place = object.place(self.padding);
            match &object.form {
                PlacedForm::Single(single) => {
                    counters.primitives(which.len() as u32);
                    single.blocked_of_many(&place, rays, which, blocked);
                }
                PlacedForm::Mesh(mesh) => {
                    mesh_stream::blocked(mesh, &place, rays, which, blocked, counters);
                }
            }
        }
    }
}

impl<A> ObjectList<A> {
    fn in_slots(&self, slots: Range<u32>) -> &[Placed<A>] {
        &self.objects[slots.start as usize..slots.end as usize]
    }
}

impl<A> Placed<A> {
    #[inline(always)]
    fn place(&self, padding: Padding) -> Place<'_> {
        Place {
            to_object: self.to_object.as_deref(),
            bounds: &self.bounds,
            padding,
            object: self.id,
        }
    }
}
