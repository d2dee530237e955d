//! Who watches a comparison, and may stop it.

use super::ComparisonResult;
use crate::ray_file::RayFile;

/// Receives the progress of a comparison, between its steps.
pub trait Observer: Sync {
    /// A step begins: the scene and the step, in words.
    fn begins(&self, what: &str);
    /// The share of the whole plan that is done, from 0 to 1, by the time that it has taken.
    fn advanced(&self, share: f64);
    /// Whether to stop and keep what is done.
    fn cancelled(&self) -> bool;
    /// A part of the plan is done, a scene or another: all that was measured until now, which can be gone on with. By
    /// default it is not kept.
    fn part_done(&self, _so_far: &ComparisonResult) {}
    /// The rays of a scene were recorded, where [`Plan::keep_rays`](super::Plan::keep_rays) wants them. By default they
    /// are dropped.
    fn rays_recorded(&self, _scene: &str, _rays: &RayFile) {}
}

/// Shows nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    fn begins(&self, _: &str) {}
    fn advanced(&self, _: f64) {}
    fn cancelled(&self) -> bool {
        false
    }
}
