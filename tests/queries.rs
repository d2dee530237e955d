//! Queries beyond the closest hit: all hits along a ray, and hits that pass a filter. Every structure
//! gives the answers of `none`, and the queries agree with each other.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::ops::Range;

use srt::accel::{
    Accel, AllHits, AnyHit, BallTree, Bounded, BoundingBall, BuildConfig, Bvh, Bvh8, ClosestHit,
    CompressedWideBvh, Exhaustive, Filtered, Grid, Indexed, KDopTree, KdTree, NoPacks, Octree,
    Primitives, Query, Scratch, Search, TwoLevelGrid,
};
use srt::conformance::adversarial_rays::{bundles_around, rays_at};
use srt::conformance::nasty_meshes::{self, Mesh};
use srt::counters::{Counters, NoCounters};
use srt::glam::{DAffine3, DQuat, DVec3, Vec3, Vec3A};
use srt::math::{Aabb, BoxRay, Hit, Padding, Random, Ray, RayToObject, Transform};
use srt::shapes::{Ball, Cylinder, Instance, Single, Triangle, TriangleMesh, TriangleSet};

/// Calls a function of a structure for each of them.
macro_rules! in_all_structures {
    ($check:ident $arguments:tt) => {
        in_all_structures!($check $arguments:
            Exhaustive BoundingBall Bvh CompressedWideBvh Bvh8 KdTree Grid TwoLevelGrid Octree
            BallTree KDopTree)
    };
    ($check:ident $arguments:tt: $($structure:ident)*) => {
        $($check::<$structure> $arguments;)*
    };
}

fn indexed<A: Accel>(mesh: &Mesh) -> Indexed<TriangleSet, A> {
    Indexed::build(TriangleMesh::new(&mesh.positions, &mesh.triangles), &BuildConfig::default())
}

fn answers<A: Accel, Q: Query>(mesh: &Mesh, query: Q, rays: &[Ray]) -> Vec<Q::Answer> {
    let mut answers: Vec<_> = rays.iter().map(|ray| query.start(ray)).collect();
    indexed::<A>(mesh).answer(&query, rays, &mut answers);
    answers
}

/// The filter of the tests: two of three primitives are seen.
fn is_seen(_: &Ray, hit: &Hit) -> bool {
    !hit.prim.is_multiple_of(3)
}

/// Compares a structure's answers with those that follow from all hits that `none` finds.
fn compare<A: Accel>(mesh: &Mesh, rays: &[Ray], all: &[Vec<Hit>]) {
    let of_structure = answers::<A, _>(mesh, AllHits, rays);
    let closest = answers::<A, _>(mesh, ClosestHit, rays);
    let closest_seen = answers::<A, _>(mesh, Filtered::new(ClosestHit, &is_seen), rays);
    let any_seen = answers::<A, _>(mesh, Filtered::new(AnyHit, &is_seen), rays);
    for (i, ray) in rays.iter().enumerate() {
        let name = mesh.name;
        let same = |a: &[Hit], b: &[Hit]| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.same_bits(b))
        };
        assert!(same(&of_structure[i], &all[i]), "{name}: {ray:?}: {:?}", of_structure[i]);
        let first = all[i].first().copied().unwrap_or(Hit::MISS);
        assert!(closest[i].same_bits(&first), "{name}: {ray:?}: {:?} {first:?}", closest[i]);
        let seen = all[i].iter().find(|hit| is_seen(ray, hit)).copied().unwrap_or(Hit::MISS);
        assert!(
            closest_seen[i].same_bits(&seen),
            "{name}: {ray:?}: {:?} {seen:?}",
            closest_seen[i]
        );
        assert_eq!(any_seen[i], seen.is_hit(), "{name}: {ray:?}");
    }
}

#[test]
fn all_hits_and_filtered_hits_are_the_same_in_every_structure() {
    for mesh in nasty_meshes::all() {
        let mut rays = rays_at(&mesh, 2_048, 5);
        rays.extend(bundles_around(&rays[..20]));
        let all = answers::<Exhaustive, _>(&mesh, AllHits, &rays);
        let several = all.iter().filter(|hits| hits.len() > 1).count();
        assert!(mesh.triangles.len() < 3 || several > 20, "{}: {several}", mesh.name);
        in_all_structures!(compare(&mesh, &rays, &all));
    }
}

/// Compares a structure's answers to rays without an end with those to rays that end at the largest float.
fn compare_ends<A: Accel>(mesh: &Mesh, endless: &[Ray], rays: &[Ray]) {
    let same = |(a, b): (&Hit, &Hit)| a.same_bits(b);
    let hits = [rays, endless].map(|rays| answers::<A, _>(mesh, ClosestHit, rays));
    assert!(hits[0].iter().zip(&hits[1]).all(same), "{}", mesh.name);
    let all = [rays, endless].map(|rays| answers::<A, _>(mesh, AllHits, rays));
    for (a, b) in all[0].iter().zip(&all[1]) {
        assert!(a.len() == b.len() && a.iter().zip(b).all(same), "{}", mesh.name);
    }
    let [blocked, blocked_endless] =
        [rays, endless].map(|rays| answers::<A, _>(mesh, AnyHit, rays));
    assert_eq!(blocked, blocked_endless, "{}", mesh.name);
    let alone = indexed::<A>(mesh);
    for (ray, hit) in endless.iter().zip(&hits[1]) {
        assert!(alone.hit(ray).same_bits(hit), "{}: {ray:?}", mesh.name);
    }
}

#[test]
fn nothing_is_hit_at_infinity() {
    let mesh = nasty_meshes::single();
    let mut rays = rays_at(&mesh, 512, 8);
    rays.extend(bundles_around(&rays[..8]));
    let slow_down = |number: usize, ray: &Ray| {
        let length = [1.0, 1e-39, 1e-36, 1e-38][number / 32 % 4];
        Ray::new(ray.origin, length * ray.dir.normalize_or_zero())
    };
    let usual: Vec<_> =
        rays.iter().map(|ray| Ray::new(ray.origin, ray.dir.normalize_or_zero())).collect();
    rays = rays.iter().enumerate().map(|(number, ray)| slow_down(number, ray)).collect();
    // Slow rays come to the triangle beyond the largest float, if they do; some do before it.
    let [hit, hit_usual] =
        [&rays, &usual].map(|rays| answers::<Exhaustive, _>(&mesh, AnyHit, rays));
    let lost = hit.iter().zip(&hit_usual).filter(|&(&hit, &usual)| usual && !hit).count();
    assert!(lost > 50 && hit.iter().filter(|&&hit| hit).count() > 50, "{lost}");
    let endless: Vec<_> = rays.iter().map(|ray| Ray { t_max: f32::INFINITY, ..*ray }).collect();
    in_all_structures!(compare_ends(&mesh, &endless, &rays));
}

#[test]
fn all_hits_are_in_order_and_each_is_one() {
    let mesh = nasty_meshes::lattice();
    let rays = rays_at(&mesh, 500, 6);
    for hits in answers::<Bvh, _>(&mesh, AllHits, &rays) {
        assert!(hits.windows(2).all(|pair| pair[0].precedes(&pair[1])), "{hits:?}");
    }
}

#[test]
fn a_hit_that_is_recorded_twice_counts_once() {
    let hit = |t, prim| Hit { t, object: 0, prim, u: 0.0, v: 0.0 };
    let mut answer = Vec::new();
    for hit in [hit(2.0, 1), hit(1.0, 7), hit(2.0, 1), hit(2.0, 0)] {
        AllHits.record(&mut answer, &hit);
    }
    assert_eq!(answer, [hit(1.0, 7), hit(2.0, 0), hit(2.0, 1)]);
}

/// Shapes that are objects, each by itself.
#[derive(Clone)]
struct Shapes {
    objects: Vec<Object>,
    padding: Padding,
}

#[derive(Clone)]
struct Object {
    id: u32,
    shape: Single,
    to_object: Option<RayToObject>,
    bounds: Aabb,
}

impl Object {
    /// A shape under a transform, if there is one.
    fn new(id: u32, shape: Single, transform: Option<DAffine3>) -> Self {
        let transform = transform.map(|transform| Transform::new(transform).unwrap());
        let own = shape.bounds();
        let bounds = transform.as_ref().map_or(own, |transform| transform.bounds_to_world(&own));
        Self { id, shape, to_object: transform.map(|transform| transform.ray_to_object()), bounds }
    }
}

impl Shapes {
    fn new(objects: Vec<Object>) -> Self {
        let all = objects.iter().fold(Aabb::EMPTY, |all, object| all.union(object.bounds));
        Self { objects, padding: Padding { factor: 4.0, ..Padding::of_bounds(&all) } }
    }

    /// Balls, cylinders and triangles beside each other and within each other.
    fn some() -> Self {
        let mut random = Random::new(&[51]);
        let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
        let turns = [DQuat::IDENTITY, DQuat::from_rotation_y(std::f64::consts::FRAC_PI_2)];
        let objects = (0..90).map(|id| {
            let (center, radius) = (point(), 0.02 + 0.1 * point().x);
            let size = DVec3::splat(f64::from(radius));
            let turn = turns[id as usize / 3 % 2];
            let placed = DAffine3::from_scale_rotation_translation(size, turn, center.as_dvec3());
            match id % 3 {
                0 => Object::new(id, Single::Ball(Ball { center, radius }), None),
                1 => Object::new(id, Single::Cylinder(Cylinder), Some(placed)),
                _ => {
                    let corners = [center, center + 0.2 * point(), center + 0.2 * point()];
                    Object::new(id, Single::Triangle(Triangle::new(corners)), None)
                }
            }
        });
        Self::new(objects.collect())
    }

    fn instance<'a>(&'a self, object: &'a Object) -> Instance<'a> {
        let Object { id, to_object, bounds, .. } = object;
        let (to_object, padding) = (to_object.as_ref(), self.padding);
        Instance { to_object, bounds: *bounds, padding, object: *id }
    }

    fn in_slots(&self, slots: Range<u32>) -> &[Object] {
        &self.objects[slots.start as usize..slots.end as usize]
    }
}

impl Bounded for Shapes {
    fn count(&self) -> u32 {
        self.objects.len() as u32
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.objects[index as usize].bounds
    }

    fn mean_point(&self) -> Vec3A {
        self.total_bounds().center()
    }
}

impl Primitives for Shapes {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        self.objects = order.iter().map(|&index| self.objects[index as usize].clone()).collect();
    }

    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        _: &mut C,
    ) {
        for object in self.in_slots(slots) {
            object.shape.test(query, &self.instance(object), ray, box_ray, answer);
        }
    }

    fn test_stream<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        rays: (&[Ray], &[u32]),
        answers: &mut [Q::Answer],
        _: &mut Scratch,
        _: &mut C,
    ) {
        for object in self.in_slots(slots) {
            object.shape.test_many(query, &self.instance(object), rays, answers);
        }
    }
}

/// The answers to the three queries.
struct Found {
    closest: Vec<Hit>,
    any: Vec<bool>,
    all: Vec<Vec<Hit>>,
}

/// What a structure finds, of rays in a slice; each ray alone finds the same.
fn found<A: Accel>(primitives: &(impl Primitives + Clone), rays: &[Ray]) -> Found {
    let index: Indexed<_, A> = Indexed::build(primitives.clone(), &BuildConfig::default());
    let mut found = Found {
        closest: vec![Hit::MISS; rays.len()],
        any: vec![false; rays.len()],
        all: vec![Vec::new(); rays.len()],
    };
    index.answer(&ClosestHit, rays, &mut found.closest);
    index.answer(&AnyHit, rays, &mut found.any);
    index.answer(&AllHits, rays, &mut found.all);
    for (i, ray) in rays.iter().enumerate() {
        assert!(index.hit(ray).same_bits(&found.closest[i]), "{ray:?}: {:?}", found.closest[i]);
        assert_eq!(index.occluded(ray), found.any[i], "{ray:?}");
    }
    found
}

fn compare_shapes<A: Accel>(shapes: &Shapes, rays: &[Ray], expected: &Found) {
    let found = found::<A>(shapes, rays);
    assert_eq!(found.any, expected.any);
    let same = |(a, b): (&Hit, &Hit)| a.same_bits(b);
    assert!(found.closest.iter().zip(&expected.closest).all(same));
    for (found, expected) in found.all.iter().zip(&expected.all) {
        let are_same = found.len() == expected.len() && found.iter().zip(expected).all(same);
        assert!(are_same, "{found:?} {expected:?}");
    }
}

/// Rays at shapes from near and from far, along axes and across.
fn rays_at_shapes(shapes: &Shapes) -> Vec<Ray> {
    let mut random = Random::new(&[52]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
    let rays = (0..3_000).map(|i| {
        let bounds = shapes.objects[i % shapes.objects.len()].bounds;
        let target = Vec3::from(bounds.center()) + 0.6 * point() * Vec3::from(bounds.size());
        let mut way = [3.0, 1e3, 1e7, 1e8][i % 4] * point();
        if i / 4 % 2 == 0 {
            way *= [Vec3::X, Vec3::Y, Vec3::Z][i / 8 % 3];
        }
        Ray::new(target + way, -way.normalize())
    });
    rays.collect()
}

#[test]
fn shapes_are_hit_first_where_their_formula_has_its_first_crossing() {
    let shapes = Shapes::some();
    let rays = rays_at_shapes(&shapes);
    let expected = found::<Exhaustive>(&shapes, &rays);
    let (mut hits, mut by_formula) = (0, 0);
    for (i, ray) in rays.iter().enumerate() {
        let (closest, all) = (&expected.closest[i], &expected.all[i]);
        assert_eq!(expected.any[i], closest.is_hit(), "{ray:?}");
        let first = all.first().copied().unwrap_or(Hit::MISS);
        assert_eq!((closest.t, closest.object), (first.t, first.object), "{ray:?}");
        assert!(!closest.is_hit() || all.iter().any(|hit| hit.same_bits(closest)), "{ray:?}");
        hits += usize::from(closest.is_hit());
        by_formula += usize::from(closest.prim != first.prim);
    }
    assert!(hits > 1_000 && by_formula > 20, "{hits} {by_formula}");
    in_all_structures!(compare_shapes(&shapes, &rays, &expected));
}

#[test]
fn a_cylinder_is_hit_where_the_ray_enters_though_both_crossings_are_at_one_parameter() {
    let shapes = Shapes::new(vec![Object::new(0, Single::Cylinder(Cylinder), None)]);
    let ray = Ray::new(Vec3::new(0.25, 0.5, 1e9), Vec3::NEG_Z);
    let found = found::<Bvh8>(&shapes, &[ray]);
    let parts = found.all[0].iter().map(|hit| (hit.t, hit.prim)).collect::<Vec<_>>();
    assert_eq!(parts, [(1e9, Cylinder::BOTTOM), (1e9, Cylinder::TOP)]);
    assert_eq!((found.closest[0].t, found.closest[0].prim), (1e9, Cylinder::TOP));
}

fn hits_nothing<A: Accel>(primitives: &(impl Primitives + Clone), rays: &[Ray]) {
    let Found { closest, any, all } = found::<A>(primitives, rays);
    for (i, ray) in rays.iter().enumerate() {
        let is_hit = closest[i].is_hit() || any[i] || !all[i].is_empty();
        assert!(!is_hit, "{ray:?}: {:?} {} {:?}", closest[i], any[i], all[i]);
    }
}

/// Rays with a NaN in each place, and in both ends, made from others.
fn without_numbers(rays: &[Ray]) -> Vec<Ray> {
    let with = |ray: &Ray, places: &[usize]| {
        let mut array = ray.to_array();
        places.iter().for_each(|&place| array[place] = f32::NAN);
        Ray::from_arrays(&[array])[0]
    };
    let places = [&[0][..], &[1], &[2], &[3], &[4], &[5], &[6], &[7], &[3, 7], &[0, 1, 2]];
    // Those of a kind come together, as packets take them.
    places.iter().flat_map(|places| rays.iter().map(|ray| with(ray, places))).collect()
}

#[test]
fn a_ray_with_a_nan_hits_nothing() {
    let shapes = Shapes::some();
    let mut rays = rays_at_shapes(&shapes);
    let hit = found::<Exhaustive>(&shapes, &rays).any;
    let mut hit = hit.iter();
    rays.retain(|_| *hit.next().unwrap());
    rays.truncate(150);
    in_all_structures!(hits_nothing(&shapes, &without_numbers(&rays)));

    let mesh = nasty_meshes::soup();
    let set = TriangleSet::new(&mesh.positions, &mesh.triangles);
    let at_mesh = rays_at(&mesh, 100, 53);
    in_all_structures!(hits_nothing(&set, &without_numbers(&at_mesh)));
}

/// What is hit by rays that move infinitely fast along some axes is not defined; but nothing that is not there is
/// entered. Builds with debug assertions refuse them.
#[cfg(not(debug_assertions))]
#[test]
fn infinite_directions_are_no_reason_to_panic() {
    let shapes = Shapes::some();
    let mesh = nasty_meshes::soup();
    let kinds = [0.0, 0.5, f32::INFINITY, f32::NEG_INFINITY];
    for dir in 0..64_usize {
        let dir = Vec3::new(kinds[dir % 4], kinds[dir / 4 % 4], kinds[dir / 16]);
        let rays = [Ray::new(Vec3::new(0.4, 0.5, -1.0), dir); 67];
        for count in [1, 3, 9, 20, 90] {
            let few = Shapes::new(shapes.objects[..count].to_vec());
            in_all_structures!(answer_all(&few, &rays));
            let triangles = &mesh.triangles[..count * mesh.triangles.len() / 90];
            in_all_structures!(answer_all(&TriangleSet::new(&mesh.positions, triangles), &rays));
        }
    }
}

#[cfg(not(debug_assertions))]
fn answer_all<A: Accel>(primitives: &(impl Primitives + Clone), rays: &[Ray]) {
    let index: Indexed<_, A> = Indexed::build(primitives.clone(), &BuildConfig::default());
    index.answer(&ClosestHit, rays, &mut vec![Hit::MISS; rays.len()]);
    index.answer(&AnyHit, rays, &mut vec![false; rays.len()]);
}

/// A ray that may be asked for in the world, and is infinite in the space of a small object.
#[cfg(not(debug_assertions))]
#[test]
fn rays_that_are_infinite_within_a_small_object_are_no_reason_to_panic() {
    let mesh = indexed::<Bvh8>(&nasty_meshes::soup());
    let transform = Transform::new(DAffine3::from_scale(DVec3::splat(1e-9))).unwrap();
    let bounds = transform.bounds_to_world(&mesh.primitives().total_bounds());
    let to_object = transform.ray_to_object();
    let padding = Padding::of_bounds(&bounds);
    let instance = Instance { to_object: Some(&to_object), bounds, padding, object: 0 };
    let rays = [Ray::new(Vec3::from(bounds.min), Vec3::splat(1e30)); 64];
    assert_eq!(rays[0].check(), Ok(()));
    let which: Vec<u32> = (0..64).collect();
    let answers = [Hit::none_before(f32::MAX); 64];
    let mut entered = srt::shapes::Entered::default();
    instance.enter_many(&ClosestHit, (&rays, &which), &answers, &mut entered);
    assert!(entered.rays.len() == 64 && entered.rays[0].dir == Vec3::INFINITY);
    mesh.answer(&ClosestHit, &entered.rays, &mut [Hit::MISS; 64]);
    mesh.answer(&AnyHit, &entered.rays, &mut [false; 64]);
}

/// Queries of one's own, which promise nothing.
#[derive(Clone, Copy)]
enum Own {
    /// The two closest hits.
    Two,
    /// Any hit, and which it is.
    Any,
    /// The closest hit no farther than a limit of the query.
    Within(f32),
    /// Refuses hits, but does not say so: over triangles it is never asked.
    Silent,
}

/// [`Own`] of one kind of search.
#[derive(Clone, Copy)]
struct Asked<const FIRST: bool>(Own);

impl<const FIRST: bool> Query for Asked<FIRST> {
    type Answer = Vec<Hit>;
    const SEARCH: Search = if FIRST { Search::First } else { Search::Closest };

    fn start(&self, _: &Ray) -> Vec<Hit> {
        Vec::new()
    }

    fn end(&self, ray: &Ray, answer: &Vec<Hit>) -> f32 {
        match self.0 {
            Own::Two => answer.get(1).map_or(ray.end(), |second| second.t),
            Own::Any if !answer.is_empty() => f32::NEG_INFINITY,
            Own::Within(limit) => answer.first().map_or(ray.end().min(limit), |first| first.t),
            _ => answer.first().map_or(ray.end(), |first| first.t),
        }
    }

    fn accepts(&self, _: &Ray, _: &Hit) -> bool {
        !matches!(self.0, Own::Silent)
    }

    fn record(&self, answer: &mut Vec<Hit>, hit: &Hit) {
        AllHits.record(answer, hit);
        answer.truncate(if matches!(self.0, Own::Two) { 2 } else { 1 });
    }

    fn merge(&self, answer: &mut Vec<Hit>, of_object: &Vec<Hit>, object: u32, begin: f32) {
        AllHits.merge(answer, of_object, object, begin);
    }
}

/// Compares what slices of rays get from kernels with what each ray gets alone; how many hits that are.
fn compare_with_alone<Q: Query<Answer = Vec<Hit>>>(mesh: &Mesh, query: Q, rays: &[Ray]) -> usize {
    let bvh8 = indexed::<Bvh8>(mesh);
    let alone = |ray| bvh8.search_one(&query, ray, &mut NoCounters);
    let alone: Vec<_> = rays.iter().map(alone).collect();
    for length in [64, 5] {
        let mut slice = vec![Vec::new(); rays.len()];
        for (rays, answers) in rays.chunks(length).zip(slice.chunks_mut(length)) {
            bvh8.answer(&query, rays, answers);
        }
        for (slice, alone) in slice.iter().zip(&alone) {
            let same = slice.iter().zip(alone).all(|(a, b)| a.same_bits(b));
            assert!(same && slice.len() == alone.len(), "{slice:?} {alone:?}");
        }
    }
    alone.iter().map(Vec::len).sum()
}

#[test]
fn queries_that_promise_nothing_are_answered_in_slices_as_alone() {
    let mesh = nasty_meshes::soup();
    let aimed = rays_at(&mesh, 256, 3);
    // Rays of one octant, which go together where they may.
    let mut rays = bundles_around(&aimed[..16]);
    rays.extend(aimed);
    let closest = |own| compare_with_alone(&mesh, Asked::<false>(own), &rays);
    let (one, two) = (closest(Own::Silent), closest(Own::Two));
    assert!(one > 300 && two > one + 100, "{one} {two}");
    let within = closest(Own::Within(1.0));
    assert!(within > 50 && within + 50 < one, "{within} of {one}");
    assert_eq!(compare_with_alone(&mesh, Asked::<true>(Own::Any), &rays), one);
}
