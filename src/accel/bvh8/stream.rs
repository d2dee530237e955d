//! Streams: many rays go down the tree together, to primitives that each take time.
//!
//! A node is visited once, by all rays of a stream that meet it, and a primitive is tested once, with
//! all rays that meet its box: so its matrix, or the structure within it, is met by many rays while
//! it is at hand. After Barringer, Akenine-Möller: *Dynamic Ray Stream Traversal*, 2014.
//!
//! ```text
//! for each octant of directions: push (root, its rays)
//! while something is on the stack:
//!     pop (child, rays)
//!     a leaf:  test its primitives with the rays
//!     a node:  test each ray against the eight boxes before the end of its search, and append it to
//!              the lists of the children that it enters; push these, the farthest first
//! ```

use glam::Vec3A;

use crate::accel::{Primitives, Query, Scratch, Search, search_one};
use crate::counters::Counters;
use crate::math::{BoxRay, Lanes as _, Mask as _, Ray};
use crate::simd::{Kernel, Simd, dispatch, splat3};

use super::Bvh8;
use super::node::{Child, Node, WIDTH, near_planes, order_shift};
use super::slab_ray::SlabRay;

/// Rays of a stream: few enough to stay in a core's cache.
const RAYS: usize = 1024;

/// The memory of streams.
#[derive(Default)]
struct Memory {
    slabs: Vec<SlabRay>,
    /// The lists of rays, by their places in the stream. Those of a node's children lie behind all
    /// that are still to be visited.
    lists: Vec<u32>,
    stack: Vec<Entry>,
}

/// What is to be visited.
#[derive(Clone, Copy, Debug)]
struct Entry {
    child: Child,
    /// Its list.
    start: usize,
    length: usize,
    /// Where the lists of its children may begin.
    free: usize,
}

/// Answers a query for many rays.
pub(super) fn search<P: Primitives, Q: Query, C: Counters>(
    tree: &Bvh8,
    query: &Q,
    primitives: &P,
    rays: &[Ray],
    answers: &mut [Q::Answer],
    scratch: &mut Scratch,
    counters: &mut C,
) {
    scratch.lend(|memory: &mut Memory, scratch| {
        for (rays, answers) in rays.chunks(RAYS).zip(answers.chunks_mut(RAYS)) {
            let mut stream = Stream { tree, query, primitives, rays, answers, scratch, counters };
            if let [root] = &tree.nodes[..] {
                stream.test_all(root, &mut memory.lists);
            } else {
                dispatch(Descent { stream: &mut stream, memory });
            }
            for answer in stream.answers {
                query.finish(answer);
            }
        }
    });
}

/// A slice of rays that go together.
struct Stream<'a, P, Q: Query, C> {
    tree: &'a Bvh8,
    query: &'a Q,
    primitives: &'a P,
    rays: &'a [Ray],
    answers: &'a mut [Q::Answer],
    /// For searches within the primitives.
    scratch: &'a mut Scratch,
    counters: &'a mut C,
}

/// A stream on its way down the tree.
struct Descent<'a, 's, P, Q: Query, C> {
    stream: &'a mut Stream<'s, P, Q, C>,
    memory: &'a mut Memory,
}

impl<P: Primitives, Q: Query, C: Counters> Kernel for Descent<'_, '_, P, Q, C> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        self.stream.search_all::<S>(self.memory);
    }
}

impl<P: Primitives, Q: Query, C: Counters> Stream<'_, P, Q, C> {
    /// Prepares the rays and sorts them by octant; returns how many are in each. Where any hit will
    /// do, no order is the better one, and all go with the first octant. Rays that the slab test
    /// cannot take are searched at once, alone.
    #[inline(always)]
    fn start<S: Simd>(&mut self, memory: &mut Memory) -> [usize; 8] {
        let Memory { slabs, lists, .. } = memory;
        slabs.clear();
        if lists.len() < 8 * RAYS {
            lists.resize(8 * RAYS, 0);
        }
        let padding = self.primitives.padding();
        let mut counts = [0; 8];
        for (place, ray) in self.rays.iter().enumerate() {
            let box_ray = BoxRay::new(ray, padding);
            let slab = SlabRay::any::<S>(ray, &box_ray, padding);
            slabs.push(slab.unwrap_or(SlabRay::VACANT));
            let Some(slab) = slab else {
                self.answers[place] = self.search_alone(ray);
                continue;
            };
            self.answers[place] = self.query.start(ray);
            let octant = if Q::SEARCH == Search::First { 0 } else { slab.octant as usize % 8 };
            lists[octant * RAYS + counts[octant]] = place as u32;
            counts[octant] += 1;
        }
        counts
    }

    #[cold]
    #[inline(never)]
    fn search_alone(&mut self, ray: &Ray) -> Q::Answer {
        search_one(self.tree, self.query, self.primitives, ray, self.counters)
    }

    /// Tests the few primitives of a tree of one node with all rays, without the node's boxes: the
    /// primitives test their own anyway. Near ones come first, as the first ray sees it.
    fn test_all(&mut self, root: &Node, lists: &mut Vec<u32>) {
        for (answer, ray) in self.answers.iter_mut().zip(self.rays) {
            *answer = self.query.start(ray);
        }
        lists.clear();
        lists.extend(0..self.rays.len() as u32);
        let towards = self.rays.first().map_or(Vec3A::ZERO, |ray| ray.dir.into());
        let shift = order_shift(towards.cmplt(Vec3A::ZERO).bitmask());
        let mut open = lists.len();
        for word in root.orders().iter().rev() {
            let child = Child(root.children()[(word >> shift) as usize % WIDTH]);
            if child != Child::ABSENT {
                open = self.test(child, &mut lists[..open]);
            }
        }
    }

    /// Searches with the rays of each octant.
    #[inline(always)]
    fn search_all<S: Simd>(&mut self, memory: &mut Memory) {
        let counts = self.start::<S>(memory);
        for (octant, &count) in counts.iter().enumerate() {
            self.search::<S>(memory, octant, count);
        }
    }

    /// Searches with the rays of an octant.
    #[inline(always)]
    fn search<S: Simd>(&mut self, memory: &mut Memory, octant: usize, count: usize) {
        let Memory { slabs, lists, stack } = memory;
        let shift = order_shift(octant as u32);
        stack.clear();
        let root =
            Entry { child: Child::ROOT, start: octant * RAYS, length: count, free: 8 * RAYS };
        if count > 0 {
            stack.push(root);
        }
        while let Some(Entry { child, start, length, free }) = stack.pop() {
            if child.is_leaf() {
                self.test(child, &mut lists[start..start + length]);
                continue;
            }
            if lists.len() < free + WIDTH * length {
                lists.resize(free + WIDTH * length, 0);
            }
            let node = &self.tree.nodes[child.index()];
            if C::COUNTS {
                self.counters.boxes(node.present().count() as u32 * length as u32);
            }
            let (visited, below) = lists.split_at_mut(free);
            let list = &visited[start..start + length];
            let lengths = self.enter::<S>(node, slabs, list, &mut below[..WIDTH * length]);
            for word in node.orders() {
                let lane = (word >> shift) as usize % WIDTH;
                if lengths[lane] > 0 {
                    stack.push(Entry {
                        child: Child(node.children()[lane]),
                        start: free + lane * length,
                        length: lengths[lane],
                        free: free + WIDTH * length,
                    });
                }
            }
        }
    }

    /// Appends each ray of a list to the lists of the children that it enters; each of these has
    /// room for all. Returns their lengths.
    #[inline(always)]
    fn enter<S: Simd>(
        &self,
        node: &Node,
        slabs: &[SlabRay],
        list: &[u32],
        below: &mut [u32],
    ) -> [usize; WIDTH] {
        let mut lengths = [0; WIDTH];
        for &place in list {
            let (slab, ray) = (&slabs[place as usize], &self.rays[place as usize]);
            let end = self.query.end(ray, &self.answers[place as usize]);
            let entered = entered::<S>(node, slab, ray.t_min, end);
            for (lane, length) in lengths.iter_mut().enumerate() {
                below[lane * list.len() + *length] = place;
                *length += (entered >> lane & 1) as usize;
            }
        }
        lengths
    }

    /// Tests the primitives of a leaf with those rays of a list whose search goes on; these come to
    /// its front. Returns how many they are.
    fn test(&mut self, leaf: Child, list: &mut [u32]) -> usize {
        let mut open = 0;
        for index in 0..list.len() {
            let place = list[index];
            list[open] = place;
            let (ray, answer) = (&self.rays[place as usize], &self.answers[place as usize]);
            open += usize::from(self.query.end(ray, answer) != f32::NEG_INFINITY);
        }
        let first = (leaf.block() * self.tree.block) as u32;
        self.primitives.test_stream(
            self.query,
            first..first + leaf.count(),
            (self.rays, &list[..open]),
            self.answers,
            self.scratch,
            self.counters,
        );
        open
    }
}

/// The children that a ray enters before an end.
#[inline(always)]
fn entered<S: Simd>(node: &Node, slab: &SlabRay, t_min: f32, end: f32) -> u32 {
    let (begin, leave) = node.intervals::<S>(
        near_planes(slab.octant),
        splat3::<S::F8>(slab.inv_dir.to_array()),
        splat3::<S::F8>(slab.near.to_array()),
        splat3::<S::F8>(slab.far.to_array()),
        [S::F8::splat(t_min), S::F8::splat(end)],
    );
    begin.le(leave).bits()
}

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use glam::Vec3;

    use super::super::{Height, STREAM_LEVELS};
    use super::*;
    use crate::accel::refit::Memory as Followed;
    use crate::accel::{Accel, AnyHit, Bounded, ClosestHit, NoPacks};
    use crate::counters::NoCounters;
    use crate::math::{Aabb, Hit, Padding};

    /// Squares across the z axis: number `i` at `z = i`.
    struct Squares(u32);

    impl Bounded for Squares {
        fn count(&self) -> u32 {
            self.0
        }

        fn bounds(&self, index: u32) -> Aabb {
            let z = index as f32;
            Aabb { min: Vec3A::new(0.0, 0.0, z), max: Vec3A::new(1.0, 1.0, z) }
        }

        fn mean_point(&self) -> Vec3A {
            Vec3A::ZERO
        }
    }

    impl Primitives for Squares {
        type Packs = NoPacks;

        fn packs(&self) -> &NoPacks {
            &NoPacks
        }

        fn padding(&self) -> Padding {
            Padding { largest: self.0 as f32, factor: 1.0 }
        }

        fn reorder(&mut self, _: &[u32]) {}

        fn test<Q: Query, C: Counters>(
            &self,
            query: &Q,
            slots: Range<u32>,
            ray: &Ray,
            _: &BoxRay,
            answer: &mut Q::Answer,
            _: &mut C,
        ) {
            for prim in slots {
                let t = (prim as f32 - ray.origin.z) / ray.dir.z;
                if ray.t_min <= t && t <= query.end(ray, answer) {
                    query.record(answer, &Hit { t, object: 0, prim, u: 0.0, v: 0.0 });
                }
            }
        }
    }

    /// Searches a chain of nodes, each with a square and the next node: what no builder makes, but a file may hold.
    /// Returns the bytes of the lists.
    fn search_chain(levels: usize) -> usize {
        let squares = Squares(levels as u32);
        let all = squares.total_bounds();
        let mut nodes = vec![Node::EMPTY; levels];
        for (i, node) in nodes.iter_mut().enumerate() {
            node.set(0, Child::leaf(i, 1), &all);
            if i + 1 < levels {
                node.set(1, Child::node(i + 1), &all);
            }
            node.sort();
        }
        let height = Height::of(&nodes);
        assert_eq!(height, Height { need: levels, levels });
        let tree = Bvh8 { nodes, block: 1, height, memory: Followed::default() };
        let rays = [Ray::new(Vec3::new(0.5, 0.5, levels as f32), Vec3::NEG_Z); RAYS];
        let (mut hits, mut blocked) = ([Hit::MISS; RAYS], [false; RAYS]);
        let (mut scratch, counters) = (Scratch::default(), &mut NoCounters);
        tree.search(&ClosestHit, &squares, &rays, &mut hits, &mut scratch, counters);
        tree.search(&AnyHit, &squares, &rays, &mut blocked, &mut scratch, counters);
        assert!(hits.iter().all(|hit| hit.prim == levels as u32 - 1));
        assert!(blocked.iter().all(|&blocked| blocked));
        scratch.lend(|memory: &mut Memory, _| size_of_val(&memory.lists[..]))
    }

    #[test]
    fn streams_take_a_limited_memory() {
        let most = search_chain(STREAM_LEVELS);
        assert!(most > 0 && most <= 17 << 20, "{most} bytes");
        assert_eq!(search_chain(STREAM_LEVELS + 1), 0, "rays are walked one by one");
    }
}
