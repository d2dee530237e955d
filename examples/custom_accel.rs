//! An acceleration structure of your own, from outside the crate: a grid of loose cells (`grid/mod.rs`).
//! It is held against no structure at all, bit for bit, by rays made to find differences, and
//! measured beside the library's structures; if a hit differed, the ray that shows it would be
//! printed.
//!
//! `cargo run --release --example custom_accel`

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

mod grid;

use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use srt::accel::Bvh;
use srt::assets::generate::{MeshKind, generate};
use srt::compare::{Plan, SceneInput, Silent, run};
use srt::conformance;
use srt::report::Report;
use srt::scene::{Scene, Structure, structure_named};
use srt::scene_file::{ParseOptions, parse};

use grid::Grid;

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
    println!("{}", conformance::check::<Grid>()?);
    let parsed = parse(SCENE, &ParseOptions::default()).map_err(|errors| format!("{errors:?}"))?;
    let knot = Arc::new(generate(MeshKind::TorusKnot, 20_000, 0));
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
    let grid = Structure::new::<Bvh, Grid>("loose-grid", "a grid of loose cells over triangles");
    let library = ["none", "bvh"].into_iter().filter_map(structure_named).copied();
    let structures: Vec<Structure> = library.chain([grid]).collect();
    let outcome = run(&plan, &structures, &Silent)?;
    println!("{}", Report::new(&outcome.comparison).terminal());
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
