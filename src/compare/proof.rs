//! That all structures do the same work: equal hits and equal pictures, bit for bit.

use std::fmt::Write;
use std::time::Duration;

use crate::accel::Tracer;
use crate::image_io::{Picture, compare};
use crate::math::{Hit, Ray};
use crate::record::StructureProof;

use super::entrant::{Answers, Entrant, trace};
use super::hash::picture_hash;
use super::record_rays::{Query, RaySet, spread};

/// What comparing a class may always take for each structure, even if the budget is spent: quick
/// structures are never measured without it.
pub(super) const LEAST_SHARE: Duration = Duration::from_millis(2);

/// What the reference says to the rays of a class.
pub(super) struct Expected<'a> {
    pub(super) set: &'a RaySet,
    rays: Vec<Ray>,
    pub(super) answers: Answers,
}

impl Expected<'_> {
    /// Whether the reference answered all recorded rays of the class.
    pub(super) fn is_whole(&self) -> bool {
        self.rays.len() == self.set.rays.len()
    }

    /// As many of the rays as `share` has time for, evenly spread, and their places.
    pub(super) fn asked(&self, time: Option<Duration>, share: Duration) -> (Vec<usize>, Vec<Ray>) {
        let count = affordable(time, share).min(self.rays.len());
        let places: Vec<usize> = (0..count).map(|i| i * self.rays.len() / count).collect();
        let rays = places.iter().map(|&place| self.rays[place]).collect();
        (places, rays)
    }
}

/// The reference's answers to as many rays of each class as `share` has time for.
pub(super) fn expected<'a>(
    reference: &mut Entrant<'_>,
    sets: &'a [RaySet],
    ray_times: &[Option<Duration>],
    share: Duration,
) -> Vec<Expected<'a>> {
    let mut all = Vec::new();
    for (set, time) in sets.iter().zip(ray_times) {
        let rays = spread(&set.rays, affordable(*time, share));
        let mut answers = Answers::default();
        if reference.attempt(|tracer| trace(tracer, set.query, &rays, &mut answers, None)).is_some()
        {
            all.push(Expected { set, rays, answers });
        }
    }
    all
}

fn affordable(time: Option<Duration>, share: Duration) -> usize {
    time.map_or(0, |time| (share.as_secs_f64() / time.as_secs_f64().max(1e-12)) as usize)
}

/// Compares a structure's answers with those that are expected, on as many rays of each class as
/// `share` has time for.
pub(super) fn check_rays(
    entrant: &mut Entrant<'_>,
    expected: &[Expected<'_>],
    ray_times: &[Option<Duration>],
    share: Duration,
    proof: &mut StructureProof,
) {
    for (class, time) in expected.iter().zip(ray_times) {
        let (places, rays) = class.asked(*time, share);
        let mut answers = Answers::default();
        let query = class.set.query;
        let traced = entrant.attempt(|tracer| {
            trace(tracer, query, &rays, &mut answers, None);
            let differs = |&i: &usize| !class.answers.same(places[i], &answers, i, query);
            let differing: Vec<usize> = (0..rays.len()).filter(differs).collect();
            let text = differing.first().map(|&first| {
                let expected = class.answers.at(places[first], query);
                let class = class.set.class.name();
                describe(class, &smallest(tracer, query, rays[first], &expected), tracer, &expected)
            });
            (differing.len() as u64, text)
        });
        let Some((differing, text)) = traced else { return };
        proof.rays_checked += rays.len() as u64;
        proof.differing_hits += differing;
        proof.first_difference = proof.first_difference.take().or(text);
    }
}

/// One answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Answer {
    Hit(Hit),
    Blocked(bool),
}

impl Answers {
    pub(super) fn at(&self, place: usize, query: Query) -> Answer {
        match query {
            Query::Closest => Answer::Hit(self.hits[place]),
            Query::Any => Answer::Blocked(self.blocked[place]),
        }
    }

    fn same(&self, place: usize, other: &Self, other_place: usize, query: Query) -> bool {
        self.at(place, query).same_bits(&other.at(other_place, query))
    }
}

impl Answer {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Hit(a), Self::Hit(b)) => a.same_bits(b),
            (a, b) => a == b,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Hit(hit) if hit.is_hit() => {
                let Hit { t, object, prim, u, v } = hit;
                format!("t {t:?}, object {object}, primitive {prim}, u {u:?}, v {v:?}")
            }
            Self::Hit(_) => "nothing".to_owned(),
            Self::Blocked(true) => "blocked".to_owned(),
            Self::Blocked(false) => "not blocked".to_owned(),
        }
    }
}

/// The ray, cut to the piece around the hit that is expected if the answer is still another one:
/// fewer primitives are left that could be to blame.
fn smallest(tracer: &dyn Tracer, query: Query, ray: Ray, expected: &Answer) -> Ray {
    let Answer::Hit(hit) = expected else { return ray };
    if !hit.is_hit() {
        return ray;
    }
    let mut found = ray;
    for shorter in [Ray { t_max: hit.t, ..ray }, Ray { t_min: hit.t, t_max: hit.t, ..ray }] {
        if !answer(tracer, query, &shorter).same_bits(expected) {
            found = shorter;
        }
    }
    found
}

fn answer(tracer: &dyn Tracer, query: Query, ray: &Ray) -> Answer {
    let mut answers = Answers::default();
    trace(tracer, query, std::slice::from_ref(ray), &mut answers, None);
    answers.at(0, query)
}

/// A ray in full precision (what is printed reads back as the same bits), and both answers.
fn describe(class: &str, ray: &Ray, tracer: &dyn Tracer, expected: &Answer) -> String {
    let query = match expected {
        Answer::Hit(_) => Query::Closest,
        Answer::Blocked(_) => Query::Any,
    };
    let Ray { origin: o, dir: d, t_min, t_max } = ray;
    let mut text = format!("{class} ray: origin {:?} {:?} {:?}, ", o.x, o.y, o.z);
    // Writing to a string cannot fail.
    let _ =
        write!(text, "direction {:?} {:?} {:?}, t from {t_min:?} to {t_max:?}; ", d.x, d.y, d.z);
    let got = answer(tracer, query, ray);
    let _ = write!(text, "expected {}, got {}", expected.text(), got.text());
    text
}

/// Compares a structure's picture with the reference's.
pub(super) fn check_picture(expected: &Picture, own: &Picture, proof: &mut StructureProof) {
    proof.picture_hash = Some(picture_hash(own));
    let Ok(difference) = compare(expected, own) else { return };
    proof.picture_equal = Some(difference.differing == 0);
    proof.differing_pixels = difference.differing;
    proof.largest_difference = f64::from(difference.largest.min(f32::MAX));
}
