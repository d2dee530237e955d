//! Renderings of a structure that end when the comparison is cancelled.

use crate::image_io::Picture;
use crate::render::{self, Image, Rendering, Settings, render};
use crate::scene::{Scene, TracedWorld};

use super::candidate::Candidate;
use super::context::SceneContext;

/// A rendering on the threads of the current pool that stops when it is cancelled.
pub(super) fn render_until(
    cancelled: &(dyn Fn() -> bool + Sync),
    scene: &Scene,
    tracer: &dyn TracedWorld,
    settings: &Settings,
) -> Rendering {
    render(scene, tracer, settings, &Stopper(cancelled))
}

struct Stopper<'a>(&'a (dyn Fn() -> bool + Sync));

impl render::Observer for Stopper<'_> {
    fn tile_done(&self, _: u64, _: u64) {}
    fn cancelled(&self) -> bool {
        (self.0)()
    }
}

/// A structure's whole rendering on all threads; `None` if it fails or is cancelled.
pub(super) fn render_whole(
    context: &SceneContext<'_>,
    candidate: &mut Candidate<'_>,
    settings: &Settings,
) -> Option<Image> {
    let render = |world: &dyn TracedWorld| {
        let render = || render_until(context.cancelled, context.scene, world, settings);
        context.pools.all.install(render)
    };
    let rendering = candidate.attempt(render).filter(|rendering| rendering.complete)?;
    Some(rendering.image)
}

/// The colours of a rendering; `None` if it shows numbers.
pub(super) fn colors(image: Image) -> Option<Picture> {
    match image {
        Image::Color(picture) => Some(picture),
        Image::Scalar { .. } => None,
    }
}
