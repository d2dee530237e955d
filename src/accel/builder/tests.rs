use std::hash::{DefaultHasher as Hasher, Hash as _, Hasher as _};

use super::*;
use crate::math::Random;
use crate::simd::Isa;

fn tree(builder: Builder, boxes: &[Aabb], [pack, most]: [u32; 2], quality: Quality) -> Bvh2 {
    let boxes = Boxes(boxes.to_vec());
    let choice = TreeChoice::new(builder, quality, false);
    choice.tree(&boxes, pack, most, &mut BuildStages::default())
}

fn boxes(count: u32) -> Vec<Aabb> {
    let mut random = Random::new(&[29, u64::from(count)]);
    let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
    (0..count).map(|_| (point(), point())).map(|(a, b)| Aabb { min: a, max: a + 0.1 * b }).collect()
}

/// Every primitive once, boxes that are the unions of those below, leaves that are not too large.
fn assert_whole(tree: &Bvh2, boxes: &[Aabb], most: u32) {
    let mut seen = vec![false; boxes.len()];
    let (mut open, mut nodes) = (vec![0], 0);
    while let Some(index) = open.pop() {
        nodes += 1;
        let node = &tree.nodes[index as usize];
        let first = node.first_index as usize;
        let around = if node.is_leaf() {
            assert!(node.prim_count <= most, "{} in a leaf", node.prim_count);
            let own = &tree.primitive_indices[first..first + node.prim_count as usize];
            own.iter().fold(Aabb::EMPTY, |around, &primitive| {
                assert!(!std::mem::replace(&mut seen[primitive as usize], true));
                around.union(boxes[primitive as usize])
            })
        } else {
            open.extend([node.first_index, node.first_index + 1]);
            let [a, b] = [first, first + 1].map(|child| *tree.nodes[child].aabb());
            Aabb { min: a.min.min(b.min), max: a.max.max(b.max) }
        };
        assert_eq!(Aabb { min: node.aabb().min, max: node.aabb().max }, around);
    }
    assert!(seen.iter().all(|&seen| seen), "a primitive is lost");
    assert_eq!(nodes, tree.nodes.len());
}

#[test]
fn words_name_the_builders() {
    let option = Builder::option("sah");
    assert_eq!(Builder::WORDS.len(), Builder::ALL.len());
    for (word, &builder) in Builder::WORDS.iter().zip(Builder::ALL) {
        let options = BuildOptions::of::<super::super::Bvh>(&format!("builder={word}"));
        assert_eq!(Builder::chosen(&options.expect(word), &option), Some(builder));
    }
    assert_eq!(Builder::chosen(&BuildOptions::NONE, &option), None);
}

#[test]
fn every_builder_holds_all_primitives_in_the_boxes_around_them() {
    for &builder in Builder::ALL {
        for count in [1, 2, 3, 17, 1_000, 20_000] {
            for (leaves, quality) in
                [([1, 1], Quality::Medium), ([8, 8], Quality::Medium), ([8, 8], Quality::Slow)]
            {
                let boxes = boxes(count);
                assert_whole(&tree(builder, &boxes, leaves, quality), &boxes, leaves[1]);
            }
        }
    }
}

#[test]
fn equal_boxes_and_boxes_that_are_not_finite_lose_no_primitive() {
    for &builder in Builder::ALL.iter().filter(|&&builder| builder != Builder::Ploc) {
        let same = vec![boxes(1)[0]; 5_000];
        assert_whole(&tree(builder, &same, [1, 1], Quality::Medium), &same, 1);
        let mut boxes = boxes(6_000);
        for (i, bounds) in boxes.iter_mut().enumerate().filter(|(i, _)| i % 7 == 0) {
            let far = if i % 2 == 0 { f32::INFINITY } else { f32::MAX };
            *bounds = Aabb { min: Vec3A::splat(-far), max: Vec3A::splat(far) };
        }
        assert_whole(&tree(builder, &boxes, [8, 8], Quality::Medium), &boxes, 8);
    }
}

/// Of boxes that shrink towards a point a library parts few from the many, level by level, for which it calls
/// itself: on the stack of a thread of the pool, and with the floats that there are, in three directions.
#[cfg(feature = "libraries")]
#[test]
fn libraries_make_no_chain_and_need_no_higher_stack() {
    let power = |i: u32| 1e18 * 0.9f32.powi(i as i32);
    let along = |axis: usize, i: u32| {
        let mut corner = Vec3A::ZERO;
        corner[axis] = power(i);
        Aabb { min: corner, max: corner }
    };
    let lines = (0..3).flat_map(|axis| (0..1_300).map(move |i| along(axis, i)));
    let cubes = (0..1_300).map(|i| Aabb { min: Vec3A::ZERO, max: Vec3A::splat(power(i)) });
    for boxes in [lines.collect::<Vec<_>>(), cubes.collect()] {
        for builder in [Builder::Parry, Builder::Svenstaro] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("a pool");
            let tree = pool.install(|| tree(builder, &boxes, [1, 1], Quality::Medium));
            assert_whole(&tree, &boxes, 1);
            let (mut open, mut deepest) = (vec![(0, 0)], 0);
            while let Some((index, depth)) = open.pop() {
                let node: &obvhs::bvh2::node::Bvh2Node = &tree.nodes[index as usize];
                deepest = depth.max(deepest);
                if !node.is_leaf() {
                    open.extend([0, 1].map(|side| (node.first_index + side, depth + 1)));
                }
            }
            println!("{builder:?}: {deepest} levels");
            assert!(deepest < USUAL_DEPTH + 32, "{builder:?}: {deepest} levels");
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_tree() {
    let boxes = boxes(30_000);
    for &builder in Builder::ALL {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("a pool").install(|| tree(builder, &boxes, [8, 8], Quality::Medium))
        };
        let (one, three) = (on(1), on(3));
        assert_eq!(one.primitive_indices, three.primitive_indices);
        assert_eq!(format!("{:?}", one.nodes), format!("{:?}", three.nodes));
    }
}

/// The trees of bins as words, in one hash. On each instruction set a process of its own: it is chosen once.
#[test]
fn the_instruction_set_changes_no_tree() {
    const ASKED: &str = "SRT_TEST_TREES";
    const ANSWER: &str = "trees ";
    if std::env::var_os(ASKED).is_some() {
        let mut hash = Hasher::new();
        for (count, quality) in [(3_000, Quality::Medium), (40_000, Quality::Medium)]
            .into_iter()
            .chain([(40_000, Quality::Fastest)])
        {
            let tree = tree(Builder::Sah, &boxes(count), [8, 8], quality);
            tree.primitive_indices.iter().for_each(|index| index.hash(&mut hash));
            format!("{:?}", tree.nodes).hash(&mut hash);
        }
        println!("{ANSWER}{}", hash.finish());
        return;
    }
    let on = |isa: Isa| {
        let name = "accel::builder::tests::the_instruction_set_changes_no_tree";
        let test = std::process::Command::new(std::env::current_exe().unwrap())
            .args(["--exact", name, "--nocapture"])
            .envs([(ASKED, "1"), ("SRT_ISA", isa.name())])
            .output();
        let output = String::from_utf8(test.unwrap().stdout).unwrap();
        let answer = output.split_once(ANSWER).unwrap_or_else(|| panic!("{output}")).1;
        answer.lines().next().unwrap().to_owned()
    };
    let trees: Vec<_> = Isa::ALL.into_iter().filter(|isa| isa.is_present()).map(on).collect();
    assert!(trees.iter().all(|tree| *tree == trees[0]), "{trees:?}");
}

#[test]
fn a_sweep_over_all_places_costs_no_more_than_bins_and_halves_cost_the_most() {
    let boxes = boxes(5_000);
    let cost = |builder| {
        let tree = tree(builder, &boxes, [1, 1], Quality::Medium);
        let inner = tree.nodes.iter().filter(|node| !node.is_leaf());
        inner.map(|node| f64::from(node.aabb().half_area())).sum::<f64>()
    };
    let [bins, sweep, median, curve, above] =
        [Builder::Sah, Builder::Sweep, Builder::Median, Builder::Lbvh, Builder::Hlbvh].map(cost);
    assert!(
        sweep < 1.02 * bins && bins < median && bins < above && above < curve,
        "{bins} {sweep} {median} {curve} {above}"
    );
}
