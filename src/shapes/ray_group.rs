//! Sixteen rays at an object, a ray in each lane.

use crate::accel::Query;
use crate::math::slab::{finite_reciprocal, slab};
use crate::math::{Lanes, Lanes3, Mask as _, Ray, within};
use crate::simd::{LANES, Row, Simd};

use super::Instance;

/// Rays, and where hits count.
pub(super) struct RayGroup<S: Simd> {
    pub(super) origin: Lanes3<S::F16>,
    pub(super) dir: Lanes3<S::F16>,
    /// The parameters between which hits count: in the rays' intervals before the ends of their
    /// searches, and in those of the object's box.
    pub(super) begin: S::F16,
    pub(super) end: S::F16,
}

impl<S: Simd> RayGroup<S> {
    /// Up to sixteen rays of the world, by their places in both slices. In the lanes that are left,
    /// nothing counts. `records` are memory.
    #[inline(always)]
    pub(super) fn load<Q: Query>(
        instance: &Instance<'_>,
        query: &Q,
        (rays, places): (&[Ray], &[u32]),
        answers: &[Q::Answer],
        records: &mut [[f32; 8]; LANES],
    ) -> Self {
        let mut ends = [f32::NEG_INFINITY; LANES];
        for (lane, &at) in places.iter().enumerate() {
            let ray = &rays[at as usize];
            records[lane % LANES] = ray.to_array();
            ends[lane % LANES] = query.end(ray, &answers[at as usize]);
        }
        let rows = S::transpose(records);
        let mut group = Self {
            origin: [rows[0], rows[1], rows[2]],
            dir: [rows[4], rows[5], rows[6]],
            begin: rows[3],
            end: S::F16::load(&ends),
        };
        group.cut_to_box(instance);
        group
    }

    /// Cuts the intervals to those of the object's box.
    #[inline(always)]
    fn cut_to_box(&mut self, instance: &Instance<'_>) {
        let origin = &self.origin;
        let largest = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        let pad = instance.padding.of_rays(largest);
        for (axis, origin) in origin.iter().enumerate() {
            let low = S::F16::splat(instance.bounds.min[axis]);
            let high = S::F16::splat(instance.bounds.max[axis]);
            let inv_dir = finite_reciprocal(self.dir[axis]);
            let (near, far) = slab([low, high], [*origin + pad, *origin - pad], inv_dir);
            // Of a number and what is none, the second operand remains: no hit lies before it.
            self.begin = near.max(self.begin);
            self.end = far.min(self.end);
        }
    }

    /// Which rays count a hit at these parameters.
    #[inline(always)]
    pub(super) fn accepts(&self, t: S::F16) -> u32 {
        within(t, [self.begin, self.end]).bits()
    }

    /// Takes the rays to the object's own space: the operations of `RayToObject::apply`.
    #[inline(always)]
    pub(super) fn enter_own_space(&mut self, instance: &Instance<'_>) {
        let Some(to_object) = instance.to_object else { return };
        let columns = to_object.columns();
        let (origin, dir) = (self.origin, self.dir);
        for (axis, own) in self.origin.iter_mut().enumerate() {
            let [x, y, z, by] = row::<S>(&columns, axis);
            *own = origin[0] * x + origin[1] * y + origin[2] * z + by;
        }
        for (axis, own) in self.dir.iter_mut().enumerate() {
            let [x, y, z, _] = row::<S>(&columns, axis);
            *own = dir[0] * x + dir[1] * y + dir[2] * z;
        }
    }
}

/// A row of a matrix and of its translation.
#[inline(always)]
fn row<S: Simd>(columns: &[[f32; 3]; 4], axis: usize) -> [S::F16; 4] {
    [
        S::F16::splat(columns[0][axis]),
        S::F16::splat(columns[1][axis]),
        S::F16::splat(columns[2][axis]),
        S::F16::splat(columns[3][axis]),
    ]
}
