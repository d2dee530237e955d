//! Where the triangles of a mesh are: the box around them and the mean of their vertices.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::{DVec3, Vec3, Vec3A};
use rayon::prelude::*;

use crate::accel::{Bounded, PACK, Packs as _};
use crate::math::{Aabb, Lanes as _, Lanes3};
use crate::simd::{Kernel, Row as _, Simd, dispatch, splat3};

use super::TriangleSet;

/// Triangles, vertices or corners that a thread takes together.
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

/// The box around all triangles, in whatever slots they are.
#[cfg(feature = "program")]
pub(super) fn bounds_of_slots(set: &TriangleSet) -> Aabb {
    let of_pack = |pack: &super::Pack| {
        let present = (0..PACK).filter(|&lane| pack.rows[super::PRIM][lane] != crate::math::NONE);
        present.map(|lane| pack.triangle(lane).bounds()).fold(Aabb::EMPTY, Aabb::union)
    };
    let packs = set.packs.par_iter().with_min_len(CHUNK / PACK);
    packs.map(of_pack).reduce(|| Aabb::EMPTY, Aabb::union)
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

/// Which vertices of a mesh its triangles use: a file may hold others, and these are no part of the mesh.
pub(super) struct Used(Vec<AtomicBool>);

impl Used {
    /// None of so many.
    pub(super) fn none(vertices: usize) -> Self {
        Self(std::iter::repeat_with(|| AtomicBool::new(false)).take(vertices).collect())
    }

    /// Those of some triangles among so many.
    pub(super) fn by(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let used = Self::none(vertices);
        let corners = triangles.as_flattened().par_chunks(CHUNK);
        corners.for_each(|corners| corners.iter().for_each(|&corner| used.note(corner)));
        used
    }

    /// Notes one that is there.
    #[inline(always)]
    pub(super) fn note(&self, vertex: u32) {
        self.0[vertex as usize].store(true, Ordering::Relaxed);
    }

    /// The mean of those that are used, each counted once, and the box around them.
    pub(super) fn mean_and_bounds(&self, positions: &[Vec3]) -> (Vec3A, Aabb) {
        let of_chunk = |(positions, used): (&[Vec3], &[AtomicBool])| {
            let mut sum = (DVec3::ZERO, 0u32);
            let mut bounds = Aabb::EMPTY;
            for (&position, used) in positions.iter().zip(used) {
                if used.load(Ordering::Relaxed) {
                    sum = (sum.0 + position.as_dvec3(), sum.1 + 1);
                    let point = Vec3A::from(position);
                    bounds = Aabb { min: bounds.min.min(point), max: bounds.max.max(point) };
                }
            }
            (sum, bounds)
        };
        // Added up in one order, whatever the number of threads.
        let chunks: Vec<_> =
            positions.par_chunks(CHUNK).zip(self.0.par_chunks(CHUNK)).map(of_chunk).collect();
        let sum = chunks.iter().fold((DVec3::ZERO, 0), |a, (b, _)| (a.0 + b.0, a.1 + b.1));
        let bounds = chunks.iter().fold(Aabb::EMPTY, |all, (_, bounds)| all.union(*bounds));
        ((sum.0 / f64::from(1.max(sum.1))).as_vec3a(), bounds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_and_means_are_those_of_a_plain_sum() {
        for count in [0, 1, 7, 8, 9, 30_001] {
            let at = |i: usize| Vec3::new(i as f32, (i % 100) as f32 - 60.0, -2.0 - (i % 7) as f32);
            let positions: Vec<_> = (0..3 * count).map(at).collect();
            let triangles: Vec<_> =
                (0..count as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let set = TriangleSet::new(&positions, &triangles);
            let around = Aabb::of_points(positions.iter().map(|&p| p.into()));
            assert_eq!(bounds_of(&set), around, "{count}");
            let used = Used::by(&triangles, positions.len());
            assert_eq!(used.mean_and_bounds(&positions), (set.mean_point(), around), "{count}");
            let sum: DVec3 = positions.iter().map(|p| p.as_dvec3()).sum();
            let mean = sum / positions.len().max(1) as f64;
            let error = (set.mean_point().as_dvec3() - mean).length();
            assert!(error <= 1e-6 * mean.length(), "{count}: {error}");
        }
    }
}
