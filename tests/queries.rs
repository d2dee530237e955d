//! Queries beyond the closest hit: all hits along a ray, and hits that pass a filter. Every structure
//! gives the answers of `none`, and the queries agree with each other.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use srt::accel::{
    Accel, AllHits, AnyHit, BallTree, BoundingBall, BuildConfig, Bvh, Bvh8, ClosestHit,
    CompressedWideBvh, Exhaustive, Filtered, Grid, Indexed, KDopTree, KdTree, Octree, Query,
    TwoLevelGrid,
};
use srt::conformance::adversarial_rays::{bundles_around, rays_at};
use srt::conformance::nasty_meshes::{self, Mesh};
use srt::math::{Hit, Ray};
use srt::shapes::{TriangleMesh, TriangleSet};

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
        compare::<Exhaustive>(&mesh, &rays, &all);
        compare::<BoundingBall>(&mesh, &rays, &all);
        compare::<Bvh>(&mesh, &rays, &all);
        compare::<CompressedWideBvh>(&mesh, &rays, &all);
        compare::<Bvh8>(&mesh, &rays, &all);
        compare::<KdTree>(&mesh, &rays, &all);
        compare::<Grid>(&mesh, &rays, &all);
        compare::<TwoLevelGrid>(&mesh, &rays, &all);
        compare::<Octree>(&mesh, &rays, &all);
        compare::<BallTree>(&mesh, &rays, &all);
        compare::<KDopTree>(&mesh, &rays, &all);
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
    compare_ends::<Exhaustive>(&mesh, &endless, &rays);
    compare_ends::<BoundingBall>(&mesh, &endless, &rays);
    compare_ends::<Bvh>(&mesh, &endless, &rays);
    compare_ends::<CompressedWideBvh>(&mesh, &endless, &rays);
    compare_ends::<Bvh8>(&mesh, &endless, &rays);
    compare_ends::<KdTree>(&mesh, &endless, &rays);
    compare_ends::<Grid>(&mesh, &endless, &rays);
    compare_ends::<TwoLevelGrid>(&mesh, &endless, &rays);
    compare_ends::<Octree>(&mesh, &endless, &rays);
    compare_ends::<BallTree>(&mesh, &endless, &rays);
    compare_ends::<KDopTree>(&mesh, &endless, &rays);
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
