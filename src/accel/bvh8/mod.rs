//! A tree of eight children a node, with kernels that trace many rays at once.
//!
//! A binary tree with a primitive in each leaf (`binary.rs`) is collapsed at the least cost
//! (`plan.rs`, `collapse.rs`). Slices of rays go down it in packets as long as they are coherent
//! (`packet.rs`) and in waves where they are not (`wave.rs`); where primitives are not tested in
//! packs, a stream of rays is brought to each node and to each primitive that any of them meets
//! (`stream.rs`). A single ray is walked by [`Accel::traverse`], which is also the way of the rays
//! that the kernels' terms cannot take.

mod answer;
mod binary;
mod binned;
mod collapse;
mod node;
mod packet;
mod parked;
mod plan;
mod slab_ray;
mod stream;
mod wave;

use std::cell::Cell;
use std::ops::{ControlFlow, Range};

use glam::Vec4;
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Hit, Padding, Ray};
use crate::simd::{Kernel, Simd, dispatch, prefetch};

use self::answer::Answer;
use self::binary::binary_tree;
use self::collapse::{Leaves, collapse};
use self::node::{Child, FAR, Node, WIDTH, near_planes, order_shift};
use self::packet::Outcome;
use self::parked::Parked;
use self::plan::Plan;
use self::slab_ray::Sides;
use super::{
    Accel, Bounded, BuildConfig, BuildStages, Built, Order, PACK, Packs as _, Primitives,
    StructureShape, Tree, obvhs_boxes,
};

/// The stack lives with the call up to this height, and on the heap beyond.
const USUAL_HEIGHT: usize = 64;

/// The most entries that the stacks of the kernels hold, a power of two: enough for trees of
/// billions. In deeper ones, streams of rays are brought to each node.
const HEIGHT: usize = 128;

/// Bytes that a processor's caches hold, about.
const CACHE: u64 = 1 << 25;

/// A wide tree of boxes.
#[derive(Clone, Debug)]
pub struct Bvh8 {
    /// The root is the first; none if there are no primitives.
    nodes: Vec<Node>,
    /// Slots from the beginning of one block to that of the next.
    block: usize,
    /// The most entries that a stack holds at once, whatever the order of the children.
    need: usize,
}

impl Accel for Bvh8 {
    fn build(primitives: &impl Bounded, config: &BuildConfig) -> Built<Self> {
        Self::build_in_stages(primitives, config, &mut BuildStages::default())
    }

    fn build_in_stages(
        primitives: &impl Bounded,
        config: &BuildConfig,
        stages: &mut BuildStages,
    ) -> Built<Self> {
        let packed = primitives.lanes() > 1;
        let leaves = Leaves {
            most: config.max_leaf.clamp(1, WIDTH as u32),
            block: if packed { PACK } else { 1 },
        };
        if primitives.count() == 0 {
            let accel = Self { nodes: Vec::new(), block: leaves.block, need: 0 };
            return Built { accel, order: None };
        }
        let boxes = stages.time("boxes", || obvhs_boxes(primitives));
        let tree = binary_tree(&boxes, leaves, config.quality, stages);
        let plan = stages.time("plan", || Plan::new(&tree, leaves));
        let wide = stages.time("collapse", || collapse(&tree, &plan, leaves));
        let need = stack_need(&wide.nodes);
        let accel = Self { nodes: wide.nodes, block: leaves.block, need };
        Built { accel, order: Some(Order::Permutation(wide.order)) }
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
        let mut end = ray.t_max;
        let mut stack = SmallVec::<[(Child, f32); USUAL_HEIGHT]>::new();
        stack.push((Child::node(0), ray.t_min));
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

    fn intersect_many<P: Primitives, C: Counters>(
        &self,
        primitives: &P,
        rays: &[Ray],
        hits: &mut [Hit],
        counters: &mut C,
    ) {
        self.answer(primitives, rays, hits, counters);
    }

    fn occluded_many<P: Primitives, C: Counters>(
        &self,
        primitives: &P,
        rays: &[Ray],
        answers: &mut [bool],
        counters: &mut C,
    ) {
        self.answer(primitives, rays, answers, counters);
    }

    fn shape(&self) -> StructureShape {
        let mut shape = StructureShape::default();
        let mut open: Vec<_> = self.nodes.first().map(|root| (root, 0, 1.0)).into_iter().collect();
        let root_area = self.nodes.first().map_or(0.0, |root| root.bounds().half_area());
        let mut cost = 0.0;
        // A node, its depth, and the share of the rays that meet it: by its area in the root's.
        while let Some((node, depth, met)) = open.pop() {
            shape.nodes += 1;
            for (lane, child) in node.present() {
                let share = node.child_bounds(lane).half_area() / root_area;
                cost += met;
                if child.is_leaf() {
                    shape.add_leaf(child.count(), depth + 1);
                    cost += share * f64::from(child.count());
                } else {
                    open.push((&self.nodes[child.index()], depth + 1, share));
                }
            }
        }
        shape.sah_cost = (cost.is_finite() && shape.nodes > 0).then_some(cost);
        shape.bytes = (size_of::<Self>() + self.nodes.capacity() * size_of::<Node>()) as u64;
        shape
    }

    fn tree(&self) -> Option<Tree> {
        let bounds = self.nodes.first().map_or(Aabb::EMPTY, Node::bounds);
        self.nodes.first()?;
        Some(Tree::of((Child::node(0), bounds), |&(child, bounds), children| {
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

impl Bvh8 {
    /// Answers a slice of rays: in packets and waves where primitives are tested in packs, else in
    /// streams. An empty tree has nothing to be hit.
    fn answer<P: Primitives, A: Answer, C: Counters>(
        &self,
        primitives: &P,
        rays: &[Ray],
        answers: &mut [A],
        counters: &mut C,
    ) {
        if self.nodes.is_empty() {
            answers.fill(A::of(Hit::MISS));
        } else if let Some(search) = Search::new(self, primitives) {
            dispatch(Trace { search, rays, answers, counters });
        } else {
            dispatch(stream::Trace { tree: self, primitives, rays, answers, counters });
        }
    }
}

/// The most entries that a subtree can put on a stack: all of a node's children, or all but one
/// and what that one puts there. Children stand behind their parents.
fn stack_need(nodes: &[Node]) -> usize {
    let mut need = vec![0; nodes.len()];
    for (index, node) in nodes.iter().enumerate().rev() {
        let inner = node.present().filter(|(_, child)| !child.is_leaf());
        let deepest = inner.map(|(_, child)| need[child.index()]).max().unwrap_or(0);
        let width = node.present().count();
        need[index] = width.max(width - 1 + deepest);
    }
    need.first().copied().unwrap_or(0)
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
                begin = begin.max((near - self.origins[axis][0]) * self.inv_dir[axis]);
                leave = leave.min((far - self.origins[axis][1]) * self.inv_dir[axis]);
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

/// What a kernel searches.
struct Search<'a, P: Primitives> {
    tree: &'a Bvh8,
    primitives: &'a P,
    packs: &'a P::Packs,
    padding: Padding,
    /// Whether nodes and packs do not fit into the caches, so that rays ask for what they are about
    /// to read.
    large: bool,
}

impl<'a, P: Primitives> Search<'a, P> {
    /// What the kernels take, if they can: not primitives without packs, nor a tree so deep that it
    /// would need higher stacks than theirs.
    fn new(tree: &'a Bvh8, primitives: &'a P) -> Option<Self> {
        let packs = primitives.packs()?;
        let bytes = size_of_val(&tree.nodes[..]) as u64 + packs.bytes();
        let padding = primitives.padding();
        (tree.need < HEIGHT).then_some(Self {
            tree,
            primitives,
            packs,
            padding,
            large: bytes > CACHE,
        })
    }

    /// Asks the caches for what will be visited soon.
    #[inline(always)]
    fn prefetch(&self, child: Child) {
        if child.is_leaf() {
            self.packs.prefetch(child.block());
        } else {
            prefetch(&self.tree.nodes[child.index()]);
        }
    }
}

/// The kernels' memory.
#[derive(Default)]
struct Scratch {
    wave: wave::Scratch,
    packet: packet::Stack,
    /// Rays that go down in waves, by their place in the slice: from the root, and from where their
    /// packet has parted.
    scattered: Vec<u32>,
    parked: Parked,
}

/// Rays that are traced together: few enough to stay in a core's cache.
const AT_ONCE: usize = 4096;

impl Scratch {
    /// Rays go down by sixteens where and as long as they are coherent, and else in waves.
    #[inline(always)]
    fn trace<S: Simd, P: Primitives, A: Answer, C: Counters>(
        &mut self,
        search: &Search<'_, P>,
        rays: &[Ray],
        answers: &mut [A],
        counters: &mut C,
    ) {
        let Self { wave, packet, scattered, parked } = self;
        scattered.clear();
        parked.clear();
        let (packets, rest) = rays.as_chunks::<{ packet::RAYS }>();
        let (of_packets, _) = answers.as_chunks_mut::<{ packet::RAYS }>();
        for (number, (rays, answers)) in packets.iter().zip(of_packets).enumerate() {
            let first = (number * packet::RAYS) as u32;
            let numbered = (first, rays);
            let outcome = packet::search::<S, P, A, C, false>(
                search, numbered, answers, packet, parked, counters,
            );
            if outcome == Outcome::Mixed {
                scattered.extend(first..first + packet::RAYS as u32);
            }
        }
        scattered.extend((rays.len() - rest.len()) as u32..rays.len() as u32);
        let waiting = (&scattered[..], &*parked);
        wave::search::<S, P, A, C>(search, rays, waiting, answers, wave, counters);
    }
}

thread_local! {
    /// Kept from call to call; absent while used.
    static SCRATCH: Cell<Option<Box<Scratch>>> = const { Cell::new(None) };
}

/// What is asked of a slice of rays.
struct Trace<'a, P: Primitives, A, C> {
    search: Search<'a, P>,
    rays: &'a [Ray],
    answers: &'a mut [A],
    counters: &'a mut C,
}

impl<P: Primitives, A: Answer, C: Counters> Kernel for Trace<'_, P, A, C> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { search, rays, answers, counters } = self;
        let mut scratch = SCRATCH.take().unwrap_or_default();
        for (rays, answers) in rays.chunks(AT_ONCE).zip(answers.chunks_mut(AT_ONCE)) {
            scratch.trace::<S, P, A, C>(&search, rays, answers, counters);
        }
        SCRATCH.set(Some(scratch));
    }
}
