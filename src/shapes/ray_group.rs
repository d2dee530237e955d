//! Sixteen rays at an object, a ray in each lane.

use crate::math::Ray;
use crate::simd::{LANES, Lanes, Lanes3, Mask, Row, Simd};

use super::Place;
use super::place::SoFar;

/// Rays, and where hits count.
pub(super) struct Group<S: Simd> {
    pub(super) origin: Lanes3<S::F16>,
    pub(super) dir: Lanes3<S::F16>,
    /// The parameters between which hits count: in the rays' intervals before the ends of their
    /// searches, and in those of the object's box.
    pub(super) begin: S::F16,
    pub(super) end: S::F16,
}

impl<S: Simd> Group<S> {
    /// Up to sixteen rays of the world, by their places in both slices. In the lanes that are left,
    /// nothing counts. `records` are memory.
    #[inline(always)]
    pub(super) fn load(
        place: &Place<'_>,
        rays: &[Ray],
        places: &[u32],
        so_far: &[impl SoFar],
        records: &mut [[f32; 8]; LANES],
    ) -> Self {
        let mut ends = [f32::NEG_INFINITY; LANES];
        for (lane, &at) in places.iter().enumerate() {
            let ray = &rays[at as usize];
            records[lane % LANES] = ray.to_array();
            ends[lane % LANES] = so_far[at as usize].end(ray);
        }
        let rows = S::transpose(records);
        let mut group = Self {
            origin: [rows[0], rows[1], rows[2]],
            dir: [rows[4], rows[5], rows[6]],
            begin: rows[3],
            end: S::F16::load(&ends),
        };
        group.cut_to_box(place);
        group
    }

    /// The operations of `BoxRay`.
    #[inline(always)]
    fn cut_to_box(&mut self, place: &Place<'_>) {
        let (origin, padding) = (&self.origin, place.padding);
        let reach = origin[0].abs().max(origin[1].abs()).max(origin[2].abs());
        let reach = S::F16::splat(padding.largest) + reach;
        let pad = S::F16::splat(16.0 * f32::EPSILON * padding.factor) * reach;
        for (axis, origin) in origin.iter().enumerate() {
            let low = S::F16::splat(place.bounds.min[axis]);
            let high = S::F16::splat(place.bounds.max[axis]);
            let inv_dir = S::F16::splat(1.0) / self.dir[axis];
            let inv_dir = inv_dir.max(S::F16::splat(-f32::MAX)).min(S::F16::splat(f32::MAX));
            let a = (low - (*origin + pad)) * inv_dir;
            let b = (high - (*origin - pad)) * inv_dir;
            // Of a number and what is none, the second operand remains: no hit lies before it.
            self.begin = a.min(b).max(self.begin);
            self.end = a.max(b).min(self.end);
        }
    }

    /// Which rays count a hit at these parameters.
    #[inline(always)]
    pub(super) fn accepts(&self, t: S::F16) -> u32 {
        (self.begin.le(t) & t.le(self.end)).bits()
    }

    /// Takes the rays to the object's own space: the operations of `RayToObject::apply`.
    #[inline(always)]
    pub(super) fn enter_own_space(&mut self, place: &Place<'_>) {
        let Some(to_object) = place.to_object else { return };
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
