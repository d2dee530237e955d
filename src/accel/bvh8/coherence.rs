//! Whether a packet's rays still go together.

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
    pub(super) fn new(rays: usize) -> Self {
        let most = rays as u32 + Self::SAVED;
        Self { rays: most, most, price: 2 + rays as u32 / 16 }
    }

    /// Pays for a visit by some rays; returns whether the budget had enough.
    #[inline(always)]
    pub(super) fn pay(&mut self, active: u32) -> bool {
        let with = (self.rays + active.count_ones()).min(self.most);
        self.rays = with.saturating_sub(self.price);
        with >= self.price
    }
}
