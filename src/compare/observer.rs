//! Who watches a comparison, and may stop it.

/// Told of progress between steps.
pub trait Observer: Sync {
    /// Work on something begins: a scene and a step of it, in words.
    fn begins(&self, what: &str);
    /// The share of the whole plan that is done, from 0 to 1, by the time it was given.
    fn advanced(&self, share: f64);
    /// Whether to stop and keep what is done.
    fn cancelled(&self) -> bool;
}

/// Watches nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    fn begins(&self, _: &str) {}
    fn advanced(&self, _: f64) {}
    fn cancelled(&self) -> bool {
        false
    }
}
