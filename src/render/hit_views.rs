//! What each pixel hit, or which cell it sees, instead of its colour: one ray through its centre.

use crate::accel::Answers;
use crate::math::{Color, Hit, Random, Ray};

use super::cells::{is_before, surface_color};
use super::frame::Frame;
use super::measured_tracer::MeasuredTracer;
use super::view_rays::Pixel;
use super::{RayClass, Stage, View};

/// Renders the normals, depths, objects or primitives of some pixels, in their order.
pub(super) fn render_hits(
    frame: &Frame<'_>,
    tracer: &mut MeasuredTracer<'_>,
    pixels: &[Pixel],
    view: View,
) -> Vec<Color> {
    let rays: Vec<Ray> = pixels.iter().map(|&p| frame.view_rays.through_center(p)).collect();
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.lap(Stage::MakingRays);
    tracer.trace(RayClass::View, &rays, Answers::ClosestHit(&mut hits));
    let seen = rays.iter().zip(&hits).map(|(ray, hit)| value_of(frame, view, ray, hit)).collect();
    tracer.lap(Stage::Shading);
    seen
}

/// Renders the cells that some pixels see, in their order.
pub(super) fn render_cells(
    frame: &Frame<'_>,
    tracer: &mut MeasuredTracer<'_>,
    pixels: &[Pixel],
) -> Vec<Color> {
    let rays: Vec<Ray> = pixels.iter().map(|&p| frame.view_rays.through_center(p)).collect();
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.lap(Stage::MakingRays);
    tracer.trace(RayClass::View, &rays, Answers::ClosestHit(&mut hits));
    let cells = frame.cells.as_deref();
    let seen_through = |ray: &Ray| cells.and_then(|cells| cells.seen(ray));
    let color = |(&Pixel { x, y }, (ray, hit)): (&Pixel, (&Ray, &Hit))| match seen_through(ray) {
        Some(cell) if !is_before(hit, &cell) => {
            // The rim of a cell is where the pixel to the right, or that below, sees another one.
            let beside = [Pixel { x: x + 1, y }, Pixel { x, y: y + 1 }];
            cell.color(&beside.map(|p| seen_through(&frame.view_rays.through_center(p))))
        }
        _ if hit.is_hit() => surface_color(frame.scene.surface(ray, hit).normal, ray),
        _ => Color::ZERO,
    };
    let seen = pixels.iter().zip(rays.iter().zip(&hits)).map(color).collect();
    tracer.lap(Stage::Shading);
    seen
}

/// What a pixel shows: a colour, or a depth in every component.
fn value_of(frame: &Frame<'_>, view: View, ray: &Ray, hit: &Hit) -> Color {
    match view {
        View::Depth if hit.is_hit() => Color::splat(hit.t * ray.dir.length()),
        View::Depth => Color::NAN,
        _ if !hit.is_hit() => Color::ZERO,
        View::Normal => 0.5 * (frame.scene.surface(ray, hit).normal + Color::ONE),
        View::Object => id_color(&[u64::from(hit.object)]),
        _ => id_color(&[u64::from(hit.object), u64::from(hit.prim)]),
    }
}

/// A random colour for an id, neither dark nor pale.
fn id_color(id: &[u64]) -> Color {
    let mut random = Random::new(id);
    let color = Color::from_array(std::array::from_fn(|_| random.next_f32()));
    0.25 + 0.75 * color
}
