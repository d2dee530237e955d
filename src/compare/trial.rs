//! How long a ray takes a structure, by a short trial before anything is measured: budgets are
//! divided by it.

use std::time::Duration;

use crate::accel::Tracer;
use crate::math::Ray;

use super::candidate::Candidate;
use super::clock::timed;
use super::record_rays::RaySet;
use super::trace::trace;

/// For each set of rays, the time of one of its rays; `None` where the structure failed.
pub(super) type RayTimes = Vec<Option<Duration>>;

/// A trial ends once it has taken this long.
const TRIAL_TIME: Duration = Duration::from_millis(3);

/// A trial that has taken this long is not repeated.
const NOT_REPEATED: Duration = Duration::from_millis(60);

/// In how many places of the sequence a trial's rays lie, at most.
const MOST_RUNS: usize = 4;

/// How many times as long on the wall as of its own a trial may take, at most.
const MOST_WAITING: u64 = 4;

/// The time of a ray of each set, one after the other: each trial has the results of those before.
pub(super) fn ray_times(candidate: &mut Candidate<'_>, sets: &[RaySet]) -> RayTimes {
    let mut longest = None;
    let time = |set| {
        let time = ray_time(candidate, set, longest);
        longest = longest.max(time);
        time
    };
    sets.iter().map(time).collect()
}

/// How long one of a structure's rays takes; `None` if it fails.
///
/// `known` is what a ray of another class took it. If that is longer than a trial may take, there
/// is no other trial: such a structure tests nearly everything for rays of any class, and every
/// one of them would cost more than a small budget has.
fn ray_time(
    candidate: &mut Candidate<'_>,
    set: &RaySet,
    known: Option<Duration>,
) -> Option<Duration> {
    if known.is_some_and(|known| known >= TRIAL_TIME) {
        return known.filter(|_| candidate.can_trace());
    }
    candidate.attempt(|tracer| {
        let mut count = 1;
        loop {
            let rays = runs(&set.rays, count);
            // The quicker of two, unless the first took very long: caches were cold, pages had to be brought
            // back, or another program had the processor.
            let first = time(tracer, set, &rays);
            let again = || time(tracer, set, &rays);
            let time = if first >= NOT_REPEATED { first } else { first.min(again()) };
            if time >= TRIAL_TIME || rays.len() == set.rays.len() {
                return time.div_f64(rays.len().max(1) as f64);
            }
            count *= 4;
        }
    })
}

/// At most `count` rays, in a few runs of consecutive ones, as a renderer sends them: single rays would take longer.
fn runs(rays: &[Ray], count: usize) -> Vec<Ray> {
    if count >= rays.len() {
        return rays.to_vec();
    }
    let runs = count.clamp(1, MOST_RUNS);
    let length = count / runs;
    let run = |run: usize| &rays[run * rays.len() / runs..][..length];
    (0..runs).flat_map(run).copied().collect()
}

/// The time of some rays. What other programs take of the processor now, they will take of the
/// rounds too, but a single interruption of a short trial must not count as that.
fn time(tracer: &dyn Tracer, set: &RaySet, rays: &[Ray]) -> Duration {
    let work = || trace(tracer, rays, &mut set.results(), None);
    let round = timed(work).1;
    Duration::from_nanos(round.wall_ns.min(round.own_ns().saturating_mul(MOST_WAITING)))
}

/// How long a structure needs for all rays of all sets; [`Duration::MAX`] if a trial failed.
pub(super) fn time_of_all(times: &[Option<Duration>], sets: &[RaySet]) -> Duration {
    let of_set = |(time, set): (&Option<Duration>, &RaySet)| {
        time.as_ref()?.checked_mul(u32::try_from(set.rays.len()).ok()?)
    };
    let all = times.iter().zip(sets).map(of_set);
    all.sum::<Option<Duration>>().unwrap_or(Duration::MAX)
}

/// How many rays a structure can trace in some time; none if a ray's time is not known.
pub(super) fn affordable(ray_time: Option<Duration>, time: Duration) -> usize {
    ray_time.map_or(0, |ray| (time.as_secs_f64() / ray.as_secs_f64().max(1e-12)) as usize)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn a_trial_has_runs_of_rays_and_at_last_all() {
        let rays: Vec<Ray> = (0..18).map(|i| Ray::new(Vec3::splat(i as f32), Vec3::X)).collect();
        let origins = |count| runs(&rays, count).iter().map(|ray| ray.origin.x).collect::<Vec<_>>();
        assert_eq!(origins(1), [0.0]);
        assert_eq!(origins(8), [0.0, 1.0, 4.0, 5.0, 9.0, 10.0, 13.0, 14.0]);
        assert_eq!(origins(18).len(), 18);
        assert_eq!(origins(64).len(), 18);
    }
}
