//! A mesh in a place: its rays, through a structure and through none at all.

use std::any::Any;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use glam::Vec3;

use crate::accel::{
    Accel, AllHits, Answers, AnyHit, BuildConfig, BuildOptions, ClosestHit, Exhaustive, Filtered,
    Indexed, Moved, PACK, Packs, Primitives, Quality, Query, Scratch, Tracer, Update,
};
use crate::counters::{Counts, NoCounters};
use crate::math::{Hit, Ray};
use crate::shapes::{TriangleMesh, TriangleSet};

use super::adversarial_rays::{bundles_around, rays_at, rays_cut_at_hits};
use super::axis_grids::grids_over;
use super::difference::{Answer, FirstDifference, Question, Subject, Way};
use super::nasty_meshes::{self, Mesh};
use super::one_by_one::OneByOne;
use super::summary::Summary;

/// Rays that are aimed at each mesh in each place; about as many again are made of them.
const RAYS: usize = 2_000;

/// Meshes of more triangles than this take the longest without a structure, and get fewer rays.
const MANY: usize = 5_000;

/// Rays that are aimed at a mesh of many triangles.
const FEW_RAYS: usize = 384;

/// Of the rays that are aimed, and of the bundles around them, so many are asked for all hits, and for filtered ones.
const ASKED_MORE: usize = 128;

/// Where the second slice ends; the first is one ray, which shows how slow a structure is. Each following one has twice
/// as many rays, so that slices of many lengths are traced, and begins where rays that go together do.
const SECOND_END: usize = 16;

/// Triangles, in packs or one by one.
pub(super) trait Triangles: Primitives {
    const ONE_BY_ONE: bool;

    /// A structure over those of a mesh.
    fn indexed<A: Accel>(mesh: &Mesh, config: &BuildConfig) -> Indexed<Self, A>
    where
        Self: Sized;

    fn set(&self) -> &TriangleSet;

    fn set_mut(&mut self) -> &mut TriangleSet;
}

impl Triangles for TriangleSet {
    const ONE_BY_ONE: bool = false;

    fn indexed<A: Accel>(mesh: &Mesh, config: &BuildConfig) -> Indexed<Self, A> {
        Indexed::build(TriangleMesh::new(&mesh.positions, &mesh.triangles), config)
    }

    fn set(&self) -> &TriangleSet {
        self
    }

    fn set_mut(&mut self) -> &mut TriangleSet {
        self
    }
}

impl Triangles for OneByOne {
    const ONE_BY_ONE: bool = true;

    fn indexed<A: Accel>(mesh: &Mesh, config: &BuildConfig) -> Indexed<Self, A> {
        Indexed::build(Self(TriangleSet::new(&mesh.positions, &mesh.triangles)), config)
    }

    fn set(&self) -> &TriangleSet {
        &self.0
    }

    fn set_mut(&mut self) -> &mut TriangleSet {
        &mut self.0
    }
}

/// A structure as the check makes it. What follows is compiled once for all structures, but for the makers' functions
/// and what [`Asked`] asks.
pub(super) struct Maker<'a> {
    /// In which ways it can follow.
    updates: &'static [Update],
    one_by_one: bool,
    make: Box<Make<'a>>,
}

/// Builds a structure in some quality for a mesh, or lets it follow to that.
type Make<'a> = dyn Fn(&Mesh, Build) -> Box<dyn Asked + 'a> + Sync + 'a;

/// How a structure is made: built, and perhaps moved.
type Build = (Quality, Option<Update>);

/// A structure over triangles, built with some options.
pub(super) fn maker<'a, P: Triangles + 'a, A: Accel + 'a>(options: &'a BuildOptions) -> Maker<'a> {
    let make = |mesh: &Mesh, (quality, update): Build| -> Box<dyn Asked + 'a> {
        Box::new(match update {
            Some(update) => followed_to::<P, A>(mesh, update, quality, options),
            None => indexed::<P, A>(mesh, quality, options),
        })
    };
    Maker { updates: A::UPDATES, one_by_one: P::ONE_BY_ONE, make: Box::new(make) }
}

/// What the check asks of a structure.
pub(super) trait Asked: Tracer {
    /// The first hit of a ray by itself, and whether there is any.
    fn alone(&self, ray: &Ray) -> Answer;

    /// All hits of some rays, which are not counted.
    fn all(&self, rays: &[Ray], way: Way) -> Vec<Vec<Hit>>;

    /// The first hit of those that are seen, and whether there is any.
    fn seen(&self, rays: &[Ray], way: Way) -> Vec<Answer>;
}

impl<P: Primitives, A: Accel> Asked for Indexed<P, A> {
    fn alone(&self, ray: &Ray) -> Answer {
        Answer { hit: self.hit(ray), blocked: self.occluded(ray) }
    }

    fn all(&self, rays: &[Ray], way: Way) -> Vec<Vec<Hit>> {
        answers_to(self, AllHits, rays, way)
    }

    fn seen(&self, rays: &[Ray], way: Way) -> Vec<Answer> {
        let hits = answers_to(self, Filtered::new(ClosestHit, &is_seen), rays, way);
        let blocked = answers_to(self, Filtered::new(AnyHit, &is_seen), rays, way);
        answers_of(hits, blocked)
    }
}

/// A mesh, scaled and moved.
#[derive(Clone, Copy)]
pub(super) struct Case<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) scale: f32,
    pub(super) offset: Vec3,
}

/// What is wrong with a structure.
pub(super) enum Fault {
    Difference(Box<FirstDifference>),
    /// It panics: what and where, in words.
    Panic(String),
}

/// A check of one mesh, on its way.
struct Check<'a, 'm> {
    case: &'a Case<'a>,
    maker: &'a Maker<'m>,
    moved: &'a Mesh,
    rays: MadeRays,
    /// How many rays have been compared.
    compared: usize,
    ended: &'a dyn Fn() -> bool,
}

impl Case<'_> {
    /// Compares a structure with none, as long as `ended` is false; what was compared.
    pub(super) fn check(
        &self,
        maker: &Maker<'_>,
        ended: &dyn Fn() -> bool,
    ) -> Result<Summary, Fault> {
        if ended() {
            return Ok(Summary::default());
        }
        let moved = self.mesh.moved(self.scale, self.offset);
        let rays = MadeRays::of(&moved);
        let mut check = Check { case: self, maker, moved: &moved, rays, compared: 0, ended };
        // The quality is what the tree looks like, and the scale how numbers round: not all of both.
        let qualities: &[Quality] = match self.scale {
            1.0 if moved.triangles.len() <= MANY => {
                &[Quality::Fastest, Quality::Medium, Quality::Slowest]
            }
            _ => &[Quality::Medium],
        };
        let built = qualities.iter().map(|&quality| (quality, None));
        let followed = maker.updates.iter().map(|&update| (Quality::Medium, Some(update)));
        for build in built.chain(followed) {
            // After a panic nothing that it may have left half done is looked at.
            let checked = catch_unwind(AssertUnwindSafe(|| check.of_build(build)));
            match checked {
                Ok(Ok(true)) => {}
                Ok(Ok(false)) => return Ok(check.summary(false)),
                Ok(Err(difference)) => return Err(Fault::Difference(difference)),
                Err(payload) => {
                    let Self { mesh, scale, offset } = *self;
                    let (mesh, one_by_one) = (mesh.name, maker.one_by_one);
                    let subject = Subject { mesh, scale, offset, made: build, one_by_one };
                    let message = message_of(&*payload);
                    return Err(Fault::Panic(format!("{subject}: {message}")));
                }
            }
        }
        Ok(check.summary(true))
    }
}

/// What a panic says.
pub(crate) fn message_of(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("without a message")
}

impl Check<'_, '_> {
    /// Compares a structure that is made in one way. Returns whether all was compared.
    fn of_build(&mut self, build: Build) -> Result<bool, Box<FirstDifference>> {
        if self.is_to_end() {
            return Ok(false);
        }
        let own = (self.maker.make)(self.moved, build);
        let mut from = 0;
        while let Some(slice) = self.rays.slice_from(from) {
            // A slow structure is to end soon, so its rays are traced alone before they are in one call.
            for way in [Way::Alone, Way::Slice, Way::Counted] {
                for part in parts(slice.clone(), way) {
                    if self.is_to_end() {
                        return Ok(false);
                    }
                    let MadeRays { rays, expected, .. } = &self.rays;
                    let got = answers(&*own, &rays[part.clone()], way);
                    if let Some((i, got)) = first_unlike(part, &got, expected) {
                        let asked = (Question::First, way, rays[i]);
                        return Err(self.difference(build, asked, [expected[i], got]));
                    }
                }
            }
            self.compared = self.compared.max(slice.end);
            from = slice.end;
        }
        self.ask_more(&*own, build)
    }

    /// Compares all hits, and those that pass a filter, for some of the rays.
    fn ask_more(&mut self, own: &dyn Asked, build: Build) -> Result<bool, Box<FirstDifference>> {
        for start in [0, self.rays.aimed] {
            let part = start..start + ASKED_MORE;
            for way in [Way::Alone, Way::Slice] {
                if self.is_to_end() {
                    return Ok(false);
                }
                let all = self.rays.all_hits(part.clone());
                let rays = &self.rays.rays[part.clone()];
                let got = own.all(rays, way);
                let unlike = (0..rays.len()).find_map(|i| Some((i, other_hit(&all[i], &got[i])?)));
                if let Some((i, answers)) = unlike {
                    let asked = (Question::All, way, rays[i]);
                    return Err(self.difference(build, asked, answers));
                }
                for (i, got) in own.seen(rays, way).into_iter().enumerate() {
                    let seen = all[i].iter().copied().find(|hit| is_seen(&rays[i], hit));
                    let hit = seen.unwrap_or(Hit::MISS);
                    let expected = Answer { hit, blocked: seen.is_some() };
                    if !got.same_bits(&expected) {
                        let asked = (Question::Filtered, way, rays[i]);
                        return Err(self.difference(build, asked, [expected, got]));
                    }
                }
            }
        }
        Ok(true)
    }

    /// What was made ready is worth a ray.
    fn is_to_end(&self) -> bool {
        self.compared > 0 && (self.ended)()
    }

    fn summary(&self, whole: bool) -> Summary {
        self.rays.summary(self.compared, whole)
    }

    fn difference(
        &self,
        (quality, update): Build,
        (question, way, ray): (Question, Way, Ray),
        [expected, got]: [Answer; 2],
    ) -> Box<FirstDifference> {
        let Case { mesh: &Mesh { name: mesh, .. }, scale, offset } = *self.case;
        let one_by_one = self.maker.one_by_one;
        Box::new(FirstDifference {
            mesh,
            scale,
            offset,
            quality,
            update,
            one_by_one,
            question,
            way,
            ray,
            expected,
            got,
        })
    }
}

/// The filter of the check: two of three triangles are seen.
fn is_seen(_: &Ray, hit: &Hit) -> bool {
    !hit.prim.is_multiple_of(3)
}

/// The first of all hits that is another than expected, both as answers.
fn other_hit(expected: &[Hit], got: &[Hit]) -> Option<[Answer; 2]> {
    let same = expected.iter().zip(got).take_while(|(a, b)| a.same_bits(b)).count();
    let answer = |hits: &[Hit]| Answer {
        hit: hits.get(same).copied().unwrap_or(Hit::MISS),
        blocked: same < hits.len(),
    };
    (same < expected.len().max(got.len())).then(|| [answer(expected), answer(got)])
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
    /// How many of them, the first, are aimed at triangles.
    aimed: usize,
    /// Whether the rays that are cut at hits are among them.
    has_cut: bool,
    /// All hits of some rays, by where these begin.
    all: Vec<(usize, Arc<[Vec<Hit>]>)>,
}

impl MadeRays {
    fn of(moved: &Mesh) -> Self {
        let none = indexed(moved, Quality::Medium, &BuildOptions::NONE);
        // Even where there is nothing, rays are aimed at something.
        let single = nasty_meshes::single();
        let target = if moved.triangles.is_empty() { &single } else { moved };
        let (aimed, side) = if target.triangles.len() > MANY { (FEW_RAYS, 4) } else { (RAYS, 8) };
        let mut rays = rays_at(target, aimed, 99);
        rays.extend(bundles_around(&rays[..aimed / 64]));
        rays.extend(grids_over(target, side, 23));
        Self { none, rays, expected: Vec::new(), aimed, has_cut: false, all: Vec::new() }
    }

    /// All hits of some of the rays.
    fn all_hits(&mut self, part: Range<usize>) -> Arc<[Vec<Hit>]> {
        if let Some((_, all)) = self.all.iter().find(|(start, _)| *start == part.start) {
            return all.clone();
        }
        let start = part.start;
        let all: Arc<[_]> = self.none.all(&self.rays[part], Way::Slice).into();
        self.all.push((start, all.clone()));
        all
    }

    /// The slice that begins at a ray, with its answers; `None` behind the last.
    fn slice_from(&mut self, from: usize) -> Option<Range<usize>> {
        if from == self.rays.len() && !self.has_cut {
            let hits: Vec<Hit> =
                self.expected[..self.aimed].iter().map(|answer| answer.hit).collect();
            // Last, because their number is any: the others go together in bundles.
            self.rays.extend(rays_cut_at_hits(&self.rays[..self.aimed], &hits));
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
/// in steps: all of them, all but a few, and these few by their slots.
fn followed_to<P: Triangles, A: Accel>(
    mesh: &Mesh,
    update: Update,
    quality: Quality,
    options: &BuildOptions,
) -> Indexed<P, A> {
    let count = mesh.positions.len();
    let place = |by: usize, i: usize| mesh.positions[(i + by * (1 + i % 5)) % count];
    let at = |positions| Mesh { positions, triangles: mesh.triangles.clone(), ..*mesh };
    let stirred = |by: usize| at((0..count).map(|i| place(by, i)).collect());
    // Few enough that trees go up from the leaves of these alone.
    let mut nearly = stirred(0);
    for &corner in mesh.triangles.iter().take(1 + mesh.triangles.len() / 500).flatten() {
        nearly.positions[corner as usize] = place(1, corner as usize);
    }
    let differs = |triangle: usize| {
        let after = mesh.corners(triangle).map(|corner| corner.to_array().map(f32::to_bits));
        after != nearly.corners(triangle).map(|corner| corner.to_array().map(f32::to_bits))
    };
    let have_moved: Vec<bool> = (0..mesh.triangles.len()).map(differs).collect();

    let mut own = indexed::<P, A>(&stirred(3), quality, options);
    let follow = |own: &mut Indexed<P, A>, to: &Mesh, moved: Moved<'_>| {
        let change = |own: &mut P| own.set_mut().move_to(&to.positions, &to.triangles);
        let done = own.refit(update, moved, change, |own, bounds| own.set_mut().settle(bounds));
        done.unwrap_or_else(|error| panic!("the triangles have moved: {error}"));
    };
    follow(&mut own, &stirred(1), Moved::All);
    follow(&mut own, &nearly, Moved::All);
    let set = own.primitives().set();
    let has_moved = |&slot: &u32| {
        let prim = Packs::id(set, slot as usize / PACK, slot as usize % PACK);
        have_moved.get(prim as usize).copied().unwrap_or(false)
    };
    let slots: Vec<u32> = (0..set.slots()).filter(has_moved).collect();
    follow(&mut own, mesh, Moved::Slots(&slots));
    own
}

/// The first hits of some rays, and whether there are any.
pub(super) fn answers(index: &dyn Asked, rays: &[Ray], way: Way) -> Vec<Answer> {
    if way == Way::Alone {
        return rays.iter().map(|ray| index.alone(ray)).collect();
    }
    let mut hits: Vec<_> = rays.iter().map(|ray| ClosestHit.start(ray)).collect();
    let mut blocked: Vec<_> = rays.iter().map(|ray| AnyHit.start(ray)).collect();
    for answers in [Answers::ClosestHit(&mut hits), Answers::AnyHit(&mut blocked)] {
        let mut counts = Counts::default();
        let counts = (way == Way::Counted).then_some(&mut counts);
        index.trace(rays, answers, &mut Scratch::default(), counts);
    }
    answers_of(hits, blocked)
}

fn answers_of(hits: Vec<Hit>, blocked: Vec<bool>) -> Vec<Answer> {
    hits.into_iter().zip(blocked).map(|(hit, blocked)| Answer { hit, blocked }).collect()
}

/// The answers to a query of rays by themselves, or of all in one call.
fn answers_to<P: Primitives, A: Accel, Q: Query>(
    index: &Indexed<P, A>,
    query: Q,
    rays: &[Ray],
    way: Way,
) -> Vec<Q::Answer> {
    if way == Way::Alone {
        let alone = |ray| index.search_one(&query, ray, &mut NoCounters);
        return rays.iter().map(alone).collect();
    }
    let mut answers: Vec<_> = rays.iter().map(|ray| query.start(ray)).collect();
    index.search(&query, rays, &mut answers, &mut Scratch::default(), &mut NoCounters);
    answers
}
