//! Nodes of eight children.

use glam::Vec3A;

use crate::math::Aabb;
use crate::simd::{Row, Simd};

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// Eight boxes and what they hold: four cache lines.
///
/// Absent children have empty boxes (low planes at +∞, high ones at −∞), which no ray enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// Low planes along x, high planes along x, then y and z, as bits of floats: a ray picks its
    /// near and far planes by a row's number. Then children and orders. Eight rows, so that a number
    /// of three bits is always in range.
    rows: [[u32; WIDTH]; 8],
}

/// The row of the children: see [`Child`].
const CHILDREN: usize = 6;

/// The row of the orders. For each octant of directions there are three bits in every word: which
/// child comes in this place, the farthest first.
const ORDER: usize = 7;

/// The rows of planes that are the near ones for rays of an octant: a bit of it is set for each axis
/// along which they run backwards. The far rows are the same numbers with the lowest bit changed.
#[inline(always)]
pub(super) fn near_rows(octant: u32) -> [u32; 3] {
    [octant & 1, 2 + (octant >> 1 & 1), 4 + (octant >> 2 & 1)]
}

/// Where an octant's order stands in the words of [`Node::orders`].
#[inline(always)]
pub(super) fn order_shift(octant: u32) -> u32 {
    3 * octant
}

/// A child in a word, as it stands on stacks: the index of a node, or a leaf's range of slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(pub(super) u32);

const LEAF_BIT: u32 = 1 << 31;
const COUNT_SHIFT: u32 = 28;
const BLOCK_MASK: u32 = (1 << COUNT_SHIFT) - 1;

impl Child {
    /// No child; also what lies at the bottom of a stack. It passes for a leaf.
    pub(super) const ABSENT: Self = Self(u32::MAX);

    /// The largest number of blocks of slots, and of nodes.
    pub(super) const LIMIT: usize = BLOCK_MASK as usize;

    /// A node.
    pub(super) fn node(index: usize) -> Self {
        debug_assert!(index < Self::LIMIT);
        Self(index as u32)
    }

    /// A leaf of 1 to 8 primitives that begin with a block.
    pub(super) fn leaf(block: usize, count: usize) -> Self {
        debug_assert!((1..=WIDTH).contains(&count) && block < Self::LIMIT);
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
        let low = [f32::INFINITY.to_bits(); WIDTH];
        let high = [f32::NEG_INFINITY.to_bits(); WIDTH];
        Self { rows: [low, high, low, high, low, high, [Child::ABSENT.0; WIDTH], [0; WIDTH]] }
    };

    /// A row of planes.
    #[inline(always)]
    pub(super) fn planes<S: Simd>(&self, row: usize) -> S::F8 {
        S::F8::load_bits(&self.rows[row % 8])
    }

    /// One child's plane.
    #[inline(always)]
    pub(super) fn plane(&self, row: usize, lane: usize) -> f32 {
        f32::from_bits(self.rows[row % 8][lane % WIDTH])
    }

    /// The children's words.
    #[inline(always)]
    pub(super) fn children(&self) -> &[u32; WIDTH] {
        &self.rows[CHILDREN]
    }

    /// The orders of the octants.
    #[inline(always)]
    pub(super) fn orders(&self) -> &[u32; WIDTH] {
        &self.rows[ORDER]
    }

    /// Puts a child into a lane.
    pub(super) fn set(&mut self, lane: usize, child: Child, bounds: &Aabb) {
        for axis in 0..3 {
            self.rows[2 * axis][lane] = bounds.min[axis].to_bits();
            self.rows[2 * axis + 1][lane] = bounds.max[axis].to_bits();
        }
        self.rows[CHILDREN][lane] = child.0;
    }

    /// The node with all that its children refer to so many nodes, and blocks of slots, later.
    pub(super) fn moved(mut self, nodes: usize, blocks: usize) -> Self {
        for word in &mut self.rows[CHILDREN] {
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
        let corner = |high: usize| {
            Vec3A::from_array(std::array::from_fn(|axis| self.plane(2 * axis + high, lane)))
        };
        Aabb { min: corner(0), max: corner(1) }
    }

    /// The box around all children.
    pub(super) fn bounds(&self) -> Aabb {
        self.present().map(|(lane, _)| self.child_bounds(lane)).fold(Aabb::EMPTY, Aabb::union)
    }

    /// Notes the order in which each octant's rays meet the children: by the children's centres
    /// along the octant's diagonal.
    pub(super) fn sort(&mut self) {
        let mut centers = [Vec3A::ZERO; WIDTH];
        let mut count = 0;
        for (lane, _) in self.present() {
            centers[lane] = self.child_bounds(lane).center();
            count = lane + 1;
        }
        self.rows[ORDER] = [0; WIDTH];
        for octant in 0..8 {
            let diagonal = Vec3A::from_array(std::array::from_fn(|axis| {
                if octant >> axis & 1 == 0 { 1.0 } else { -1.0 }
            }));
            let along = centers.map(|center| center.dot(diagonal));
            let mut lanes: [usize; WIDTH] = std::array::from_fn(|lane| lane);
            lanes[..count].sort_by(|&a, &b| along[b].total_cmp(&along[a]));
            for (word, lane) in self.rows[ORDER].iter_mut().zip(lanes) {
                *word |= (lane as u32) << order_shift(octant);
            }
        }
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
