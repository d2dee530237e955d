//! Rays a second of several structures on one thread, beside those of peers: for each mesh and each
//! class of rays, in interleaved rounds.
//!
//! `cargo bench --bench peers --features embree -- bunny.obj dragon.obj --rounds 15` measures the
//! meshes that are named and a generated hall; `--help` tells the rest. It prints Markdown.
//! Answers are checked first: structures must give equal hits, and a peer's must agree.

#![allow(clippy::print_stdout, reason = "this program is run for what it prints")]

mod builds;
mod check;
mod layers;
mod rays;
mod rounds;
mod table;
mod view;

use clap::Parser;
use srt::accel::{BuildConfig, Tracer};
use srt::scene::{Structure, structure_named};

use rays::Class;

/// What is measured.
#[derive(Debug, Parser)]
struct Arguments {
    /// OBJ files or recipes (`generate:terrain:1000000`); a hall of 279,000 triangles joins them.
    meshes: Vec<String>,
    /// Structures, with commas; ratios are to the first.
    #[arg(long, value_delimiter = ',', default_value = "embree,embree16,bvh,cwbvh")]
    structures: Vec<String>,
    /// Classes of rays, with commas.
    #[arg(long, value_delimiter = ',', default_value = "view,shadow,diffuse,mirror")]
    classes: Vec<Class>,
    /// Rounds, in each of which every structure traces every ray once.
    #[arg(long, default_value_t = 9)]
    rounds: usize,
    /// Rounds of builds, on one thread and on all.
    #[arg(long, default_value_t = 0)]
    builds: usize,
    /// Also the time of `bvh8` over that of its tree over the triangles alone.
    #[arg(long)]
    layers: bool,
    /// Side of the picture in pixels, a multiple of 16.
    #[arg(long, default_value_t = 1024)]
    size: u32,
    /// Without the hall.
    #[arg(long)]
    no_hall: bool,
    /// What `cargo bench` adds.
    #[arg(long, hide = true)]
    bench: bool,
}

/// The generated mesh that is always there.
const HALL: &str = "generate:hall:279000";

fn main() -> Result<(), String> {
    let mut arguments = Arguments::parse();
    if !arguments.no_hall {
        arguments.meshes.push(HALL.to_owned());
    }
    let structures = structures(&arguments.structures)?;
    let mut all = table::Ratios::new(&arguments.structures, &arguments.classes);
    for mesh in &arguments.meshes {
        let (scene, light) = view::scene_of(mesh, arguments.size)?;
        println!("\n## {mesh}: {} triangles\n", scene.triangle_count());
        let worlds = builds::build_all(&structures, &scene)?;
        if arguments.builds > 0 {
            builds::measure(&structures, &scene, arguments.builds)?;
        }
        let guide = structure_named("bvh").ok_or("there is no `bvh`")?;
        let guide = guide.build(&scene, &BuildConfig::default());
        let sets = rays::ray_sets(&scene, &*guide, light);
        let worlds: Vec<&dyn Tracer> = worlds.iter().map(|world| &**world as _).collect();
        let layers = arguments.layers.then(|| layers::Layers::new(&scene)).transpose()?;
        for set in sets.iter().filter(|set| arguments.classes.contains(&set.class)) {
            check::check(&structures, &worlds, &*guide, set)?;
            let times = rounds::interleaved(&worlds, set, arguments.rounds);
            all.add(set, &times);
            if let Some(layers) = &layers {
                layers.measure(set, arguments.rounds);
            }
        }
        all.print_mesh();
    }
    all.print_means();
    Ok(())
}

fn structures(names: &[String]) -> Result<Vec<&'static Structure>, String> {
    let named = |name: &String| structure_named(name).ok_or(format!("no structure is `{name}`"));
    names.iter().map(named).collect()
}
