//! That a yardstick does nearly the same work: the share of its answers that agree.

use std::time::Duration;

use crate::math::CLOSE;
use crate::record::PeerAgreement;

use super::entrant::{Answers, Entrant, trace};
use super::proof::{Answer, Expected};

/// The share of answers that must agree; below it, its speed means nothing.
const LEAST_SHARE: f64 = 0.9999;

/// Compares a yardstick's answers with those that are expected, on as many rays of each class as
/// `share` has time for. It takes no further part if too few agree.
pub(super) fn check(
    entrant: &mut Entrant<'_>,
    expected: &[Expected<'_>],
    ray_times: &[Option<Duration>],
    share: Duration,
) -> Option<PeerAgreement> {
    let structure = entrant.structure.name.to_owned();
    let mut proof = PeerAgreement { structure, rays_checked: 0, rays_agreeing: 0, close: CLOSE };
    for (class, time) in expected.iter().zip(ray_times) {
        let (places, rays) = class.asked(*time, share);
        let query = class.set.query;
        let mut answers = Answers::default();
        entrant.attempt(|tracer| trace(tracer, query, &rays, &mut answers, None))?;
        let agrees = |&(i, &place): &(usize, &usize)| {
            class.answers.at(place, query).agrees(&answers.at(i, query))
        };
        proof.rays_checked += rays.len() as u64;
        proof.rays_agreeing += places.iter().enumerate().filter(agrees).count() as u64;
    }
    if proof.share().is_some_and(|share| share < LEAST_SHARE) {
        let (agreeing, checked) = (proof.rays_agreeing, proof.rays_checked);
        entrant.fail(format!("only {agreeing} of {checked} of its answers agree"));
    }
    (proof.rays_checked > 0).then_some(proof)
}

impl Answer {
    fn agrees(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Hit(a), Self::Hit(b)) => a.agrees(b),
            (a, b) => a == b,
        }
    }
}
