//! The box around triangles that stand in packs.

use std::ops::Range;

use glam::Vec3A;
use rayon::prelude::*;

use crate::accel::Packs as _;
use crate::math::{Aabb, Lanes as _, Lanes3};
use crate::simd::{Kernel, Row as _, Simd, dispatch, splat3};

use super::TriangleSet;

/// Packs that a thread takes together.
const CHUNK: usize = 1 << 10;

/// The box around all triangles, in whatever slots they are.
pub(super) fn bounds_of(set: &TriangleSet) -> Aabb {
    let count = set.packs.len();
    let chunk = |chunk: usize| {
        let first = chunk * CHUNK;
        dispatch(BoundsOf { set, packs: first..count.min(first + CHUNK) })
    };
    let chunks = (0..count.div_ceil(CHUNK)).into_par_iter();
    chunks.map(chunk).reduce(|| Aabb::EMPTY, Aabb::union)
}

/// The box around all triangles of some packs.
struct BoundsOf<'a> {
    set: &'a TriangleSet,
    packs: Range<usize>,
}

impl Kernel for BoundsOf<'_> {
    type Output = Aabb;

    #[inline(always)]
    fn run<S: Simd>(self) -> Aabb {
        let mut all: [Lanes3<S::F8>; 2] =
            [splat3([f32::INFINITY; 3]), splat3([f32::NEG_INFINITY; 3])];
        for pack in self.packs {
            let [low, high] = self.set.boxes::<S>(pack);
            // Empty lanes are NaN.
            let present = low[0].le(low[0]);
            for axis in 0..3 {
                all[0][axis] = all[0][axis].min(low[axis]).select_where(present, all[0][axis]);
                all[1][axis] = all[1][axis].max(high[axis]).select_where(present, all[1][axis]);
            }
        }
        let [low, high] = all;
        Aabb {
            min: Vec3A::new(low[0].smallest(), low[1].smallest(), low[2].smallest()),
            max: Vec3A::new(high[0].largest(), high[1].largest(), high[2].largest()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::Primitives as _;
    use crate::math::NONE;
    use crate::shapes::triangle_mesh::extent::tests::apart;

    #[test]
    fn boxes_are_around_all() {
        for count in [0, 1, 7, 8, 9, 30_001] {
            let (positions, triangles) = apart(count);
            let mut set = TriangleSet::new(&positions, &triangles);
            let around = Aabb::of_points(positions.iter().map(|&p| p.into()));
            assert_eq!(bounds_of(&set), around, "{count}");
            // Three to a pack, from the last on.
            let slot = |slot: u32| if slot % 8 < 3 { slot / 8 * 3 + slot % 8 } else { NONE };
            let from_last = |place: u32| (count as u32).checked_sub(place + 1).unwrap_or(NONE);
            let slots = (0..(count as u32).div_ceil(3) * 8).map(slot);
            let order: Vec<_> =
                slots.map(|place| if place == NONE { NONE } else { from_last(place) }).collect();
            set.reorder(&order);
            assert_eq!(bounds_of(&set), around, "{count}, in an order");
        }
    }
}
