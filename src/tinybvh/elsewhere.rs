//! The tree on other processors than those of x86-64: there is none.

use crate::math::{Hit, Ray};

use super::TinyBvhError;
use super::triangles::{Corner, Facts, Quality};

/// A tree that cannot be.
pub(super) enum Index {}

impl Index {
    pub(super) fn check_processor() -> Result<(), TinyBvhError> {
        Err(TinyBvhError::Processor)
    }

    pub(super) fn build(_: &[Corner], _: Quality, _: usize) -> Result<Self, TinyBvhError> {
        Err(TinyBvhError::Processor)
    }

    pub(super) fn facts(&self) -> Facts {
        match *self {}
    }

    pub(super) fn closest(&self, _: &[Ray], _: &mut [Hit]) {
        match *self {}
    }

    pub(super) fn any(&self, _: &[Ray], _: &mut [bool]) {
        match *self {}
    }
}
