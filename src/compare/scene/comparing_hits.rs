//! The third step: compares the hits of all structures with those of a reference.
//!
//! Where the reference has time for some of the rays only, a structure that agrees with it on these
//! is the witness for all others: a few rays meet few primitives, and would not catch a structure
//! that loses some of the rest.

use std::time::Duration;

use crate::compare::agreement;
use crate::compare::budget::Budget;
use crate::compare::candidate::Candidate;
use crate::compare::context::SceneContext;
use crate::compare::proof::{check_rays, expected, time_for_class};
use crate::compare::trial::time_of_all;
use crate::record::Proof;

use super::picture_times::{PictureTimes, picture_budget};
use super::recording::SceneRays;

/// Compares all results with the reference's; `None` if no structure can be that.
pub(super) fn compare_hits(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    rays: &SceneRays,
    budget: Budget,
) -> Option<Proof> {
    let (settings, time) = (context.picture_settings(), picture_budget(budget));
    let pictures =
        PictureTimes::of_builds_and_renderings(context, candidates, rays, &settings, time);
    let reference = reference(candidates, rays, &pictures.fit)?;
    let time = time_for_class(budget.left(), candidates.len(), rays.sets.len());
    let times = &rays.times;
    let expected = expected(&mut candidates[reference], &rays.sets, &times[reference], time);
    let has_all = expected.iter().all(|class| class.is_whole());
    let mut proof =
        Proof { reference: candidates[reference].name().to_owned(), ..Proof::default() };
    for (candidate, times) in candidates.iter_mut().zip(times) {
        if (context.cancelled)() {
            break;
        }
        if candidate.is_peer() {
            proof.peers.extend(agreement::check(candidate, &expected, times, time));
            continue;
        }
        let own = check_rays(candidate, &expected, times, time);
        if own.rays_checked > 0 {
            proof.structures.push(own);
        }
    }
    if !has_all && !(context.cancelled)() {
        compare_with_witness(candidates, rays, reference, time, &mut proof);
    }
    Some(proof)
}

/// The reference: `none`, if it has time for a picture; else the first structure that has, one of the
/// library if there is any; else the quickest. One that does not conform is none. `fit` are those that
/// have time for a picture.
fn reference(candidates: &[Candidate<'_>], rays: &SceneRays, fit: &[usize]) -> Option<usize> {
    let can_be = |i: &usize| !candidates[*i].is_peer() && candidates[*i].is_fit();
    let is_foreign = |i: &usize| !candidates[*i].is_of_library();
    let none = || fit.iter().copied().find(|&i| candidates[i].name() == "none");
    let with_time = || fit.iter().copied().filter(can_be).min_by_key(is_foreign);
    let can_trace = |i: &usize| can_be(i) && candidates[*i].can_trace();
    // The quickest traces the most rays.
    let time = |i: &usize| time_of_all(&rays.times[*i], &rays.sets);
    let quickest =
        || (0..candidates.len()).filter(can_trace).min_by_key(|i| (is_foreign(i), time(i)));
    none().or_else(with_time).or_else(quickest)
}

/// Compares all results with those of a witness: a structure that agreed with the reference and has
/// time for all rays.
fn compare_with_witness(
    candidates: &mut [Candidate<'_>],
    rays: &SceneRays,
    reference: usize,
    time: Duration,
    proof: &mut Proof,
) {
    let Some(witness) = witness(candidates, rays, reference, time, proof) else { return };
    let times = &rays.times;
    let expected = expected(&mut candidates[witness], &rays.sets, &times[witness], time);
    for (index, (candidate, times)) in candidates.iter_mut().zip(times).enumerate() {
        let name = candidate.name();
        let entry = proof.structures.iter_mut().find(|entry| entry.structure == name);
        let Some(entry) = entry.filter(|_| index != reference && index != witness) else {
            continue;
        };
        let own = check_rays(candidate, &expected, times, time);
        // The rays that the reference traced are among these.
        entry.rays_checked = entry.rays_checked.max(own.rays_checked);
        entry.differing_hits = entry.differing_hits.max(own.differing_hits);
        entry.first_difference = entry.first_difference.take().or(own.first_difference);
    }
    proof.witness = Some(candidates[witness].name().to_owned());
}

/// The first structure of the library that agreed with the reference and has time for all rays of
/// each class.
fn witness(
    candidates: &[Candidate<'_>],
    rays: &SceneRays,
    reference: usize,
    time: Duration,
    proof: &Proof,
) -> Option<usize> {
    let has_time = |i: usize| {
        rays.sets.iter().zip(&rays.times[i]).all(|(set, ray_time)| {
            let all = |ray: Duration| ray.as_secs_f64() * set.rays.len() as f64;
            ray_time.is_some_and(|ray| all(ray) <= time.as_secs_f64())
        })
    };
    let agreed = |name: &str| proof.structure(name).is_some_and(|own| own.rays_checked > 0);
    let can_be = |candidate: &Candidate<'_>| {
        !candidate.is_peer() && candidate.is_of_library() && candidate.can_trace()
    };
    (0..candidates.len())
        .filter(|&i| i != reference && can_be(&candidates[i]) && has_time(i))
        .find(|&i| agreed(candidates[i].name()))
}
