//! The objects of a scene as primitives: the upper of the two levels.
//!
//! An object takes the ray to its own space, without renormalising, and tests its formula, or searches its
//! mesh's own structure. A hit counts only by the interval of the object's box in the world, which is
//! what a structure over the objects prunes by. The list itself prunes nothing, so that
//! `none` means none.

use std::ops::Range;
use std::sync::Arc;

use glam::{Vec3, Vec3A};
use rayon::prelude::*;

use crate::accel::{Accel, Bounded, Indexed, NoPacks, Primitives, Query, Scratch};
use crate::counters::Counters;
use crate::description::Shape;
use crate::math::{Aabb, BoxRay, NONE, Padding, Ray, RayToObject};
use crate::shapes::{Instance, Single, TriangleSet};
use crate::simd::{Cache, ask_for_huge_pages, prefetch};

use super::mesh_rays::{test_mesh, test_mesh_many};
use super::{Object, Scene, SceneChange};

/// Paddings grow with how much a transform amplifies rounding, up to this: beyond, an object is so
/// nearly flat that its own hits are noise.
const LARGEST_AMPLIFICATION: f64 = 1e4;

/// So many objects are asked of memory ahead of their use.
const AHEAD: usize = 12;

/// The objects of a scene, their meshes indexed by `A`. Empty slots are not supported, and not
/// needed: objects are tested one by one.
#[derive(Clone, Debug)]
pub struct ObjectList<A> {
    stored: StoredObjects,
    meshes: Vec<Arc<Indexed<TriangleSet, A>>>,
}

/// The objects without their meshes: what is made of them is compiled once for all structures.
#[derive(Clone, Debug)]
struct StoredObjects {
    objects: Vec<StoredInstance>,
    to_object: Vec<RayToObject>,
    singles: Vec<Single>,
    padding: Padding,
    /// The slot of each object, once objects have moved.
    slots: Vec<u32>,
}

/// An object as a ray meets it. Small: there may be millions.
#[derive(Clone, Copy, Debug)]
struct StoredInstance {
    /// The corners of its box in the world.
    corners: [Vec3; 2],
    /// Index into the list's transforms, or [`NONE`].
    to_object: u32,
    form: StoredForm,
    id: u32,
}

/// Indices into the list's shapes or meshes.
#[derive(Clone, Copy, Debug)]
enum StoredForm {
    Single(u32),
    Mesh(u32),
}

impl<A: Accel> ObjectList<A> {
    /// The objects of a scene; `meshes` are the scene's, indexed, in its order.
    ///
    /// # Panics
    /// If there are 2³² − 1 objects or more.
    #[must_use]
    pub fn new(scene: &Scene, meshes: &[Arc<Indexed<TriangleSet, A>>]) -> Self {
        Self { stored: StoredObjects::new(scene), meshes: meshes.to_vec() }
    }

    /// The same list as [`new`](Self::new), its objects in an order of slots; each is in one. `None` if rays cannot be
    /// taken to an object's own space.
    pub(super) fn in_order(
        scene: &Scene,
        meshes: &[Arc<Indexed<TriangleSet, A>>],
        order: &[u32],
    ) -> Option<Self> {
        Some(Self { stored: StoredObjects::in_order(scene, order)?, meshes: meshes.to_vec() })
    }

    /// The object in each slot.
    pub(super) fn ids(&self) -> Vec<u32> {
        self.stored.objects.iter().map(|object| object.id).collect()
    }

    /// Takes the meshes out, for as long as they change, and puts others in.
    pub(super) fn swap_meshes(&mut self, meshes: &mut Vec<Arc<Indexed<TriangleSet, A>>>) {
        std::mem::swap(&mut self.meshes, meshes);
    }

    /// The object in a slot.
    pub(super) fn id_of(&self, slot: u32) -> u32 {
        self.stored.objects[slot as usize].id
    }

    /// The slots of some objects.
    pub(super) fn slots_of(&mut self, objects: &[u32]) -> Vec<u32> {
        self.stored.slots_of(objects)
    }

    /// Moves objects to where they are now; [`settle`](Self::settle) is to follow. `slots` are those of the objects
    /// that have moved.
    pub(super) fn move_to(&mut self, change: &SceneChange<'_>, slots: &[u32]) {
        self.stored.move_to(change, slots);
    }

    /// Takes note of the box around all objects after they were moved.
    pub(super) fn settle(&mut self, bounds: &Aabb) {
        self.stored.padding.largest = bounds.largest_coordinate();
    }
}

impl StoredObjects {
    fn new(scene: &Scene) -> Self {
        assert!(scene.objects.len() < NONE as usize, "fewer than 2^32 - 1 objects");
        let mut list = Self {
            objects: Vec::with_capacity(scene.objects.len()),
            to_object: Vec::new(),
            singles: Vec::new(),
            padding: Padding { largest: scene.bounds().largest_coordinate(), factor: 1.0 },
            slots: Vec::new(),
        };
        let mut amplification = 1.0;
        for (id, object) in scene.objects.iter().enumerate() {
            let transform = scene.transform_of(object);
            if let Some(transform) = &transform {
                amplification = transform.amplification().max(amplification);
            }
            list.place(id as u32, object, transform.map(|t| t.ray_to_object()));
        }
        list.padding.factor = amplification.min(LARGEST_AMPLIFICATION) as f32;
        list
    }

    fn in_order(scene: &Scene, order: &[u32]) -> Option<Self> {
        let stored = |(slot, &id): (usize, &u32)| {
            // Slots are in another order than ids: what comes next is not in the caches.
            if let Some(&next) = order.get(slot + AHEAD) {
                prefetch(&scene.objects[next as usize], Cache::First);
            }
            let object = &scene.objects[id as usize];
            let form = match object.shape {
                Shape::Single(_) => StoredForm::Single(0),
                Shape::Mesh { mesh, .. } => StoredForm::Mesh(mesh as u32),
            };
            StoredInstance { corners: object.corners, to_object: object.transform, form, id }
        };
        let mut objects = Vec::with_capacity(order.len());
        ask_for_huge_pages(objects.spare_capacity_mut());
        let slots = order.par_iter().enumerate().with_min_len(1 << 8);
        slots.map(stored).collect_into_vec(&mut objects);
        // What the objects refer to stands in the order of the objects, too.
        let (mut singles, mut transforms) = (Vec::new(), Vec::new());
        for object in &mut objects {
            if object.to_object != NONE {
                object.to_object = push(&mut transforms, object.to_object);
            }
            if let StoredForm::Single(place) = &mut object.form
                && let Shape::Single(single) = scene.objects[object.id as usize].shape
            {
                *place = push(&mut singles, single);
            }
        }
        let mut to_object = Vec::with_capacity(transforms.len());
        ask_for_huge_pages(to_object.spare_capacity_mut());
        let mut amplifications = Vec::new();
        let places = transforms.par_iter().enumerate().with_min_len(1 << 8);
        let prepared = places.map(|(place, &transform)| {
            if let Some(&next) = transforms.get(place + AHEAD) {
                scene.transforms.prefetch(next);
            }
            let transform = scene.transforms.get(transform);
            let transform = transform.expect("what is not `NONE` is there");
            (transform.ray_to_object(), transform.amplification())
        });
        prepared.unzip_into_vecs(&mut to_object, &mut amplifications);
        if !to_object.par_iter().with_min_len(1 << 12).all(RayToObject::is_finite) {
            return None;
        }
        let amplification = amplifications.into_iter().fold(1.0, f64::max);
        let factor = amplification.min(LARGEST_AMPLIFICATION) as f32;
        Some(Self {
            objects,
            to_object,
            singles,
            padding: Padding { largest: scene.bounds().largest_coordinate(), factor },
            slots: Vec::new(),
        })
    }

    fn slots_of(&mut self, objects: &[u32]) -> Vec<u32> {
        if self.slots.len() != self.objects.len() {
            self.slots = vec![0; self.objects.len()];
            for (slot, object) in (0..).zip(&self.objects) {
                self.slots[object.id as usize] = slot;
            }
        }
        objects.iter().map(|&object| self.slots[object as usize]).collect()
    }

    fn move_to(&mut self, change: &SceneChange<'_>, slots: &[u32]) {
        for (&id, &slot) in change.objects.iter().zip(slots) {
            let object = &change.after.objects[id as usize];
            let stored = &mut self.objects[slot as usize];
            stored.corners = object.corners;
            if let (StoredForm::Single(place), Shape::Single(single)) = (stored.form, object.shape)
            {
                self.singles[place as usize] = single;
            }
            match change.after.transform_of(object).map(|transform| transform.ray_to_object()) {
                None => stored.to_object = NONE,
                Some(to_object) => match self.to_object.get_mut(stored.to_object as usize) {
                    Some(place) => *place = to_object,
                    None => stored.to_object = push(&mut self.to_object, to_object),
                },
            }
        }
        self.padding.factor = self.factor(change);
    }

    /// The factor of the padding: that of a list of the scene as it is, to the bit. Unless one of the objects that have
    /// moved had the largest amplification, no other needs to be looked at.
    fn factor(&self, change: &SceneChange<'_>) -> f32 {
        let of = |scene: &Scene, id: u32| {
            let transform = scene.transform_of(&scene.objects[id as usize]);
            transform.map_or(1.0, |transform| transform.amplification())
        };
        let cut = |amplification: f64| amplification.min(LARGEST_AMPLIFICATION) as f32;
        let moved = change.objects.iter();
        let was_largest = |&id: &u32| cut(of(change.before, id)) >= self.padding.factor;
        if self.padding.factor > 1.0 && moved.clone().any(was_largest) {
            let all = 0..change.after.objects.len() as u32;
            return cut(all
                .into_par_iter()
                .map(|id| of(change.after, id))
                .reduce(|| 1.0, f64::max));
        }
        let largest = moved.map(|&id| of(change.after, id)).fold(1.0, f64::max);
        self.padding.factor.max(cut(largest))
    }

    fn place(&mut self, id: u32, object: &Object, to_object: Option<RayToObject>) {
        let form = match object.shape {
            Shape::Single(single) => StoredForm::Single(push(&mut self.singles, single)),
            Shape::Mesh { mesh, .. } => StoredForm::Mesh(mesh as u32),
        };
        let to_object = to_object.map_or(NONE, |to_object| push(&mut self.to_object, to_object));
        self.objects.push(StoredInstance { corners: object.corners, to_object, form, id });
    }

    fn mean_point(&self) -> Vec3A {
        let sum = self.objects.iter().map(|object| object.bounds().center()).sum::<Vec3A>();
        sum / self.objects.len().max(1) as f32
    }

    /// What the objects refer to comes into the order of the objects, too.
    fn reorder(&mut self, order: &[u32]) {
        let (to_object, singles) =
            (std::mem::take(&mut self.to_object), std::mem::take(&mut self.singles));
        let mut objects = Vec::with_capacity(self.objects.len());
        self.to_object.reserve_exact(to_object.len());
        self.singles.reserve_exact(singles.len());
        for &from in order.iter().filter(|&&from| from != NONE) {
            let mut object = self.objects[from as usize];
            if let Some(&transform) = to_object.get(object.to_object as usize) {
                object.to_object = push(&mut self.to_object, transform);
            }
            if let StoredForm::Single(single) = &mut object.form {
                *single = push(&mut self.singles, singles[*single as usize]);
            }
            objects.push(object);
        }
        self.objects = objects;
        self.slots.clear();
    }

    #[inline(always)]
    fn in_slots(&self, slots: Range<u32>) -> &[StoredInstance] {
        &self.objects[slots.start as usize..slots.end as usize]
    }

    #[inline(always)]
    fn instance(&self, object: &StoredInstance) -> Instance<'_> {
        Instance {
            to_object: self.to_object.get(object.to_object as usize),
            bounds: object.bounds(),
            padding: self.padding,
            object: object.id,
        }
    }

    #[inline(always)]
    fn single(&self, index: u32) -> &Single {
        &self.singles[index as usize]
    }
}

/// Appends a value; returns its index.
fn push<T>(values: &mut Vec<T>, value: T) -> u32 {
    values.push(value);
    (values.len() - 1) as u32
}

impl<A: Accel> Bounded for ObjectList<A> {
    // A scene with others is refused.
    const SOUND_BOXES: bool = true;

    fn count(&self) -> u32 {
        self.stored.objects.len() as u32
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.stored.objects[index as usize].bounds()
    }

    fn mean_point(&self) -> Vec3A {
        self.stored.mean_point()
    }
}

impl<A: Accel> Primitives for ObjectList<A> {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.stored.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        self.stored.reorder(order);
    }

    #[inline]
    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        counters: &mut C,
    ) {
        for object in self.stored.in_slots(slots) {
            let instance = self.stored.instance(object);
            match object.form {
                StoredForm::Single(single) => {
                    counters.primitives(1);
                    self.stored.single(single).test(query, &instance, ray, box_ray, answer);
                }
                StoredForm::Mesh(mesh) => {
                    let mesh = self.mesh(mesh);
                    test_mesh(query, mesh, &instance, (ray, box_ray), answer, counters);
                }
            }
            if query.end(ray, answer) == f32::NEG_INFINITY {
                return;
            }
        }
    }

    fn test_stream<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        (rays, which): (&[Ray], &[u32]),
        answers: &mut [Q::Answer],
        scratch: &mut Scratch,
        counters: &mut C,
    ) {
        for object in self.stored.in_slots(slots) {
            let instance = self.stored.instance(object);
            let of_rays = (rays, which);
            match object.form {
                StoredForm::Single(single) => {
                    counters.primitives(which.len() as u32);
                    self.stored.single(single).test_many(query, &instance, of_rays, answers);
                }
                StoredForm::Mesh(mesh) => {
                    let mesh = self.mesh(mesh);
                    test_mesh_many(query, mesh, &instance, of_rays, answers, scratch, counters);
                }
            }
        }
    }
}

impl<A> ObjectList<A> {
    #[inline(always)]
    fn mesh(&self, index: u32) -> &Indexed<TriangleSet, A> {
        &self.meshes[index as usize]
    }
}

impl StoredInstance {
    #[inline(always)]
    fn bounds(&self) -> Aabb {
        let [min, max] = self.corners.map(Vec3A::from);
        Aabb { min, max }
    }
}
