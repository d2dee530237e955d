//! A build: what it is given beside the primitives, and what it returns.

use crate::math::Aabb;
use crate::simd::table;

use super::{Bounded, BuildConfig, BuildStages, Order};

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
    /// Which primitive is in which slot; `None` where slots are indices. A structure that refers to a
    /// primitive from several leaves either offers its one slot several times, or has it copied
    /// ([`Order::References`]), so that every leaf is a range and is tested in packs.
    pub order: Option<Order>,
}

/// The primitives' boxes: what builds go on with that are compiled once for all primitives.
pub(super) fn boxes_of(primitives: &impl Bounded) -> Vec<Aabb> {
    table(primitives.count() as usize, Aabb::EMPTY, |index, bounds| {
        *bounds = primitives.bounds(index as u32);
    })
}

/// The primitives' boxes as obvhs's builders take them.
pub(super) fn obvhs_boxes(primitives: &impl Bounded) -> Vec<obvhs::aabb::Aabb> {
    table(primitives.count() as usize, obvhs::aabb::Aabb::INVALID, |index, bounds| {
        let Aabb { min, max } = primitives.bounds(index as u32);
        *bounds = obvhs::aabb::Aabb { min, max };
    })
}
