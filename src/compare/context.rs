//! What all measurements in a scene share. Knows nothing of the steps that make them.

use crate::render::Settings;
use crate::scene::Scene;

use super::budget::Budget;
use super::plan::Plan;
use super::pools::Pools;
use super::rounds::Repeat;

/// A scene, and how it is measured.
#[derive(Clone, Copy)]
pub(super) struct SceneContext<'a> {
    pub(super) scene: &'a Scene,
    pub(super) plan: &'a Plan,
    pub(super) pools: &'a Pools,
    pub(super) cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl<'a> SceneContext<'a> {
    /// The settings of the scene's picture.
    pub(super) fn picture_settings(&self) -> Settings {
        self.plan.picture.settings(self.scene)
    }

    /// Rounds by the plan's rule.
    pub(super) fn rounds(&self, budget: Budget) -> Repeat<'a> {
        Repeat::new(self.plan.rounds.clone(), budget, self.cancelled)
    }

    /// Rounds by the plan's rule, without those that warm up: for work that was done before.
    pub(super) fn rounds_after_warmup(&self, budget: Budget) -> Repeat<'a> {
        let mut repeat = self.rounds(budget);
        repeat.rule.warmup = 0;
        repeat
    }
}
