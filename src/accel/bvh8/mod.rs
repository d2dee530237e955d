//! A tree of eight children a node, with kernels that trace many rays at once.
//!
//! A binary tree (`builder/`), made from the top down, is collapsed at the least cost (`plan.rs`,
//! `collapse.rs`). Slices of rays go down it in packets as long as they are coherent
//! (`packet/`) and in waves where they are not (`wave/`), which `kernels.rs` decides; where
//! primitives are not tested in packs, a stream of rays is brought to each node and to each primitive
//! that any of them meets (`stream.rs`). A single ray is walked by [`Accel::traverse`]. So are the
//! rays that the kernels' terms cannot take, those of queries that keep more than one hit, and those in trees of
//! very many levels. Where primitives move, the boxes follow (`refit.rs`).
//!
//! * *Idea*: What a ray costs is mostly waiting: for the next node, for a branch. Eight boxes are tested by one
//!   instruction, 16 or 32 rays go together where they can, and where they cannot others are searched meanwhile.
//! * *Papers*: Dammertz, Hanika, Keller: *Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent
//!   Rays*, 2008, for wide nodes; Fuetterling, Lojewski, Pfreundt, Ebert: *Efficient Ray Tracing Kernels for Modern CPU
//!   Architectures*, 2015, for streams of rays; Ylitie, Karras, Laine, 2017, for the collapse.
//! * *Build*: O(n log n), in parallel.
//! * *A ray*: O(log n) nodes in the mean, eight boxes each at once.
//! * *Memory*: 256 bytes a node; 320 a leaf of eight triangles, which is the triangles themselves.
//! * *It wins*: wherever rays come in slices. Single rays are better off with `bvh`.
//! * *Picture*: `docs/gallery/cells-bvh8.png`.

mod candidates;
mod coherence;
mod collapse;
mod diverged;
mod kernels;
mod meeting;
mod node;
mod packet;
mod plan;
mod refit;
mod save;
mod slab_ray;
mod stream;
mod task;
mod wave;

use std::ops::{ControlFlow, Range};

use glam::Vec4;
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::slab::crossing;
use crate::math::{Aabb, BoxRay, Ray};

use self::collapse::{Wide, collapse};
use self::node::{Child, FAR, Node, WIDTH, near_planes, order_shift};
use self::plan::{Leaves, Plan};
use self::slab_ray::Sides;
use super::builder::{Builder, TreeChoice, cuts};
use super::refit::Memory;
use super::{
    Accel, Bounded, Build, BuildConfig, Built, Followed, Moved, OptionInfo, Order, PACK, Packs,
    Primitives, Query, Scratch, Search, Tree, Update, search_one,
};

/// The stack lives with the call up to this height, and on the heap beyond.
const USUAL_HEIGHT: usize = 64;

/// The most entries that the stacks of the kernels hold, a power of two: enough for trees of
/// billions. In deeper ones, streams of rays are brought to each node.
const HEIGHT: usize = 128;

/// The most levels of nodes that streams go down. Each level takes memory for eight lists of rays, so that this many
/// take 16 MiB. In deeper trees, which no builder makes over usual boxes, each ray is walked by itself.
const STREAM_LEVELS: usize = 512;

/// A wide tree of boxes.
#[derive(Clone, Debug)]
pub struct Bvh8 {
    /// The root is the first; none if there are no primitives.
    nodes: Vec<Node>,
    /// Slots from the beginning of one block to that of the next.
    block: usize,
    height: Height,
    /// What was needed to follow primitives that move.
    memory: Memory,
}

const BUILDER: OptionInfo = Builder::option("sah");
const LEAF: OptionInfo = OptionInfo::leaf(WIDTH as u32, "8");

impl Accel for Bvh8 {
    /// As measured over a terrain and a sphere of two million triangles: by `slow` builds, others take 40.
    const BUILD_BYTES: u64 = 170;

    const OPTIONS: &'static [OptionInfo] = &[BUILDER, Builder::REINSERTION, LEAF];

    const UPDATES: &'static [Update] = &Update::ALL;

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let leaves = Leaves::of(build.config, build.grain);
        if primitives.count() == 0 {
            let memory = Memory::default();
            let height = Height::default();
            let accel = Self { nodes: Vec::new(), block: leaves.block, height, memory };
            return Built { accel, order: None };
        }
        let (wide, references) = wide_tree(primitives, leaves, build, cuts(build.grain));
        let height = Height::of(&wide.nodes);
        let memory = Memory::default();
        let accel = Self { nodes: wide.nodes, block: leaves.block, height, memory };
        let order = Order::of(wide.order, references, primitives.count());
        Built { accel, order: Some(order) }
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        if self.nodes.is_empty() {
            return;
        }
        let wide_ray = WideRay::new(ray, box_ray);
        let mut end = ray.end();
        let mut stack = SmallVec::<[(Child, f32); USUAL_HEIGHT]>::new();
        stack.push((Child::ROOT, ray.t_min));
        while let Some((child, begin)) = stack.pop() {
            if begin > end {
                continue;
            }
            if child.is_leaf() {
                let first = (child.block() * self.block) as u32;
                match leaf(first..first + child.count(), counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
                continue;
            }
            let node = &self.nodes[child.index()];
            counters.boxes(node.present().count() as u32);
            let (begins, entered) = wide_ray.enter(node, end);
            for word in node.orders() {
                let lane = (word >> wide_ray.order_shift) as usize % WIDTH;
                if entered >> lane & 1 != 0 {
                    stack.push((Child(node.children()[lane]), begins[lane]));
                }
            }
        }
    }

    fn search<P: Primitives, Q: Query, C: Counters>(
        &self,
        query: &Q,
        primitives: &P,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        scratch: &mut Scratch,
        counters: &mut C,
    ) {
        let one_by_one = const {
            let keeps_one = Q::KEEPS_ONE_HIT && !matches!(Q::SEARCH, Search::All);
            <P::Packs as Packs>::GRAIN > 1 && !keeps_one
        };
        let in_packs = const { <P::Packs as Packs>::GRAIN > 1 } && self.height.need < HEIGHT;
        let too_deep = !in_packs && self.height.levels > STREAM_LEVELS;
        if self.nodes.is_empty() || one_by_one || too_deep {
            for (ray, answer) in rays.iter().zip(answers) {
                *answer = search_one(self, query, primitives, ray, counters);
            }
        } else if in_packs {
            kernels::search(self, query, primitives, rays, answers, scratch, counters);
        } else {
            stream::search(self, query, primitives, rays, answers, scratch, counters);
        }
    }

    fn refit<P: Primitives>(
        &mut self,
        update: Update,
        primitives: &P,
        moved: Moved<'_>,
        build: &Build<'_>,
    ) -> Followed {
        refit::refit(self, update, primitives, moved, build)
    }

    fn bytes(&self) -> u64 {
        let nodes = self.nodes.capacity() * size_of::<Node>();
        (size_of::<Self>() + nodes + self.memory.bytes()) as u64
    }

    fn tree(&self) -> Option<Tree> {
        let bounds = self.nodes.first().map_or(Aabb::EMPTY, Node::bounds);
        self.nodes.first()?;
        Some(Tree::of((Child::ROOT, bounds), |&(child, bounds), children| {
            if child.is_leaf() {
                let first = (child.block() * self.block) as u32;
                return (bounds, first..first + child.count());
            }
            let node = &self.nodes[child.index()];
            children.extend(node.present().map(|(lane, child)| (child, node.child_bounds(lane))));
            (bounds, 0..0)
        }))
    }
}

impl Leaves {
    /// What the options say, of primitives that are tested so many at once.
    fn of(config: &BuildConfig, grain: u32) -> Self {
        Self {
            most: config.options.number(&LEAF).unwrap_or(config.max_leaf).clamp(1, WIDTH as u32),
            block: if grain > 1 { PACK } else { 1 },
        }
    }
}

/// Builds the tree over at least one primitive.
fn wide_tree(
    primitives: &impl Bounded,
    leaves: Leaves,
    build: &mut Build<'_>,
    cuts: bool,
) -> (Wide, usize) {
    let Build { config, stages, .. } = build;
    let choice = TreeChoice::of(config, cuts, &BUILDER, Builder::Sah);
    let tree = choice.tree(primitives, leaves.block as u32, leaves.most, stages);
    let plan = stages.time("plan", || Plan::new(&tree, leaves));
    let wide = stages.time("collapse", || collapse(&tree, &plan, leaves));
    (wide, tree.primitive_indices.len())
}

/// How high a tree is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Height {
    /// The most entries that a stack holds at once, whatever the order of the children.
    need: usize,
    /// Levels of nodes.
    levels: usize,
}

impl Height {
    /// Of a subtree's entries on a stack: all of a node's children, or all but one and what that one
    /// puts there. Children have larger indices than their parents.
    fn of(nodes: &[Node]) -> Self {
        let mut heights = vec![Self::default(); nodes.len()];
        for (index, node) in nodes.iter().enumerate().rev() {
            let mut below = Self::default();
            for (_, child) in node.present().filter(|(_, child)| !child.is_leaf()) {
                let Self { need, levels } = heights[child.index()];
                below = Self { need: below.need.max(need), levels: below.levels.max(levels) };
            }
            let width = node.present().count();
            heights[index] =
                Self { need: width.max(width - 1 + below.need), levels: below.levels + 1 };
        }
        heights.first().copied().unwrap_or_default()
    }
}

/// A ray as [`Accel::traverse`] tests it against eight boxes: exactly [`BoxRay::interval`].
struct WideRay {
    origins: [[Vec4; 2]; 3],
    inv_dir: [Vec4; 3],
    near_planes: [u32; 3],
    order_shift: u32,
    t_min: Vec4,
}

impl WideRay {
    #[inline(always)]
    fn new(ray: &Ray, box_ray: &BoxRay) -> Self {
        let Sides { near, far, octant } = Sides::of(box_ray);
        Self {
            origins: std::array::from_fn(|axis| [Vec4::splat(near[axis]), Vec4::splat(far[axis])]),
            inv_dir: std::array::from_fn(|axis| Vec4::splat(box_ray.inv_dir[axis])),
            near_planes: near_planes(octant),
            order_shift: order_shift(octant),
            t_min: Vec4::splat(ray.t_min),
        }
    }

    /// Where the ray enters each child, and a mask of those that it enters before `end`.
    #[inline(always)]
    fn enter(&self, node: &Node, end: f32) -> ([f32; WIDTH], u32) {
        let mut begins = [0.0; WIDTH];
        let mut entered = 0;
        for half in [0, 4] {
            let (mut begin, mut leave) = (self.t_min, Vec4::splat(end));
            for axis in 0..3 {
                let place = self.near_planes[axis];
                let near = planes_of_half(node, place, half);
                let far = planes_of_half(node, place ^ FAR, half);
                begin = begin.max(crossing(near, self.origins[axis][0], self.inv_dir[axis]));
                leave = leave.min(crossing(far, self.origins[axis][1], self.inv_dir[axis]));
            }
            begin.write_to_slice(&mut begins[half..]);
            entered |= begin.cmple(leave).bitmask() << half;
        }
        (begins, entered)
    }
}

#[inline(always)]
fn planes_of_half(node: &Node, place: u32, half: usize) -> Vec4 {
    let plane = |lane: usize| node.plane(place, half + lane);
    Vec4::new(plane(0), plane(1), plane(2), plane(3))
}
