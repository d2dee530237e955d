//! The observer of a rendering, which may cancel it.

use crate::math::Ray;

use super::RayClass;

/// Receives the progress of a rendering. All methods are called from all threads.
pub trait Observer: Sync {
    /// A tile of `pixels` pixels was rendered with `rays` rays.
    fn tile_done(&self, pixels: u64, rays: u64);
    /// Whether to stop. Asked often, between slices of rays; a tile that was begun is left out then.
    fn cancelled(&self) -> bool;
    /// These rays are about to be traced together, as a replay would trace them again. Does nothing
    /// unless it is overridden. After the rendering was cancelled none are sent.
    fn rays_sent(&self, _class: RayClass, _rays: &[Ray]) {}
}

/// An observer that ignores progress and never cancels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    fn tile_done(&self, _: u64, _: u64) {}
    fn cancelled(&self) -> bool {
        false
    }
}
