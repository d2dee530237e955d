//! What partitions of space share: how a ray crosses the planes between cells, and the lists of the
//! primitives that cells refer to. The rules for cells stand at [`Accel`](super::Accel).

mod filing;
mod lists;
mod mailbox;
mod plane_ray;
mod raster;
mod walk;

use super::{Allowed, OptionInfo};

pub(super) use filing::{Boxes, Filed};
pub(super) use lists::{CellLists, ListBuilder, MOST_REFERENCES};
pub(super) use mailbox::Mailbox;
pub(super) use plane_ray::PlaneRay;
pub(super) use raster::Raster;
pub(super) use walk::walk;

/// The option that limits how often primitives are listed, with what holds where it is not given.
pub(super) const fn references_option(default: &'static str) -> OptionInfo {
    OptionInfo {
        name: "references",
        allowed: Allowed::Numbers(1, 32),
        default,
        summary: "the most references a triangle, in the mean",
    }
}
