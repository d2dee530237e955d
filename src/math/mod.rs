//! Rays, hits, boxes and transforms: the vocabulary that every layer shares.
//!
//! Knows nothing of structures, shapes, scenes or files. Coordinates that are traced are `f32`;
//! what is computed once per scene or per hit is computed in `f64` and rounded at the end.

mod aabb;
mod box_ray;
#[cfg(feature = "program")]
mod count;
mod hash;
mod hit;
mod lanes;
mod outward;
mod ray;
mod size_range;
pub mod slab;
mod transform;

pub use aabb::Aabb;
pub use box_ray::BoxRay;
#[cfg(feature = "program")]
pub use count::read_count;
pub use hash::Random;
#[cfg(feature = "program")]
pub(crate) use hash::{hash_u64, unit_pair};
pub use hit::{CLOSE, Hit, NONE};
pub use lanes::{LaneFormula, Lanes, Lanes3, Mask, dot, ones, sub, within};
pub(crate) use outward::{round_down, round_up};
pub(crate) use ray::search_ends;
pub use ray::{Ray, RayError};
pub use size_range::SizeRange;
pub use slab::Padding;
pub(crate) use transform::outward_box;
pub use transform::{ConditionError, RayToObject, Transform};

/// The unit roundoff of `f32`: half the distance between 1 and the next float, 2⁻²⁴.
pub(crate) const UNIT_ROUNDOFF: f64 = 1.0 / 16_777_216.0;

/// A colour: linear red, green and blue, unclamped.
#[cfg(feature = "program")]
pub type Color = glam::Vec3;
