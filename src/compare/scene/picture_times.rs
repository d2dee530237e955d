//! How long pictures will take, by what their rays take, and which structures have time for one.

use std::time::Duration;

use crate::compare::budget::Budget;
use crate::compare::candidate::Candidate;
use crate::compare::context::SceneContext;
use crate::compare::trial::RayTimes;
use crate::record::RayClass;
use crate::render::Settings;

use super::recording::SceneRays;

/// What a ray costs beside its search: shading, sampling, and the handling of waves.
const SHADING: Duration = Duration::from_nanos(150);

/// The share of what is left of a scene's budget that its picture may take.
const SHARE_OF_PICTURE: f64 = 0.45;

/// The budget of a scene's picture, of what is left for the scene.
pub(super) fn picture_budget(budget: Budget) -> Budget {
    budget.share(SHARE_OF_PICTURE)
}

/// View samples of a picture.
pub(super) fn view_samples(settings: &Settings) -> f64 {
    f64::from(settings.width) * f64::from(settings.height) * f64::from(settings.samples_per_pixel())
}

/// How long a picture will take each structure, and which of them have time for it.
pub(super) struct PictureTimes {
    /// `None` for structures that cannot trace. Without the builds.
    pub(super) times: Vec<Option<Duration>>,
    /// The places of those that have time for the picture.
    pub(super) fit: Vec<usize>,
}

impl PictureTimes {
    /// Of renderings alone.
    pub(super) fn of_renderings(
        context: &SceneContext<'_>,
        candidates: &[Candidate<'_>],
        rays: &SceneRays,
        settings: &Settings,
        budget: Budget,
    ) -> Self {
        let times = estimates(context, candidates, rays, settings);
        let fit = that_fit(&times, budget.left());
        Self { times, fit }
    }

    /// Of builds and the renderings after them.
    pub(super) fn of_builds_and_renderings(
        context: &SceneContext<'_>,
        candidates: &[Candidate<'_>],
        rays: &SceneRays,
        settings: &Settings,
        budget: Budget,
    ) -> Self {
        let times = estimates(context, candidates, rays, settings);
        let with_build = |(candidate, time): (&Candidate<'_>, &Option<Duration>)| {
            Some((*time)?.saturating_add(candidate.build_report()?.time))
        };
        let with_builds: Vec<_> = candidates.iter().zip(&times).map(with_build).collect();
        let fit = that_fit(&with_builds, budget.left());
        Self { times, fit }
    }

    /// One sentence about all that have no time for the picture.
    pub(super) fn note_missing(&self, candidates: &[Candidate<'_>], what: &str) -> Option<String> {
        let missing = |(index, candidate): (usize, &Candidate<'_>)| {
            let time = self.times[index].filter(|_| !self.fit.contains(&index))?;
            Some(format!("`{}` (about {})", candidate.name(), in_words(time)))
        };
        let missing: Vec<String> = candidates.iter().enumerate().filter_map(missing).collect();
        (!missing.is_empty())
            .then(|| format!("there was no time for a {what} with {}.", missing.join(", ")))
    }
}

/// How long each structure needs for a picture's view samples and all rays that follow from them.
fn estimates(
    context: &SceneContext<'_>,
    candidates: &[Candidate<'_>],
    rays: &SceneRays,
    settings: &Settings,
) -> Vec<Option<Duration>> {
    let (samples, threads) = (view_samples(settings), context.plan.threads);
    let estimate = |(times, candidate): (&RayTimes, &Candidate<'_>)| {
        estimate(rays, candidate.can_trace().then_some(times)?, samples, threads)
    };
    rays.times.iter().zip(candidates).map(estimate).collect()
}

fn estimate(rays: &SceneRays, times: &RayTimes, samples: f64, threads: usize) -> Option<Duration> {
    // 0 for those that a renderer does not send.
    let per_sample = |class: RayClass| {
        rays.per_sample.iter().find(|(other, _)| *other == class).map_or(0.0, |(_, rays)| *rays)
    };
    let mut seconds = 0.0;
    for (set, time) in rays.sets.iter().zip(times) {
        let time = (*time)? + SHADING;
        seconds += per_sample(set.class) * samples * time.as_secs_f64();
    }
    Some(Duration::from_secs_f64((seconds / threads as f64).min(1e9)))
}

/// Which structures have time for something, the quickest first: their times add up to no more
/// than `budget`.
fn that_fit(times: &[Option<Duration>], budget: Duration) -> Vec<usize> {
    let mut known: Vec<(Duration, usize)> =
        times.iter().enumerate().filter_map(|(i, time)| Some(((*time)?, i))).collect();
    known.sort();
    let mut sum = Duration::ZERO;
    let fits = known.into_iter().take_while(|(time, _)| {
        sum = sum.saturating_add(*time);
        sum <= budget
    });
    let mut fit: Vec<usize> = fits.map(|(_, index)| index).collect();
    fit.sort_unstable();
    fit
}

/// A time that was estimated, with two figures, in the largest unit of which it has two.
fn in_words(time: Duration) -> String {
    const UNITS: [(&str, f64); 5] =
        [("days", 86_400.0), ("h", 3_600.0), ("min", 60.0), ("s", 1.0), ("ms", 1e-3)];
    let seconds = time.as_secs_f64();
    let fits = |(_, length): &(&str, f64)| seconds >= 2.0 * length;
    let (unit, length) = UNITS.into_iter().find(fits).unwrap_or(("ms", 1e-3));
    let value = seconds / length;
    if value < 10.0 { format!("{value:.1} {unit}") } else { format!("{value:.0} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_in_a_unit_that_people_read() {
        let words = |seconds| in_words(Duration::from_secs_f64(seconds));
        assert_eq!([0.001_2, 1.5, 45.0].map(words), ["1.2 ms", "1500 ms", "45 s"]);
        assert_eq!([130.0, 9_000.0, 1_197_504.0].map(words), ["2.2 min", "2.5 h", "14 days"]);
    }

    #[test]
    fn the_quickest_fit_first() {
        let seconds = |s: u64| Some(Duration::from_secs(s));
        let times = [seconds(50), seconds(3), None, seconds(1)];
        assert_eq!(that_fit(&times, Duration::from_secs(5)), [1, 3]);
        assert_eq!(that_fit(&times, Duration::from_secs(100)), [0, 1, 3]);
        assert_eq!(that_fit(&times, Duration::ZERO), [0usize; 0]);
    }
}
