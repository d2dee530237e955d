//! No structure: every primitive is offered to every ray. The definition of the right answer.
//!
//! * *Build*: none.
//! * *A ray*: n primitives, eight at a time where they are triangles.
//! * *Memory*: none but for the primitives.
//! * *It wins*: for up to about eight primitives.

use std::io;
use std::ops::{ControlFlow, Range};

use crate::counters::Counters;
use crate::math::{BoxRay, Ray};

use super::save::expect_dense;
use super::{
    Accel, Bounded, Build, Built, Decoder, Encoder, LoadError, Portable, Slots, StructureShape,
    Update,
};

/// Offers everything.
#[derive(Clone, Copy, Debug)]
pub struct Exhaustive {
    count: u32,
}

impl Accel for Exhaustive {
    const ONE_BY_ONE: bool = true;

    /// It has no boxes, and nothing to improve.
    const UPDATES: &'static [Update] = &[Update::Refit];

    fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        Built { accel: Self { count: primitives.count() }, order: None }
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        _: &Ray,
        _: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let _ = leaf(0..self.count, counters);
    }

    fn bytes(&self) -> u64 {
        size_of::<Self>() as u64
    }

    fn shape(&self) -> StructureShape {
        let mut shape = StructureShape { bytes: self.bytes(), ..StructureShape::default() };
        shape.add_leaf(self.count, 0);
        shape
    }
}

impl Portable for Exhaustive {
    const NAME: &'static str = "none";

    fn write(&self, _: &mut Encoder<'_>) -> io::Result<()> {
        Ok(())
    }

    fn read(
        primitives: &impl Bounded,
        Slots { order, .. }: Slots<'_>,
        _: &mut Decoder<'_>,
    ) -> Result<Self, LoadError> {
        expect_dense(order, primitives.count())?;
        Ok(Self { count: primitives.count() })
    }
}
