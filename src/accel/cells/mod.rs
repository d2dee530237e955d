//! What partitions of space share: how a ray crosses the planes between cells, and the lists of the
//! primitives that cells refer to. The rules for cells stand at [`Accel`](super::Accel).

mod filing;
mod lists;
mod mailbox;
mod plane_ray;
mod raster;
mod walk;

pub(super) use filing::{Boxes, Filed};
pub(super) use lists::{CellLists, ListBuilder};
pub(super) use mailbox::Mailbox;
pub(super) use plane_ray::PlaneRay;
pub(super) use raster::Raster;
pub(super) use walk::walk;
