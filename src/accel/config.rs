//! How a structure is built.

use obvhs::BvhBuildParams;

use super::BuildOptions;

/// How much time a build may take for a better tree: obvhs's presets. `bvh8` has a builder of its own,
/// which looks less closely in quick builds, and takes reinsertion from these in slow ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quality {
    /// obvhs's `fastest_build`.
    Fastest,
    /// obvhs's `fast_build`.
    Fast,
    /// obvhs's `medium_build`.
    #[default]
    Medium,
    /// obvhs's `slow_build`, without its pre-splits.
    Slow,
    /// obvhs's `very_slow_build`, without its pre-splits.
    Slowest,
}

impl Quality {
    /// All of them, the quickest build first.
    pub const ALL: [Self; 5] = [Self::Fastest, Self::Fast, Self::Medium, Self::Slow, Self::Slowest];

    /// The name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fastest => "fastest",
            Self::Fast => "fast",
            Self::Medium => "medium",
            Self::Slow => "slow",
            Self::Slowest => "slowest",
        }
    }

    /// obvhs's parameters.
    ///
    /// Pre-splits are off in all of them: the boxes of the parts of a triangle do not cover its own
    /// box, and a hit that its own box accepts could then be pruned. That would break equal hits.
    pub(super) fn parameters(self) -> BvhBuildParams {
        let preset = match self {
            Self::Fastest => BvhBuildParams::fastest_build(),
            Self::Fast => BvhBuildParams::fast_build(),
            Self::Medium => BvhBuildParams::medium_build(),
            Self::Slow => BvhBuildParams::slow_build(),
            Self::Slowest => BvhBuildParams::very_slow_build(),
        };
        BvhBuildParams { pre_split: false, ..preset }
    }
}

/// What the caller chooses of a build.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildConfig {
    /// Time against quality.
    pub quality: Quality,
    /// The most primitives in a leaf of a tree, at least 1; trees with a smaller limit keep theirs. Partitions of space
    /// ignore it (`KdTree`, `Grid`, `TwoLevelGrid`, `Octree`): their leaves hold what touches a cell.
    pub max_leaf: u32,
    /// Options of the structure's own; those that it does not offer mean nothing to it.
    pub options: BuildOptions,
}

impl Default for BuildConfig {
    fn default() -> Self {
        Self { quality: Quality::default(), max_leaf: 8, options: BuildOptions::NONE }
    }
}
