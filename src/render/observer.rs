//! Who watches a rendering, and may stop it.

use crate::math::Ray;

use super::RayClass;

/// Told of progress from all threads, between tiles.
pub trait Observer: Sync {
    /// A tile is done.
    fn tile_done(&self, pixels: u64, rays: u64);
    /// Whether to stop. Asked before each tile; tiles that were begun are finished.
    fn cancelled(&self) -> bool;
    /// These rays are sent now: what a replay needs. Most observers need not know.
    fn rays_sent(&self, _class: RayClass, _rays: &[Ray]) {}
}

/// Watches nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    fn tile_done(&self, _: u64, _: u64) {}
    fn cancelled(&self) -> bool {
        false
    }
}
