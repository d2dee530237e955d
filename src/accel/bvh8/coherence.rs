//! Whether a packet's rays still go together, and whether those of the packets before it did.

/// The coherence budget of a packet, in rays. Each visit earns as many as take part in it and costs
/// a price, about what a visit of one ray in a wave costs beside that of a packet. When the budget is
/// spent, the rays are better off in waves.
pub(super) struct CoherenceBudget {
    rays: u32,
    /// The most that can be saved for visits by few.
    most: u32,
    price: u32,
}

impl CoherenceBudget {
    /// The most that can be saved beyond the rays of one visit.
    const SAVED: u32 = 16;

    /// What a packet of so many rays starts with.
    fn new(rays: u32, price: u32) -> Self {
        let most = rays + Self::SAVED;
        Self { rays: most, most, price }
    }

    /// Pays for a visit by some rays; returns whether the budget had enough.
    #[inline(always)]
    pub(super) fn pay(&mut self, active: u32) -> bool {
        let with = (self.rays + active.count_ones()).min(self.most);
        self.rays = with.saturating_sub(self.price);
        with >= self.price
    }
}

/// How packets of a slice fared where nodes and packs come from far away. Where primitives are smaller than pixels,
/// nearly every leaf is one ray's alone, and each waits for its memory; in waves dozens of rays wait together.
#[derive(Default)]
pub(super) struct Coherence {
    packets: u32,
    /// Visits of leaves.
    leaves: u32,
    /// Those by few rays.
    lonely: u32,
}

impl Coherence {
    /// So few rays at a leaf are better off in waves.
    const FEW: u32 = 2;
    /// So many visits tell enough.
    const ENOUGH: u32 = 64;
    /// One packet of so many keeps to the usual price: those that diverge early see no leaves.
    const PROBED: u32 = 8;

    /// The budget of the next packet, of so many rays.
    #[inline(always)]
    pub(super) fn budget(&mut self, rays: u32) -> CoherenceBudget {
        self.packets += 1;
        let are_lonely = self.leaves >= Self::ENOUGH && self.lonely > self.leaves / 4 * 3;
        let is_probe = self.packets.is_multiple_of(Self::PROBED);
        let price = if are_lonely && !is_probe { rays / 2 } else { 2 + rays / 16 };
        CoherenceBudget::new(rays, price)
    }

    /// Notes the visit of a leaf by some rays.
    #[inline(always)]
    pub(super) fn note_leaf(&mut self, active: u32) {
        self.leaves += 1;
        self.lonely += u32::from(active.count_ones() <= Self::FEW);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAYS: u32 = 32;
    const ONE: u32 = 1;
    const MANY: u32 = 0xff;

    /// How many visits by some rays a packet can pay for, of sixty-four.
    fn visits(mut budget: CoherenceBudget, active: u32) -> usize {
        (0..64).take_while(|_| budget.pay(active)).count()
    }

    #[test]
    fn a_packet_goes_on_as_long_as_enough_rays_take_part() {
        let budget = || CoherenceBudget::new(RAYS, 4);
        assert_eq!(visits(budget(), u32::MAX), 64);
        assert_eq!(visits(budget(), MANY), 64);
        assert_eq!(visits(budget(), 0xf), 64);
        // No more than 48 rays are saved. The first visit leaves 44, each one further three less.
        assert_eq!(visits(budget(), ONE), 15);
    }

    #[test]
    fn where_leaves_are_single_rays_packets_diverge_early_but_for_one_of_eight() {
        let mut coherence = Coherence::default();
        let usual = visits(coherence.budget(RAYS), ONE);
        for _ in 0..Coherence::ENOUGH {
            coherence.note_leaf(ONE);
        }
        let mut after: Vec<_> = (0..16).map(|_| visits(coherence.budget(RAYS), ONE)).collect();
        after.sort_unstable();
        assert_eq!(after, [[3; 14].as_slice(), &[usual; 2]].concat());
        // A third of the visits by many rays, and all packets go on again.
        for _ in 0..Coherence::ENOUGH / 2 {
            coherence.note_leaf(MANY);
        }
        assert!((0..16).all(|_| visits(coherence.budget(RAYS), ONE) == usual));
    }
}
