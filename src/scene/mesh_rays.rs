//! A mesh and many rays: those that meet the object's box are taken to its own space, and the mesh's
//! structure is searched for all of them at once.

use crate::accel::{Accel, Indexed, Query, Scratch};
use crate::counters::Counters;
use crate::math::{BoxRay, Ray};
use crate::shapes::{Instance, TriangleSet};

/// Fewer rays are searched for one by one: a structure's kernels take time to begin.
const FEW: usize = 4;

/// Rays in the object's own space, which rays of the slice they are, and their answers.
struct OwnRays<A> {
    rays: Vec<Ray>,
    entered: Vec<u32>,
    answers: Vec<A>,
}

impl<A> Default for OwnRays<A> {
    fn default() -> Self {
        Self { rays: Vec::new(), entered: Vec::new(), answers: Vec::new() }
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
    let own = instance.enter(ray, box_ray, query.end(ray, answer));
    let of_mesh = mesh.search_one(&query.in_object(instance.object), &own, counters);
    query.merge(answer, &of_mesh, instance.object);
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
        let OwnRays { rays: own, entered, answers: of_mesh } = own;
        instance.enter_many(query, (rays, which), answers, own, entered);
        of_mesh.clear();
        if own.len() < FEW {
            of_mesh.extend(own.iter().map(|ray| mesh.search_one(&in_object, ray, counters)));
        } else {
            of_mesh.extend(own.iter().map(|ray| query.start(ray)));
            mesh.search(&in_object, own, of_mesh, scratch, counters);
        }
        for (&place, of_mesh) in entered.iter().zip(of_mesh) {
            query.merge(&mut answers[place as usize], of_mesh, instance.object);
        }
    });
}
