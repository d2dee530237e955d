//! What was chosen for a binary tree: who builds it, and how much it is improved.

use obvhs::bvh2::Bvh2;

use super::super::{Allowed, Bounded, BuildConfig, BuildStages, OptionInfo, Quality};
use super::Builder;
use super::reinsertion::{reinsert, reinsert_largest};

/// A builder, and the share of the nodes that are reinserted.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct TreeChoice {
    builder: Builder,
    quality: Quality,
    /// The share of the nodes that are reinserted in each round; 0 for no reinsertion.
    pub(in super::super) reinserted: f32,
    /// Whether the largest nodes are reinserted.
    largest: bool,
    /// Whether several leaves may refer to a primitive.
    cuts: bool,
}

impl Builder {
    /// The option that says how many nodes are reinserted.
    pub(in super::super) const REINSERTION: OptionInfo = OptionInfo {
        name: "reinsertion",
        allowed: Allowed::Numbers(0, 100),
        default: "as the quality says: with ploc from medium builds on, with others from slow ones on; with sah in medium \
                  builds up to a thousand of the largest nodes",
        summary: "percent of the tree's nodes that are put elsewhere in each round where that is cheaper",
    };
}

impl TreeChoice {
    /// What the options say, by that of the builder, with another where none is given. `cuts` says whether several
    /// leaves may refer to a primitive.
    pub(in super::super) fn of(
        config: &BuildConfig,
        cuts: bool,
        option: &OptionInfo,
        default: Builder,
    ) -> Self {
        let builder = Builder::chosen(&config.options, option).unwrap_or(default);
        let usual = Self::new(builder, config.quality, cuts);
        let percent = config.options.number(&Builder::REINSERTION);
        let chosen = percent.map(|percent| percent as f32 / 100.0);
        match chosen {
            Some(reinserted) => Self { reinserted, largest: false, ..usual },
            None => usual,
        }
    }

    /// A builder, with as much reinsertion as the quality says.
    pub(super) fn new(builder: Builder, quality: Quality, cuts: bool) -> Self {
        let reinserted = match (builder, quality) {
            // The tree of bins is as good with its largest nodes alone, and the others are what they are called as
            // long as no more than a usual build is wanted.
            (Builder::Ploc, _) | (_, Quality::Slow | Quality::Slowest) => {
                quality.parameters().reinsertion_batch_ratio
            }
            _ => 0.0,
        };
        let largest = builder == Builder::Sah && quality == Quality::Medium;
        Self { builder, quality, reinserted, largest, cuts }
    }

    /// Builds a tree over at least one primitive, for leaves in which `pack` primitives, a power of two,
    /// cost as much as one. Its leaves hold up to `most` primitives where parting them would not pay.
    pub(in super::super) fn tree(
        &self,
        primitives: &impl Bounded,
        pack: u32,
        most: u32,
        stages: &mut BuildStages,
    ) -> Bvh2 {
        // Primitives are reinserted one by one.
        let most = if pack > 1 && self.reinserted == 0.0 { most } else { 1 };
        let mut tree = self.builder.tree(primitives, [pack, most], self.quality, self.cuts, stages);
        reinsert(&mut tree, self.reinserted, stages);
        if self.largest {
            reinsert_largest(&mut tree, stages);
        }
        tree
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::{BuildOptions, Bvh8};
    use super::super::Boxes;
    use super::*;
    use crate::math::{Aabb, Random};
    use glam::Vec3A;

    #[test]
    fn reinsertion_is_as_it_is_given_or_as_the_quality_says_and_makes_trees_cheaper() {
        let option = Builder::option("sah");
        let of = |text: &str, quality| {
            let options = BuildOptions::of::<Bvh8>(text).unwrap();
            let config = BuildConfig { options, quality, ..BuildConfig::default() };
            TreeChoice::of(&config, false, &option, Builder::Sah)
        };
        let share = |text: &str, quality| of(text, quality).reinserted;
        assert_eq!(share("leaf=8", Quality::Medium), 0.0);
        assert!(
            share("leaf=8", Quality::Slow) > 0.0 && share("builder=ploc", Quality::Medium) > 0.0
        );
        assert_eq!(share("builder=ploc,reinsertion=0", Quality::Slow), 0.0);
        assert_eq!(share("builder=lbvh,reinsertion=15", Quality::Fastest), 0.15);

        let mut random = Random::new(&[31]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let boxes: Vec<Aabb> = (0..3000)
            .map(|_| (point(), point()))
            .map(|(a, b)| Aabb { min: a, max: a + 0.1 * b })
            .collect();
        let boxes = Boxes(boxes);
        let cost = |text: &str| {
            let tree = of(text, Quality::Medium).tree(&boxes, 1, 1, &mut BuildStages::default());
            let inner = tree.nodes.iter().filter(|node| !node.is_leaf());
            inner.map(|node| f64::from(node.aabb().half_area())).sum::<f64>()
        };
        for builder in ["lbvh", "median", "sah"] {
            let [plain, improved] = ["0", "50"]
                .map(|percent| cost(&format!("builder={builder},reinsertion={percent}")));
            assert!(improved < plain, "{builder}: {plain} {improved}");
        }
    }
}
