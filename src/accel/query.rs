//! Queries: the closest hit of a ray, whether there is any hit, all hits.
//!
//! A query is one type, known to structures, primitives and tracers alike. Its answer grows while a
//! ray is searched: it starts empty and records hits, and the query knows from it how far further hits would count.

use std::ops::Range;

use crate::math::{Hit, Ray};

/// What a hit does to the rest of a ray's search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// It ends the search: any hit will do.
    First,
    /// It shortens the search: what lies behind it is not wanted.
    Closest,
    /// Nothing: every hit is wanted.
    All,
}

/// A question about rays.
///
/// One of your own is right as soon as its methods are: rays are searched one by one. It gets the kernels for slices
/// of rays by [`KEEPS_ONE_HIT`](Self::KEEPS_ONE_HIT), if it can promise that.
///
/// Whoever searches calls [`start`](Self::start), then [`record`](Self::record) for hits that count,
/// in any order and some of them perhaps twice, then [`finish`](Self::finish). A hit counts if its
/// `t` lies between `ray.t_min` and [`end`](Self::end), by the own-box rule of [`Accel`](super::Accel),
/// and if it is [`accepted`](Self::accepts).
pub trait Query: Copy + Send + Sync {
    /// What is known of a ray.
    type Answer: Clone + Send + 'static;

    /// What a hit does to the search.
    const SEARCH: Search;

    /// Whether [`accepts`](Self::accepts) ever refuses a hit; without it, that need not be called.
    const FILTERS: bool = false;

    /// Whether the answer follows from one hit alone, so that kernels may search for that, for many rays at once:
    ///
    /// * before a hit is recorded, [`end`](Self::end) is [`Ray::end`](crate::math::Ray::end);
    /// * of [`Search::Closest`], the answer follows from the first hit that is accepted in the order
    ///   `(t, object, prim)`, and behind a hit `end` is its `t`;
    /// * of [`Search::First`], it follows from whether there is a hit, and behind one `end` is −∞. Of the hit that
    ///   is recorded then, or given to [`of_one`](Self::of_one), only [`Hit::is_hit`] means anything.
    ///
    /// A query that keeps several hits, ends sooner, or looks at any hit that there is, leaves this at `false`.
    const KEEPS_ONE_HIT: bool = false;

    /// Before the search.
    fn start(&self, ray: &Ray) -> Self::Answer;

    /// The largest parameter at which further hits count; −∞ once the search is over.
    fn end(&self, ray: &Ray, answer: &Self::Answer) -> f32;

    /// Whether a hit is to be recorded, or passed over as if its primitive were not there: for
    /// example by the transparency of what was hit. It is obeyed only with [`FILTERS`](Self::FILTERS).
    #[inline(always)]
    fn accepts(&self, ray: &Ray, hit: &Hit) -> bool {
        let _ = (ray, hit);
        true
    }

    /// Takes up a hit that counts.
    fn record(&self, answer: &mut Self::Answer, hit: &Hit);

    /// After the search.
    #[inline(always)]
    fn finish(&self, answer: &mut Self::Answer) {
        let _ = answer;
    }

    /// The answer after a search that recorded one hit, or [`Hit::MISS`]: what kernels have found. They are only for
    /// queries that [keep one hit](Self::KEEPS_ONE_HIT).
    #[inline(always)]
    fn of_one(&self, ray: &Ray, found: &Hit) -> Self::Answer {
        let mut answer = self.start(ray);
        if found.is_hit() {
            self.record(&mut answer, found);
        }
        self.finish(&mut answer);
        answer
    }

    /// The query as it is put to the primitives of an object of a scene.
    #[inline(always)]
    #[must_use]
    fn in_object(&self, object: u32) -> Self {
        let _ = object;
        *self
    }

    /// Takes up what the primitives of an object have answered. Its box begins at `begin`: hits that
    /// come earlier, by rounding, count there.
    fn merge(&self, answer: &mut Self::Answer, of_object: &Self::Answer, object: u32, begin: f32);
}

/// The first hit in the order `(t, object, prim)`, or [`Hit::MISS`]. Within one object of a single shape, it is the
/// first crossing of its formula: see [`Hit`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ClosestHit;

impl Query for ClosestHit {
    type Answer = Hit;
    const SEARCH: Search = Search::Closest;
    const KEEPS_ONE_HIT: bool = true;

    #[inline(always)]
    fn start(&self, ray: &Ray) -> Hit {
        Hit::none_before(ray.end())
    }

    #[inline(always)]
    fn end(&self, _: &Ray, answer: &Hit) -> f32 {
        answer.t
    }

    #[inline(always)]
    fn record(&self, answer: &mut Hit, hit: &Hit) {
        if hit.precedes(answer) {
            *answer = *hit;
        }
    }

    #[inline(always)]
    fn finish(&self, answer: &mut Hit) {
        if !answer.is_hit() {
            *answer = Hit::MISS;
        }
    }

    #[inline(always)]
    fn of_one(&self, _: &Ray, found: &Hit) -> Hit {
        *found
    }

    #[inline(always)]
    fn merge(&self, answer: &mut Hit, of_object: &Hit, object: u32, begin: f32) {
        if of_object.is_hit() {
            self.record(answer, &of_object.in_object(object, begin));
        }
    }
}

/// Whether there is any hit: for shadows.
#[derive(Clone, Copy, Debug, Default)]
pub struct AnyHit;

impl Query for AnyHit {
    type Answer = bool;
    const SEARCH: Search = Search::First;
    const KEEPS_ONE_HIT: bool = true;

    #[inline(always)]
    fn start(&self, _: &Ray) -> bool {
        false
    }

    #[inline(always)]
    fn end(&self, ray: &Ray, answer: &bool) -> f32 {
        if *answer { f32::NEG_INFINITY } else { ray.end() }
    }

    #[inline(always)]
    fn record(&self, answer: &mut bool, _: &Hit) {
        *answer = true;
    }

    #[inline(always)]
    fn of_one(&self, _: &Ray, found: &Hit) -> bool {
        found.is_hit()
    }

    #[inline(always)]
    fn merge(&self, answer: &mut bool, of_object: &bool, _: u32, _: f32) {
        *answer |= of_object;
    }
}

/// All hits in the order `(t, object, prim)`, each once.
#[derive(Clone, Copy, Debug, Default)]
pub struct AllHits;

impl Query for AllHits {
    type Answer = Vec<Hit>;
    const SEARCH: Search = Search::All;

    fn start(&self, _: &Ray) -> Vec<Hit> {
        Vec::new()
    }

    fn end(&self, ray: &Ray, _: &Vec<Hit>) -> f32 {
        ray.end()
    }

    fn record(&self, answer: &mut Vec<Hit>, hit: &Hit) {
        let place = answer.partition_point(|other| other.precedes(hit));
        // A structure may offer a primitive twice.
        if answer.get(place).is_none_or(|other| hit.precedes(other)) {
            answer.insert(place, *hit);
        }
    }

    fn merge(&self, answer: &mut Vec<Hit>, of_object: &Vec<Hit>, object: u32, begin: f32) {
        for hit in of_object {
            self.record(answer, &hit.in_object(object, begin));
        }
    }
}

/// Another query, of those hits alone that pass a filter: for example by the alpha of a texture.
#[derive(Debug)]
pub struct Filtered<'a, Q, F> {
    query: Q,
    filter: &'a F,
    /// The object whose primitives are searched, if hits do not name it.
    object: Option<u32>,
}

impl<Q: Clone, F> Clone for Filtered<'_, Q, F> {
    fn clone(&self) -> Self {
        Self { query: self.query.clone(), ..*self }
    }
}

impl<Q: Copy, F> Copy for Filtered<'_, Q, F> {}

impl<'a, Q: Query, F: Fn(&Ray, &Hit) -> bool + Sync> Filtered<'a, Q, F> {
    /// `filter` sees the ray in the space of the primitive, and the hit with all its ids. It may be
    /// called for hits that are not recorded in the end, and more than once for one hit.
    #[must_use]
    pub fn new(query: Q, filter: &'a F) -> Self {
        Self { query, filter, object: None }
    }
}

impl<Q: Query, F: Fn(&Ray, &Hit) -> bool + Sync> Query for Filtered<'_, Q, F> {
    type Answer = Q::Answer;
    const SEARCH: Search = Q::SEARCH;
    const FILTERS: bool = true;
    const KEEPS_ONE_HIT: bool = Q::KEEPS_ONE_HIT;

    fn start(&self, ray: &Ray) -> Q::Answer {
        self.query.start(ray)
    }

    fn end(&self, ray: &Ray, answer: &Q::Answer) -> f32 {
        self.query.end(ray, answer)
    }

    fn accepts(&self, ray: &Ray, hit: &Hit) -> bool {
        let object = self.object.unwrap_or(hit.object);
        let passes = (self.filter)(ray, &Hit { object, ..*hit });
        passes && (!Q::FILTERS || self.query.accepts(ray, hit))
    }

    fn record(&self, answer: &mut Q::Answer, hit: &Hit) {
        self.query.record(answer, hit);
    }

    fn finish(&self, answer: &mut Q::Answer) {
        self.query.finish(answer);
    }

    fn in_object(&self, object: u32) -> Self {
        Self { query: self.query.in_object(object), object: Some(object), ..*self }
    }

    fn merge(&self, answer: &mut Q::Answer, of_object: &Q::Answer, object: u32, begin: f32) {
        self.query.merge(answer, of_object, object, begin);
    }
}

/// The queries that a program chooses between as it runs: those of [`Answers`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QueryKind {
    /// [`ClosestHit`].
    ClosestHit,
    /// [`AnyHit`].
    AnyHit,
}

/// Memory for the answers of a slice of rays. Its kind is the query: one that is chosen as the program
/// runs.
#[derive(Debug)]
pub enum Answers<'a> {
    /// [`ClosestHit`].
    ClosestHit(&'a mut [Hit]),
    /// [`AnyHit`].
    AnyHit(&'a mut [bool]),
}

impl Answers<'_> {
    /// The memory for some of the rays, lent for a shorter time.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn part(&mut self, rays: Range<usize>) -> Answers<'_> {
        match self {
            Self::ClosestHit(hits) => Answers::ClosestHit(&mut hits[rays]),
            Self::AnyHit(blocked) => Answers::AnyHit(&mut blocked[rays]),
        }
    }

    /// Makes all of them answers of rays that hit nothing.
    pub fn clear(&mut self) {
        match self {
            Self::ClosestHit(hits) => hits.fill(Hit::MISS),
            Self::AnyHit(blocked) => blocked.fill(false),
        }
    }

    /// How many rays hit something.
    #[must_use]
    pub fn hit_count(&self) -> usize {
        match self {
            Self::ClosestHit(hits) => hits.iter().filter(|hit| hit.is_hit()).count(),
            Self::AnyHit(blocked) => blocked.iter().filter(|&&blocked| blocked).count(),
        }
    }
}
