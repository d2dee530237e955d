//! The box around triangles that stand in packs.

use std::ops::Range;

use glam::Vec3A;
use rayon::prelude::*;

use crate::accel::{Bounded, PACK, Packs as _};
use crate::math::{Aabb, Lanes as _, Lanes3};
use crate::simd::{Kernel, Row as _, Simd, dispatch, splat3};

use super::TriangleSet;

/// Triangles that a thread takes together.
const CHUNK: usize = 1 << 13;

/// The box around all triangles.
pub(super) fn bounds_of(set: &TriangleSet) -> Aabb {
    // Empty lanes would count as points; the last pack alone has some, before a structure's order.
    let whole = set.packs.len().min(set.count as usize / PACK);
    let chunks = (0..whole.div_ceil(CHUNK / PACK)).into_par_iter();
    let bounds = chunks.map(|chunk| {
        let first = chunk * (CHUNK / PACK);
        dispatch(BoundsOf { set, packs: first..whole.min(first + CHUNK / PACK) })
    });
    let rest = (whole * PACK) as u32..set.count;
    let rest = rest.map(|index| Bounded::bounds(set, index)).fold(Aabb::EMPTY, Aabb::union);
    bounds.reduce(|| Aabb::EMPTY, Aabb::union).union(rest)
}

/// The box around all triangles of whole packs.
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
            for axis in 0..3 {
                all[0][axis] = all[0][axis].min(low[axis]);
                all[1][axis] = all[1][axis].max(high[axis]);
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
    use glam::Vec3;

    #[test]
    fn boxes_are_around_all() {
        for count in [0, 1, 7, 8, 9, 30_001] {
            let at = |i: usize| Vec3::new(i as f32, (i % 100) as f32 - 60.0, -2.0 - (i % 7) as f32);
            let positions: Vec<_> = (0..3 * count).map(at).collect();
            let triangles: Vec<_> =
                (0..count as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let set = TriangleSet::new(&positions, &triangles);
            let around = Aabb::of_points(positions.iter().map(|&p| p.into()));
            assert_eq!(bounds_of(&set), around, "{count}");
        }
    }
}
