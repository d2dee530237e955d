//! A mesh in a place: its rays, through a structure and through none at all.

use std::ops::Range;

use glam::Vec3;

use crate::accel::{
    Accel, AnyHit, BuildConfig, BuildOptions, ClosestHit, Exhaustive, Indexed, Moved, Primitives,
    Quality, Query, Scratch, Update,
};
use crate::counters::{Counts, NoCounters};
use crate::math::{Hit, Ray};
use crate::shapes::{TriangleMesh, TriangleSet};

use super::adversarial_rays::{bundles_around, rays_at, rays_cut_at_hits};
use super::axis_grids::grids_over;
use super::difference::{Answer, FirstDifference, Way};
use super::nasty_meshes::{self, Mesh};
use super::one_by_one::OneByOne;
use super::summary::Summary;

/// Rays that are aimed at each mesh in each place; about as many again are made of them.
const RAYS: usize = 2_000;

/// Where the second slice ends; the first is one ray, which shows how slow a structure is. Each following one has twice
/// as many rays, so that slices of many lengths are traced, and begins where rays that go together do.
const SECOND_END: usize = 16;

/// Triangles, in packs or one by one.
pub(super) trait Triangles: Primitives {
    /// A structure over those of a mesh.
    fn indexed<A: Accel>(mesh: &Mesh, config: &BuildConfig) -> Indexed<Self, A>
    where
        Self: Sized;

    fn set(&mut self) -> &mut TriangleSet;
}

impl Triangles for TriangleSet {
    fn indexed<A: Accel>(mesh: &Mesh, config: &BuildConfig) -> Indexed<Self, A> {
        Indexed::build(TriangleMesh::new(&mesh.positions, &mesh.triangles), config)
    }

    fn set(&mut self) -> &mut TriangleSet {
        self
    }
}

impl Triangles for OneByOne {
    fn indexed<A: Accel>(mesh: &Mesh, config: &BuildConfig) -> Indexed<Self, A> {
        Indexed::build(Self(TriangleSet::new(&mesh.positions, &mesh.triangles)), config)
    }

    fn set(&mut self) -> &mut TriangleSet {
        &mut self.0
    }
}

/// A mesh, scaled and moved.
#[derive(Clone, Copy)]
pub(super) struct Case<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) scale: f32,
    pub(super) offset: Vec3,
}

impl Case<'_> {
    /// Compares a structure with none, as long as `ended` is false; what was compared.
    pub(super) fn check<P: Triangles, A: Accel>(
        &self,
        options: &BuildOptions,
        ended: &dyn Fn() -> bool,
    ) -> Result<Summary, FirstDifference> {
        if ended() {
            return Ok(Summary::default());
        }
        let moved = self.mesh.moved(self.scale, self.offset);
        let mut made = MadeRays::of(&moved);
        // The quality is what the tree looks like, and the scale how numbers round: not all of both.
        let qualities: &[Quality] = match self.scale {
            1.0 => &[Quality::Fastest, Quality::Medium, Quality::Slowest],
            _ => &[Quality::Medium],
        };
        let built = qualities.iter().map(|&quality| (quality, None));
        let followed = A::UPDATES.iter().map(|&update| (Quality::Medium, Some(update)));
        let mut compared = 0;
        for (quality, update) in built.chain(followed) {
            if compared > 0 && ended() {
                return Ok(made.summary(compared, false));
            }
            let own = match update {
                Some(update) => followed_to::<P, A>(&moved, update, quality, options),
                None => indexed::<P, A>(&moved, quality, options),
            };
            let mut from = 0;
            while let Some(slice) = made.slice_from(from) {
                // A slow structure is to end soon, so its rays are traced alone before they are in one call.
                for way in [Way::Alone, Way::Slice, Way::Counted] {
                    for part in parts(slice.clone(), way) {
                        // What was made ready is worth a ray.
                        if compared > 0 && ended() {
                            return Ok(made.summary(compared, false));
                        }
                        let MadeRays { rays, expected, .. } = &made;
                        let got = answers(&own, &rays[part.clone()], way);
                        if let Some((i, got)) = first_unlike(part, &got, expected) {
                            let made = (quality, update);
                            return Err(self.difference(made, way, rays[i], expected[i], got));
                        }
                    }
                }
                compared = compared.max(slice.end);
                from = slice.end;
            }
        }
        Ok(made.summary(compared, true))
    }

    fn difference(
        &self,
        (quality, update): (Quality, Option<Update>),
        way: Way,
        ray: Ray,
        expected: Answer,
        got: Answer,
    ) -> FirstDifference {
        let Self { mesh: &Mesh { name: mesh, .. }, scale, offset } = *self;
        FirstDifference { mesh, scale, offset, quality, update, way, ray, expected, got }
    }
}

/// The calls of a slice: one for each of its rays, or one for all.
fn parts(slice: Range<usize>, way: Way) -> impl Iterator<Item = Range<usize>> {
    let length = if way == Way::Alone { 1 } else { slice.len() };
    slice.clone().step_by(length.max(1)).map(move |from| from..from + length)
}

/// The first ray of a part with another answer than expected, and its answer.
fn first_unlike(
    part: Range<usize>,
    got: &[Answer],
    expected: &[Answer],
) -> Option<(usize, Answer)> {
    part.zip(got).find(|(i, got)| !got.same_bits(&expected[*i])).map(|(i, got)| (i, *got))
}

/// The rays that are made for a mesh, and their answers without a structure, as far as they were asked for.
struct MadeRays {
    none: Indexed<TriangleSet, Exhaustive>,
    rays: Vec<Ray>,
    expected: Vec<Answer>,
    /// Whether the rays that are cut at hits are among them.
    has_cut: bool,
}

impl MadeRays {
    fn of(moved: &Mesh) -> Self {
        let none = indexed(moved, Quality::Medium, &BuildOptions::NONE);
        // Even where there is nothing, rays are aimed at something.
        let single = nasty_meshes::single();
        let target = if moved.triangles.is_empty() { &single } else { moved };
        let mut rays = rays_at(target, RAYS, 99);
        rays.extend(bundles_around(&rays[..RAYS / 64]));
        rays.extend(grids_over(target, 8, 23));
        Self { none, rays, expected: Vec::new(), has_cut: false }
    }

    /// The slice that begins at a ray, with its answers; `None` behind the last.
    fn slice_from(&mut self, from: usize) -> Option<Range<usize>> {
        if from == self.rays.len() && !self.has_cut {
            let hits: Vec<Hit> = self.expected[..RAYS].iter().map(|answer| answer.hit).collect();
            // Last, because their number is any: the others go together in bundles.
            self.rays.extend(rays_cut_at_hits(&self.rays[..RAYS], &hits));
            self.has_cut = true;
        }
        let end = match from {
            0 => 1,
            1 => SECOND_END,
            _ => 2 * from + SECOND_END,
        };
        let end = end.min(self.rays.len());
        let missing = self.expected.len()..end.max(self.expected.len());
        self.expected.extend(answers(&self.none, &self.rays[missing], Way::Slice));
        (from < end).then_some(from..end)
    }

    /// The first so many rays, as what was compared.
    fn summary(&self, compared: usize, whole: bool) -> Summary {
        let hits = self.expected[..compared].iter().filter(|answer| answer.hit.is_hit()).count();
        Summary { meshes: usize::from(whole), all_meshes: 0, rays: compared, hits }
    }
}

pub(super) fn indexed<P: Triangles, A: Accel>(
    mesh: &Mesh,
    quality: Quality,
    options: &BuildOptions,
) -> Indexed<P, A> {
    let config = BuildConfig { quality, options: options.clone(), ..BuildConfig::default() };
    P::indexed(mesh, &config)
}

/// A structure that was built for the mesh with its vertices in each other's places, and has followed them to their own
/// in two steps.
fn followed_to<P: Triangles, A: Accel>(
    mesh: &Mesh,
    update: Update,
    quality: Quality,
    options: &BuildOptions,
) -> Indexed<P, A> {
    let count = mesh.positions.len();
    let stirred = |by: usize| Mesh {
        positions: (0..count).map(|i| mesh.positions[(i + by * (1 + i % 5)) % count]).collect(),
        triangles: mesh.triangles.clone(),
        ..*mesh
    };
    let mut own = indexed::<P, A>(&stirred(3), quality, options);
    for Mesh { positions, triangles, .. } in [stirred(1), stirred(0)] {
        let change = |own: &mut P| own.set().move_to(&positions, &triangles);
        let done = own.refit(update, Moved::All, change, |own, bounds| own.set().settle(bounds));
        done.unwrap_or_else(|error| panic!("the triangles have moved: {error}"));
    }
    own
}

pub(super) fn answers<P: Primitives, A: Accel>(
    index: &Indexed<P, A>,
    rays: &[Ray],
    way: Way,
) -> Vec<Answer> {
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
