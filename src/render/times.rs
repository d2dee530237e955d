//! The time of a rendering by stage.

use std::time::Duration;

use super::RayClass;

/// What a thread is doing for a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Tracing the rays of a class.
    Tracing(RayClass),
    /// Making view, shadow, mirrored and refracted rays. Includes the contributions of lights, which
    /// are computed together with their shadow rays.
    MakingRays,
    /// Computing surfaces from hits, and adding up the light that is not blocked.
    Shading,
    /// All else: means of samples, scheduling of tiles.
    Rest,
}

impl Stage {
    /// All stages of a rendering, in the order of reports.
    pub const ALL: [Self; 7] = [
        Self::Tracing(RayClass::View),
        Self::Tracing(RayClass::Shadow),
        Self::Tracing(RayClass::Mirror),
        Self::Tracing(RayClass::Refraction),
        Self::MakingRays,
        Self::Shading,
        Self::Rest,
    ];

    /// The name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tracing(RayClass::View) => "tracing view rays",
            Self::Tracing(RayClass::Shadow) => "tracing shadow rays",
            Self::Tracing(RayClass::Mirror) => "tracing mirror rays",
            Self::Tracing(RayClass::Refraction) => "tracing refraction rays",
            Self::Tracing(RayClass::Diffuse) => "tracing diffuse rays",
            Self::Tracing(RayClass::Random) => "tracing random rays",
            Self::Tracing(RayClass::Probe) => "tracing probe rays",
            Self::MakingRays => "making rays",
            Self::Shading => "shading",
            Self::Rest => "the rest",
        }
    }

    fn index(self) -> usize {
        match self {
            Self::MakingRays => 0,
            Self::Shading => 1,
            Self::Rest => 2,
            Self::Tracing(class) => 3 + class as usize,
        }
    }
}

/// Time by stage, the sum over all threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StageTimes([Duration; 3 + RayClass::ALL.len()]);

impl StageTimes {
    /// The time of a stage.
    #[must_use]
    pub fn of(&self, stage: Stage) -> Duration {
        self.0[stage.index()]
    }

    /// The time of all stages.
    #[must_use]
    pub fn total(&self) -> Duration {
        self.0.iter().sum()
    }

    /// The time of tracing rays of all classes.
    #[must_use]
    pub fn tracing(&self) -> Duration {
        RayClass::ALL.iter().map(|&class| self.of(Stage::Tracing(class))).sum()
    }

    /// The time of all that is not tracing.
    #[must_use]
    pub fn outside_tracing(&self) -> Duration {
        self.total() - self.tracing()
    }

    /// The share of a stage in the total time, from 0 to 1; `None` if the total is zero.
    #[must_use]
    pub fn share(&self, stage: Stage) -> Option<f64> {
        quotient(self.of(stage), self.total())
    }

    /// The share of tracing in the total time, from 0 to 1; `None` if the total is zero.
    #[must_use]
    pub fn tracing_share(&self) -> Option<f64> {
        quotient(self.tracing(), self.total())
    }

    /// The share of all that is not tracing, from 0 to 1; `None` if the total is zero.
    #[must_use]
    pub fn outside_tracing_share(&self) -> Option<f64> {
        quotient(self.outside_tracing(), self.total())
    }

    /// Adds time to a stage.
    pub fn add(&mut self, stage: Stage, time: Duration) {
        self.0[stage.index()] += time;
    }

    /// Adds the times of another part of the rendering.
    pub(super) fn merge(&mut self, other: &Self) {
        for (sum, time) in self.0.iter_mut().zip(other.0) {
            *sum += time;
        }
    }
}

fn quotient(part: Duration, whole: Duration) -> Option<f64> {
    (!whole.is_zero()).then(|| part.as_secs_f64() / whole.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_add_up() {
        let mut times = StageTimes::default();
        for (i, stage) in (1..).zip(Stage::ALL) {
            times.add(stage, Duration::from_secs(i));
        }
        times.add(Stage::Shading, Duration::from_secs(10));
        assert_eq!(times.of(Stage::Shading), Duration::from_secs(16));
        assert_eq!(times.tracing(), Duration::from_secs(1 + 2 + 3 + 4));
        assert_eq!(times.total(), Duration::from_secs(28 + 10));
        assert_eq!(times.tracing_share(), Some(10.0 / 38.0));
        assert_eq!(times.outside_tracing_share(), Some(28.0 / 38.0));
        assert_eq!(times.share(Stage::Shading), Some(16.0 / 38.0));
        assert_eq!(StageTimes::default().tracing_share(), None);
        let mut twice = times;
        twice.merge(&times);
        assert_eq!(twice.total(), 2 * times.total());
    }
}
