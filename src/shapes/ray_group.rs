//! Sixteen rays at an object, a ray in each lane.

use glam::Vec3;

use crate::accel::Query;
use crate::math::slab::{finite_reciprocal, slab};
use crate::math::{Lanes, Lanes3, Mask as _, Ray, within};
use crate::simd::{LANES, Row, Simd};

use super::Instance;
use super::single_shape::Reach;

/// Rays, and where hits count.
pub(super) struct RayGroup<S: Simd> {
    pub(super) origin: Lanes3<S::F16>,
    pub(super) dir: Lanes3<S::F16>,
    /// The parameters between which hits count.
    pub(super) reach: Reach<S::F16>,
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
        let rows = S::F16::of_records(records.each_ref());
        let of_ray = [rows[3], S::F16::load(&ends)];
        let mut group = Self {
            origin: [rows[0], rows[1], rows[2]],
            dir: [rows[4], rows[5], rows[6]],
            reach: Reach { of_ray, in_box: of_ray },
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
            let [begin, end] = self.reach.in_box;
            self.reach.in_box = [near.max(begin), far.min(end)];
        }
    }

    /// The rays, one by one, without their intervals.
    #[inline(always)]
    pub(super) fn rays(&self) -> [Ray; LANES] {
        let mut rows = [[0.0; LANES]; 6];
        for axis in 0..3 {
            self.origin[axis].store(&mut rows[axis]);
            self.dir[axis].store(&mut rows[3 + axis]);
        }
        let vector = |first: usize, lane: usize| {
            Vec3::new(rows[first][lane], rows[first + 1][lane], rows[first + 2][lane])
        };
        std::array::from_fn(|lane| Ray::new(vector(0, lane), vector(3, lane)))
    }

    /// Which rays meet the object's box.
    #[inline(always)]
    pub(super) fn meets(&self) -> u32 {
        let [begin, end] = self.reach.in_box;
        begin.le(end).bits()
    }

    /// Which rays count a hit at these parameters, if hits are not moved.
    #[inline(always)]
    pub(super) fn accepts(&self, t: S::F16) -> u32 {
        within(t, self.reach.in_box).bits()
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
