//! What a tree is built for, and what its build may cost.

use super::super::Quality;

/// What a pack costs in units of what each primitive in it adds. That is little, but of splits into as many
/// packs it prefers those that leave few primitives to a large box: what shares a leaf with a large primitive
/// is tested with every ray that meets the box of that one.
pub(super) const PACK_COST: f32 = 64.0;

/// What splits are weighed by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms {
    /// The logarithm of how many primitives are tested at once: they cost as much as one.
    pub(super) pack_bits: u32,
    /// Up to so many primitives may stay together in a leaf, where parting them would not pay.
    pub(super) most: usize,
    /// How closely it is looked.
    pub(super) effort: Effort,
}

/// How closely a build looks for splits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Of twice as many primitives, or more, a sample of at least so many is binned.
    pub(super) sample: usize,
    /// The most that the boxes around all primitives may be larger than those around a sample, by
    /// their areas. Where they are larger, the sample has left out what matters, and all are binned.
    pub(super) slack: f32,
    /// Whether splits are sought along the widest axis alone.
    pub(super) widest: bool,
    /// Whether what fits into a leaf is one. Otherwise more than half of that is parted where it pays, and looked at
    /// where it could.
    pub(super) whole: bool,
}

impl Effort {
    /// What a quality takes.
    pub(super) fn of(quality: Quality) -> Self {
        let close = Self { sample: 2048, slack: 1.25, widest: false, whole: false };
        match quality {
            Quality::Fastest => Self { sample: 64, slack: 4.0, widest: true, whole: true },
            Quality::Fast => Self { sample: 1024, whole: true, ..close },
            Quality::Medium | Quality::Slow | Quality::Slowest => close,
        }
    }
}

/// What so many primitives cost: the packs that they fill, where `1 << pack_bits` are tested at once, and each of them.
#[inline(always)]
pub(super) fn cost_of(count: usize, pack_bits: u32) -> f32 {
    PACK_COST * count.div_ceil(1 << pack_bits) as f32 + count as f32
}

impl Terms {
    /// What primitives within a box of half this surface cost together.
    #[inline(always)]
    pub(super) fn cost(&self, half_area: f32, count: usize) -> f32 {
        half_area * cost_of(count, self.pack_bits)
    }

    /// Up to so many primitives stay together without a look.
    #[inline(always)]
    pub(super) fn unparted(&self) -> usize {
        let most = if self.effort.whole { self.most } else { self.most / 2 };
        most.max(1)
    }
}
