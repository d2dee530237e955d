//! From pieces of a picture to its parts: threads render them, and send each part as soon as it is there.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::film::{Part, Piece};
use crate::scene::{Camera, Scene, TracedWorld};

use super::frame::Frame;
use super::tile_renderer::TileRenderer;
use super::{CellView, Observer, RenderStats, Settings, View};

/// What parts hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// The sums of samples where a piece begins with sample 0, and samples elsewhere: the least memory.
    Sums,
    /// The samples: what noise is estimated from.
    Samples,
}

/// A scene with a structure and settings, and all that is computed from them before the first ray.
pub struct Renderer<'a> {
    frame: Frame<'a>,
    world: &'a dyn TracedWorld,
}

impl<'a> Renderer<'a> {
    /// Computes what all pieces share.
    #[must_use]
    pub fn new(scene: &'a Scene, world: &'a dyn TracedWorld, settings: &'a Settings) -> Self {
        let shows_cells = settings.view == View::Cells;
        let cells = shows_cells.then(|| Arc::new(CellView::new(scene, world)));
        Self::seen_by(&scene.camera, scene, world, settings, cells)
    }

    /// The same with another camera than the scene's own, and with cells that were made before; [`View::Cells`] has no
    /// cells without them. The size of the picture is that of the settings.
    #[must_use]
    pub fn seen_by(
        camera: &Camera,
        scene: &'a Scene,
        world: &'a dyn TracedWorld,
        settings: &'a Settings,
        cells: Option<Arc<CellView>>,
    ) -> Self {
        Self { frame: Frame::new(scene, camera, settings, cells), world }
    }

    /// Renders pieces on the threads of the current rayon pool: each thread takes the next one, until there are no more
    /// or the observer stops it. `send` gets each part from the thread that rendered it, in no order. A piece that was
    /// begun when the rendering was stopped is left out.
    ///
    /// The samples of pieces are numbers below [`Settings::film_samples`]. The time of the statistics is not set.
    pub fn render(
        &self,
        pieces: &[Piece],
        kept: Kept,
        observer: &dyn Observer,
        send: &(dyn Fn(Part) + Sync),
    ) -> RenderStats {
        let next = AtomicUsize::new(0);
        let on_thread = |_| {
            let mut renderer = TileRenderer::new(&self.frame, self.world, observer);
            let mut sum = RenderStats::default();
            while let Some(piece) = pieces.get(next.fetch_add(1, Ordering::Relaxed)) {
                let Some((part, stats)) = renderer.render(piece, kept) else { break };
                observer.tile_done(piece.area.pixels(), stats.total_rays());
                sum.merge(&stats);
                send(part);
            }
            sum
        };
        let threads = rayon::current_num_threads();
        let sums: Vec<_> = (0..threads).into_par_iter().with_max_len(1).map(on_thread).collect();
        let mut stats = RenderStats::default();
        sums.iter().for_each(|own| stats.merge(own));
        stats
    }
}
