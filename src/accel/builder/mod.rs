//! Binary trees with one or a few primitives in each leaf: what the layouts of structures are made
//! from.
//!
//! A builder knows boxes and no layout, and a layout takes the tree of any builder:
//!
//! * `sah` (`binned.rs`): from the top by the surface area heuristic in bins, more or less closely
//!   (`terms.rs`);
//! * `ploc` (obvhs): from the bottom by clustering (Meister, Bittner: *Parallel Locally-Ordered
//!   Clustering for Bounding Volume Hierarchy Construction*, 2018);
//! * `sweep` (`all_places.rs`): from the top by the surface area heuristic, with all places weighed;
//! * `median` (`median.rs`): from the top, halved by number;
//! * `lbvh` (`lbvh.rs`): along Morton's curve;
//! * `hlbvh` (`hlbvh.rs`): along Morton's curve below, by the surface area heuristic above;
//! * `sbvh` (`spatial.rs`): from the top by the surface area heuristic, boxes cut where that pays;
//! * `parry` (`parry.rs`), with the feature `libraries`: as parry3d parts them;
//! * `svenstaro` (`svenstaro.rs`), with the same: as the crate bvh parts them.
//!
//! Of the trees of the last two only the form is taken (`walked.rs`), so that they are compared by the same formula and
//! under the same walk as all others; as they are shipped, the same libraries are peers.
//!
//! Each can be improved by obvhs's reinsertion (Meister, Bittner: *Parallel Reinsertion for Bounding Volume Hierarchy
//! Optimization*, 2018), as the option or the quality says (`choice.rs`). None depends on the number of threads.

mod all_places;
mod binned;
mod bins;
mod branch;
mod choice;
mod hlbvh;
mod lbvh;
mod median;
#[cfg(feature = "libraries")]
mod parry;
mod reference;
mod sorted;
mod spatial;
mod split;
#[cfg(feature = "libraries")]
mod svenstaro;
mod sweep;
mod terms;
mod top_down;
#[cfg(feature = "libraries")]
mod walked;

use glam::Vec3A;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;
use rayon::prelude::*;

use crate::math::Aabb;

use self::terms::{Effort, Terms};
use super::build::obvhs_boxes;
use super::{Allowed, Bounded, BuildOptions, BuildStages, OptionInfo, Quality};

pub(super) use self::choice::TreeChoice;

/// How a tree is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Builder {
    /// From the top down by the surface area heuristic, in bins.
    Sah,
    /// From the bottom up by clustering.
    Ploc,
    /// From the top down by the surface area heuristic, all places weighed.
    Sweep,
    /// From the top down, halved by number.
    Median,
    /// Along Morton's curve.
    Lbvh,
    /// Along Morton's curve below, by the surface area heuristic above.
    Hlbvh,
    /// As parry3d parts them.
    #[cfg(feature = "libraries")]
    Parry,
    /// As the crate bvh parts them.
    #[cfg(feature = "libraries")]
    Svenstaro,
    /// From the top down by the surface area heuristic, boxes cut where that pays.
    Sbvh,
}

/// What the options' summaries say of the builders of other libraries.
#[cfg(feature = "libraries")]
macro_rules! libraries {
    () => {
        ", or as a library builds it: parry3d (parry) or the crate bvh (svenstaro)"
    };
}
#[cfg(not(feature = "libraries"))]
macro_rules! libraries {
    () => {
        ""
    };
}

impl Builder {
    const ALL: &[Self] = &[
        Self::Sah,
        Self::Ploc,
        Self::Sweep,
        Self::Median,
        Self::Lbvh,
        Self::Hlbvh,
        #[cfg(feature = "libraries")]
        Self::Parry,
        #[cfg(feature = "libraries")]
        Self::Svenstaro,
        Self::Sbvh,
    ];

    /// What they are called, in the same order; the last one cuts boxes.
    const WORDS: &[&str] = &[
        "sah",
        "ploc",
        "sweep",
        "median",
        "lbvh",
        "hlbvh",
        #[cfg(feature = "libraries")]
        "parry",
        #[cfg(feature = "libraries")]
        "svenstaro",
        "sbvh",
    ];

    /// The option that chooses it, with what holds where it is not given.
    pub(super) const fn option(default: &'static str) -> OptionInfo {
        OptionInfo {
            name: "builder",
            allowed: Allowed::Words(Self::WORDS),
            default,
            summary: concat!(
                "binary tree by the surface area heuristic (in bins, by a sweep over all places, or in bins with ",
                "boxes that are cut: sbvh), by clustering, by halves of equal number or along Morton's curve (with the ",
                "heuristic above: hlbvh)",
                libraries!()
            ),
        }
    }

    /// The same for structures of whole boxes.
    pub(super) const fn option_without_cuts(default: &'static str) -> OptionInfo {
        let (words, _) = Self::WORDS.split_at(Self::WORDS.len() - 1);
        OptionInfo {
            allowed: Allowed::Words(words),
            summary: concat!(
                "binary tree by the surface area heuristic (in bins or by a sweep over all places), by clustering, by ",
                "halves of equal number or along Morton's curve (with the heuristic above: hlbvh)",
                libraries!()
            ),
            ..Self::option(default)
        }
    }

    /// What was chosen.
    pub(super) fn chosen(options: &BuildOptions, option: &OptionInfo) -> Option<Self> {
        let chosen = options.word(option)?;
        Self::WORDS.iter().zip(Self::ALL).find(|(word, _)| **word == chosen).map(|(_, own)| *own)
    }

    /// Builds a tree over at least one primitive, for leaves in which `pack` primitives, a power of two,
    /// cost as much as one. Its leaves hold up to `most` primitives where parting them would not pay. Several
    /// leaves may refer to a primitive if `cuts` says so.
    fn tree(
        self,
        primitives: &impl Bounded,
        [pack, most]: [u32; 2],
        quality: Quality,
        cuts: bool,
        stages: &mut BuildStages,
    ) -> Bvh2 {
        let (parameters, effort) = (quality.parameters(), Effort::of(quality));
        let terms = Terms { pack_bits: pack.ilog2(), most: most as usize, effort };
        match self {
            Self::Sah => binned::build(primitives, terms, stages),
            Self::Sweep => all_places::build(primitives, terms, stages),
            Self::Median => median::build(primitives, stages),
            Self::Lbvh => lbvh::build(primitives, stages),
            Self::Hlbvh => hlbvh::build(primitives, effort, stages),
            #[cfg(feature = "libraries")]
            Self::Parry => parry::build(primitives, stages),
            #[cfg(feature = "libraries")]
            Self::Svenstaro => svenstaro::build(primitives, stages),
            Self::Sbvh => spatial::build(primitives, terms, cuts, stages),
            Self::Ploc => {
                let boxes = stages.time("boxes", || obvhs_boxes(primitives));
                let build = || {
                    PlocBuilder::with_capacity(boxes.len()).build(
                        parameters.ploc_search_distance,
                        &boxes,
                        (0..boxes.len() as u32).collect(),
                        parameters.sort_precision,
                        parameters.search_depth_threshold,
                    )
                };
                stages.time("tree", build)
            }
        }
    }
}

/// Whether boxes may be cut, of primitives that are tested so many at once: where they are tested one by one, as
/// objects are, none is copied, since an object may be large and move by itself.
pub(super) fn cuts(grain: u32) -> bool {
    grain > 1
}

/// Boxes of nothing else.
pub(super) struct Boxes(pub(super) Vec<Aabb>);

impl Boxes {
    /// Those of some primitives.
    pub(super) fn of(primitives: &impl Bounded, some: &[u32]) -> Self {
        Self(some.par_iter().map(|&index| primitives.bounds(index)).collect())
    }
}

impl Bounded for Boxes {
    fn count(&self) -> u32 {
        self.0.len() as u32
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.0[index as usize]
    }

    fn mean_point(&self) -> Vec3A {
        self.total_bounds().center()
    }
}

/// Improves a tree by reinserting a share of its nodes again and again.
pub(super) fn reinsert(tree: &mut Bvh2, share: f32, stages: &mut BuildStages) {
    if share > 0.0 {
        stages.time("reinsertion", || ReinsertionOptimizer::default().run(tree, share, None));
    }
}

#[cfg(test)]
mod tests {
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
        (0..count)
            .map(|_| (point(), point()))
            .map(|(a, b)| Aabb { min: a, max: a + 0.1 * b })
            .collect()
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
                assert!(deepest < walked::USUAL_DEPTH + 32, "{builder:?}: {deepest} levels");
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
            [Builder::Sah, Builder::Sweep, Builder::Median, Builder::Lbvh, Builder::Hlbvh]
                .map(cost);
        assert!(
            sweep < 1.02 * bins && bins < median && bins < above && above < curve,
            "{bins} {sweep} {median} {curve} {above}"
        );
    }
}
