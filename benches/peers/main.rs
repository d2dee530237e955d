//! Rays a second of several structures on one thread, beside those of peers: for each mesh and each
//! class of rays, in interleaved rounds.
//!
//! `cargo bench --bench peers --features embree -- bunny.obj dragon.obj --rounds 15` measures the
//! given meshes and a generated hall; `--help` lists all options. It prints Markdown. Results are
//! checked first: those of structures must be equal, those of a peer must agree on nearly all rays.

#![allow(clippy::print_stdout, reason = "this program is run for what it prints")]

mod builds;
mod check;
mod layers;
mod rays;
mod table;
mod view;

use clap::Parser;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use srt::accel::{BuildConfig, Tracer};
use srt::record::RayClass;
use srt::scene::{Structure, structure_named};

use rays::CLASSES;

/// What is measured.
#[derive(Debug, Parser)]
struct Arguments {
    /// OBJ files or recipes (`generate:terrain:1000000`); a hall of 279,000 triangles is added.
    meshes: Vec<String>,
    /// Structures, separated by commas; ratios are to the first.
    #[arg(long, value_delimiter = ',', default_value = "embree,embree16,bvh,cwbvh")]
    structures: Vec<String>,
    /// Classes of rays, separated by commas.
    #[arg(long, value_delimiter = ',', default_value = "view,shadow,diffuse,mirror",
        value_parser = class())]
    classes: Vec<RayClass>,
    /// Rounds, in each of which every structure traces every ray once.
    #[arg(long, default_value_t = 9)]
    rounds: usize,
    /// Rounds of builds, on one thread and on all.
    #[arg(long, default_value_t = 0)]
    builds: usize,
    /// Also print the ratio of the time of `bvh8` to that of its tree over the triangles alone.
    #[arg(long)]
    layers: bool,
    /// Side of the picture in pixels, a multiple of 16.
    #[arg(long, default_value_t = 1024)]
    size: u32,
    /// Leave out the ground below meshes that are not halls.
    #[arg(long)]
    no_ground: bool,
    /// Leave out the hall.
    #[arg(long)]
    no_hall: bool,
    /// Added by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// The generated mesh that is added to the others.
const HALL: &str = "generate:hall:279000";

fn main() -> Result<(), String> {
    let mut arguments = Arguments::parse();
    if !arguments.no_hall {
        arguments.meshes.push(HALL.to_owned());
    }
    let structures = structures(&arguments.structures)?;
    let machine = srt::compare::machine();
    println!("One thread of {}, {}.", machine.cpu, machine.instruction_set);
    let mut all = table::Ratios::new(&arguments.structures, &arguments.classes);
    for mesh in &arguments.meshes {
        let views = view::scenes_of(mesh, arguments.size, !arguments.no_ground)?;
        let scene = &views[0].0;
        println!("\n## {mesh}: {} triangles\n", scene.triangle_count());
        let worlds = builds::build_all(&structures, scene)?;
        if arguments.builds > 0 {
            builds::measure(&structures, scene, arguments.builds)?;
        }
        let reference = structure_named("bvh").ok_or("there is no `bvh`")?;
        let reference = reference.build(scene, &BuildConfig::default());
        let sets = rays::ray_sets(&views, &*reference);
        let worlds: Vec<&dyn Tracer> = worlds.iter().map(|world| &**world as _).collect();
        let layers = arguments.layers.then(|| layers::Layers::new(scene)).transpose()?;
        for set in sets.iter().filter(|set| arguments.classes.contains(&set.class)) {
            check::check(&structures, &worlds, &*reference, set)?;
            let times = rays::seconds(&worlds, set, arguments.rounds);
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

/// Takes the name of a class.
fn class() -> impl TypedValueParser<Value = RayClass> {
    PossibleValuesParser::new(CLASSES.map(RayClass::name)).try_map(|name| {
        let named = CLASSES.into_iter().find(|class| class.name() == name);
        named.ok_or_else(|| format!("there is no class `{name}`"))
    })
}

fn structures(names: &[String]) -> Result<Vec<&'static Structure>, String> {
    let named = |name: &String| structure_named(name).ok_or(format!("no structure is `{name}`"));
    names.iter().map(named).collect()
}
