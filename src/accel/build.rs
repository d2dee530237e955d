//! A build: what it is given beside the primitives, and what it returns.

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::math::Aabb;

use super::{Bounded, BuildConfig, BuildStages};

/// What a structure is given to build itself, beside the primitives.
#[derive(Debug)]
pub struct Build<'a> {
    /// What the caller chose.
    pub config: &'a BuildConfig,
    /// How many slots a single ray is tested with at once: ranges that begin at a multiple of it are
    /// the cheapest. Above 1, primitives are tested in packs, and slots may stay empty. See
    /// [`Packs::GRAIN`](super::Packs::GRAIN).
    pub grain: u32,
    /// What the build spends its time on. A structure that notes nothing is built in one stage.
    pub stages: &'a mut BuildStages,
}

/// What a build returns.
#[derive(Debug)]
pub struct Built<A> {
    /// The structure.
    pub accel: A,
    /// Slot → primitive index, where the structure wants an order of its own;
    /// [`NONE`](crate::math::NONE) for a slot that stays empty, which is for primitives that are tested
    /// several at once ([`Build::grain`]): others close ranks.
    ///
    /// Each primitive has exactly one slot: [`Indexed::build`](super::Indexed::build) panics
    /// otherwise, with a message as `the order names primitive 17 twice and 4 never`. A primitive
    /// that several leaves want is offered several times from its one slot.
    pub order: Option<Vec<u32>>,
}

/// The primitives' boxes as obvhs's builders take them.
pub(super) fn obvhs_boxes(primitives: &impl Bounded) -> Vec<obvhs::aabb::Aabb> {
    (0..primitives.count())
        .into_par_iter()
        .map(|i| {
            let Aabb { min, max } = primitives.bounds(i);
            obvhs::aabb::Aabb { min, max }
        })
        .collect()
}
