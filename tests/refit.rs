//! Structures that follow triangles which move, without any scene: the whole tree, or the paths from a few leaves, in
//! every way that they offer.
#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use glam::{Vec3, Vec3Swizzles};
use srt::accel::{
    Accel, Bounded, BuildConfig, BuildOptions, Bvh, Bvh8, ClosestHit, Exhaustive, Indexed, Moved,
    Portable, PortablePrimitives, Primitives, Tree, Update,
};
use srt::math::{Aabb, Hit, Random, Ray};
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
    update: Update,
    moved: Moved<'_>,
    (positions, triangles): (&[Vec3], &[[u32; 3]]),
) {
    let change = |set: &mut TriangleSet| set.move_to(positions, triangles);
    index.refit(update, moved, change, TriangleSet::settle).unwrap();
}

/// Moves some vertices, more of them in later frames.
fn move_some(positions: &mut [Vec3], frame: usize) {
    let every = 40 * frame + 1;
    for (i, position) in positions.iter_mut().enumerate() {
        if (i / 3).is_multiple_of(every) {
            *position = 1.1 * position.yzx() - 0.2;
        }
    }
}

/// The slots of the triangles whose boxes are others than before.
fn moved_slots<A: Accel>(
    before: &Indexed<TriangleSet, A>,
    now: &Indexed<TriangleSet, A>,
) -> Vec<u32> {
    let of = |index: &Indexed<TriangleSet, A>| {
        let tree = index.tree().unwrap();
        let set = index.primitives();
        let mut boxes: Vec<_> = tree
            .slots()
            .map(|(slot, _)| (PortablePrimitives::id(set, slot), slot, set.bounds(slot)))
            .collect();
        boxes.sort_by_key(|(id, ..)| *id);
        boxes
    };
    let pairs = of(before).into_iter().zip(of(now));
    pairs.filter(|(before, now)| before.2 != now.2).map(|(before, _)| before.1).collect()
}

/// Boxes are the unions of what is below them, to the bit.
fn assert_tight(tree: &Tree, set: &TriangleSet) {
    let nodes = tree.nodes();
    let mut around = vec![Aabb::EMPTY; nodes.len()];
    for (index, node) in nodes.iter().enumerate().rev() {
        let slots = node.slots.clone().map(|slot| set.bounds(slot));
        let mut bounds = slots.fold(Aabb::EMPTY, Aabb::union);
        let mut child = index + 1;
        while child < node.end {
            bounds = bounds.union(around[child]);
            child = nodes[child].end;
        }
        // No ray is tested against the root, and one that is a leaf has no box.
        assert!(index == 0 || node.bounds == bounds, "node {index}");
        around[index] = bounds;
    }
}

/// All hits equal those of no structure, by slices and one by one; nothing but the tree is another one than if it was
/// built now; and it is written and read.
fn assert_right<A: Portable + Clone>(
    own: &Indexed<TriangleSet, A>,
    (positions, triangles): (&[Vec3], &[[u32; 3]]),
    what: &str,
) {
    let rays = rays();
    let set = TriangleSet::new(positions, triangles);
    assert_eq!(own.primitives().padding(), set.padding());
    assert_eq!(own.primitives().mean_point(), set.mean_point());
    assert_tight(&own.tree().unwrap(), own.primitives());
    let none: Indexed<_, Exhaustive> = Indexed::build(set, &BuildConfig::default());
    let expected = hits(&none, &rays);
    let alone: Vec<Hit> = rays[..500].iter().map(|ray| own.hit(ray)).collect();
    let mut bytes = Vec::new();
    own.save(&mut bytes).unwrap();
    let read: Indexed<TriangleSet, A> = Indexed::load(&bytes[..]).unwrap();
    assert!(read.tree() == own.tree(), "{what}");
    for got in [hits(own, &rays), hits(&read, &rays), alone] {
        let differs = |(got, expected): (&Hit, &Hit)| !got.same_bits(expected);
        assert_eq!(got.iter().zip(&expected).position(differs), None, "{what}");
    }
}

/// In each of some frames, the tree that was gone through as a whole and the one of which paths were gone up are right,
/// and after a refit they are the same.
fn follows<A: Portable + Clone>() {
    for update in Update::ALL {
        for count in [1, 7, 300, 6_000] {
            let (mut positions, triangles) = triangles(count);
            let built = TriangleSet::new(&positions, &triangles);
            let mut few: Indexed<TriangleSet, A> = Indexed::build(built, &BuildConfig::default());
            let (mut all, mut refitted) = (few.clone(), few.clone());
            let mut changed = false;
            for frame in 1..4 {
                move_some(&mut positions, frame);
                let mesh = (&positions[..], &triangles[..]);
                let before = few.clone();
                refit(&mut all, update, Moved::All, mesh);
                refit(&mut refitted, Update::Refit, Moved::All, mesh);
                let slots = moved_slots(&before, &all);
                assert!(count < 300 || !slots.is_empty());
                refit(&mut few, update, Moved::Slots(&slots), mesh);
                let what = format!("{update:?}, {count} triangles, frame {frame}");
                assert_right(&all, mesh, &what);
                assert_right(&few, mesh, &what);
                assert!(update != Update::Refit || few.tree() == all.tree(), "{what}");
                changed |= all.tree() != refitted.tree() && few.tree() != refitted.tree();
            }
            let is_large = count >= 300;
            assert!(!is_large || changed == (update != Update::Refit), "{update:?}, {count}");
            let cost = |index: &Indexed<TriangleSet, A>| index.shape().sah_cost.unwrap();
            let improved = is_large && changed;
            assert!(!improved || cost(&all) < cost(&refitted), "{update:?}, {count}");
        }
    }
}

/// Ways of following may come after each other, and threads change nothing.
fn mixes<A: Portable + Clone>() {
    let (mut positions, triangles) = triangles(5_000);
    let built = TriangleSet::new(&positions, &triangles);
    let one: Indexed<TriangleSet, A> = Indexed::build(built, &BuildConfig::default());
    let mut indices = [one.clone(), one];
    let pools =
        [1, 2].map(|threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap());
    for frame in 1..8 {
        move_some(&mut positions, frame);
        let mesh = (&positions[..], &triangles[..]);
        let update = Update::ALL[frame * 2 % 3];
        for (index, pool) in indices.iter_mut().zip(&pools) {
            let before = index.clone();
            pool.install(|| {
                refit(index, update, Moved::All, mesh);
                // Nothing moves any more, but the paths are gone up.
                let slots = moved_slots(&before, index);
                let next = Update::ALL[(frame + 1) % 3];
                refit(index, next, Moved::Slots(&slots[..slots.len().min(9)]), mesh);
            });
        }
        assert!(indices[0].tree() == indices[1].tree(), "frame {frame}");
        assert_right(&indices[0], mesh, &format!("{update:?}, frame {frame}"));
    }
}

/// Where one of sixteen clouds of triangles is stirred, others far from it stay as they are.
fn leaves_what_is_good<A: Portable + Clone>() {
    const CLOUDS: u32 = 16;
    let (cloud, own) = triangles(300);
    let count = cloud.len() as u32;
    let at = |number: u32| 10.0 * Vec3::new((number % 4) as f32, (number / 4) as f32, 0.0);
    let clouds = (0..CLOUDS).flat_map(|number| cloud.iter().map(move |&p| p + at(number)));
    let mut positions: Vec<Vec3> = clouds.collect();
    let shifted = |number: u32| own.iter().map(move |t| t.map(|corner| corner + number * count));
    let triangles: Vec<_> = (0..CLOUDS).flat_map(shifted).collect();
    let built = TriangleSet::new(&positions, &triangles);
    let mut refitted: Indexed<TriangleSet, A> = Indexed::build(built, &BuildConfig::default());
    let mut partial = refitted.clone();
    for position in &mut positions[((CLOUDS - 1) * count) as usize..] {
        let from = *position - at(CLOUDS - 1);
        *position = at(CLOUDS - 1) + (7.0 * from.yzx()).fract();
    }
    let mesh = (&positions[..], &triangles[..]);
    refit(&mut refitted, Update::Refit, Moved::All, mesh);
    refit(&mut partial, Update::Partial, Moved::All, mesh);
    assert_right(&partial, mesh, "one of sixteen clouds");
    // Each node of the first cloud, with its number of triangles.
    let first = |index: &Indexed<TriangleSet, A>| {
        let tree = index.tree().unwrap();
        let own = tree.nodes().iter().filter(|node| node.bounds.max.x.max(node.bounds.max.y) < 5.0);
        own.map(|node| (node.bounds, node.slots.len())).collect::<Vec<_>>()
    };
    let (kept, left) = (first(&refitted), first(&partial));
    assert!(kept.len() > 40, "{} nodes", kept.len());
    let other = kept.iter().zip(&left).position(|(a, b)| a != b);
    assert!(kept == left, "{} and {} nodes, {other:?} is another", kept.len(), left.len());
    let cost = |index: &Indexed<TriangleSet, A>| index.shape().sah_cost.unwrap();
    assert!(cost(&partial) < cost(&refitted));
}

#[test]
fn what_has_stayed_good_is_left_alone() {
    leaves_what_is_good::<Bvh>();
    leaves_what_is_good::<Bvh8>();
}

#[test]
fn ways_of_following_go_together_with_any_number_of_threads() {
    mixes::<Bvh>();
    mixes::<Bvh8>();
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
        index.clone().refit(Update::Refit, Moved::All, change, TriangleSet::settle).unwrap_err()
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

/// A tree whose leaves share triangles follows too: each copy is moved, and has its whole box.
fn copies_follow<A: Portable + Clone>() {
    let rays = rays();
    let mut random = Random::new(&[77]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
    // Long triangles along all axes, so that boxes are cut.
    let mut positions: Vec<Vec3> = Vec::new();
    for i in 0..1_500 {
        let (at, mut along) = (point(), 0.02 * point());
        along[i % 3] = 0.4;
        positions.extend([at, at + along, at + along + 0.02 * point()]);
    }
    let triangles: Vec<[u32; 3]> = (0..1_500).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let config = BuildConfig {
        options: BuildOptions::of::<A>("builder=sbvh").unwrap(),
        ..BuildConfig::default()
    };
    let set = TriangleSet::new(&positions, &triangles);
    let mut index: Indexed<TriangleSet, A> = Indexed::build(set, &config);
    let slots = |index: &Indexed<TriangleSet, A>| index.tree().unwrap().slots().count();
    assert!(slots(&index) > 1_550, "{} slots", slots(&index));
    for frame in 1..9 {
        move_some(&mut positions, frame);
        let mesh = (&positions[..], &triangles[..]);
        refit(&mut index, Update::ALL[frame % 3], Moved::All, mesh);
        let set = TriangleSet::new(&positions, &triangles);
        assert_eq!(index.primitives().padding(), set.padding());
        assert_tight(&index.tree().unwrap(), index.primitives());
        let none: Indexed<_, Exhaustive> = Indexed::build(set, &BuildConfig::default());
        let (got, expected) = (hits(&index, &rays), hits(&none, &rays));
        let differs = |(got, expected): (&Hit, &Hit)| !got.same_bits(expected);
        assert_eq!(got.iter().zip(&expected).position(differs), None, "frame {frame}");
    }
}

#[test]
fn trees_whose_leaves_share_triangles_follow() {
    copies_follow::<Bvh>();
    copies_follow::<Bvh8>();
}
