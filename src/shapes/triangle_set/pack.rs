//! Eight triangles side by side.

use glam::Vec3;

use crate::accel::PACK;
use crate::math::{Lanes3, NONE};
use crate::shapes::Triangle;
use crate::simd::{Row as _, Simd, table};

/// Eight triangles in structure-of-arrays form, five cache lines. Empty lanes are all NaN, which
/// nothing hits.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Pack {
    /// A row of eight for each corner and axis, as bits of floats; then the indices in the mesh. In one array, so that
    /// a row that a ray picks for a corner, by a number of two bits, is never out of bounds.
    pub(super) rows: [[u32; PACK]; ROWS],
}

/// Rows of a pack.
pub(super) const ROWS: usize = 10;

/// The last row: the indices in the mesh.
pub(super) const PRIM: usize = 9;

impl Pack {
    pub(super) const EMPTY: Self = {
        let mut rows = [[f32::NAN.to_bits(); PACK]; ROWS];
        rows[PRIM] = [NONE; PACK];
        Self { rows }
    };

    pub(super) fn set(&mut self, lane: usize, triangle: &Triangle, prim: u32) {
        for (rows, corner) in self.rows.chunks_exact_mut(3).zip(triangle.corners) {
            for (row, value) in rows.iter_mut().zip(corner.to_array()) {
                row[lane] = value.to_bits();
            }
        }
        self.rows[PRIM][lane] = prim;
    }

    /// A coordinate of a corner, by their numbers up to two, in a lane.
    #[inline(always)]
    pub(super) fn coordinate(&self, corner: usize, axis: usize, lane: usize) -> f32 {
        f32::from_bits(self.rows[3 * corner + axis][lane % PACK])
    }

    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> Triangle {
        let corner = |corner| {
            let [x, y, z] = [0, 1, 2].map(|axis| self.coordinate(corner, axis, lane));
            Vec3::new(x, y, z)
        };
        Triangle::new([corner(0), corner(1), corner(2)])
    }
}

/// Three rows of a pack.
#[inline(always)]
pub(super) fn load3<S: Simd>(rows: &[[u32; PACK]; ROWS], [x, y, z]: [usize; 3]) -> Lanes3<S::F8> {
    [S::F8::load_bits(&rows[x]), S::F8::load_bits(&rows[y]), S::F8::load_bits(&rows[z])]
}

/// Packs with the triangles of so many slots and their ids.
pub(super) fn pack(
    slots: usize,
    triangle: impl Fn(usize) -> Option<(Triangle, u32)> + Sync + Send,
) -> Vec<Pack> {
    table(slots.div_ceil(PACK), Pack::EMPTY, |index, pack| {
        for lane in 0..PACK {
            if let Some((triangle, prim)) = triangle(index * PACK + lane) {
                pack.set(lane, &triangle, prim);
            }
        }
    })
}
