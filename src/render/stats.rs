//! What the rays of a rendering did, by class.

use std::time::Duration;

use crate::counters::Counts;

use super::{RayClass, StageTimes};

/// The rays of a class.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClassStats {
    /// How many were traced.
    pub rays: u64,
    /// How many hit something; for shadow rays, how many were blocked.
    pub hits: u64,
    /// Tests they took; all zero unless counting was on.
    pub tests: Counts,
}

/// All rays of a rendering.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RenderStats {
    classes: [ClassStats; RayClass::ALL.len()],
    /// What the threads spent their time on.
    pub thread_times: StageTimes,
    /// Wall time of the rendering, the structure's build excluded.
    pub time: Duration,
}

impl RenderStats {
    /// One class.
    #[must_use]
    pub fn class(&self, class: RayClass) -> &ClassStats {
        &self.classes[class as usize]
    }

    /// One class, to add to.
    pub(super) fn class_mut(&mut self, class: RayClass) -> &mut ClassStats {
        &mut self.classes[class as usize]
    }

    /// Rays of all classes.
    #[must_use]
    pub fn total_rays(&self) -> u64 {
        self.classes.iter().map(|class| class.rays).sum()
    }

    /// Tests of all classes.
    #[must_use]
    pub fn total_tests(&self) -> Counts {
        self.classes.iter().fold(Counts::default(), |mut sum, class| {
            sum += class.tests;
            sum
        })
    }

    /// Adds the rays of another part of the rendering; the wall time stays as it is.
    pub fn merge(&mut self, other: &Self) {
        for (sum, class) in self.classes.iter_mut().zip(&other.classes) {
            sum.rays += class.rays;
            sum.hits += class.hits;
            sum.tests += class.tests;
        }
        self.thread_times.merge(&other.thread_times);
    }
}
