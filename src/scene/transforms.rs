//! The transforms of a scene's objects: ready for use where they are few, small where they are many.

use std::borrow::Cow;

use glam::DAffine3;
use rayon::prelude::*;

use crate::math::Transform;
use crate::simd::{Cache, prefetch};

/// The most transforms that are kept as they are used. Of the others the matrix alone is kept, less
/// than half as much; to invert it takes some nanoseconds of each hit.
const FEW: usize = 1 << 16;

/// Invertible transforms, by index.
#[derive(Clone, Debug, Default)]
pub(super) struct Transforms {
    /// The first few.
    whole: Vec<Transform>,
    /// The others: object space to world space.
    matrices: Vec<DAffine3>,
}

impl Transforms {
    /// Adds a transform; returns its index.
    pub(super) fn add(&mut self, transform: &Transform) -> u32 {
        if self.whole.len() < FEW {
            self.whole.push(*transform);
        } else {
            self.matrices.push(transform.world_from_object);
        }
        (self.whole.len() + self.matrices.len() - 1) as u32
    }

    /// Matrices that [`Transform::new`] has taken before.
    pub(super) fn of_invertible(mut matrices: Vec<DAffine3>) -> Self {
        let others = matrices.split_off(matrices.len().min(FEW));
        let few = matrices.into_par_iter().with_min_len(1 << 8);
        Self { whole: few.map(Transform::of_invertible).collect(), matrices: others }
    }

    /// Asks the caches for the transform of an index.
    #[inline]
    pub(super) fn prefetch(&self, index: u32) {
        let index = index as usize;
        if let Some(transform) = self.whole.get(index) {
            prefetch(&transform.world_from_object, Cache::First);
        } else if let Some(matrix) = self.matrices.get(index - self.whole.len()) {
            prefetch(matrix, Cache::First);
        }
    }

    /// The matrices of all, in their order.
    pub(super) fn matrices(&self) -> Vec<DAffine3> {
        let whole = self.whole.iter().map(|transform| transform.world_from_object);
        whole.chain(self.matrices.iter().copied()).collect()
    }

    /// The transform of an index; none for [`NONE`](crate::math::NONE).
    #[inline]
    pub(super) fn get(&self, index: u32) -> Option<Cow<'_, Transform>> {
        let index = index as usize;
        if let Some(transform) = self.whole.get(index) {
            return Some(Cow::Borrowed(transform));
        }
        let matrix = *self.matrices.get(index.checked_sub(self.whole.len())?)?;
        Some(Cow::Owned(Transform::of_invertible(matrix)))
    }
}
