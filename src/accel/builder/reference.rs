//! What a tree is built from: boxes that carry the index of their primitive.

use glam::{Vec3A, Vec4};
use rayon::prelude::*;

use super::super::Bounded;
use crate::math::Aabb;
use crate::simd::ask_for_huge_pages;

/// A box as a row of eight: the low corner with its signs changed, and the high corner. So the box
/// around two boxes is one maximum. The fourth lane of either corner holds something else.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Corners(pub(super) [f32; 8]);

impl Corners {
    /// The box of no points.
    pub(super) const EMPTY: Self = Self([f32::NEG_INFINITY; 8]);

    /// Both corners, the low one with its signs changed.
    #[inline(always)]
    fn halves(&self) -> [Vec4; 2] {
        let (halves, _) = self.0.as_chunks::<4>();
        [Vec4::from_array(halves[0]), Vec4::from_array(halves[1])]
    }

    /// The box around two boxes.
    #[inline(always)]
    pub(super) fn union(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|lane| self.0[lane].max(other.0[lane])))
    }

    /// What can be twice the centre of a box within this one, of a range.
    #[inline(always)]
    pub(super) fn centers(&self, range: &Centers) -> Centers {
        let [low, high] = self.halves();
        [range[0].max(-2.0 * low), range[1].min(2.0 * high)]
    }

    /// Half of the surface.
    #[inline(always)]
    pub(super) fn half_area(&self) -> f32 {
        let [low, high] = self.halves();
        let size = high + low;
        size.x * size.y + size.y * size.z + size.z * size.x
    }

    /// As a box of obvhs's.
    #[inline(always)]
    pub(super) fn aabb(&self) -> obvhs::aabb::Aabb {
        let [low, high] = self.halves();
        obvhs::aabb::Aabb { min: -Vec3A::from_vec4(low), max: Vec3A::from_vec4(high) }
    }
}

/// The low and the high corner of the box around twice some centres.
pub(super) type Centers = [Vec4; 2];

/// That of no centres.
pub(super) const NOWHERE: Centers = [Vec4::INFINITY, Vec4::NEG_INFINITY];

/// A primitive's box. Half of the bits of its index stand in the fourth lane of either corner, as
/// whole numbers: bits of an index could be a number that is slow to compute with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reference(pub(super) Corners);

impl Reference {
    /// Those of all primitives, by their indices.
    pub(super) fn all(primitives: &impl Bounded) -> Vec<Self> {
        let mut references = Vec::with_capacity(primitives.count() as usize);
        ask_for_huge_pages(references.spare_capacity_mut());
        (0..primitives.count())
            .into_par_iter()
            .map(|index| Self::new(index, &primitives.bounds(index)))
            .collect_into_vec(&mut references);
        references
    }

    #[inline]
    pub(super) fn new(index: u32, bounds: &Aabb) -> Self {
        let [low, high] = [(-bounds.min).to_array(), bounds.max.to_array()];
        let halves = [(index & 0xffff) as f32, (index >> 16) as f32];
        Self(Corners([low[0], low[1], low[2], halves[0], high[0], high[1], high[2], halves[1]]))
    }

    pub(super) fn index(&self) -> u32 {
        let [.., low, _, _, _, high] = self.0.0;
        low as u32 | (high as u32) << 16
    }

    /// Twice the centre of the box.
    #[inline(always)]
    pub(super) fn center(&self) -> Vec4 {
        let [low, high] = self.0.halves();
        high - low
    }
}
