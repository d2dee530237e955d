//! An acceleration structure of one's own, from outside the crate: a uniform grid, after Amanatides
//! and Woo, *A Fast Voxel Traversal Algorithm for Ray Tracing*, 1987. It is held against the
//! library's structures, bit for bit, and timed beside them.
//!
//! `cargo run --release --example custom_accel`

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

use std::ops::{ControlFlow, Range};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use glam::{UVec3, Vec3A};
use srt::accel::{Accel, Bounded, BuildConfig, Built, Bvh, StructureShape};
use srt::assets::generate::{Kind, generate};
use srt::compare::{Plan, SceneInput, Silent, run};
use srt::counters::Counters;
use srt::math::{Aabb, BoxRay, Ray};
use srt::report::terminal;
use srt::scene::{Scene, Structure, structure_named};
use srt::scene_file::{ParseOptions, parse};

/// Cells of equal boxes. A primitive has a slot in every cell that its box meets; the slots of a
/// cell follow each other.
struct Grid {
    cells: UVec3,
    bounds: Aabb,
    /// Where each cell's slots begin; one entry more than there are cells.
    first: Vec<u32>,
    /// Which primitive each is.
    slots: Vec<u32>,
}

impl Grid {
    /// The range of cells along each axis that a box meets, one more on each side: a cell's planes
    /// are rounded, and a hit on a plane belongs to both of its sides.
    fn cells_of(&self, bounds: &Aabb) -> (UVec3, UVec3) {
        let scale = self.cells.as_vec3a() / self.bounds.size();
        let place = |p: Vec3A| ((p - self.bounds.min) * scale).as_ivec3();
        let last = self.cells.as_ivec3() - 1;
        let low = (place(bounds.min) - 1).clamp(glam::IVec3::ZERO, last);
        let high = (place(bounds.max) + 1).clamp(glam::IVec3::ZERO, last);
        (low.as_uvec3(), high.as_uvec3())
    }

    fn index(&self, cell: UVec3) -> usize {
        ((cell.z * self.cells.y + cell.y) * self.cells.x + cell.x) as usize
    }

    fn cell_bounds(&self, cell: UVec3) -> Aabb {
        let size = self.bounds.size() / self.cells.as_vec3a();
        let min = self.bounds.min + cell.as_vec3a() * size;
        Aabb { min, max: min + size }
    }
}

impl Accel for Grid {
    fn build(primitives: &impl Bounded, _: &BuildConfig) -> Built<Self> {
        let count = primitives.count();
        let mut bounds = primitives.total_bounds();
        if count == 0 {
            bounds = Aabb { min: Vec3A::ZERO, max: Vec3A::ONE };
        }
        // A flat box is made a little thick, so that its cells have an inside.
        let size = bounds.size().max(Vec3A::splat(1e-3 * bounds.size().max_element().max(1e-30)));
        bounds.max = bounds.min + size;
        // About as many cells as primitives, as near to cubes as the box allows.
        let edge = (size.element_product() / count.max(1) as f32).cbrt();
        let cells = (size / edge).ceil().clamp(Vec3A::ONE, Vec3A::splat(128.0)).as_uvec3();
        let mut grid = Self { cells, bounds, first: Vec::new(), slots: Vec::new() };
        let mut lists = vec![Vec::new(); cells.element_product() as usize];
        for primitive in 0..count {
            let (low, high) = grid.cells_of(&primitives.bounds(primitive));
            for (x, y, z) in all(low, high) {
                lists[grid.index(UVec3::new(x, y, z))].push(primitive);
            }
        }
        grid.first.push(0);
        for list in lists {
            grid.slots.extend(list);
            grid.first.push(grid.slots.len() as u32);
        }
        Built { accel: grid, order: None }
    }

    /// Walks from cell to cell. The contract asks that nothing is left out that an exact walk with
    /// padding would meet: cells hold primitives of their neighbours too, and those are wider than
    /// the padding of any ray that starts near the grid; rays from far away test everything.
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        if self.slots.is_empty() {
            return;
        }
        counters.boxes(1);
        let (near, far) = box_ray.interval(&self.bounds);
        if near > ray.t_max.min(far) || far < ray.t_min {
            return;
        }
        let size = self.bounds.size() / self.cells.as_vec3a();
        let (mut end, start) = (ray.t_max, near.max(ray.t_min));
        let entry = Vec3A::from(ray.origin) + start * Vec3A::from(ray.dir);
        let walks = entry.is_finite() && 4.0 * box_ray.pad < size.min_element();
        let last = self.cells - 1;
        let place = ((entry - self.bounds.min) / size).as_ivec3();
        let mut cell = place.clamp(glam::IVec3::ZERO, last.as_ivec3()).as_uvec3();
        loop {
            let cells = if walks { cell..=cell } else { UVec3::ZERO..=last };
            for (x, y, z) in all(*cells.start(), *cells.end()) {
                let index = self.index(UVec3::new(x, y, z));
                for &primitive in
                    &self.slots[self.first[index] as usize..self.first[index + 1] as usize]
                {
                    match leaf(primitive..primitive + 1, counters) {
                        ControlFlow::Continue(t) => end = t,
                        ControlFlow::Break(()) => return,
                    }
                }
            }
            // To the neighbour behind the nearest of the cell's far planes.
            let bounds = self.cell_bounds(cell);
            let dir = Vec3A::from(ray.dir);
            let plane = Vec3A::select(dir.cmpgt(Vec3A::ZERO), bounds.max, bounds.min);
            let leaves = (plane - Vec3A::from(ray.origin)) * box_ray.inv_dir;
            let leaves = Vec3A::select(dir.cmpeq(Vec3A::ZERO), Vec3A::MAX, leaves);
            let axis = (0..3).min_by(|&a, &b| leaves[a].total_cmp(&leaves[b])).unwrap_or(0);
            let forward = dir[axis] > 0.0;
            let at_border = if forward { cell[axis] == last[axis] } else { cell[axis] == 0 };
            // Hits of this cell's neighbourhood may lie a little behind its plane; a cell more is
            // walked before the search ends.
            let margin = 2.0 * box_ray.pad * box_ray.inv_dir[axis].abs();
            if !walks || at_border || leaves[axis] - margin > end {
                return;
            }
            cell[axis] = if forward { cell[axis] + 1 } else { cell[axis] - 1 };
        }
    }

    fn shape(&self) -> StructureShape {
        let mut shape = StructureShape { nodes: 1, ..StructureShape::default() };
        self.first.windows(2).for_each(|ends| shape.add_leaf(ends[1] - ends[0], 1));
        shape.bytes = 4 * (self.first.len() + self.slots.len()) as u64;
        shape
    }
}

fn all(low: UVec3, high: UVec3) -> impl Iterator<Item = (u32, u32, u32)> {
    let row = move |y, z| (low.x..=high.x).map(move |x| (x, y, z));
    (low.z..=high.z).flat_map(move |z| (low.y..=high.y).flat_map(move |y| row(y, z)))
}

const SCENE: &str = "sce1.0
eyepos 0.3 -3.2 1.4
eyedir -0.3 3.2 -1.4
eyeup 0 0 1
wdist 1
fovy_deg 38
nx 240
ny 160
max_recursion 2
cp 0.2 0.2 0.2
object_phong generate:torus-knot:20000
{
translate -3 -2 4
pointlight 0 0 0 0.9 0.9 0.9
}
end
";

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let parsed = parse(SCENE, &ParseOptions::default()).map_err(|errors| format!("{errors:?}"))?;
    let knot = Arc::new(generate(Kind::TorusKnot, 20_000, 0));
    let scene = Scene::new(&parsed.description, vec![knot])
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))?;
    let input = SceneInput {
        name: "knot".to_owned(),
        path: "examples/custom_accel.rs".to_owned(),
        hash: String::new(),
        scene,
    };
    let mut plan = Plan::of_scenes(vec![input]);
    plan.budget = Some(Duration::from_secs(10));
    // A tree over the objects, the grid over the triangles of each mesh.
    let grid = Structure::new::<Bvh, Grid>("grid", "a uniform grid over triangles");
    let library = ["none", "bvh"].into_iter().filter_map(structure_named).copied();
    let structures: Vec<Structure> = library.chain([grid]).collect();
    let outcome = run(&plan, &structures, &Silent)?;
    println!("{}", terminal::write(&outcome.comparison));
    for entry in outcome.comparison.scenes.iter().flat_map(|s| &s.proof).flat_map(|p| &p.structures)
    {
        println!(
            "{}: {} rays checked, {} differ",
            entry.structure, entry.rays_checked, entry.differing_hits
        );
        entry.first_difference.iter().for_each(|difference| println!("  {difference}"));
    }
    Ok(if outcome.holds() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
