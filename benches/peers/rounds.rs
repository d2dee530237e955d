//! Interleaved rounds on one thread.

use std::time::Instant;

use srt::accel::{Answers, Scratch, Tracer};
use srt::math::{Hit, Ray};

use crate::rays::{Class, RaySet};

/// Rays in a call.
const RAYS_AT_ONCE: usize = 4096;

/// Seconds for all rays of a set: for each structure, one for each round. A round before the first
/// warms up.
pub(crate) fn interleaved(worlds: &[&dyn Tracer], set: &RaySet, rounds: usize) -> Vec<Vec<f64>> {
    let mut times = vec![Vec::with_capacity(rounds); worlds.len()];
    let mut buffers = Buffers::default();
    for round in 0..=rounds {
        // Another structure is the first in each round.
        for place in 0..worlds.len() {
            let index = (place + round) % worlds.len();
            let start = Instant::now();
            trace(worlds[index], set, &mut buffers);
            let time = start.elapsed().as_secs_f64();
            if round > 0 {
                times[index].push(time);
            }
        }
    }
    times
}

/// Answers to a call, used again for the next.
struct Buffers {
    hits: Vec<Hit>,
    blocked: Vec<bool>,
    scratch: Scratch,
}

impl Default for Buffers {
    fn default() -> Self {
        Self {
            hits: vec![Hit::MISS; RAYS_AT_ONCE],
            blocked: vec![false; RAYS_AT_ONCE],
            scratch: Scratch::default(),
        }
    }
}

fn trace(world: &dyn Tracer, set: &RaySet, buffers: &mut Buffers) {
    for rays in set.rays.chunks(RAYS_AT_ONCE) {
        if set.class == Class::Shadow {
            let answers = Answers::AnyHit(&mut buffers.blocked[..rays.len()]);
            world.trace(rays, answers, &mut buffers.scratch, None);
        } else {
            let answers = Answers::ClosestHit(&mut buffers.hits[..rays.len()]);
            world.trace(rays, answers, &mut buffers.scratch, None);
        }
    }
    std::hint::black_box(buffers);
}

/// All answers of a world: hits, or for shadow rays whether they are blocked.
pub(crate) fn answers(world: &dyn Tracer, class: Class, rays: &[Ray]) -> (Vec<Hit>, Vec<bool>) {
    let (mut hits, mut blocked) = (vec![], vec![]);
    if class == Class::Shadow {
        blocked.resize(rays.len(), false);
        world.trace(rays, Answers::AnyHit(&mut blocked), &mut Scratch::default(), None);
    } else {
        hits.resize(rays.len(), Hit::MISS);
        world.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    }
    (hits, blocked)
}
