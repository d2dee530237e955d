//! Whether a packet's rays still go together.

/// The coherence budget of a packet, in rays. Each visit earns as many as take part in it and costs
/// a price, about what a visit of one ray in a wave costs beside that of a packet. When the budget is
/// spent, the rays are better off in waves.
pub(super) struct CoherenceBudget {
    rays: u32,
    most: u32,
    price: u32,
}

impl CoherenceBudget {
    /// What a packet of so many rays starts with, and the most that it can save for visits by few.
    /// A packet waits for memory at each visit; a wave waits for all of its rays at once.
    pub(super) fn new(rays: usize, large: bool) -> Self {
        let most = rays as u32 + 16;
        Self { rays: most, most, price: if large { rays as u32 * 3 / 4 } else { rays as u32 / 8 + 2 } }
    }

    /// Pays for a visit by some rays; returns whether the budget had enough.
    #[inline(always)]
    pub(super) fn pay(&mut self, active: u32) -> bool {
        let with = (self.rays + active.count_ones()).min(self.most);
        self.rays = with.saturating_sub(self.price);
        with >= self.price
    }
}
