//! The structures that were built over a scene, kept as long as they are used or were used lately.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::accel::BuildConfig;
use crate::render::CellView;
use crate::scene::{BuildReport, Scene, Structure, TracedWorld};

/// So many are kept: going back to one of them takes no time.
const MOST_KEPT: usize = 3;

/// A scene with a structure over it.
pub(super) struct BuiltWorld {
    /// What is traced.
    pub(super) traced: Box<dyn TracedWorld>,
    /// What building it took and gave.
    pub(super) report: BuildReport,
    /// Its cells, once they were looked at.
    cells: OnceLock<Arc<CellView>>,
}

impl BuiltWorld {
    /// Its cells over its scene.
    pub(super) fn cells(&self, scene: &Scene) -> Arc<CellView> {
        let make = || Arc::new(CellView::new(scene, &*self.traced));
        Arc::clone(self.cells.get_or_init(make))
    }
}

/// The worlds of a scene by the names of their structures, the one used last at the end.
#[derive(Default)]
pub(super) struct Worlds(Mutex<Vec<(&'static str, Arc<BuiltWorld>)>>);

impl Worlds {
    /// The world of a structure, built on the threads of the current pool if it is not there.
    ///
    /// # Errors
    /// Why it cannot be built, in words.
    pub(super) fn get(
        &self,
        structure: &Structure,
        scene: &Scene,
        config: &BuildConfig,
    ) -> Result<Arc<BuiltWorld>, String> {
        // Held while it is built: two who want the same wait for one build.
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let world = match kept.iter().position(|(name, _)| *name == structure.name) {
            Some(place) => kept.remove(place).1,
            None => {
                let traced = structure
                    .try_build(scene, config)
                    .map_err(|error| format!("`{}`: {error}", structure.name))?;
                let report = traced.build_report();
                Arc::new(BuiltWorld { traced, report, cells: OnceLock::new() })
            }
        };
        kept.push((structure.name, Arc::clone(&world)));
        if kept.len() > MOST_KEPT {
            kept.remove(0);
        }
        Ok(world)
    }
}
