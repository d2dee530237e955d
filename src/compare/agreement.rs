//! Whether a peer does nearly the same work: the share of its results that agree with the reference's.

use std::time::Duration;

use crate::math::CLOSE;
use crate::record::PeerAgreement;

use super::candidate::Candidate;
use super::proof::Expected;
use super::trace::trace;
use super::trial::RayTimes;

/// The share of results that must agree; below it, a peer's speed means nothing.
const LEAST_SHARE: f64 = 0.9999;

/// Compares a peer's results with those that are expected, on as many rays of each class as fit into
/// `time`. If too few agree, it has failed.
pub(super) fn check(
    candidate: &mut Candidate<'_>,
    expected: &[Expected<'_>],
    ray_times: &RayTimes,
    time: Duration,
) -> Option<PeerAgreement> {
    let structure = candidate.name().to_owned();
    let mut proof = PeerAgreement { structure, rays_checked: 0, rays_agreeing: 0, close: CLOSE };
    for (class, ray_time) in expected.iter().zip(ray_times) {
        let (places, rays) = class.sample(*ray_time, time);
        let mut results = class.set.results();
        candidate.attempt(|tracer| trace(tracer, &rays, &mut results, None))?;
        let agrees =
            |&(i, &place): &(usize, &usize)| class.results.get(place).agrees(&results.get(i));
        proof.rays_checked += rays.len() as u64;
        proof.rays_agreeing += places.iter().enumerate().filter(agrees).count() as u64;
    }
    if proof.share().is_some_and(|share| share < LEAST_SHARE) {
        let (agreeing, checked) = (proof.rays_agreeing, proof.rays_checked);
        candidate.fail(format!("only {agreeing} of {checked} of its results agree"));
    }
    (proof.rays_checked > 0).then_some(proof)
}
