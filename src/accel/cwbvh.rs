//! obvhs's compressed eight-wide tree, walked by this project's own slab test.
//!
//! obvhs's own traversal starts every box at t = 10⁻⁴, prunes without padding and holds 32 stack
//! entries; the walk below tests the decoded boxes by the common slab formula, with the padding
//! doubled for what the grid's arithmetic rounds, on a stack that grows with the tree.
//!
//! * *Idea*: A ray waits for memory, so nodes are made small: the boxes of eight children are stored as bytes on a grid
//!   over the node's box.
//! * *Paper*: Ylitie, Karras, Laine: *Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs*, 2017.
//! * *Build*: that of the binary tree (`builder=`), and O(n) for the collapse.
//! * *A ray*: O(log n) nodes in the mean, up to eight boxes each, which are decoded as they are read.
//! * *Memory*: 80 bytes a node of up to eight children, a third of what `bvh` takes; leaves hold up to three.
//! * *It wins*: in memory, where the caches are what a ray waits for; it was made for GPUs. In the caches, what
//!   decoding costs is about what the narrower tree costs.
//! * *Picture*: `docs/gallery/cells-cwbvh.png`.

mod save;

use std::ops::{ControlFlow, Range};

use glam::{IVec4, Vec3A, Vec4};
use obvhs::cwbvh::bvh2_to_cwbvh::bvh2_to_cwbvh;
use obvhs::cwbvh::node::CwBvhNode;
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::slab::crossing;
use crate::math::{Aabb, BoxRay, Ray, ones};

use super::builder::{Builder, TreeChoice, cuts};
use super::{Accel, Bounded, Build, Built, OptionInfo, Order, Tree};

const WIDTH: usize = 8;

/// Seven of eight children wait at each level: enough for eight levels before the heap is used.
const USUAL_STACK: usize = 64;

/// A tree of eight-wide nodes of 80 bytes.
#[derive(Clone, Debug)]
pub struct CompressedWideBvh {
    nodes: Vec<CwBvhNode>,
}

/// The most primitives in a leaf that a node can refer to.
const MOST: u32 = 3;

const BUILDER: OptionInfo = Builder::option("ploc");
const LEAF: OptionInfo = OptionInfo::leaf(MOST, "3; in the fastest build 1");

impl Accel for CompressedWideBvh {
    const ONE_BY_ONE: bool = true;

    /// As measured over a terrain and a sphere of two million triangles.
    const BUILD_BYTES: u64 = 230;

    const OPTIONS: &'static [OptionInfo] = &[BUILDER, Builder::REINSERTION, LEAF];

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        if primitives.count() == 0 {
            return Built { accel: Self { nodes: Vec::new() }, order: None };
        }
        let Build { config, grain, stages } = build;
        let usual_leaf = config.quality.parameters().max_prims_per_leaf.min(config.max_leaf);
        let most = config.options.number(&LEAF).unwrap_or(usual_leaf).clamp(1, MOST);
        let choice = TreeChoice::of(config, cuts(*grain), &BUILDER, Builder::Ploc);
        // Leaves begin anywhere, so that packs make none of them cheaper.
        let binary = choice.tree(primitives, 1, 1, stages);
        let tree = stages.time("collapse", || bvh2_to_cwbvh(&binary, most, true, false));
        let mut nodes = tree.nodes;
        nodes.shrink_to_fit();
        let references = binary.primitive_indices.len();
        let order = Order::of(tree.primitive_indices, references, primitives.count());
        Built { accel: Self { nodes }, order: Some(order) }
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
        let grid_ray = GridRay::new(box_ray);
        let mut end = ray.end();
        let mut stack = SmallVec::<[(u32, f32); USUAL_STACK]>::new();
        stack.push((0, ray.t_min));
        while let Some((index, near)) = stack.pop() {
            if near > end {
                continue;
            }
            let node = &self.nodes[index as usize];
            let children = grid_ray.children(node, ray.t_min, end);
            counters.boxes(children.tested);
            // Leaves first: they can only shorten the search. The comparison with `end` is made
            // again for each, since the ones before may have.
            for child in ones(u32::from(children.hit & !node.imask)) {
                if children.near[child] <= end {
                    let (first, count) = node.child_primitives(child);
                    match leaf(first..first + count, counters) {
                        ControlFlow::Continue(t) => end = t,
                        ControlFlow::Break(()) => return,
                    }
                }
            }
            // A child's position in the node is the octant it lies in; the smallest difference
            // from where the ray goes to is the farthest child, and is pushed first.
            let inner = children.hit & node.imask;
            for place in 0..WIDTH {
                let child = place ^ grid_ray.far_octant;
                if inner >> child & 1 != 0 {
                    stack.push((node.child_node_index(child), children.near[child]));
                }
            }
        }
    }

    fn bytes(&self) -> u64 {
        (size_of::<Self>() + self.nodes.capacity() * size_of::<CwBvhNode>()) as u64
    }

    fn tree(&self) -> Option<Tree> {
        let root = Child::Node(0, own_box(&self.nodes.first()?.aabb()));
        Some(Tree::of(root, |at, children| match at {
            Child::Leaf(slots, bounds) => (*bounds, slots.clone()),
            Child::Node(index, bounds) => {
                let node: &CwBvhNode = &self.nodes[*index as usize];
                for child in (0..WIDTH).filter(|&child| !node.is_child_empty(child)) {
                    let bounds = own_box(&node.child_aabb(child));
                    let (first, count) = node.child_primitives(child);
                    children.push(if node.is_leaf(child) {
                        Child::Leaf(first..first + count, bounds)
                    } else {
                        Child::Node(node.child_node_index(child), bounds)
                    });
                }
                (*bounds, 0..0)
            }
        }))
    }
}

/// A child and its box as the node above it stores it.
enum Child {
    Leaf(Range<u32>, Aabb),
    Node(u32, Aabb),
}

/// One of obvhs's boxes as one of this project's.
fn own_box(bounds: &obvhs::aabb::Aabb) -> Aabb {
    Aabb { min: bounds.min, max: bounds.max }
}

/// What a node's children are to a ray.
struct Children {
    near: [f32; WIDTH],
    hit: u8,
    tested: u32,
}

/// A ray as the grid boxes of a node see it.
struct GridRay {
    inv_dir: Vec3A,
    /// What the planes at which the ray enters, and leaves, are measured from.
    near_origin: Vec3A,
    far_origin: Vec3A,
    negative: [bool; 3],
    /// The octant whose child is the last that the ray reaches.
    far_octant: usize,
}

impl GridRay {
    fn new(box_ray: &BoxRay) -> Self {
        let wide = box_ray.widened(1.0);
        let negative = wide.inv_dir.to_array().map(f32::is_sign_negative);
        let pick = |plus: Vec3A, minus: Vec3A| {
            let axis = |i: usize| if negative[i] { minus[i] } else { plus[i] };
            Vec3A::new(axis(0), axis(1), axis(2))
        };
        let [x, y, z] = negative.map(usize::from);
        Self {
            inv_dir: wide.inv_dir,
            near_origin: pick(wide.origin_plus, wide.origin_minus),
            far_origin: pick(wide.origin_minus, wide.origin_plus),
            negative,
            far_octant: 7 - (x << 2 | y << 1 | z),
        }
    }

    /// Tests the eight children of a node, four at a time.
    #[inline]
    fn children(&self, node: &CwBvhNode, t_min: f32, end: f32) -> Children {
        let axes = [
            (&node.child_min_x, &node.child_max_x),
            (&node.child_min_y, &node.child_max_y),
            (&node.child_min_z, &node.child_max_z),
        ];
        let corner = node.p.to_array();
        let cell = node.compute_extent().to_array();
        let mut children = Children { near: [0.0; WIDTH], hit: 0, tested: 0 };
        for half in 0..2 {
            let (mut near, mut far) = (Vec4::splat(t_min), Vec4::splat(end));
            for axis in 0..3 {
                let (min, max) = axes[axis];
                let (enter, leave) = if self.negative[axis] { (max, min) } else { (min, max) };
                let plane = |bytes: &[u8; WIDTH], origin: f32| {
                    let position = four_floats(bytes, half) * cell[axis] + corner[axis];
                    let inv_dir = Vec4::splat(self.inv_dir[axis]);
                    crossing(position, Vec4::splat(origin), inv_dir)
                };
                near = near.max(plane(enter, self.near_origin[axis]));
                far = far.min(plane(leave, self.far_origin[axis]));
            }
            let entered = near.cmple(far).bitmask() as u8;
            children.hit |= entered << (4 * half);
            near.write_to_slice(&mut children.near[4 * half..]);
        }
        let present = present(node);
        children.hit &= present;
        children.tested = present.count_ones();
        children
    }
}

/// Four of eight bytes as floats.
#[inline(always)]
fn four_floats(bytes: &[u8; WIDTH], half: usize) -> Vec4 {
    let four = [0, 1, 2, 3].map(|i| i32::from(bytes[4 * half + i]));
    IVec4::from_array(four).as_vec4()
}

/// Which children there are: those whose byte of meta data is not zero.
#[inline(always)]
fn present(node: &CwBvhNode) -> u8 {
    // The top bit of each byte that has any bit set: 0x7F is added without a carry out.
    const LOW: u64 = 0x7F7F_7F7F_7F7F_7F7F;
    let meta = u64::from_le_bytes(node.child_meta);
    let tops = (((meta & LOW) + LOW) | meta) & !LOW;
    // Gathers the eight top bits into the highest byte.
    ((tops >> 7).wrapping_mul(0x0102_0408_1020_4080) >> 56) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn children_are_present_where_their_meta_data_is_not_zero() {
        for mask in 0..=255u8 {
            let meta =
                std::array::from_fn(|i| if mask >> i & 1 == 1 { 0x20 << (i % 3) } else { 0 });
            let node = CwBvhNode { child_meta: meta, ..CwBvhNode::default() };
            assert_eq!(present(&node), mask);
        }
    }
}
