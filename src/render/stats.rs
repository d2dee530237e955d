//! What the rays of a rendering did, by class.

use std::time::Duration;

use crate::counters::Counts;

use super::StageTimes;

/// What a ray is sent for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayClass {
    /// From the eye through a pixel.
    View,
    /// From a surface to a light.
    Shadow,
    /// Along a mirror direction.
    Mirror,
    /// Through a surface.
    Refraction,
}

impl RayClass {
    /// All classes, in the order of reports.
    pub const ALL: [Self; 4] = [Self::View, Self::Shadow, Self::Mirror, Self::Refraction];

    /// The name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::Shadow => "shadow",
            Self::Mirror => "mirror",
            Self::Refraction => "refraction",
        }
    }
}

/// The rays of a class.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClassStats {
    /// How many were traced.
    pub rays: u64,
    /// How many hit something; for shadow rays, how many were blocked.
    pub hits: u64,
    /// Tests they took; all zero unless counting was asked for.
    pub tests: Counts,
}

/// All rays of a rendering.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RenderStats {
    classes: [ClassStats; 4],
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

    /// Adds the rays of another part of the rendering.
    pub(super) fn merge(&mut self, other: &Self) {
        for (sum, class) in self.classes.iter_mut().zip(&other.classes) {
            sum.rays += class.rays;
            sum.hits += class.hits;
            sum.tests += class.tests;
        }
        self.thread_times.merge(&other.thread_times);
    }
}
