//! A mesh and many rays: those that meet the object's box are taken to its own space, and the mesh's
//! structure is searched for all of them at once.

use crate::accel::{Accel, Indexed, Query, Scratch};
use crate::counters::Counters;
use crate::math::{BoxRay, Ray};
use crate::shapes::{Entered, Instance, TriangleSet};

/// Fewer rays are searched for one by one: a structure's kernels take time to begin.
const FEW: usize = 4;

/// The rays that meet an object's box, and what the mesh answers them.
struct OwnRays<A> {
    entered: Entered,
    answers: Vec<A>,
}

impl<A> Default for OwnRays<A> {
    fn default() -> Self {
        Self { entered: Entered::default(), answers: Vec::new() }
    }
}

/// Takes up what a mesh answers for one ray. `box_ray` is the ray with the padding of the instance.
#[inline]
pub(super) fn test_mesh<Q: Query, A: Accel, C: Counters>(
    query: &Q,
    mesh: &Indexed<TriangleSet, A>,
    instance: &Instance<'_>,
    (ray, box_ray): (&Ray, &BoxRay),
    answer: &mut Q::Answer,
    counters: &mut C,
) {
    let (own, begin) = instance.enter(ray, box_ray, query.end(ray, answer));
    let of_mesh = mesh.search_one(&query.in_object(instance.object), &own, counters);
    query.merge(answer, &of_mesh, instance.object, begin);
}

/// Takes up what a mesh answers for some of a slice of rays. `which` has their places in both slices.
pub(super) fn test_mesh_many<Q: Query, A: Accel, C: Counters>(
    query: &Q,
    mesh: &Indexed<TriangleSet, A>,
    instance: &Instance<'_>,
    (rays, which): (&[Ray], &[u32]),
    answers: &mut [Q::Answer],
    scratch: &mut Scratch,
    counters: &mut C,
) {
    let in_object = query.in_object(instance.object);
    scratch.lend(|own: &mut OwnRays<Q::Answer>, scratch| {
        let OwnRays { entered, answers: of_mesh } = own;
        instance.enter_many(query, (rays, which), answers, entered);
        let Entered { rays: own, places, begins } = entered;
        of_mesh.clear();
        if own.len() < FEW {
            of_mesh.extend(own.iter().map(|ray| mesh.search_one(&in_object, ray, counters)));
        } else {
            of_mesh.extend(own.iter().map(|ray| query.start(ray)));
            mesh.search(&in_object, own, of_mesh, scratch, counters);
        }
        for ((&place, &begin), of_mesh) in places.iter().zip(&*begins).zip(of_mesh) {
            query.merge(&mut answers[place as usize], of_mesh, instance.object, begin);
        }
    });
}
