//! Grids of rays that run along an axis, or nearly: plans, probes of heights, straight shadows.

use glam::Vec3;

use crate::math::{Random, Ray};

use super::nasty_meshes::Mesh;

/// So many by so many rays of a grid, side by side, stand in a row.
const BLOCK: usize = 4;

/// The components across, for each grid in turn.
const ACROSS: [[f32; 2]; 6] =
    [[0.0, 0.0], [-0.0, 0.0], [1e-38, -0.0], [-1e-30, 1e-38], [-0.0, -1e-45], [1e-18, 0.0]];

/// Grids in all six directions. Of the first half of the rays sixteen in a row have one octant and
/// go together where a structure traces packets; in the other half the same are mixed.
///
/// A grid has `side` rays along each side; there are 36 grids.
///
/// # Panics
/// If the mesh has no vertex, or `side` is no multiple of four.
#[must_use]
pub fn grids_over(mesh: &Mesh, side: usize, seed: u64) -> Vec<Ray> {
    assert!(!mesh.positions.is_empty(), "a mesh without a vertex");
    assert!(side > 0 && side.is_multiple_of(BLOCK), "a grid is made of blocks of four by four");
    let mut random = Random::new(&[seed]);
    let mut rays = Vec::with_capacity(2 * 6 * ACROSS.len() * side * side);
    for direction in 0..6 {
        for across in ACROSS {
            let mut dir = Vec3::ZERO;
            let axes = [0, 1, 2].map(|next| (direction / 2 + next) % 3);
            dir[axes[0]] = if direction % 2 == 1 { -1.0 } else { 1.0 };
            (dir[axes[1]], dir[axes[2]]) = (across[0], across[1]);
            let mut grid = Grid::new(mesh, side, axes, dir, &mut random);
            for block in 0..(side / BLOCK).pow(2) {
                for place in 0..BLOCK * BLOCK {
                    let column = block / (side / BLOCK) * BLOCK + place / BLOCK;
                    let row = block % (side / BLOCK) * BLOCK + place % BLOCK;
                    rays.push(grid.ray(column, row));
                }
                // Now and then a ray of the same octant that is not along the axis.
                if (rays.len() / BLOCK.pow(2)).is_multiple_of(5) {
                    let last = rays.last_mut().expect("a block has rays");
                    last.dir += 0.2 * Vec3::ONE.copysign(last.dir);
                }
            }
        }
    }
    let mut mixed = rays.clone();
    for place in (1..mixed.len()).rev() {
        mixed.swap(place, random.below(place as u32 + 1) as usize);
    }
    rays.extend(mixed);
    rays
}

/// The coordinates across of a grid, and how its rays run.
struct Grid<'a> {
    /// The axes along and across.
    axes: [usize; 3],
    dir: Vec3,
    columns: Vec<f32>,
    rows: Vec<f32>,
    /// Where rays start.
    starts: Vec<f32>,
    random: &'a mut Random,
}

impl<'a> Grid<'a> {
    fn new(mesh: &Mesh, side: usize, axes: [usize; 3], dir: Vec3, random: &'a mut Random) -> Self {
        let columns = coordinates(mesh, side, axes[1], random);
        let rows = coordinates(mesh, side, axes[2], random);
        let mut starts = coordinates(mesh, side, axes[0], random);
        let (first, last) = (starts[0], starts[side - 1]);
        starts.extend([first - 3.0 * (last - first), last + 3.0 * (last - first)]);
        Self { axes, dir, columns, rows, starts, random }
    }

    fn ray(&mut self, column: usize, row: usize) -> Ray {
        let mut origin = Vec3::ZERO;
        let side = self.columns.len();
        let before = if self.dir[self.axes[0]] > 0.0 { side } else { side + 1 };
        // Two of three start before the mesh, the others anywhere in it or behind.
        let start = match self.random.below(3) {
            0 => self.random.below(self.starts.len() as u32) as usize,
            _ => before,
        };
        origin[self.axes[0]] = self.starts[start];
        origin[self.axes[1]] = self.columns[column];
        origin[self.axes[2]] = self.rows[row];
        let mut ray = Ray::new(origin, self.dir);
        if self.random.below(8) == 0 {
            let length = self.starts[side + 1] - self.starts[side];
            ray.t_max = length * self.random.next_f32();
        }
        ray
    }
}

/// Coordinates along an axis in ascending order: of corners, which are planes of boxes; of what is
/// just covered by the padding, or just not; and of what lies between.
fn coordinates(mesh: &Mesh, side: usize, axis: usize, random: &mut Random) -> Vec<f32> {
    let low = mesh.positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = mesh.positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let largest = low.abs().max(high.abs()).max_element();
    // The padding of a ray from among the boxes is between this and twice this.
    let pad = 16.0 * f32::EPSILON * largest;
    let mut all: Vec<f32> = (0..side)
        .map(|number| {
            let corner = mesh.positions[random.below(mesh.positions.len() as u32) as usize][axis];
            match number % 4 {
                0 => low[axis] + random.next_f32() * (high[axis] - low[axis]),
                1 => corner + pad * (6.0 * random.next_f32() - 3.0),
                _ => corner,
            }
        })
        .collect();
    all.sort_by(f32::total_cmp);
    all
}
