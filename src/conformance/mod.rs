//! Whether a structure keeps the contract of [`Accel`]: its answers against those of no structure
//! at all, bit for bit, on meshes and rays that are made to find differences.
//!
//! ```no_run
//! use srt::accel::Bvh;
//!
//! let summary = srt::conformance::check::<Bvh>().unwrap_or_else(|difference| panic!("{difference}"));
//! assert!(summary.rays > 50_000);
//! ```
//!
//! Any type that implements [`Accel`] stands in for `Bvh`: one test of one line checks a structure
//! of your own over triangles. `tests/equal_hits` holds the library's own structures to more rays
//! of the same kinds.

pub mod adversarial_rays;
pub mod axis_grids;
mod case;
mod difference;
mod limits;
pub mod nasty_meshes;
mod one_by_one;
mod summary;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use glam::Vec3;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::accel::{Accel, BuildOptions};
use crate::shapes::TriangleSet;

use case::{Case, Fault, Maker, Triangles, maker};
use limits::Shares;
use one_by_one::OneByOne;

#[cfg(feature = "program")]
pub(crate) use case::message_of;
pub use difference::{Answer, FirstDifference, Question, Way};
pub use limits::{Limits, Progress};
pub use summary::Summary;

/// Where each mesh is put: scales that round otherwise, and a place far off.
const PLACES: [(f32, Vec3); 4] =
    [(1.0, Vec3::ZERO), (1e6, Vec3::ZERO), (1e-6, Vec3::ZERO), (1e3, Vec3::splat(1e6))];

/// Compares a structure over the triangles of [`nasty_meshes`] with [`Exhaustive`](crate::accel::Exhaustive), by
/// [`adversarial_rays`] and [`axis_grids`] at scales from 10⁻⁶ to 10⁶: the first hit and any hit of all rays, and of
/// some of them all hits and filtered ones; as it is built, and as it has followed triangles that moved, in each way
/// that it offers.
///
/// # Errors
/// With the first ray, in an order that is always the same, for which its answers differ by a bit.
///
/// # Panics
/// Where the structure does: the message names the mesh, its place, and how the structure was built.
pub fn check<A: Accel>() -> Result<Summary, FirstDifference> {
    check_with::<A>(&BuildOptions::NONE, &Limits::NONE)
}

/// [`check`] of a structure as it is built with options, within limits. Where these end it, the
/// summary is of what was compared until then.
///
/// ```no_run
/// use std::time::Duration;
/// use srt::accel::{BuildOptions, Bvh};
/// use srt::conformance::{Limits, check_with};
///
/// let limits = Limits { time: Some(Duration::from_secs(2)), ..Limits::NONE };
/// match check_with::<Bvh>(&BuildOptions::NONE, &limits) {
///     Ok(summary) if summary.is_whole() => println!("it keeps the contract: {summary}"),
///     Ok(summary) => println!("nothing is known against it: {summary}"),
///     Err(difference) => println!("it does not: {difference}"),
/// }
/// ```
///
/// # Errors
/// As of [`check`]. Which ray is the first may depend on limits that end the check.
///
/// # Panics
/// Where the structure does: the message names the mesh, its place, and how the structure was built.
pub fn check_with<A: Accel>(
    options: &BuildOptions,
    limits: &Limits<'_>,
) -> Result<Summary, FirstDifference> {
    check_over::<TriangleSet, A>(options, limits)
}

/// [`check_with`], where triangles are tested one by one, as the objects of a scene are, and not in
/// packs.
///
/// # Errors
/// As of [`check_with`].
///
/// # Panics
/// Where the structure does: the message names the mesh, its place, and how the structure was built.
pub fn check_one_by_one<A: Accel>(
    options: &BuildOptions,
    limits: &Limits<'_>,
) -> Result<Summary, FirstDifference> {
    check_over::<OneByOne, A>(options, limits)
}

fn check_over<P: Triangles, A: Accel>(
    options: &BuildOptions,
    limits: &Limits<'_>,
) -> Result<Summary, FirstDifference> {
    let start = Instant::now();
    check_by(&maker::<P, A>(options), limits, &|| start.elapsed())
}

/// [`check_over`], of a structure as it is made, by a clock that shows how long the check has gone on. Compiled once
/// for all structures, as is what it calls.
fn check_by(
    maker: &Maker<'_>,
    limits: &Limits<'_>,
    clock: &(dyn Fn() -> Duration + Sync),
) -> Result<Summary, FirstDifference> {
    let mut meshes = nasty_meshes::all();
    meshes.push(nasty_meshes::empty("empty"));
    let large = nasty_meshes::terrain();
    let in_places = meshes.iter().flat_map(|mesh| PLACES.map(|place| (mesh, place)));
    let cases: Vec<(usize, Case<'_>)> = in_places
        .chain([(&large, PLACES[0])])
        .map(|(mesh, (scale, offset))| Case { mesh, scale, offset })
        .enumerate()
        .collect();
    let shares = Shares::new(limits.time, clock);
    let mut summaries = vec![Summary::default(); cases.len()];
    // What is left of the time goes to the meshes whose shares were too small.
    let mut left: Vec<(usize, Case<'_>)> = cases.clone();
    while !left.is_empty() {
        let (count, all) = (left.len(), cases.len());
        let compared = match check_all(&left, maker, limits, &shares, all) {
            Ok(compared) => compared,
            Err(Fault::Difference(difference)) => return Err(*difference),
            Err(Fault::Panic(message)) => panic!("{message}"),
        };
        for (&(number, _), own) in left.iter().zip(compared) {
            if own.rays >= summaries[number].rays {
                summaries[number] = own;
            }
        }
        left.retain(|&(number, _)| summaries[number].meshes == 0);
        if (limits.cancelled)() || shares.is_nearly_spent() || left.len() == count {
            break;
        }
    }
    let none = Summary { all_meshes: cases.len(), ..Summary::default() };
    Ok(summaries.into_iter().fold(none, Summary::plus))
}

/// Checks some of all cases in parallel, each in its share of the time.
fn check_all(
    cases: &[(usize, Case<'_>)],
    maker: &Maker<'_>,
    limits: &Limits<'_>,
    shares: &Shares<'_>,
    all: usize,
) -> Result<Vec<Summary>, Fault> {
    let (begun, done) = (AtomicUsize::new(0), AtomicUsize::new(all - cases.len()));
    // Behind a difference, or a panic, nothing needs to be compared; before it, there may be one that counts as the
    // first.
    let first_wrong = AtomicUsize::new(usize::MAX);
    let threads = rayon::current_num_threads();
    let results: Vec<_> = cases
        .par_iter()
        .map(|&(number, case)| {
            let left = cases.len() - begun.fetch_add(1, Ordering::Relaxed);
            let end = shares.end_of_next(left.div_ceil(threads));
            let ended = || {
                first_wrong.load(Ordering::Relaxed) < number
                    || shares.is_over(end)
                    || (limits.cancelled)()
            };
            let result = case.check(maker, &ended);
            if result.is_err() {
                first_wrong.fetch_min(number, Ordering::Relaxed);
            }
            (limits.progress)(done.fetch_add(1, Ordering::Relaxed) + 1, all);
            result
        })
        .collect();
    results.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use std::ops::{ControlFlow, Range};
    use std::time::Duration;

    use super::case::{answers, indexed};
    use super::*;
    use crate::accel::{
        Bounded, Build, Built, Exhaustive, Followed, Moved, Primitives, Query, Scratch, Search,
        Update,
    };
    use crate::counters::Counters;
    use crate::math::{BoxRay, Ray};

    /// Every primitive but those behind the end of the search: a tie at the end is lost, since the
    /// comparison is not inclusive.
    struct Exclusive(Vec<crate::math::Aabb>);

    impl Accel for Exclusive {
        fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
            let boxes = (0..primitives.count()).map(|i| primitives.bounds(i)).collect();
            Built { accel: Self(boxes), order: None }
        }

        fn traverse<C: Counters>(
            &self,
            ray: &Ray,
            box_ray: &BoxRay,
            counters: &mut C,
            mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            let mut end = ray.end();
            // The last first, so that a tie's smaller id comes late.
            for (slot, bounds) in (0..self.0.len() as u32).zip(&self.0).rev() {
                let (near, far) = box_ray.interval(bounds);
                if near.max(ray.t_min) < far.min(end) {
                    match leaf(slot..slot + 1, counters) {
                        ControlFlow::Continue(t) => end = t,
                        ControlFlow::Break(()) => return,
                    }
                }
            }
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    #[test]
    fn what_loses_ties_is_found_out() {
        let difference = check::<Exclusive>().unwrap_err();
        let text = difference.to_string();
        assert!(text.contains("mesh `lattice` times 1e0"), "{text}");
        assert!(text.contains("\n  got      ") && text.contains("\n  expected Hit"), "{text}");
        // The ray and the mesh that are named do show it.
        let meshes = nasty_meshes::all();
        let mesh = meshes.iter().find(|mesh| mesh.name == difference.mesh).unwrap();
        let moved = mesh.moved(difference.scale, difference.offset);
        let again =
            indexed::<TriangleSet, Exclusive>(&moved, difference.quality, &BuildOptions::NONE);
        let answer = answers(&again, &[difference.ray], difference.way)[0];
        assert!(answer.same_bits(&difference.got));
    }

    #[test]
    fn none_is_itself_one_by_one_too() {
        let (parts, last) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let progress = |done, of| {
            parts.fetch_add(1, Ordering::Relaxed);
            if done == of {
                last.store(of, Ordering::Relaxed);
            }
        };
        let limits = Limits { progress: &progress, ..Limits::NONE };
        let summary = check_one_by_one::<Exhaustive>(&BuildOptions::NONE, &limits).unwrap();
        assert_eq!(
            (summary.meshes, summary.all_meshes),
            (29, 29),
            "seven meshes in four places, and a large one"
        );
        assert!(summary.hits > summary.rays / 10, "{summary}");
        assert_eq!((parts.into_inner(), last.into_inner()), (29, 29));
    }

    /// No structure, which panics where there are many primitives.
    struct Fragile(Exhaustive);

    impl Accel for Fragile {
        fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
            assert!(primitives.count() < 10_000, "a node is lost");
            let Built { accel, order } = Exhaustive::build(primitives, build);
            Built { accel: Self(accel), order }
        }

        fn traverse<C: Counters>(
            &self,
            ray: &Ray,
            box_ray: &BoxRay,
            counters: &mut C,
            leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            self.0.traverse(ray, box_ray, counters, leaf);
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    #[test]
    #[should_panic(
        expected = "mesh `terrain` times 1e0 plus [0, 0, 0], built `medium`, triangles tested one by one: \
                    a node is lost"
    )]
    fn a_panic_names_what_it_is_over() {
        let _ = check_one_by_one::<Fragile>(&BuildOptions::NONE, &Limits::NONE);
    }

    /// No structure, which forgets all primitives where some of them are refitted by their slots.
    struct Forgetful {
        none: Exhaustive,
        has_followed: bool,
    }

    impl Accel for Forgetful {
        const UPDATES: &'static [Update] = &[Update::Refit];

        fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
            let Built { accel: none, order } = Exhaustive::build(primitives, build);
            Built { accel: Self { none, has_followed: false }, order }
        }

        fn traverse<C: Counters>(
            &self,
            ray: &Ray,
            box_ray: &BoxRay,
            counters: &mut C,
            leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            if !self.has_followed {
                self.none.traverse(ray, box_ray, counters, leaf);
            }
        }

        fn refit<P: Primitives>(
            &mut self,
            _: Update,
            primitives: &P,
            moved: Moved<'_>,
            _: &Build<'_>,
        ) -> Followed {
            self.has_followed = matches!(moved, Moved::Slots(slots) if !slots.is_empty());
            Followed::in_place(primitives.total_bounds())
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    #[test]
    fn structures_follow_slots() {
        let difference = check::<Forgetful>().unwrap_err();
        assert_eq!(difference.update, Some(Update::Refit));
        assert!(difference.to_string().contains("built `medium` and refitted, traced"));
    }

    /// No structure, which answers no query of a slice but those that keep one hit of all there are.
    struct Partial(Exhaustive, bool);

    impl Accel for Partial {
        fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
            let Built { accel, order } = Exhaustive::build(primitives, build);
            Built { accel: Self(accel, true), order }
        }

        fn traverse<C: Counters>(
            &self,
            ray: &Ray,
            box_ray: &BoxRay,
            counters: &mut C,
            leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            self.0.traverse(ray, box_ray, counters, leaf);
        }

        fn search<P: Primitives, Q: Query, C: Counters>(
            &self,
            query: &Q,
            primitives: &P,
            rays: &[Ray],
            answers: &mut [Q::Answer],
            scratch: &mut Scratch,
            counters: &mut C,
        ) {
            let is_known = Q::KEEPS_ONE_HIT && !Q::FILTERS;
            let has_all = if self.1 { Q::FILTERS } else { Q::SEARCH == Search::All };
            if is_known || has_all {
                self.0.search(query, primitives, rays, answers, scratch, counters);
            }
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    /// The same with filters that it does not know, in the place of all hits.
    struct Unfiltered(Partial);

    impl Accel for Unfiltered {
        fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
            let Built { accel: Partial(accel, _), order } = Partial::build(primitives, build);
            Built { accel: Self(Partial(accel, false)), order }
        }

        fn traverse<C: Counters>(
            &self,
            ray: &Ray,
            box_ray: &BoxRay,
            counters: &mut C,
            leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            self.0.traverse(ray, box_ray, counters, leaf);
        }

        fn search<P: Primitives, Q: Query, C: Counters>(
            &self,
            query: &Q,
            primitives: &P,
            rays: &[Ray],
            answers: &mut [Q::Answer],
            scratch: &mut Scratch,
            counters: &mut C,
        ) {
            self.0.search(query, primitives, rays, answers, scratch, counters);
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    #[test]
    fn all_hits_and_filtered_ones_are_asked_for() {
        let difference = check::<Partial>().unwrap_err();
        assert_eq!((difference.question, difference.way), (Question::All, Way::Slice));
        assert!(difference.to_string().contains(", all hits, traced in a slice"), "{difference}");
        let difference = check::<Unfiltered>().unwrap_err();
        assert_eq!(difference.question, Question::Filtered);
        assert!(
            difference.to_string().contains(", hits filtered, traced in a slice"),
            "{difference}"
        );
    }

    /// How many times a ray has been traced through [`Slow`].
    static TRAVERSALS: AtomicUsize = AtomicUsize::new(0);

    /// No structure, which counts its traversals: each stands for a millisecond.
    struct Slow(Exhaustive);

    impl Accel for Slow {
        fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
            let Built { accel, order } = Exhaustive::build(primitives, build);
            Built { accel: Self(accel), order }
        }

        fn traverse<C: Counters>(
            &self,
            ray: &Ray,
            box_ray: &BoxRay,
            counters: &mut C,
            leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            TRAVERSALS.fetch_add(1, Ordering::Relaxed);
            self.0.traverse(ray, box_ray, counters, leaf);
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    #[test]
    fn what_is_slow_is_compared_on_some_rays_of_all_meshes() {
        // All rays would take more than half an hour. The time is simulated, so that what else the machine does is
        // no part of it.
        let clock = || Duration::from_millis(TRAVERSALS.load(Ordering::Relaxed) as u64);
        let limits = Limits { time: Some(Duration::from_secs(6)), ..Limits::NONE };
        let options = BuildOptions::NONE;
        let slow = maker::<TriangleSet, Slow>(&options);
        let summary = check_by(&slow, &limits, &clock).unwrap();
        assert!(clock() < Duration::from_secs(12), "{:?}", clock());
        assert!(!summary.is_whole() && summary.rays > 100 && summary.hits > 10, "{summary}");
        let text = summary.to_string();
        assert!(text.ends_with("ended with 0 of 29 meshes compared in full"), "{text}");
    }

    #[test]
    fn a_check_ends_when_it_is_cancelled() {
        let calls = AtomicUsize::new(0);
        let cancelled = || calls.fetch_add(1, Ordering::Relaxed) >= 3;
        let limits = Limits { cancelled: &cancelled, ..Limits::NONE };
        let summary = check_with::<Exhaustive>(&BuildOptions::NONE, &limits).unwrap();
        assert!(!summary.is_whole() && summary.meshes == 0 && summary.rays <= 64, "{summary}");
    }
}
