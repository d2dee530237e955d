//! What a build spends its time on.

use std::time::{Duration, Instant};

/// The wall times of a build's stages, in the order in which they first came.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BuildStages(Vec<(&'static str, Duration)>);

impl BuildStages {
    /// Does some work and notes its time.
    pub fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        self.add(stage, start.elapsed());
        result
    }

    /// Notes a time; those of stages of one name are added up.
    pub fn add(&mut self, stage: &'static str, time: Duration) {
        match self.0.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, sum)) => *sum += time,
            None => self.0.push((stage, time)),
        }
    }

    /// Adds the stages of another build.
    pub fn merge(&mut self, other: &Self) {
        for (stage, time) in other.iter() {
            self.add(stage, time);
        }
    }

    /// Names and times.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Duration)> + '_ {
        self.0.iter().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_keep_their_order_and_add_up() {
        let mut stages = BuildStages::default();
        assert_eq!(stages.time("boxes", || 3), 3);
        stages.add("tree", Duration::from_secs(1));
        let mut other = BuildStages::default();
        other.add("primitives", Duration::from_secs(2));
        other.add("tree", Duration::from_secs(4));
        stages.merge(&other);
        let names: Vec<_> = stages.iter().map(|(name, _)| name).collect();
        assert_eq!(names, ["boxes", "tree", "primitives"]);
        assert_eq!(stages.iter().nth(1), Some(("tree", Duration::from_secs(5))));
    }
}
