//! Who watches a comparison, and may stop it.

/// Receives the progress of a comparison, between its steps.
pub trait Observer: Sync {
    /// A step begins: the scene and the step, in words.
    fn begins(&self, what: &str);
    /// The share of the whole plan that is done, from 0 to 1, by the time that it has taken.
    fn advanced(&self, share: f64);
    /// Whether to stop and keep what is done.
    fn cancelled(&self) -> bool;
}

/// Shows nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    fn begins(&self, _: &str) {}
    fn advanced(&self, _: f64) {}
    fn cancelled(&self) -> bool {
        false
    }
}
