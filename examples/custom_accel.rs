//! An acceleration structure of one's own, from outside the crate: a uniform grid. It is held
//! against the library's structures, bit for bit, and measured beside them; if a hit differed, the
//! smallest ray that shows it would be printed.
//!
//! `cargo run --release --example custom_accel`

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

use std::ops::{ControlFlow, Range};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use srt::accel::{Accel, Bounded, BuildConfig, Built, Bvh, StructureShape, Tree};
use srt::assets::generate::{Kind, generate};
use srt::compare::{Plan, SceneInput, Silent, run};
use srt::counters::Counters;
use srt::math::{Aabb, BoxRay, Ray};
use srt::report::terminal;
use srt::scene::{Scene, Structure, structure_named};
use srt::scene_file::{ParseOptions, parse};

/// The cells of a grid in which the centre of any primitive lies: the box around these primitives,
/// and their slots.
struct Grid {
    cells: Vec<(Aabb, Range<u32>)>,
}

impl Accel for Grid {
    fn build(primitives: &impl Bounded, _: &BuildConfig) -> Built<Self> {
        // About as many cells as there are primitives in each.
        let side = f64::from(primitives.count()).powf(1.0 / 6.0).ceil() as f32;
        let all = primitives.total_bounds();
        let cell_of = |primitive: u32| {
            let place = (primitives.bounds(primitive).center() - all.min) / all.size();
            (side * place).to_array().map(|x| x.min(side - 1.0) as u32)
        };
        let mut order: Vec<u32> = (0..primitives.count()).collect();
        order.sort_by_cached_key(|&primitive| cell_of(primitive));
        let (mut cells, mut first) = (Vec::new(), 0);
        for cell in order.chunk_by(|&a, &b| cell_of(a) == cell_of(b)) {
            let boxes = cell.iter().map(|&primitive| primitives.bounds(primitive));
            let end = first + cell.len() as u32;
            cells.push((boxes.fold(Aabb::EMPTY, Aabb::union), first..end));
            first = end;
        }
        Built { accel: Self { cells }, order: Some(order) }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let mut end = ray.t_max;
        for (bounds, slots) in &self.cells {
            counters.boxes(1);
            let (near, far) = box_ray.interval(bounds);
            // Inclusive: a box that begins at the end may hold a tie.
            if near.max(ray.t_min) <= far.min(end) {
                match leaf(slots.clone(), counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
            }
        }
    }

    fn shape(&self) -> StructureShape {
        let mut shape = StructureShape { nodes: 1, ..StructureShape::default() };
        self.cells.iter().for_each(|(_, slots)| shape.add_leaf(slots.len() as u32, 1));
        shape.bytes = size_of_val(&self.cells[..]) as u64;
        shape
    }

    /// The grid as a tree of two levels, so that its end-point overlap is measured too.
    fn tree(&self) -> Option<Tree> {
        let root = (Aabb::EMPTY, 0..0);
        Some(Tree::of((root, &self.cells[..]), |(node, below), children| {
            children.extend(below.iter().map(|cell| (cell.clone(), &self.cells[..0])));
            node.clone()
        }))
    }
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
