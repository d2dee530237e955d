//! A binary tree built from the top by the surface area heuristic, a primitive in each leaf.
//!
//! A node's primitives are sorted into bins by their centres, along each axis, and are split
//! between the two bins where the expected cost is the least. Primitives that are tested together
//! are counted in whole packs, which fills the leaves. After Wald: *On fast Construction of
//! SAH-based Bounding Volume Hierarchies*, 2007.
//!
//! A subtree of n primitives has 2n − 1 nodes. So the places of both halves are known before they are
//! built, and are built in parallel; which thread does it changes nothing.

use glam::Vec4;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use rayon::prelude::*;

/// The most bins along an axis. Small nodes have fewer, since their cost lies in emptying them.
const BINS: usize = 32;

/// From this depth on primitives are halved by number: no tree is deeper than this and 32 more.
const USUAL_DEPTH: u32 = 96;

/// Parts of at least so many primitives are built in parallel; chunks of that size are binned in
/// parallel.
const PARALLEL: usize = 1 << 13;

/// Builds a tree over at least one box, for leaves in which so many primitives, a power of two, cost
/// as much as one.
pub(super) fn build(boxes: &[Aabb], pack: u32) -> Bvh2 {
    let mut references: Vec<_> =
        boxes.par_iter().enumerate().map(|(index, bounds)| Reference::new(index, bounds)).collect();
    let (bounds, centers) = references
        .par_iter()
        .map(|reference| (reference.bounds(), Region::at(reference.center())))
        .reduce(|| (Region::EMPTY, Region::EMPTY), |a, b| (a.0.union(b.0), a.1.union(b.1)));
    let mut nodes = vec![Bvh2Node::default(); 2 * boxes.len() - 1];
    let (root, below) = nodes.split_first_mut().expect("there is a root");
    let part =
        Part { references: &mut references, first: 0, bounds, centers, pack_bits: pack.ilog2() };
    *root = grow(part, below, 1, 0);
    let primitive_indices = references.par_iter().map(|reference| reference.index()).collect();
    Bvh2 { nodes, primitive_indices, ..Bvh2::default() }
}

/// A primitive's box. Half of the bits of its index stand in the last lane of either corner, as
/// whole numbers.
#[derive(Clone, Copy)]
struct Reference {
    low: Vec4,
    high: Vec4,
}

impl Reference {
    fn new(index: usize, bounds: &Aabb) -> Self {
        Self {
            low: bounds.min.extend((index & 0xffff) as f32),
            high: bounds.max.extend((index >> 16) as f32),
        }
    }

    fn index(&self) -> u32 {
        self.low.w as u32 | (self.high.w as u32) << 16
    }

    fn bounds(&self) -> Region {
        Region { low: self.low, high: self.high }
    }

    /// Twice the centre of the box.
    #[inline(always)]
    fn center(&self) -> Vec4 {
        self.low + self.high
    }
}

/// A box. Its last lane means nothing.
#[derive(Clone, Copy)]
struct Region {
    low: Vec4,
    high: Vec4,
}

impl Region {
    const EMPTY: Self =
        Self { low: Vec4::splat(f32::INFINITY), high: Vec4::splat(f32::NEG_INFINITY) };

    fn at(point: Vec4) -> Self {
        Self { low: point, high: point }
    }

    #[inline(always)]
    fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Half of the surface; of an empty box, nothing sensible.
    #[inline(always)]
    fn half_area(&self) -> f32 {
        let size = self.high - self.low;
        size.x * size.y + size.y * size.z + size.z * size.x
    }

    fn aabb(&self) -> Aabb {
        Aabb { min: self.low.truncate().into(), max: self.high.truncate().into() }
    }
}

/// Primitives that a node is built over.
struct Part<'a> {
    references: &'a mut [Reference],
    /// The place of the first of them in the tree's order.
    first: u32,
    bounds: Region,
    /// The box around twice their centres.
    centers: Region,
    /// The logarithm of how many are tested at once.
    pack_bits: u32,
}

/// Builds a node, and those below it into `below`, whose first is node `base` of the tree.
fn grow(part: Part<'_>, below: &mut [Bvh2Node], base: u32, depth: u32) -> Bvh2Node {
    let (bounds, first) = (part.bounds, part.first);
    if part.references.len() == 1 {
        return Bvh2Node::new(bounds.aabb(), 1, first);
    }
    let parallel = part.references.len() >= PARALLEL;
    let [left, right] = part.split(depth);
    let (pair, below) = below.split_at_mut(2);
    let (below_left, below_right) = below.split_at_mut(2 * left.references.len() - 2);
    let (base_left, base_right) = (base + 2, base + 2 + below_left.len() as u32);
    let grow_left = || grow(left, below_left, base_left, depth + 1);
    let grow_right = || grow(right, below_right, base_right, depth + 1);
    let (left, right) =
        if parallel { rayon::join(grow_left, grow_right) } else { (grow_left(), grow_right()) };
    pair.copy_from_slice(&[left, right]);
    Bvh2Node::new(bounds.aabb(), 0, base)
}

impl<'a> Part<'a> {
    /// Splits at least two primitives. Not inlined: its bins would stand in every frame of the
    /// recursion.
    #[inline(never)]
    fn split(self, depth: u32) -> [Self; 2] {
        let count = self.references.len();
        if count == 2 || depth >= USUAL_DEPTH {
            return self.at(count / 2);
        }
        let grid = Grid::new(&self.centers, count);
        let Some(Split { axis, last }) =
            Bins::of(self.references, &grid).split(&grid, self.pack_bits)
        else {
            return self.at(count / 2);
        };
        // Those of the bins up to `last` go to the front.
        let (mut left, mut right) = ([Region::EMPTY; 2], [Region::EMPTY; 2]);
        let (mut front, mut back) = (0, count);
        while front < back {
            let reference = self.references[front];
            let center = reference.center();
            let goes_left = grid.places(center)[axis] <= last;
            let side = if goes_left { &mut left } else { &mut right };
            *side = [side[0].union(reference.bounds()), side[1].union(Region::at(center))];
            if goes_left {
                front += 1;
            } else {
                back -= 1;
                self.references.swap(front, back);
            }
        }
        self.halves(front, left, right)
    }

    /// Parts them by number.
    fn at(self, count: usize) -> [Self; 2] {
        let around = |references: &[Reference]| {
            references.iter().fold([Region::EMPTY; 2], |[bounds, centers], reference| {
                let center = Region::at(reference.center());
                [bounds.union(reference.bounds()), centers.union(center)]
            })
        };
        let (left, right) = self.references.split_at(count);
        let (left, right) = (around(left), around(right));
        self.halves(count, left, right)
    }

    fn halves(self, count: usize, left: [Region; 2], right: [Region; 2]) -> [Self; 2] {
        let (front, back) = self.references.split_at_mut(count);
        let part = |references, first, [bounds, centers]: [Region; 2]| Part {
            references,
            first,
            bounds,
            centers,
            pack_bits: self.pack_bits,
        };
        [part(front, self.first, left), part(back, self.first + count as u32, right)]
    }
}

/// Where along the axes the bins of a node lie.
struct Grid {
    origin: Vec4,
    /// Bins per length; 0 along an axis on which all centres are one.
    scale: Vec4,
    bins: usize,
}

impl Grid {
    fn new(centers: &Region, count: usize) -> Self {
        let bins = BINS.min(8 + count / 16);
        let size = centers.high - centers.low;
        let scale = Vec4::splat((bins - 1) as f32) / size;
        // Sizes too small to divide by pass for none.
        let scale = Vec4::select(scale.cmplt(Vec4::splat(f32::INFINITY)), scale, Vec4::ZERO);
        Self { origin: centers.low, scale, bins }
    }

    /// The bin of a centre along each axis: the nearest whole number.
    #[inline(always)]
    fn places(&self, center: Vec4) -> [usize; 3] {
        // Added to 2²³, a small number is rounded to whole ones and stands in the lowest bits.
        let [x, y, z, _] =
            ((center - self.origin) * self.scale + Vec4::splat(8_388_608.0)).to_array();
        [x, y, z].map(|number| (number.to_bits() as usize % BINS).min(self.bins - 1))
    }
}

/// The primitives whose centres lie in a bin.
#[derive(Clone, Copy)]
struct Bin {
    bounds: Region,
    count: u32,
}

impl Bin {
    const EMPTY: Self = Self { bounds: Region::EMPTY, count: 0 };

    fn and(self, other: &Self) -> Self {
        Self { bounds: self.bounds.union(other.bounds), count: self.count + other.count }
    }

    /// The expected cost of testing its primitives, if it is a node: 0 if there are none.
    fn cost(&self, pack_bits: u32) -> f32 {
        let tests = (self.count + (1 << pack_bits) - 1) >> pack_bits;
        if self.count == 0 { 0.0 } else { self.bounds.half_area() * tests as f32 }
    }
}

/// The bins along the three axes.
struct Bins([[Bin; BINS]; 3]);

/// The best place to part a node's primitives: behind bin `last` along an axis.
struct Split {
    axis: usize,
    last: usize,
}

impl Bins {
    fn of(references: &[Reference], grid: &Grid) -> Self {
        if references.len() < 2 * PARALLEL {
            return Self::of_chunk(references, grid);
        }
        let chunks = references.par_chunks(PARALLEL).map(|chunk| Self::of_chunk(chunk, grid));
        chunks.reduce(|| Self([[Bin::EMPTY; BINS]; 3]), Self::merged)
    }

    fn of_chunk(references: &[Reference], grid: &Grid) -> Self {
        let mut bins = [[Bin::EMPTY; BINS]; 3];
        for reference in references {
            let places = grid.places(reference.center());
            for (bins, place) in bins.iter_mut().zip(places) {
                let bin = &mut bins[place];
                bin.bounds = bin.bounds.union(reference.bounds());
                bin.count += 1;
            }
        }
        Self(bins)
    }

    fn merged(mut self, other: Self) -> Self {
        for (bin, other) in self.0.as_flattened_mut().iter_mut().zip(other.0.as_flattened()) {
            *bin = bin.and(other);
        }
        self
    }

    /// The cheapest split with primitives on both sides; none if all centres are in one bin.
    fn split(&self, grid: &Grid, pack_bits: u32) -> Option<Split> {
        let mut best = (f32::INFINITY, None);
        for (axis, bins) in self.0.iter().enumerate() {
            let bins = &bins[..grid.bins];
            let mut behind = [0.0; BINS];
            let mut right = Bin::EMPTY;
            for last in (0..bins.len() - 1).rev() {
                right = right.and(&bins[last + 1]);
                behind[last] = right.cost(pack_bits);
            }
            let (mut left, all) = (Bin::EMPTY, right.count + bins[0].count);
            for (last, bin) in bins[..bins.len() - 1].iter().enumerate() {
                left = left.and(bin);
                let cost = left.cost(pack_bits) + behind[last];
                if 0 < left.count && left.count < all && cost < best.0 {
                    best = (cost, Some(Split { axis, last }));
                }
            }
        }
        best.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use glam::Vec3A;

    fn boxes(count: u32) -> Vec<Aabb> {
        let mut random = Random::new(&[7, u64::from(count)]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        (0..count)
            .map(|_| (point(), point()))
            .map(|(a, b)| Aabb { min: a, max: a + 0.1 * b })
            .collect()
    }

    /// Every primitive once, boxes that are the unions of those below, depth.
    fn check(boxes: &[Aabb], pack: u32) -> u32 {
        let tree = build(boxes, pack);
        let mut seen = vec![false; boxes.len()];
        let mut deepest = 0;
        let mut open = vec![(0, 0)];
        while let Some((index, depth)) = open.pop() {
            let node: &Bvh2Node = &tree.nodes[index as usize];
            deepest = deepest.max(depth);
            let first = node.first_index as usize;
            let expected = if node.is_leaf() {
                let primitive = tree.primitive_indices[first] as usize;
                assert!(!std::mem::replace(&mut seen[primitive], true));
                boxes[primitive]
            } else {
                open.extend([(node.first_index, depth + 1), (node.first_index + 1, depth + 1)]);
                tree.nodes[first].aabb().union(tree.nodes[first + 1].aabb())
            };
            assert_eq!((node.aabb().min, node.aabb().max), (expected.min, expected.max));
        }
        assert!(seen.iter().all(|&seen| seen));
        deepest
    }

    #[test]
    fn trees_hold_all_primitives_in_the_boxes_around_them() {
        for count in [1, 2, 3, 17, 1000, 70_000] {
            check(&boxes(count), 1);
            check(&boxes(count), 8);
        }
    }

    #[test]
    fn equal_centers_are_halved() {
        assert_eq!(check(&vec![boxes(1)[0]; 1024], 8), 10);
    }

    #[test]
    fn centers_that_shrink_towards_a_point_make_no_chain() {
        let at = |i: i32| Vec3A::splat(0.5f32.powi(i / 8));
        let boxes: Vec<_> = (0..1000).map(|i| Aabb { min: at(i), max: at(i) }).collect();
        assert!(check(&boxes, 1) < USUAL_DEPTH + 32);
    }

    #[test]
    fn the_number_of_threads_changes_nothing() {
        let boxes = boxes(50_000);
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("a pool").install(|| build(&boxes, 8))
        };
        let (one, three) = (on(1), on(3));
        assert_eq!(one.primitive_indices, three.primitive_indices);
        let corners = |tree: &Bvh2| -> Vec<_> {
            tree.nodes.iter().map(|n| (n.aabb().min, n.aabb().max, n.first_index)).collect()
        };
        assert_eq!(corners(&one), corners(&three));
    }
}
