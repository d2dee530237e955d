//! What a traversal counts: free when off, because not counting is a type.

/// Receives what a structure and its primitives do for one or more rays.
pub trait Counters {
    /// Whether anything is counted: what is computed only to be counted depends on it.
    const COUNTS: bool;
    /// `n` bounding volumes were tested.
    fn boxes(&mut self, n: u32);
    /// `n` primitives were tested.
    fn primitives(&mut self, n: u32);
}

/// Counts nothing and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoCounters;

impl Counters for NoCounters {
    const COUNTS: bool = false;
    #[inline(always)]
    fn boxes(&mut self, _: u32) {}
    #[inline(always)]
    fn primitives(&mut self, _: u32) {}
}

/// How many tests some rays took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Bounding volumes tested: nodes' boxes, or the ball around a mesh.
    pub boxes: u64,
    /// Primitives tested by their own formula.
    pub primitives: u64,
}

impl Counters for Counts {
    const COUNTS: bool = true;
    #[inline(always)]
    fn boxes(&mut self, n: u32) {
        self.boxes += u64::from(n);
    }
    #[inline(always)]
    fn primitives(&mut self, n: u32) {
        self.primitives += u64::from(n);
    }
}

impl std::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.boxes += other.boxes;
        self.primitives += other.primitives;
    }
}
