//! Rays through a tracer, and their results: a buffer for those of many rays, and one by itself.

use std::fmt;

use crate::accel::{Answers, QueryKind, Scratch, Tracer};
use crate::counters::Counts;
use crate::math::{Hit, Ray};
use crate::ray_file::RayAnswers;

use super::record_rays::RaySet;

/// Rays in a call, as in a renderer's wave.
pub(super) const RAYS_PER_CALL: usize = crate::ray_file::RAYS_PER_CALL as usize;

/// The result of one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RayResult {
    ClosestHit(Hit),
    AnyHit(bool),
}

impl RayAnswers {
    /// The result of the ray at a place.
    pub(super) fn get(&self, place: usize) -> RayResult {
        match self {
            Self::ClosestHit(hits) => RayResult::ClosestHit(hits[place]),
            Self::AnyHit(blocked) => RayResult::AnyHit(blocked[place]),
        }
    }

    /// Replaces the results by those of some rays, traced in one call.
    pub fn trace(&mut self, tracer: &dyn Tracer, rays: &[Ray]) {
        trace_in_calls(tracer, rays, rays.len().max(1), self, None);
    }

    /// How many rays have another result than in `expected`, bit for bit.
    #[must_use]
    pub fn count_differing(&self, expected: &Self) -> usize {
        self.count_unlike(expected, RayResult::same_bits)
    }

    /// How many rays have a result that does not agree with that in `expected`: neither the same
    /// primitive nor nearly the same distance ([`Hit::agrees`]).
    #[must_use]
    pub fn count_disagreeing(&self, expected: &Self) -> usize {
        self.count_unlike(expected, RayResult::agrees)
    }

    fn count_unlike(&self, expected: &Self, like: fn(&RayResult, &RayResult) -> bool) -> usize {
        let differs = |&place: &usize| !like(&self.get(place), &expected.get(place));
        (0..expected.len()).filter(differs).count()
    }

    /// The places of the rays that have another result than in `expected`, bit for bit.
    pub(super) fn differing<'a>(&'a self, expected: &'a Self) -> impl Iterator<Item = usize> + 'a {
        (0..expected.len()).filter(|&place| !self.get(place).same_bits(&expected.get(place)))
    }
}

impl RayResult {
    pub(super) fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::ClosestHit(a), Self::ClosestHit(b)) => a.same_bits(b),
            (a, b) => a == b,
        }
    }

    /// Whether it is the same primitive or nearly the same distance: see [`Hit::agrees`].
    pub(super) fn agrees(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::ClosestHit(a), Self::ClosestHit(b)) => a.agrees(b),
            (a, b) => a == b,
        }
    }
}

/// In full precision: numbers read back as the same bits.
impl fmt::Display for RayResult {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ClosestHit(hit) if hit.is_hit() => {
                let Hit { t, object, prim, u, v } = hit;
                write!(f, "t {t:?}, object {object}, primitive {prim}, u {u:?}, v {v:?}")
            }
            Self::ClosestHit(_) => f.write_str("nothing"),
            Self::AnyHit(true) => f.write_str("blocked"),
            Self::AnyHit(false) => f.write_str("not blocked"),
        }
    }
}

/// Traces rays in calls of a wave's size, into results that are used again.
pub(super) fn trace(
    tracer: &dyn Tracer,
    rays: &[Ray],
    results: &mut RayAnswers,
    counts: Option<&mut Counts>,
) {
    trace_in_calls(tracer, rays, RAYS_PER_CALL, results, counts);
}

/// Traces rays in calls of `rays_per_call`.
fn trace_in_calls(
    tracer: &dyn Tracer,
    rays: &[Ray],
    rays_per_call: usize,
    results: &mut RayAnswers,
    mut counts: Option<&mut Counts>,
) {
    Scratch::of_thread(|scratch| match results {
        RayAnswers::ClosestHit(hits) => {
            hits.resize(rays.len(), Hit::MISS);
            let hits = hits.chunks_mut(rays_per_call);
            for (rays, hits) in rays.chunks(rays_per_call).zip(hits) {
                let answers = Answers::ClosestHit(hits);
                tracer.trace(rays, answers, scratch, counts.as_deref_mut());
            }
        }
        RayAnswers::AnyHit(blocked) => {
            blocked.resize(rays.len(), false);
            let blocked = blocked.chunks_mut(rays_per_call);
            for (rays, blocked) in rays.chunks(rays_per_call).zip(blocked) {
                let answers = Answers::AnyHit(blocked);
                tracer.trace(rays, answers, scratch, counts.as_deref_mut());
            }
        }
    });
}

/// The closest hit of each ray.
pub(super) fn closest_hits(tracer: &dyn Tracer, rays: &[Ray]) -> Vec<Hit> {
    let mut results = RayAnswers::ClosestHit(Vec::new());
    trace(tracer, rays, &mut results, None);
    match results {
        RayAnswers::ClosestHit(hits) => hits,
        RayAnswers::AnyHit(_) => Vec::new(),
    }
}

impl RaySet {
    /// Results of its query, for no rays.
    #[must_use]
    pub fn results(&self) -> RayAnswers {
        match self.query {
            QueryKind::ClosestHit => RayAnswers::ClosestHit(Vec::new()),
            QueryKind::AnyHit => RayAnswers::AnyHit(Vec::new()),
        }
    }
}
