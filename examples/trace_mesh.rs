//! Rays into a mesh: the structures by themselves, without a scene or a picture. Draws what the
//! rays hit on the terminal, the near parts dark.
//!
//! `cargo run --release --no-default-features --example trace_mesh -- [mesh.obj]`

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

use std::f32::consts::TAU;

use srt::accel::{Bounded, BuildConfig, Bvh8, ClosestHit, Indexed};
use srt::glam::Vec3;
use srt::math::{Hit, Ray};
use srt::shapes::TriangleMesh;

const COLUMNS: usize = 72;
const ROWS: usize = 32;
const SHADES: &[u8] = b"@%#*+=-:.";

/// Positions, and three of their indices for each triangle.
type Mesh = (Vec<Vec3>, Vec<[u32; 3]>);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (positions, indices) = match std::env::args().nth(1) {
        Some(path) => read_obj(&std::fs::read_to_string(path)?)?,
        None => torus(160, 64),
    };
    let mesh = TriangleMesh::try_new(&positions, &indices)?;
    let bounds = mesh.total_bounds();
    let bvh: Indexed<_, Bvh8> = Indexed::build(mesh, &BuildConfig::default());

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

/// A torus around the z axis.
fn torus(around: u32, across: u32) -> Mesh {
    let position = |i: u32| {
        let (a, b) = (i / across, i % across);
        let (a, b) = (TAU * a as f32 / around as f32, TAU * b as f32 / across as f32);
        let from_axis = 2.0 + b.cos();
        Vec3::new(from_axis * a.cos(), from_axis * a.sin(), b.sin())
    };
    let quad = |i: u32| {
        let (a, b) = (i / across, i % across);
        let at = |a: u32, b: u32| a % around * across + b % across;
        [[at(a, b), at(a + 1, b), at(a + 1, b + 1)], [at(a, b), at(a + 1, b + 1), at(a, b + 1)]]
    };
    let all = 0..around * across;
    (all.clone().map(position).collect(), all.flat_map(quad).collect())
}

/// The positions and polygons of an OBJ file, without its other features: polygons become fans.
fn read_obj(text: &str) -> Result<Mesh, Box<dyn std::error::Error>> {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let numbers: Vec<f32> = words.take(3).map(str::parse).collect::<Result<_, _>>()?;
                let numbers = <[f32; 3]>::try_from(numbers).map_err(|_| "`v` needs 3 numbers")?;
                positions.push(Vec3::from_array(numbers));
            }
            Some("f") => {
                let index = |word: &str| -> Result<u32, Box<dyn std::error::Error>> {
                    let number: u32 = word.split('/').next().unwrap_or_default().parse()?;
                    Ok(number.checked_sub(1).ok_or("indices are counted from 1")?)
                };
                let corners = words.map(index).collect::<Result<Vec<_>, _>>()?;
                let first = *corners.first().ok_or("`f` needs corners")?;
                triangles.extend(corners[1..].windows(2).map(|pair| [first, pair[0], pair[1]]));
            }
            _ => {}
        }
    }
    Ok((positions, triangles))
}
