//! Rays whose packet diverged on the way: what they have found, and what they are still to visit.

use crate::math::Hit;

use super::node::Child;

/// Diverged rays.
#[derive(Default)]
pub(super) struct Diverged {
    rays: Vec<DivergedRay>,
    /// What each ray is still to visit and where that begins, the nearest last: ray by ray.
    entries: Vec<(Child, f32)>,
}

/// A diverged ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct DivergedRay {
    /// Its place in the slice.
    pub(super) ray: u32,
    /// The best hit so far; if there is none, its parameter is the ray's end.
    pub(super) best: Hit,
    /// Its entries.
    first: u32,
    count: u32,
}

impl Diverged {
    /// Forgets all rays.
    #[inline]
    pub(super) fn clear(&mut self) {
        self.rays.clear();
        self.entries.clear();
    }

    /// Adds a ray with what it is to visit, the nearest last; does nothing if that is nothing.
    #[inline]
    pub(super) fn add(&mut self, ray: u32, best: Hit, entries: impl Iterator<Item = (Child, f32)>) {
        let first = self.entries.len();
        self.entries.extend(entries);
        let count = (self.entries.len() - first) as u32;
        if count > 0 {
            self.rays.push(DivergedRay { ray, best, first: first as u32, count });
        }
    }

    /// The rays.
    #[inline]
    pub(super) fn rays(&self) -> &[DivergedRay] {
        &self.rays
    }

    /// What a ray is to visit.
    #[inline]
    pub(super) fn entries(&self, ray: &DivergedRay) -> &[(Child, f32)] {
        let first = ray.first as usize;
        &self.entries[first..first + ray.count as usize]
    }
}
