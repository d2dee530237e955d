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
pub mod nasty_meshes;
mod one_by_one;

use std::fmt;
use std::sync::atomic::{AtomicUsize, Ordering};

use glam::Vec3;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::accel::{
    Accel, AnyHit, BuildConfig, BuildOptions, ClosestHit, Exhaustive, Indexed, Primitives, Quality,
    Query, Scratch,
};
use crate::counters::{Counts, NoCounters};
use crate::math::{Hit, Ray};
use crate::shapes::TriangleSet;

use adversarial_rays::{bundles_around, rays_at, rays_cut_at_hits};
use axis_grids::grids_over;
use nasty_meshes::Mesh;
use one_by_one::OneByOne;

/// Rays that are aimed at each mesh in each place; about as many again are made of them.
const RAYS: usize = 2_000;

/// Where each mesh is put: scales that round otherwise, and a place far off.
const PLACES: [(f32, Vec3); 4] =
    [(1.0, Vec3::ZERO), (1e6, Vec3::ZERO), (1e-6, Vec3::ZERO), (1e3, Vec3::splat(1e6))];

/// What was compared, with no difference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Meshes, each scaled and moved in several ways.
    pub meshes: usize,
    /// Rays, each searched for its closest and for any hit, in slices and alone.
    pub rays: usize,
    /// How many of them hit something.
    pub hits: usize,
}

/// The first ray whose answers differ.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub struct FirstDifference {
    /// The mesh, by its name in [`nasty_meshes`].
    pub mesh: &'static str,
    /// What it was scaled by.
    pub scale: f32,
    /// What it was moved by after that.
    pub offset: Vec3,
    /// How the structure was to be built.
    pub quality: Quality,
    /// How the ray was searched for.
    pub way: Way,
    /// The ray.
    pub ray: Ray,
    /// What every structure must answer.
    pub expected: Answer,
    /// What this one did.
    pub got: Answer,
}

/// Both answers for a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Its first hit.
    pub hit: Hit,
    /// Whether it hits anything.
    pub blocked: bool,
}

/// How rays are searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Many in a slice.
    Slice,
    /// Many in a slice, and what is tested counted.
    Counted,
    /// By themselves.
    Alone,
}

/// Compares a structure over the triangles of [`nasty_meshes`] with [`Exhaustive`], by
/// [`adversarial_rays`] and [`axis_grids`] at scales from 10⁻⁶ to 10⁶.
///
/// # Errors
/// With the first ray, in an order that is always the same, for which its answers differ by a bit.
///
/// # Panics
/// Where the structure does.
pub fn check<A: Accel>() -> Result<Summary, FirstDifference> {
    check_with::<A>(&BuildOptions::NONE, &|_, _| ())
}

/// [`check`] of a structure as it is built with options. `progress` is called with how many parts of
/// the work are done, and of how many; from several threads, not always in order.
///
/// # Errors
/// As of [`check`].
///
/// # Panics
/// Where the structure does.
pub fn check_with<A: Accel>(
    options: &BuildOptions,
    progress: &Progress,
) -> Result<Summary, FirstDifference> {
    check_over::<TriangleSet, A>(options, progress)
}

/// [`check_with`], where triangles are tested one by one, as the objects of a scene are, and not in
/// packs.
///
/// # Errors
/// As of [`check`].
///
/// # Panics
/// Where the structure does.
pub fn check_one_by_one<A: Accel>(
    options: &BuildOptions,
    progress: &Progress,
) -> Result<Summary, FirstDifference> {
    check_over::<OneByOne, A>(options, progress)
}

/// Is called with how many parts of a check are done, and of how many.
pub type Progress<'a> = dyn Fn(usize, usize) + Sync + 'a;

/// Triangles, in packs or one by one.
trait Triangles: Primitives {
    fn of(mesh: &Mesh) -> Self;
}

impl Triangles for TriangleSet {
    fn of(mesh: &Mesh) -> Self {
        Self::new(&mesh.positions, &mesh.triangles)
    }
}

impl Triangles for OneByOne {
    fn of(mesh: &Mesh) -> Self {
        Self(TriangleSet::of(mesh))
    }
}

fn check_over<P: Triangles, A: Accel>(
    options: &BuildOptions,
    progress: &Progress,
) -> Result<Summary, FirstDifference> {
    let mut meshes = nasty_meshes::all();
    meshes.push(nasty_meshes::empty("empty"));
    let cases: Vec<(&Mesh, f32, Vec3)> = meshes
        .iter()
        .flat_map(|mesh| PLACES.map(|(scale, offset)| (mesh, scale, offset)))
        .collect();
    let done = AtomicUsize::new(0);
    let results: Vec<_> = cases
        .par_iter()
        .map(|&(mesh, scale, offset)| {
            let result = check_in_place::<P, A>(mesh, (scale, offset), options);
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, cases.len());
            result
        })
        .collect();
    let mut summary = Summary { meshes: meshes.len(), ..Summary::default() };
    for result in results {
        let (rays, hits) = result?;
        summary.rays += rays;
        summary.hits += hits;
    }
    Ok(summary)
}

/// Compares on one mesh in one place: how many rays, and how many hits.
fn check_in_place<P: Triangles, A: Accel>(
    mesh: &Mesh,
    (scale, offset): (f32, Vec3),
    options: &BuildOptions,
) -> Result<(usize, usize), FirstDifference> {
    let moved = mesh.moved(scale, offset);
    let none = indexed::<TriangleSet, Exhaustive>(&moved, Quality::Medium, &BuildOptions::NONE);
    // Even where there is nothing, rays are aimed at something.
    let target = if mesh.triangles.is_empty() { nasty_meshes::single() } else { moved.clone() };
    let aimed_at = rays_at(&target, RAYS, 99);
    let aimed = answers(&none, &aimed_at, Way::Slice);
    let hits: Vec<Hit> = aimed.iter().map(|answer| answer.hit).collect();
    let mut rays = aimed_at.clone();
    rays.extend(bundles_around(&aimed_at[..RAYS / 64]));
    rays.extend(grids_over(&target, 8, 23));
    // Last, because their number is any: the others go together by sixteens.
    rays.extend(rays_cut_at_hits(&aimed_at, &hits));
    let expected = answers(&none, &rays, Way::Slice);
    // The quality is what the tree looks like, and the scale how numbers round: not all of both.
    let qualities: &[Quality] = match scale {
        1.0 => &[Quality::Fastest, Quality::Medium, Quality::Slowest],
        _ => &[Quality::Medium],
    };
    for &quality in qualities {
        let own = indexed::<P, A>(&moved, quality, options);
        for way in [Way::Slice, Way::Counted, Way::Alone] {
            let got = answers(&own, &rays, way);
            if let Some(i) = (0..rays.len()).find(|&i| !got[i].same_bits(&expected[i])) {
                let (ray, expected, got) = (rays[i], expected[i], got[i]);
                let mesh = mesh.name;
                return Err(FirstDifference {
                    mesh,
                    scale,
                    offset,
                    quality,
                    way,
                    ray,
                    expected,
                    got,
                });
            }
        }
    }
    Ok((rays.len(), expected.iter().filter(|answer| answer.hit.is_hit()).count()))
}

fn indexed<P: Triangles, A: Accel>(
    mesh: &Mesh,
    quality: Quality,
    options: &BuildOptions,
) -> Indexed<P, A> {
    let config = BuildConfig { quality, options: options.clone(), ..BuildConfig::default() };
    Indexed::build(P::of(mesh), &config)
}

fn answers<P: Primitives, A: Accel>(index: &Indexed<P, A>, rays: &[Ray], way: Way) -> Vec<Answer> {
    if way == Way::Alone {
        let alone = |ray| Answer { hit: index.hit(ray), blocked: index.occluded(ray) };
        return rays.iter().map(alone).collect();
    }
    let hits = of_slice(index, ClosestHit, rays, way);
    let blocked = of_slice(index, AnyHit, rays, way);
    hits.into_iter().zip(blocked).map(|(hit, blocked)| Answer { hit, blocked }).collect()
}

fn of_slice<P: Primitives, A: Accel, Q: Query>(
    index: &Indexed<P, A>,
    query: Q,
    rays: &[Ray],
    way: Way,
) -> Vec<Q::Answer> {
    let mut answers: Vec<_> = rays.iter().map(|ray| query.start(ray)).collect();
    let mut scratch = Scratch::default();
    match way {
        Way::Counted => {
            index.search(&query, rays, &mut answers, &mut scratch, &mut Counts::default());
        }
        _ => index.search(&query, rays, &mut answers, &mut scratch, &mut NoCounters),
    }
    answers
}

impl Answer {
    fn same_bits(&self, other: &Self) -> bool {
        self.hit.same_bits(&other.hit) && self.blocked == other.blocked
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { meshes, rays, hits } = self;
        write!(f, "{rays} rays at {meshes} meshes, {hits} of them hits: all results are equal")
    }
}

impl fmt::Display for FirstDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mesh, scale, offset, ray, .. } = self;
        let (quality, way) = (self.quality.name(), self.way);
        writeln!(
            f,
            "mesh `{mesh}` times {scale:e} plus {offset}, built `{quality}`, traced {way}: {ray:?}"
        )?;
        writeln!(f, "  got      {}", self.got)?;
        write!(f, "  expected {}", self.expected)
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let blocked = if self.blocked { "blocked" } else { "not blocked" };
        match self.hit.is_hit() {
            true => write!(f, "{:?}, {blocked}", self.hit),
            false => write!(f, "no hit, {blocked}"),
        }
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Slice => "in a slice",
            Self::Counted => "in a slice, counting",
            Self::Alone => "alone",
        })
    }
}

#[cfg(test)]
mod tests {
    use std::ops::{ControlFlow, Range};

    use super::*;
    use crate::accel::{Bounded, Build, Built};
    use crate::counters::Counters;
    use crate::math::BoxRay;

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
            let mut end = ray.t_max;
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
        let summary = check_one_by_one::<Exhaustive>(&BuildOptions::NONE, &progress).unwrap();
        assert_eq!(summary.meshes, 7);
        assert!(summary.hits > summary.rays / 10, "{summary}");
        assert_eq!((parts.into_inner(), last.into_inner()), (28, 28));
    }
}
