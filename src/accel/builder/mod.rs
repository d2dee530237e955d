//! Binary trees with one or a few primitives in each leaf: what the layouts of structures are made
//! from.
//!
//! A builder knows boxes and no layout, and a layout takes the tree of any builder:
//!
//! * `sah` (`binned.rs`): from the top by the surface area heuristic in bins, more or less closely
//!   (`terms.rs`);
//! * `ploc` (obvhs): from the bottom by clustering (Meister, Bittner: *Parallel Locally-Ordered
//!   Clustering for Bounding Volume Hierarchy Construction*, 2018);
//! * `sweep` (`all_places.rs`): from the top by the surface area heuristic, with all places weighed;
//! * `median` (`median.rs`): from the top, halved by number;
//! * `lbvh` (`lbvh.rs`): along Morton's curve;
//! * `hlbvh` (`hlbvh.rs`): along Morton's curve below, by the surface area heuristic above;
//! * `sbvh` (`spatial.rs`): from the top by the surface area heuristic, boxes cut where that pays;
//! * `parry` (`parry.rs`), with the feature `libraries`: as parry3d parts them;
//! * `svenstaro` (`svenstaro.rs`), with the same: as the crate bvh parts them.
//!
//! Of the trees of the last two only the form is taken (`walked.rs`), so that they are compared by the same formula and
//! under the same walk as all others; as they are shipped, the same libraries are peers.
//!
//! Each can be improved by reinsertion (`reinsertion.rs`), as the option or the quality says (`choice.rs`). None
//! depends on the number of threads.

mod all_places;
mod binned;
mod bins;
mod branch;
mod choice;
mod hlbvh;
mod lbvh;
mod median;
#[cfg(feature = "libraries")]
mod parry;
mod reference;
mod reinsertion;
mod sorted;
mod spatial;
mod split;
#[cfg(feature = "libraries")]
mod svenstaro;
mod sweep;
mod terms;
mod top_down;
#[cfg(feature = "libraries")]
mod walked;

use glam::Vec3A;
use obvhs::bvh2::Bvh2;
use obvhs::ploc::PlocBuilder;

use crate::math::Aabb;
use crate::simd::table;

use self::reference::Reference;
use self::terms::{Effort, Terms};
use super::build::obvhs_boxes;
use super::{Allowed, Bounded, BuildOptions, BuildStages, OptionInfo, Quality};

/// From this depth on primitives are halved by number: no tree is deeper than this and 32 more.
const USUAL_DEPTH: u32 = 96;

pub(super) use self::choice::TreeChoice;
pub(super) use self::reinsertion::reinsert;

/// How a tree is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Builder {
    /// From the top down by the surface area heuristic, in bins.
    Sah,
    /// From the bottom up by clustering.
    Ploc,
    /// From the top down by the surface area heuristic, all places weighed.
    Sweep,
    /// From the top down, halved by number.
    Median,
    /// Along Morton's curve.
    Lbvh,
    /// Along Morton's curve below, by the surface area heuristic above.
    Hlbvh,
    /// As parry3d parts them.
    #[cfg(feature = "libraries")]
    Parry,
    /// As the crate bvh parts them.
    #[cfg(feature = "libraries")]
    Svenstaro,
    /// From the top down by the surface area heuristic, boxes cut where that pays.
    Sbvh,
}

/// What the options' summaries say of the builders of other libraries.
#[cfg(feature = "libraries")]
macro_rules! libraries {
    () => {
        ", or as a library builds it: parry3d (parry) or the crate bvh (svenstaro)"
    };
}
#[cfg(not(feature = "libraries"))]
macro_rules! libraries {
    () => {
        ""
    };
}

impl Builder {
    const ALL: &[Self] = &[
        Self::Sah,
        Self::Ploc,
        Self::Sweep,
        Self::Median,
        Self::Lbvh,
        Self::Hlbvh,
        #[cfg(feature = "libraries")]
        Self::Parry,
        #[cfg(feature = "libraries")]
        Self::Svenstaro,
        Self::Sbvh,
    ];

    /// What they are called, in the same order; the last one cuts boxes.
    const WORDS: &[&str] = &[
        "sah",
        "ploc",
        "sweep",
        "median",
        "lbvh",
        "hlbvh",
        #[cfg(feature = "libraries")]
        "parry",
        #[cfg(feature = "libraries")]
        "svenstaro",
        "sbvh",
    ];

    /// The option that chooses it, with what holds where it is not given.
    pub(super) const fn option(default: &'static str) -> OptionInfo {
        OptionInfo {
            name: "builder",
            allowed: Allowed::Words(Self::WORDS),
            default,
            summary: concat!(
                "binary tree by the surface area heuristic (in bins, by a sweep over all places, or in bins with ",
                "boxes that are cut: sbvh), by clustering, by halves of equal number or along Morton's curve (with the ",
                "heuristic above: hlbvh)",
                libraries!()
            ),
        }
    }

    /// The same for structures of whole boxes.
    pub(super) const fn option_without_cuts(default: &'static str) -> OptionInfo {
        let (words, _) = Self::WORDS.split_at(Self::WORDS.len() - 1);
        OptionInfo {
            allowed: Allowed::Words(words),
            summary: concat!(
                "binary tree by the surface area heuristic (in bins or by a sweep over all places), by clustering, by ",
                "halves of equal number or along Morton's curve (with the heuristic above: hlbvh)",
                libraries!()
            ),
            ..Self::option(default)
        }
    }

    /// What was chosen.
    pub(super) fn chosen(options: &BuildOptions, option: &OptionInfo) -> Option<Self> {
        let chosen = options.word(option)?;
        Self::WORDS.iter().zip(Self::ALL).find(|(word, _)| **word == chosen).map(|(_, own)| *own)
    }

    /// Builds a tree over at least one primitive, for leaves in which `pack` primitives, a power of two,
    /// cost as much as one. Its leaves hold up to `most` primitives where parting them would not pay. Several
    /// leaves may refer to a primitive if `cuts` says so.
    fn tree(
        self,
        primitives: &dyn Boxed,
        [pack, most]: [u32; 2],
        quality: Quality,
        cuts: bool,
        stages: &mut BuildStages,
    ) -> Bvh2 {
        let (parameters, effort) = (quality.parameters(), Effort::of(quality));
        let terms = Terms { pack_bits: pack.ilog2(), most: most as usize, effort };
        match self {
            Self::Sah => binned::build(primitives, terms, stages),
            Self::Sweep => all_places::build(primitives, terms, stages),
            Self::Median => median::build(primitives, stages),
            Self::Lbvh => lbvh::build(primitives, stages),
            Self::Hlbvh => hlbvh::build(primitives, effort, stages),
            #[cfg(feature = "libraries")]
            Self::Parry => parry::build(primitives, stages),
            #[cfg(feature = "libraries")]
            Self::Svenstaro => svenstaro::build(primitives, stages),
            Self::Sbvh => spatial::build(primitives, terms, cuts, stages),
            Self::Ploc => {
                let boxes = stages.time("boxes", || primitives.obvhs_boxes());
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
        }
    }
}

/// Whether boxes may be cut, of primitives that are tested so many at once: where they are tested one by one, as
/// objects are, none is copied, since an object may be large and move by itself.
pub(super) fn cuts(grain: u32) -> bool {
    grain > 1
}

/// Primitives whose boxes are asked for all at once, so that builders are compiled once for all primitives.
trait Boxed {
    /// The boxes as obvhs's builders take them.
    fn obvhs_boxes(&self) -> Vec<obvhs::aabb::Aabb>;

    /// The boxes with their indices.
    fn references(&self) -> Vec<Reference>;
}

impl<P: Bounded> Boxed for P {
    fn obvhs_boxes(&self) -> Vec<obvhs::aabb::Aabb> {
        obvhs_boxes(self)
    }

    fn references(&self) -> Vec<Reference> {
        Reference::all(self)
    }
}

/// Boxes of nothing else.
pub(super) struct Boxes(pub(super) Vec<Aabb>);

impl Boxes {
    /// Those of some primitives.
    pub(super) fn of(primitives: &impl Bounded, some: &[u32]) -> Self {
        Self(table(some.len(), Aabb::EMPTY, |place, bounds| {
            *bounds = primitives.bounds(some[place]);
        }))
    }
}

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

#[cfg(test)]
mod tests;
