//! Pictures whose pixels are known in closed form.
//!
//! One file a formula. What lies within a hair's breadth of an edge is not asked: there the last
//! bit decides.

#[path = "../common/mod.rs"]
mod common;
mod view;

mod ambient;
mod depth;
mod mirror_image;
mod penumbra;
mod scales;
mod shadow_edge;
mod silhouette;
mod slab;
mod watertight;
