//! A few objects and a slice of rays: the rays are brought to the objects, one object after the
//! other, so that each mesh's own structure gets many rays at once.
//!
//! Objects that are not meshes come first: they are cheap, and what they hit shortens the rays for
//! the meshes. The order changes no result: the closest hit is the first of all in
//! `(t, object, prim)`.

use std::cell::Cell;

use crate::accel::{Accel, Indexed, Primitives};
use crate::counters::Counters;
use crate::math::{BoxRay, Hit, Ray};
use crate::shapes::TriangleSet;

use super::object_list::{ObjectList, Placed, PlacedForm};

/// Up to so many objects, a slice of rays is brought to each object rather than each ray to the
/// objects that it meets.
const FEW: usize = 16;

/// Of these, up to so many that are not meshes: they are tested ray by ray, so that more of them,
/// or these without a mesh, are found faster by their boxes.
const FEW_SINGLE: usize = 4;

/// Rays that are brought to the objects together: few enough to stay in a core's cache.
const AT_ONCE: usize = 1024;

/// The buffers of a slice.
#[derive(Default)]
struct Buffers {
    box_rays: Vec<BoxRay>,
    /// The rays that go to an object, in its own space, and which rays of the slice they are.
    own: Vec<Ray>,
    which: Vec<u32>,
    hits: Vec<Hit>,
    answers: Vec<bool>,
}

thread_local! {
    /// Kept from call to call; absent while used.
    static BUFFERS: Cell<Option<Box<Buffers>>> = const { Cell::new(None) };
}

/// Whether the objects are so few, meshes among them, that this is faster than finding each ray's.
pub(super) fn suits<A>(list: &ObjectList<A>) -> bool {
    let singles = others(list).count();
    list.objects.len() <= FEW && singles < list.objects.len() && singles <= FEW_SINGLE
}

/// The closest hits on all objects.
pub(super) fn closest<A: Accel, C: Counters>(
    list: &ObjectList<A>,
    rays: &[Ray],
    hits: &mut [Hit],
    counters: &mut C,
) {
    if let Some((object, mesh)) = only_mesh(list) {
        mesh.intersect_many(rays, hits, counters);
        for hit in hits.iter_mut().filter(|hit| hit.is_hit()) {
            hit.object = object.id;
        }
        return;
    }
    let mut buffers = BUFFERS.take().unwrap_or_default();
    for (rays, hits) in rays.chunks(AT_ONCE).zip(hits.chunks_mut(AT_ONCE)) {
        buffers.prepare(list, rays);
        for (ray, hit) in rays.iter().zip(&mut *hits) {
            *hit = Hit::none_before(ray.t_max);
        }
        for object in others(list) {
            for ((ray, box_ray), best) in rays.iter().zip(&buffers.box_rays).zip(&mut *hits) {
                if let Some(hit) = object.closest(ray, box_ray, best.t, counters)
                    && hit.precedes(best)
                {
                    *best = hit;
                }
            }
        }
        for (object, mesh) in meshes(list) {
            buffers.gather(object, rays, |ray| Some(hits[ray].t));
            buffers.hits.clear();
            buffers.hits.resize(buffers.own.len(), Hit::MISS);
            mesh.intersect_many(&buffers.own, &mut buffers.hits, counters);
            let found = buffers.which.iter().zip(&buffers.hits).filter(|(_, hit)| hit.is_hit());
            for (&ray, hit) in found {
                let hit = Hit { object: object.id, ..*hit };
                let best = &mut hits[ray as usize];
                if hit.precedes(best) {
                    *best = hit;
                }
            }
        }
        for hit in hits.iter_mut().filter(|hit| !hit.is_hit()) {
            *hit = Hit::MISS;
        }
    }
    BUFFERS.set(Some(buffers));
}

/// Whether each ray hits any object.
pub(super) fn blocked<A: Accel, C: Counters>(
    list: &ObjectList<A>,
    rays: &[Ray],
    answers: &mut [bool],
    counters: &mut C,
) {
    if let Some((_, mesh)) = only_mesh(list) {
        mesh.occluded_many(rays, answers, counters);
        return;
    }
    let mut buffers = BUFFERS.take().unwrap_or_default();
    for (rays, answers) in rays.chunks(AT_ONCE).zip(answers.chunks_mut(AT_ONCE)) {
        buffers.prepare(list, rays);
        answers.fill(false);
        for object in others(list) {
            for ((ray, box_ray), answer) in rays.iter().zip(&buffers.box_rays).zip(&mut *answers) {
                *answer = *answer || object.blocks(ray, box_ray, counters);
            }
        }
        for (object, mesh) in meshes(list) {
            buffers.gather(object, rays, |ray| (!answers[ray]).then_some(rays[ray].t_max));
            buffers.answers.clear();
            buffers.answers.resize(buffers.own.len(), false);
            mesh.occluded_many(&buffers.own, &mut buffers.answers, counters);
            for (&ray, &answer) in buffers.which.iter().zip(&buffers.answers) {
                answers[ray as usize] = answer;
            }
        }
    }
    BUFFERS.set(Some(buffers));
}

/// The mesh of a scene that is one mesh in the world's own space. Its hits need no look at the
/// object's box: that holds the boxes of all triangles, and is tested with no less padding.
fn only_mesh<A>(list: &ObjectList<A>) -> Option<(&Placed<A>, &Indexed<TriangleSet, A>)> {
    match &list.objects[..] {
        [object @ Placed { form: PlacedForm::Mesh(mesh), to_object: None, .. }] => {
            Some((object, mesh))
        }
        _ => None,
    }
}

fn meshes<A>(list: &ObjectList<A>) -> impl Iterator<Item = (&Placed<A>, &Indexed<TriangleSet, A>)> {
    list.objects.iter().filter_map(|object| match &object.form {
        PlacedForm::Mesh(mesh) => Some((object, &**mesh)),
        PlacedForm::Ball(_) | PlacedForm::Cylinder | PlacedForm::Triangle(_) => None,
    })
}

fn others<A>(list: &ObjectList<A>) -> impl Iterator<Item = &Placed<A>> {
    list.objects.iter().filter(|object| !matches!(object.form, PlacedForm::Mesh(_)))
}

impl Buffers {
    fn prepare<A: Accel>(&mut self, list: &ObjectList<A>, rays: &[Ray]) {
        let padding = list.padding();
        self.box_rays.clear();
        self.box_rays.extend(rays.iter().map(|ray| BoxRay::new(ray, padding)));
    }

    /// Collects the rays that meet an object's box before their end, which `end` gives for a ray
    /// that is still to be traced.
    fn gather<A: Accel>(
        &mut self,
        object: &Placed<A>,
        rays: &[Ray],
        end: impl Fn(usize) -> Option<f32>,
    ) {
        self.own.clear();
        self.which.clear();
        for (index, (ray, box_ray)) in rays.iter().zip(&self.box_rays).enumerate() {
            let Some(end) = end(index) else { continue };
            let own = object.cut_own_ray(ray, box_ray, end);
            if own.t_min <= own.t_max {
                self.own.push(own);
                self.which.push(index as u32);
            }
        }
    }
}
