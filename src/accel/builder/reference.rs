//! What a tree is built from: boxes that carry the index of their primitive.

use glam::{Vec3A, Vec4};

use super::super::{Bounded, PACK};
#[cfg(test)]
use crate::math::Aabb;
use crate::math::Lanes as _;
use crate::simd::{Kernel, Row as _, Simd, dispatch, table};

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
        // By slices: of arrays the compiler loads some floats one by one.
        [Vec4::from_slice(&self.0[..4]), Vec4::from_slice(&self.0[4..])]
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

    /// Where it begins and ends along an axis.
    pub(super) fn range(&self, axis: usize) -> [f32; 2] {
        [-self.0[axis], self.0[4 + axis]]
    }

    /// What is before a plane across an axis.
    pub(super) fn up_to(mut self, axis: usize, plane: f32) -> Self {
        self.0[4 + axis] = self.0[4 + axis].min(plane);
        self
    }

    /// What is behind a plane across an axis.
    pub(super) fn from(mut self, axis: usize, plane: f32) -> Self {
        self.0[axis] = self.0[axis].min(-plane);
        self
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
        let count = primitives.count() as usize;
        let blank = [Reference(Corners::EMPTY); PACK];
        let eights = table(count.div_ceil(PACK), blank, |eight, references| {
            dispatch(Eight { primitives, first: (eight * PACK) as u32, references });
        });
        let mut references = eights.into_flattened();
        references.truncate(count);
        references
    }

    #[cfg(test)]
    pub(super) fn new(index: u32, bounds: &Aabb) -> Self {
        let [low, high] = [(-bounds.min).to_array(), bounds.max.to_array()];
        let halves = [(index & 0xffff) as f32, (index >> 16) as f32];
        Self(Corners([low[0], low[1], low[2], halves[0], high[0], high[1], high[2], halves[1]]))
    }

    pub(super) fn index(&self) -> u32 {
        let [.., low, _, _, _, high] = self.0.0;
        low as u32 | (high as u32) << 16
    }

    /// Twice the centre of the box along an axis.
    #[inline(always)]
    pub(super) fn center_along(&self, axis: usize) -> f32 {
        self.0.0[axis % 3 + 4] - self.0.0[axis % 3]
    }

    /// Twice the centre of the box.
    #[inline(always)]
    pub(super) fn center(&self) -> Vec4 {
        let [low, high] = self.0.halves();
        high - low
    }
}

/// Eight primitives, from a multiple of eight on: what stands behind the last is not specified.
struct Eight<'a, P> {
    primitives: &'a P,
    first: u32,
    references: &'a mut [Reference; PACK],
}

impl<P: Bounded> Kernel for Eight<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let mut rows = [[0.0; 8]; PACK];
        self.primitives.bounds_of_eight::<S>(self.first, &mut rows);
        let signs = S::F8::load(&[-1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
        for (lane, row) in rows.iter().enumerate() {
            let (index, corners) = (self.first + lane as u32, &mut self.references[lane].0.0);
            S::F8::load(row).flipped_by(signs).store(corners);
            (corners[3], corners[7]) = ((index & 0xffff) as f32, (index >> 16) as f32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Boxes;
    use super::*;
    use glam::Vec3A;

    #[test]
    fn references_are_the_boxes_one_by_one() {
        for count in [1, 7, 8, 9, 70_000] {
            let at = |i: u32| Vec3A::new(i as f32, -(i as f32) / 7.0, 0.0);
            let boxes: Vec<_> =
                (0..count).map(|i| Aabb { min: at(i), max: at(i) + Vec3A::ONE }).collect();
            let all = Reference::all(&Boxes(boxes.clone()));
            assert_eq!(all.len(), boxes.len());
            for (index, (reference, bounds)) in (0..).zip(all.iter().zip(&boxes)) {
                assert_eq!(reference.index(), index);
                assert_eq!(
                    reference.0.0.map(f32::to_bits),
                    Reference::new(index, bounds).0.0.map(f32::to_bits)
                );
            }
        }
    }
}
