//! A mesh and a stream of rays: those that meet the object's box are taken to its own space, and
//! the mesh's structure is asked about all of them at once.

use std::cell::Cell;

use crate::accel::{Accel, Indexed};
use crate::counters::Counters;
use crate::math::{Hit, Ray};
use crate::shapes::{Place, SoFar, TriangleSet};

/// Fewer rays are asked about one by one: a structure's kernels take time to begin.
const FEW: usize = 4;

/// The buffers of a call.
#[derive(Default)]
struct Buffers {
    /// The rays in the object's own space, and which rays of the stream they are.
    own: Vec<Ray>,
    entered: Vec<u32>,
    hits: Vec<Hit>,
    answers: Vec<bool>,
}

thread_local! {
    /// Kept from call to call; absent while used.
    static BUFFERS: Cell<Option<Box<Buffers>>> = const { Cell::new(None) };
}

/// What a mesh can be asked about the rays of a stream.
pub(super) trait Asked: SoFar {
    /// Notes where some rays hit a mesh, or that they do. `which` has the rays' places in both
    /// slices.
    fn ask_mesh<A: Accel, C: Counters>(
        mesh: &Indexed<TriangleSet, A>,
        place: &Place<'_>,
        rays: &[Ray],
        which: &[u32],
        answers: &mut [Self],
        counters: &mut C,
    );
}

impl Asked for Hit {
    fn ask_mesh<A: Accel, C: Counters>(
        mesh: &Indexed<TriangleSet, A>,
        place: &Place<'_>,
        rays: &[Ray],
        which: &[u32],
        best: &mut [Hit],
        counters: &mut C,
    ) {
        let mut buffers = BUFFERS.take().unwrap_or_default();
        let Buffers { own, entered, hits, .. } = &mut *buffers;
        place.own_parts(rays, which, best, own, entered);
        hits.clear();
        if own.len() < FEW {
            hits.extend(own.iter().map(|ray| mesh.closest(ray, counters)));
        } else {
            hits.resize(own.len(), Hit::MISS);
            mesh.intersect_many(own, hits, counters);
        }
        for (&ray, hit) in entered.iter().zip(hits).filter(|(_, hit)| hit.is_hit()) {
            best[ray as usize].note(&Hit { object: place.object, ..*hit });
        }
        BUFFERS.set(Some(buffers));
    }
}

impl Asked for bool {
    fn ask_mesh<A: Accel, C: Counters>(
        mesh: &Indexed<TriangleSet, A>,
        place: &Place<'_>,
        rays: &[Ray],
        which: &[u32],
        blocked: &mut [bool],
        counters: &mut C,
    ) {
        let mut buffers = BUFFERS.take().unwrap_or_default();
        let Buffers { own, entered, answers, .. } = &mut *buffers;
        place.own_parts(rays, which, blocked, own, entered);
        answers.clear();
        if own.len() < FEW {
            answers.extend(own.iter().map(|ray| mesh.blocked(ray, counters)));
        } else {
            answers.resize(own.len(), false);
            mesh.occluded_many(own, answers, counters);
        }
        for (&ray, &answer) in entered.iter().zip(&*answers) {
            // A leaf of several meshes may have been asked about a ray before.
            blocked[ray as usize] |= answer;
        }
        BUFFERS.set(Some(buffers));
    }
}
