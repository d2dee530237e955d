//! Pictures whose pixels are known in closed form.
//!
//! One file per formula. Pixels very close to an edge are left out, because there the last bit
//! decides.

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
