//! Nodes of eight children.

use glam::Vec3A;

use crate::math::{Aabb, Lanes as _, Lanes3};
use crate::simd::{Kernel, Row, Simd, dispatch};

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// Eight boxes and what they hold: four cache lines.
///
/// Absent children have empty boxes (low planes at +∞, high ones at −∞), which no ray enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// Rows of eight words: low planes along x, high planes along x, then y and z, as bits of
    /// floats; then children and orders. A ray picks its near and far planes by where a row begins.
    words: [u32; ROWS * WIDTH],
}

/// Rows of a node: a power of two, so that every number cut to its bits begins a row.
const ROWS: usize = 8;

/// The first word of the children: see [`Child`].
const CHILDREN: usize = 6 * WIDTH;

/// The first word of the orders. For each octant of directions there are three bits in every word: which
/// child comes in this place, the farthest first.
pub(super) const ORDERS: usize = 7 * WIDTH;

/// Octants of directions.
const OCTANTS: usize = 8;

/// The bit in which the places of near and far planes differ.
pub(super) const FAR: u32 = WIDTH as u32;

/// The places of the planes that are the near ones for rays of an octant: a bit of it is set for each
/// axis along which they run backwards. The far ones are at the same places with [`FAR`] flipped.
#[inline(always)]
pub(super) fn near_planes(octant: u32) -> [u32; 3] {
    let place = |axis: u32| (2 * axis + (octant >> axis & 1)) * WIDTH as u32;
    [place(0), place(1), place(2)]
}

/// The first bit of an octant's order in the words of [`Node::orders`].
#[inline(always)]
pub(super) fn order_shift(octant: u32) -> u32 {
    3 * octant
}

/// A child in a word, as it is kept on stacks: the index of a node, or a leaf's range of slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(pub(super) u32);

const LEAF_BIT: u32 = 1 << 31;
const COUNT_SHIFT: u32 = 28;
const BLOCK_MASK: u32 = (1 << COUNT_SHIFT) - 1;

impl Child {
    /// The first node.
    pub(super) const ROOT: Self = Self(0);

    /// No child; also the bottom of a stack. [`is_leaf`](Self::is_leaf) holds for it.
    pub(super) const ABSENT: Self = Self(u32::MAX);

    /// The largest number of blocks of slots, and of nodes.
    pub(super) const LIMIT: usize = BLOCK_MASK as usize;

    /// A node.
    pub(super) fn node(index: usize) -> Self {
        assert!(index < Self::LIMIT, "a node out of range");
        Self(index as u32)
    }

    /// A leaf of 1 to 8 primitives that begin with a block.
    pub(super) fn leaf(block: usize, count: usize) -> Self {
        assert!((1..=WIDTH).contains(&count) && block < Self::LIMIT, "a leaf out of range");
        Self(LEAF_BIT | (count as u32 - 1) << COUNT_SHIFT | block as u32)
    }

    /// Whether it is a leaf, or absent.
    #[inline(always)]
    pub(super) fn is_leaf(self) -> bool {
        self.0 >= LEAF_BIT
    }

    /// The node's index.
    #[inline(always)]
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }

    /// The leaf's block.
    #[inline(always)]
    pub(super) fn block(self) -> usize {
        (self.0 & BLOCK_MASK) as usize
    }

    /// The leaf's number of primitives.
    #[inline(always)]
    pub(super) fn count(self) -> u32 {
        (self.0 >> COUNT_SHIFT & 7) + 1
    }
}

impl Node {
    /// A node without children.
    pub(super) const EMPTY: Self = {
        let mut words = [0; ROWS * WIDTH];
        let mut i = 0;
        while i < ORDERS {
            words[i] = match i / WIDTH {
                0 | 2 | 4 => f32::INFINITY.to_bits(),
                1 | 3 | 5 => f32::NEG_INFINITY.to_bits(),
                _ => Child::ABSENT.0,
            };
            i += 1;
        }
        Self { words }
    };

    /// The planes and children, row by row: all that the rest follows from.
    pub(super) fn stored_words(&self) -> [u32; ORDERS] {
        std::array::from_fn(|place| self.words[place])
    }

    /// The node of these words, which may be any. Lanes without a child are empty, whatever their
    /// planes are.
    pub(super) fn of_words(words: [u32; ORDERS]) -> Self {
        let mut node = Self::EMPTY;
        for lane in 0..WIDTH {
            if words[CHILDREN + lane] != Child::ABSENT.0 {
                (0..ROWS - 1).for_each(|row| {
                    node.words[row * WIDTH + lane] = words[row * WIDTH + lane];
                });
            }
        }
        node.sort();
        node
    }

    /// The row that begins at a place.
    #[inline(always)]
    fn row(&self, place: usize) -> &[u32; WIDTH] {
        let behind = &self.words[place & ((ROWS - 1) * WIDTH)..];
        behind.first_chunk().expect("rows are whole")
    }

    /// The planes at a place: see [`near_planes`].
    #[inline(always)]
    pub(super) fn planes<S: Simd>(&self, place: u32) -> S::F8 {
        S::F8::load_bits(self.row(place as usize))
    }

    /// Where a ray enters and leaves the children's boxes within its own interval, by the terms of
    /// [`SlabRay`](super::slab_ray::SlabRay).
    #[inline(always)]
    pub(super) fn intervals<S: Simd>(
        &self,
        [x, y, z]: [u32; 3],
        inv_dir: Lanes3<S::F8>,
        near: Lanes3<S::F8>,
        far: Lanes3<S::F8>,
        [t_min, t_max]: [S::F8; 2],
    ) -> (S::F8, S::F8) {
        let begin = S::F8::slab(self.planes::<S>(x), inv_dir[0], near[0])
            .max(S::F8::slab(self.planes::<S>(y), inv_dir[1], near[1]))
            .max(S::F8::slab(self.planes::<S>(z), inv_dir[2], near[2]).max(t_min));
        let end = S::F8::slab(self.planes::<S>(x ^ FAR), inv_dir[0], far[0])
            .min(S::F8::slab(self.planes::<S>(y ^ FAR), inv_dir[1], far[1]))
            .min(S::F8::slab(self.planes::<S>(z ^ FAR), inv_dir[2], far[2]).min(t_max));
        (begin, end)
    }

    /// One child's plane of those at a place.
    #[inline(always)]
    pub(super) fn plane(&self, place: u32, lane: usize) -> f32 {
        f32::from_bits(self.row(place as usize)[lane % WIDTH])
    }

    /// The smallest and the largest corner of a child's box.
    #[inline(always)]
    pub(super) fn corners(&self, lane: usize) -> [[f32; 3]; 2] {
        let [x, y, z] = near_planes(0);
        let plane = |place| self.plane(place, lane);
        [[plane(x), plane(y), plane(z)], [plane(x ^ FAR), plane(y ^ FAR), plane(z ^ FAR)]]
    }

    /// The children's words.
    #[inline(always)]
    pub(super) fn children(&self) -> &[u32; WIDTH] {
        self.row(CHILDREN)
    }

    /// The orders of the octants.
    #[inline(always)]
    pub(super) fn orders(&self) -> &[u32; WIDTH] {
        self.row(ORDERS)
    }

    /// Puts a child into a lane.
    pub(super) fn set(&mut self, lane: usize, child: Child, bounds: &Aabb) {
        for axis in 0..3 {
            self.words[2 * axis * WIDTH + lane] = bounds.min[axis].to_bits();
            self.words[(2 * axis + 1) * WIDTH + lane] = bounds.max[axis].to_bits();
        }
        self.words[CHILDREN + lane] = child.0;
    }

    /// The node with all that its children refer to so many nodes, and blocks of slots, later.
    pub(super) fn moved(mut self, nodes: usize, blocks: usize) -> Self {
        for word in &mut self.words[CHILDREN..ORDERS] {
            let child = Child(*word);
            if child != Child::ABSENT {
                *word = match child.is_leaf() {
                    true => Child::leaf(child.block() + blocks, child.count() as usize).0,
                    false => Child::node(child.index() + nodes).0,
                };
            }
        }
        self
    }

    /// The children that are there, with their lanes.
    pub(super) fn present(&self) -> impl Iterator<Item = (usize, Child)> {
        let children = self.children().iter().copied().map(Child).enumerate();
        children.filter(|&(_, child)| child != Child::ABSENT)
    }

    /// A child's box.
    pub(super) fn child_bounds(&self, lane: usize) -> Aabb {
        let [min, max] = self.corners(lane).map(Vec3A::from_array);
        Aabb { min, max }
    }

    /// The box around all children.
    pub(super) fn bounds(&self) -> Aabb {
        self.present().map(|(lane, _)| self.child_bounds(lane)).fold(Aabb::EMPTY, Aabb::union)
    }

    /// Notes the order in which each octant's rays meet the children: by the children's centres
    /// along the octant's diagonal.
    pub(super) fn sort(&mut self) {
        dispatch(Sort(self));
    }

    /// The same within a kernel.
    #[inline(always)]
    pub(super) fn sort_with<S: Simd>(&mut self) {
        // Rows of octants. What is absent comes last.
        let mut along = [S::F8::splat(f32::NEG_INFINITY); WIDTH];
        let signs = [
            S::F8::load(&[1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0]),
            S::F8::load(&[1.0, 1.0, -1.0, -1.0, 1.0, 1.0, -1.0, -1.0]),
            S::F8::load(&[1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0]),
        ];
        let zero = S::F8::splat(0.0);
        for (lane, along) in along.iter_mut().enumerate() {
            if self.children()[lane] != Child::ABSENT.0 {
                let center = self.child_bounds(lane).center();
                let sum = S::F8::splat(center.x) * signs[0]
                    + S::F8::splat(center.y) * signs[1]
                    + S::F8::splat(center.z) * signs[2];
                // What is no number, of a box that is not finite, would have no place.
                *along = sum.select_where(sum.le(sum), zero);
            }
        }
        // A child's place is the number of those that come before it: the farther ones, and of those
        // that are equally far the earlier lanes. Added to 2²³, a small number stands in the lowest bits.
        let one = S::F8::splat(1.0);
        let mut places = [S::F8::splat(8_388_608.0); WIDTH];
        for late in 1..WIDTH {
            for early in 0..late {
                let farther = along[early].lt(along[late]);
                places[early] = places[early] + one.select_where(farther, zero);
                places[late] = places[late] + zero.select_where(farther, one);
            }
        }
        let mut orders = [0; WIDTH];
        for (lane, row) in places.iter().enumerate() {
            let mut places = [0.0; OCTANTS];
            row.store(&mut places);
            for (octant, place) in places.iter().enumerate() {
                orders[place.to_bits() as usize % WIDTH] |=
                    (lane as u32) << order_shift(octant as u32);
            }
        }
        self.words[ORDERS..].copy_from_slice(&orders);
    }
}

/// Sorts a node that is sorted alone.
struct Sort<'a>(&'a mut Node);

impl Kernel for Sort<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        self.0.sort_with::<S>();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_is_four_cache_lines() {
        assert_eq!(size_of::<Node>(), 256);
    }

    #[test]
    fn a_child_keeps_what_it_is() {
        let leaf = Child::leaf(123_456, 8);
        assert!(leaf.is_leaf());
        assert_eq!((leaf.block(), leaf.count()), (123_456, 8));
        let node = Child::node(99);
        assert!(!node.is_leaf());
        assert_eq!(node.index(), 99);
        assert!(Child::ABSENT.is_leaf());
        assert_ne!(Child::leaf(Child::LIMIT - 1, 8), Child::ABSENT);
    }

    #[test]
    fn each_octant_has_its_farthest_child_first() {
        let mut node = Node::EMPTY;
        for (lane, x) in [3.0, 1.0, 2.0].into_iter().enumerate() {
            let at = Vec3A::new(x, 0.0, 0.0);
            node.set(lane, Child::node(lane), &Aabb { min: at, max: at });
        }
        node.sort();
        let places = |octant: u32| node.orders().map(|word| word >> order_shift(octant) & 7);
        assert_eq!(places(0)[..3], [0, 2, 1], "along +x");
        assert_eq!(places(1)[..3], [1, 2, 0], "along -x");
    }
}
