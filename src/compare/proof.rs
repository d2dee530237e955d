//! Whether structures do the same work: equal hits and equal pictures, bit for bit.

use std::fmt::Write;
use std::time::Duration;

use crate::accel::Tracer;
use crate::image_io::{Picture, compare};
use crate::math::Ray;
use crate::ray_file::RayAnswers;
use crate::record::StructureProof;

use super::candidate::Candidate;
use super::picture_file::picture_hash;
use super::record_rays::{RaySet, spread};
use super::trace::{RayResult, trace};
use super::trial::{RayTimes, affordable};

/// What comparing a class may always take for each structure, even if the budget is spent: quick
/// structures are never measured without it.
const LEAST_TIME: Duration = Duration::from_millis(2);

/// The share of the budget that comparing hits may take.
const SHARE: f64 = 0.1;

/// How long comparing a class may take for each structure, with so much time left. The reference
/// takes as long as all others together.
pub(super) fn time_for_class(left: Duration, candidates: usize, classes: usize) -> Duration {
    left.mul_f64(SHARE / (2.0 * candidates as f64) / classes.max(1) as f64).max(LEAST_TIME)
}

/// The reference's results for the rays of a class.
pub(super) struct Expected<'a> {
    pub(super) set: &'a RaySet,
    rays: Vec<Ray>,
    pub(super) results: RayAnswers,
}

impl Expected<'_> {
    /// Whether the reference traced all recorded rays of the class.
    pub(super) fn is_whole(&self) -> bool {
        self.rays.len() == self.set.rays.len()
    }

    /// As many of the rays as fit into `time` at `ray_time` each, evenly spread, and their places.
    pub(super) fn sample(
        &self,
        ray_time: Option<Duration>,
        time: Duration,
    ) -> (Vec<usize>, Vec<Ray>) {
        let count = affordable(ray_time, time).min(self.rays.len());
        let places: Vec<usize> = (0..count).map(|i| i * self.rays.len() / count).collect();
        let rays = places.iter().map(|&place| self.rays[place]).collect();
        (places, rays)
    }
}

/// The reference's results for as many rays of each class as fit into `time`.
pub(super) fn expected<'a>(
    reference: &mut Candidate<'_>,
    sets: &'a [RaySet],
    ray_times: &RayTimes,
    time: Duration,
) -> Vec<Expected<'a>> {
    let mut all = Vec::new();
    for (set, ray_time) in sets.iter().zip(ray_times) {
        let rays = spread(&set.rays, affordable(*ray_time, time));
        let mut results = set.results();
        if reference.attempt(|tracer| trace(tracer, &rays, &mut results, None)).is_some() {
            all.push(Expected { set, rays, results });
        }
    }
    all
}

/// Compares a structure's results with those that are expected, on as many rays of each class as
/// fit into `time`. A structure whose results differ has failed.
pub(super) fn check_rays(
    candidate: &mut Candidate<'_>,
    expected: &[Expected<'_>],
    ray_times: &RayTimes,
    time: Duration,
) -> StructureProof {
    let mut proof =
        StructureProof { structure: candidate.name().to_owned(), ..StructureProof::default() };
    for (class, ray_time) in expected.iter().zip(ray_times) {
        let Some(checked) = check_class(candidate, class, *ray_time, time) else { break };
        proof.rays_checked += checked.rays;
        proof.differing_hits += checked.differing;
        proof.first_difference = proof.first_difference.take().or(checked.first_difference);
    }
    if let Some(text) = &proof.first_difference {
        candidate.fail(format!("its results differ: {text}"));
    }
    proof
}

/// What comparing a class showed.
struct CheckedClass {
    rays: u64,
    differing: u64,
    first_difference: Option<String>,
}

/// Compares a structure's results for a class; `None` if it fails.
fn check_class(
    candidate: &mut Candidate<'_>,
    class: &Expected<'_>,
    ray_time: Option<Duration>,
    time: Duration,
) -> Option<CheckedClass> {
    let (places, rays) = class.sample(ray_time, time);
    let set = class.set;
    candidate.attempt(|tracer| {
        let mut results = set.results();
        trace(tracer, &rays, &mut results, None);
        let differs = |&i: &usize| !class.results.get(places[i]).same_bits(&results.get(i));
        let differing: Vec<usize> = (0..rays.len()).filter(differs).collect();
        let first_difference = differing.first().map(|&first| {
            let expected = class.results.get(places[first]);
            let ray = smallest(tracer, set, rays[first], &expected);
            describe(set, &ray, &expected, &result_of(tracer, set, &ray))
        });
        CheckedClass {
            rays: rays.len() as u64,
            differing: differing.len() as u64,
            first_difference,
        }
    })
}

/// The ray, cut to the piece around the hit that is expected if its result still differs from that:
/// fewer primitives are left that could be to blame.
fn smallest(tracer: &dyn Tracer, set: &RaySet, ray: Ray, expected: &RayResult) -> Ray {
    let RayResult::ClosestHit(hit) = expected else { return ray };
    if !hit.is_hit() {
        return ray;
    }
    let mut found = ray;
    for shorter in [Ray { t_max: hit.t, ..ray }, Ray { t_min: hit.t, t_max: hit.t, ..ray }] {
        if !result_of(tracer, set, &shorter).same_bits(expected) {
            found = shorter;
        }
    }
    found
}

/// The result of one ray, by the query of its class.
fn result_of(tracer: &dyn Tracer, set: &RaySet, ray: &Ray) -> RayResult {
    let mut results = set.results();
    trace(tracer, std::slice::from_ref(ray), &mut results, None);
    results.get(0)
}

/// A ray in full precision (what is printed reads back as the same bits), and both results.
pub(super) fn describe(set: &RaySet, ray: &Ray, expected: &RayResult, got: &RayResult) -> String {
    let Ray { origin: o, dir: d, t_min, t_max } = ray;
    let mut text = format!("{} ray: origin {:?} {:?} {:?}, ", set.class.name(), o.x, o.y, o.z);
    // Writing to a string cannot fail.
    let _ =
        write!(text, "direction {:?} {:?} {:?}, t from {t_min:?} to {t_max:?}; ", d.x, d.y, d.z);
    let _ = write!(text, "expected {expected}, got {got}");
    text
}

/// Compares a structure's picture with the reference's. A structure whose picture differs has failed.
pub(super) fn check_picture(
    candidate: &mut Candidate<'_>,
    expected: &Picture,
    own: &Picture,
    proof: &mut StructureProof,
) {
    proof.picture_hash = Some(picture_hash(own));
    let Ok(difference) = compare(expected, own) else { return };
    proof.picture_equal = Some(difference.differing == 0);
    proof.picture_size = Some([own.width, own.height]);
    proof.differing_pixels = difference.differing;
    proof.largest_difference = f64::from(difference.largest.min(f32::MAX));
    if difference.differing > 0 {
        candidate.fail(format!("its picture differs in {} pixels", difference.differing));
    }
}
