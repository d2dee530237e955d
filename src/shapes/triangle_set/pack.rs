//! Eight triangles side by side.

use glam::Vec3;
use rayon::prelude::*;

use crate::accel::PACK;
use crate::math::{Lanes3, NONE};
use crate::shapes::Triangle;
use crate::simd::{Row as _, Simd, ask_for_huge_pages};

use super::extent::Used;

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

    /// Up to eight triangles of a mesh, by their indices from `first` on, whose vertices are noted as used; none
    /// if a vertex is not there or not finite.
    #[inline]
    pub(super) fn of_mesh(
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        first: u32,
        used: &Used,
    ) -> Option<Self> {
        let mut pack = Self::EMPTY;
        for (lane, corners) in triangles.iter().enumerate().take(PACK) {
            for (number, &corner) in corners.iter().enumerate() {
                let position = positions.get(corner as usize)?.to_array();
                used.note(corner);
                for (axis, value) in position.into_iter().enumerate() {
                    pack.rows[3 * number + axis][lane] = value.to_bits();
                }
            }
            pack.rows[PRIM][lane] = first + lane as u32;
        }
        // All bits of an exponent are ones where a number is not finite. Absent triangles are NaN.
        let infinity = f32::INFINITY.to_bits();
        let mut finite = [true; PACK];
        for row in &pack.rows[..PRIM] {
            for (finite, bits) in finite.iter_mut().zip(row) {
                *finite &= bits & infinity != infinity;
            }
        }
        finite[..triangles.len().min(PACK)].iter().all(|&finite| finite).then_some(pack)
    }

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
    let filled = |index: usize| {
        let mut pack = Pack::EMPTY;
        for lane in 0..PACK {
            if let Some((triangle, prim)) = triangle(index * PACK + lane) {
                pack.set(lane, &triangle, prim);
            }
        }
        pack
    };
    packs_of(slots.div_ceil(PACK), filled)
}

/// So many packs, made on all threads.
pub(super) fn packs_of(count: usize, pack: impl Fn(usize) -> Pack + Sync + Send) -> Vec<Pack> {
    let mut packs = Vec::with_capacity(count);
    ask_for_huge_pages(packs.spare_capacity_mut());
    (0..count).into_par_iter().map(pack).collect_into_vec(&mut packs);
    packs
}
