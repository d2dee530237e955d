//! A tree along Morton's curve: the quickest to build, and of the least quality.
//!
//! Karras: *Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees*, 2012; the idea is
//! that of Lauterbach et al.: *Fast BVH Construction on GPUs*, 2009. Centres are put on a grid of 2²¹ cells
//! along each axis, and primitives are sorted by the bits of their cells, axis by axis in turn: 63 bits.
//! A node is parted at the first bit in which the first and the last of its codes differ, that is, where
//! a plane halves the space of the curve. Karras finds all nodes at once, each by a search in the sorted
//! codes; the tree is the same if they are found from the top, as here. Equal codes are halved by number.

use glam::Vec3A;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use rayon::prelude::*;

use super::super::BuildStages;
use super::Boxed;
use super::top_down::{self, Division};

/// Bits of a coordinate.
const BITS: u32 = 21;

/// Bits of a code.
pub(super) const CODE_BITS: u32 = 3 * BITS;

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, stages: &mut BuildStages) -> Bvh2 {
    let boxes = stages.time("boxes", || primitives.obvhs_boxes());
    let mut coded = stages.time("codes", || coded(&boxes));
    stages.time("sort", || coded.par_sort_unstable());
    stages.time("tree", || top_down::build(&Curve(&boxes), &mut coded))
}

/// A primitive on the curve: sorted by its code, then by its index, which makes one order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Coded {
    pub(super) code: u64,
    pub(super) index: u32,
}

/// Parts primitives at the planes of the curve; has their boxes.
pub(super) struct Curve<'a>(pub(super) &'a [Aabb]);

impl Division for Curve<'_> {
    type Item = Coded;

    fn divide(&self, coded: &mut [Coded]) -> usize {
        let [first, last] = [0, coded.len() - 1].map(|place| coded[place].code);
        // The bits above the first one that differs are equal in all codes between.
        match (first ^ last).checked_ilog2() {
            Some(bit) => coded.partition_point(|one| one.code >> bit & 1 == 0),
            None => coded.len() / 2,
        }
    }

    fn leaf(&self, one: &Coded) -> (u32, Aabb) {
        (one.index, self.0[one.index as usize])
    }
}

fn center(bounds: &Aabb) -> Vec3A {
    0.5 * bounds.min + 0.5 * bounds.max
}

/// The codes of all primitives.
pub(super) fn coded(boxes: &[Aabb]) -> Vec<Coded> {
    let (low, high) = boxes
        .par_iter()
        .map(|bounds| (center(bounds), center(bounds)))
        .reduce(|| (Vec3A::INFINITY, Vec3A::NEG_INFINITY), |a, b| (a.0.min(b.0), a.1.max(b.1)));
    let scale = Vec3A::splat((1 << BITS) as f32) / (high - low);
    let code = |(index, bounds): (usize, &Aabb)| {
        // Along an axis on which all centres are one this is not a number, which becomes 0.
        let cell =
            ((center(bounds) - low) * scale).to_array().map(|c| (c as u32).min((1 << BITS) - 1));
        let [x, y, z] = cell.map(spread);
        Coded { code: x << 2 | y << 1 | z, index: index as u32 }
    };
    boxes.par_iter().enumerate().map(code).collect()
}

/// The bits of a coordinate, each three places from the next.
fn spread(coordinate: u32) -> u64 {
    let mut bits = u64::from(coordinate);
    bits = (bits | bits << 32) & 0x001f_0000_0000_ffff;
    bits = (bits | bits << 16) & 0x001f_0000_ff00_00ff;
    bits = (bits | bits << 8) & 0x100f_00f0_0f00_f00f;
    bits = (bits | bits << 4) & 0x10c3_0c30_c30c_30c3;
    (bits | bits << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_spread_three_places_apart() {
        for coordinate in [0, 1, 2, 5, 0x15_5555, (1 << BITS) - 1] {
            let expected: u64 =
                (0..BITS).map(|bit| u64::from(coordinate >> bit & 1) << (3 * bit)).sum();
            assert_eq!(spread(coordinate), expected, "{coordinate:x}");
        }
    }

    #[test]
    fn codes_are_parted_at_the_first_bit_that_differs() {
        let parted = |codes: &[u64]| {
            let mut coded: Vec<Coded> =
                (0..).zip(codes).map(|(index, &code)| Coded { code, index }).collect();
            Curve(&[]).divide(&mut coded)
        };
        assert_eq!(parted(&[0b0001, 0b0010, 0b0100, 0b0101, 0b0111]), 2);
        assert_eq!(parted(&[0b1000, 0b1111]), 1);
        assert_eq!(parted(&[7, 7, 7, 7, 8]), 4);
        assert_eq!(parted(&[9; 5]), 2);
    }
}
