//! Binary trees with one or a few primitives in each leaf: what the layouts of structures are made
//! from.
//!
//! A builder knows boxes and no layout, and a layout takes the tree of any builder. Clustering goes
//! from the bottom up: PLOC (Meister, Bittner: *Parallel Locally-Ordered Clustering for Bounding
//! Volume Hierarchy Construction*, 2018), by obvhs. The surface area heuristic goes from the top down
//! (`binned.rs`), more or less closely (`terms.rs`). Either tree can be improved by obvhs's
//! reinsertion (Meister, Bittner: *Parallel Reinsertion for Bounding Volume Hierarchy Optimization*,
//! 2018), as the quality says.

mod binned;
mod bins;
mod branch;
mod reference;
mod sorted;
mod split;
mod sweep;
mod terms;

use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

use self::terms::{Effort, Terms};
use super::build::obvhs_boxes;
use super::{Allowed, Bounded, BuildOptions, BuildStages, OptionInfo, Quality};

/// How a tree is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Builder {
    /// From the top down by the surface area heuristic, in bins.
    Sah,
    /// From the bottom up by clustering.
    Ploc,
}

impl Builder {
    const WORDS: &[&str] = &["sah", "ploc"];

    /// The option that chooses it, with what holds where it is not given.
    pub(super) const fn option(default: &'static str) -> OptionInfo {
        OptionInfo {
            name: "builder",
            allowed: Allowed::Words(Self::WORDS),
            default,
            summary: "binary tree by the surface area heuristic or by clustering",
        }
    }

    /// What was chosen.
    pub(super) fn chosen(options: &BuildOptions, option: &OptionInfo) -> Option<Self> {
        options.word(option).map(|word| if word == Self::WORDS[0] { Self::Sah } else { Self::Ploc })
    }

    /// Builds a tree over at least one primitive, for leaves in which `pack` primitives, a power of two,
    /// cost as much as one. Its leaves hold up to `most` primitives where parting them would not pay.
    pub(super) fn tree(
        self,
        primitives: &impl Bounded,
        pack: u32,
        most: u32,
        quality: Quality,
        stages: &mut BuildStages,
    ) -> Bvh2 {
        let parameters = quality.parameters();
        let mut tree = match self {
            Self::Sah => {
                // Primitives are reinserted one by one.
                let whole = pack > 1 && self.reinserted(quality) == 0.0;
                let most = if whole { most as usize } else { 1 };
                let effort = Effort::of(quality);
                binned::build(primitives, Terms { pack_bits: pack.ilog2(), most, effort }, stages)
            }
            Self::Ploc => {
                let boxes = stages.time("boxes", || obvhs_boxes(primitives));
                let build = || {
                    PlocBuilder::with_capacity(boxes.len()).build(
                        parameters.ploc_search_distance,
                        &boxes,
                        (0..boxes.len() as u32).collect(),
                        parameters.sort_precision,
                        parameters.search_depth_threshold,
                    )
                };
                stages.time("tree", build)
            }
        };
        reinsert(&mut tree, self.reinserted(quality), stages);
        tree
    }

    /// The share of the nodes that are reinserted in each round.
    pub(super) fn reinserted(self, quality: Quality) -> f32 {
        match (self, quality) {
            // That tree is as good without.
            (Self::Sah, Quality::Fastest | Quality::Fast | Quality::Medium) => 0.0,
            _ => quality.parameters().reinsertion_batch_ratio,
        }
    }
}

/// Improves a tree by reinserting a share of its nodes again and again.
pub(super) fn reinsert(tree: &mut Bvh2, share: f32, stages: &mut BuildStages) {
    if share > 0.0 {
        stages.time("reinsertion", || ReinsertionOptimizer::default().run(tree, share, None));
    }
}

#[cfg(test)]
pub(super) mod tests {
    use glam::Vec3A;

    use super::*;
    use crate::math::Aabb;

    /// Boxes of nothing else.
    pub(in super::super) struct Boxes(pub(in super::super) Vec<Aabb>);

    impl Bounded for Boxes {
        fn count(&self) -> u32 {
            self.0.len() as u32
        }

        fn bounds(&self, index: u32) -> Aabb {
            self.0[index as usize]
        }

        fn mean_point(&self) -> Vec3A {
            self.total_bounds().center()
        }
    }
}
