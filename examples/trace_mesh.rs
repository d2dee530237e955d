//! Rays into a mesh, without a scene or a picture: how the library is used for its structures
//! alone. Draws what the rays hit on the terminal, the near parts dark.
//!
//! `cargo run --release --example trace_mesh -- [mesh.obj]`

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

use std::path::Path;

use srt::accel::{BuildConfig, Bvh8, ClosestHit, Indexed};
use srt::assets::load_meshes;
use srt::description::MeshReference;
use srt::glam::Vec3;
use srt::math::{Hit, Ray};
use srt::shapes::TriangleSet;

const COLUMNS: usize = 72;
const ROWS: usize = 32;
const SHADES: &[u8] = b"@%#*+=-:.";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).unwrap_or_else(|| "generate:torus-knot:20000".to_owned());
    let meshes = load_meshes(&[MeshReference::new(name)], Path::new("."))
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))?;
    let (mesh, bounds) = (&meshes[0], meshes[0].bounds());

    // Any positions and triples of indices will do.
    let triangles = TriangleSet::new(&mesh.positions, &mesh.triangles);
    let bvh: Indexed<_, Bvh8> = Indexed::build(triangles, &BuildConfig::default());

    // Parallel rays from above, a ray for each character. Many rays in one slice are the fastest.
    let (low, size) = (Vec3::from(bounds.min), Vec3::from(bounds.size()));
    let above = low.z + 1.5 * size.z;
    let ray_at = |i: usize| {
        let x = ((i % COLUMNS) as f32 + 0.5) / COLUMNS as f32;
        let y = 1.0 - ((i / COLUMNS) as f32 + 0.5) / ROWS as f32;
        Ray::new(Vec3::new(low.x + x * size.x, low.y + y * size.y, above), Vec3::NEG_Z)
    };
    let rays: Vec<Ray> = (0..COLUMNS * ROWS).map(ray_at).collect();
    let mut hits = vec![Hit::MISS; rays.len()];
    bvh.answer(&ClosestHit, &rays, &mut hits);

    let shade = |hit: &Hit| {
        let depth = (hit.t - 0.5 * size.z) / size.z;
        let step = (depth * SHADES.len() as f32).clamp(0.0, SHADES.len() as f32 - 1.0);
        if hit.is_hit() { char::from(SHADES[step as usize]) } else { ' ' }
    };
    for row in hits.chunks(COLUMNS) {
        println!("{}", row.iter().map(shade).collect::<String>());
    }
    let found = hits.iter().filter(|hit| hit.is_hit()).count();
    println!("{found} of {} rays hit; built in {:?}", rays.len(), bvh.build_time());
    Ok(())
}
