//! Whether a packet's rays still go together.

/// The coherence budget of a packet, in rays. Each visit earns as many as take part in it and costs
/// a price, about what a visit of one ray in a wave costs beside that of a packet. When the budget is
/// spent, the rays are better off in waves.
pub(super) struct CoherenceBudget {
    rays: u32,
    price: u32,
}

impl CoherenceBudget {
    /// What a packet starts with, and the most that it can save for visits by few.
    const MOST: u32 = 32;

    /// A packet waits for memory at each visit; a wave waits for all of its rays at once.
    pub(super) fn new(large: bool) -> Self {
        Self { rays: Self::MOST, price: if large { 12 } else { 4 } }
    }

    /// Pays for a visit by some rays; returns whether the budget had enough.
    #[inline(always)]
    pub(super) fn pay(&mut self, active: u32) -> bool {
        let with = (self.rays + active.count_ones()).min(Self::MOST);
        self.rays = with.saturating_sub(self.price);
        with >= self.price
    }
}
