//! Structures that follow triangles which move, without any scene: the whole tree, or the paths from a few leaves.
#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use glam::{Vec3, Vec3Swizzles};
use srt::accel::{
    Accel, Bounded, BuildConfig, Bvh, Bvh8, ClosestHit, Exhaustive, Indexed, Moved, Primitives,
};
use srt::math::{Hit, Random, Ray};
use srt::shapes::{MeshError, TriangleSet};

/// So many small triangles in a cube, some degenerate, some twice.
fn triangles(count: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut random = Random::new(&[u64::from(count)]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
    let mut positions = Vec::new();
    for i in 0..count {
        let (at, size) = (point(), if i % 50 == 0 { 0.0 } else { 0.03 });
        positions.extend([(); 3].map(|()| at + size * point()));
    }
    let mut triangles: Vec<_> = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    triangles.extend_from_within(..count as usize / 10);
    (positions, triangles)
}

fn rays() -> Vec<Ray> {
    let mut random = Random::new(&[9]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
    let mut ray = |i: usize| {
        let (from, to) = (3.0 * point() - 1.0, point());
        let mut ray = Ray::new(from, to - from);
        if i.is_multiple_of(5) {
            ray.dir = Vec3::Z * (to - from).z;
        }
        ray
    };
    (0..4_000).map(&mut ray).collect()
}

fn hits<A: Accel>(index: &Indexed<TriangleSet, A>, rays: &[Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit::MISS; rays.len()];
    index.answer(&ClosestHit, rays, &mut hits);
    hits
}

fn refit<A: Accel>(
    index: &mut Indexed<TriangleSet, A>,
    moved: Moved<'_>,
    (positions, triangles): (&[Vec3], &[[u32; 3]]),
) {
    index.refit(moved, |set| set.move_to(positions, triangles), TriangleSet::settle).unwrap();
}

/// After each of some frames all hits equal those of no structure, by slices and one by one, and the boxes are those of
/// a tree that was gone through as a whole.
fn follows<A: Accel + Clone>() {
    let rays = rays();
    for count in [1, 7, 300, 6_000] {
        let (mut positions, triangles) = triangles(count);
        let built = TriangleSet::new(&positions, &triangles);
        let mut few: Indexed<TriangleSet, A> = Indexed::build(built, &BuildConfig::default());
        let mut all = few.clone();
        for frame in 1..4 {
            let before = few.primitives().clone();
            let every = 40 * frame + 1;
            for (i, position) in positions.iter_mut().enumerate() {
                if (i / 3).is_multiple_of(every) {
                    *position = 1.1 * position.yzx() - 0.2;
                }
            }
            refit(&mut all, Moved::All, (&positions, &triangles));
            let slots = all.tree().unwrap();
            let has_moved = |&slot: &u32| before.bounds(slot) != all.primitives().bounds(slot);
            let slots: Vec<u32> = slots.slots().map(|(slot, _)| slot).filter(has_moved).collect();
            assert!(count < 300 || !slots.is_empty());
            refit(&mut few, Moved::Slots(&slots), (&positions, &triangles));
            assert!(few.tree() == all.tree(), "{count} triangles, frame {frame}");
            assert_eq!(few.primitives().padding(), all.primitives().padding());
            let set = TriangleSet::new(&positions, &triangles);
            assert_eq!(few.primitives().padding(), set.padding());
            assert_eq!(few.primitives().mean_point(), set.mean_point());
            let none: Indexed<_, Exhaustive> = Indexed::build(set, &BuildConfig::default());
            let expected = hits(&none, &rays);
            let alone: Vec<Hit> = rays[..500].iter().map(|ray| few.hit(ray)).collect();
            for got in [hits(&few, &rays), hits(&all, &rays), alone] {
                let differs = |(got, expected): (&Hit, &Hit)| !got.same_bits(expected);
                let first = got.iter().zip(&expected).position(differs);
                assert_eq!(first, None, "{count} triangles, frame {frame}");
            }
        }
    }
}

#[test]
fn a_binary_tree_follows() {
    follows::<Bvh>();
}

#[test]
fn a_tree_of_eight_children_follows() {
    follows::<Bvh8>();
}

#[test]
fn what_cannot_be_traced_is_refused() {
    let (mut positions, triangles) = triangles(9);
    let set = TriangleSet::new(&positions, &triangles);
    let index: Indexed<_, Bvh8> = Indexed::build(set, &BuildConfig::default());
    let refused = |positions: &[Vec3], triangles: &[[u32; 3]]| {
        let change = |set: &mut TriangleSet| set.move_to(positions, triangles);
        index.clone().refit(Moved::All, change, TriangleSet::settle).unwrap_err()
    };
    let other = refused(&positions, &triangles[1..]);
    assert_eq!(other, MeshError::OtherTriangles { triangles: 8, before: 9 });
    let none = refused(&positions[..20], &triangles);
    assert!(
        matches!(none, MeshError::NoVertex { triangle: 6, vertex: 20, vertices: 20 }),
        "{none}"
    );
    positions[4].y = f32::NAN;
    assert!(matches!(refused(&positions, &triangles), MeshError::NotFinite { triangle: 1, .. }));
    positions[4].y = 1e30;
    assert!(matches!(refused(&positions, &triangles), MeshError::OutOfRange { .. }));
}
