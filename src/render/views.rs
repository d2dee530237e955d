//! What each pixel hit, instead of its colour: one ray through its centre.

use crate::math::{Color, Hit, Random, Ray};

use super::batch::{Batch, Context};
use super::{Crop, RayClass, View};

/// Renders the normals, depths, objects or primitives of an area, row by row.
pub(super) fn render_view(
    context: &Context<'_>,
    batch: &mut Batch,
    area: Crop,
    view: View,
) -> Vec<Color> {
    let height = context.settings.height;
    let center = |x: u32, y: u32| context.camera.ray(f64::from(x), f64::from(height - 1 - y));
    let rays: Vec<Ray> =
        (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| center(x, y))).collect();
    let mut hits = vec![Hit::MISS; rays.len()];
    let stats = batch.stats.class_mut(RayClass::View);
    let counts = context.count.then_some(&mut stats.tests);
    context.tracer.intersect(&rays, &mut hits, counts);
    stats.rays += rays.len() as u64;
    stats.hits += hits.iter().filter(|hit| hit.is_hit()).count() as u64;
    rays.iter().zip(&hits).map(|(ray, hit)| seen(context, view, ray, hit)).collect()
}

fn seen(context: &Context<'_>, view: View, ray: &Ray, hit: &Hit) -> Color {
    match view {
        View::Depth if hit.is_hit() => Color::splat(hit.t * ray.dir.length()),
        View::Depth => Color::NAN,
        _ if !hit.is_hit() => Color::ZERO,
        View::Normal => 0.5 * (context.scene.surface(ray, hit).normal + Color::ONE),
        View::Object => id_color(&[u64::from(hit.object)]),
        _ => id_color(&[u64::from(hit.object), u64::from(hit.prim)]),
    }
}

/// A colour for an id: random, neither dark nor pale.
fn id_color(id: &[u64]) -> Color {
    let mut random = Random::new(id);
    let color = Color::from_array(std::array::from_fn(|_| random.next_f32()));
    0.25 + 0.75 * color
}
