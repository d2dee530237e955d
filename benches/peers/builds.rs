//! Builds.

use std::time::Instant;

use rayon::{ThreadPool, ThreadPoolBuilder};
use srt::accel::{BuildConfig, BuildStages};
use srt::analysis::statistics::median;
use srt::scene::{Scene, Structure, TracedWorld};

/// Builds all structures, on all threads, and tells what they occupy.
pub(crate) fn build_all(
    structures: &[&Structure],
    scene: &Scene,
) -> Result<Vec<Box<dyn TracedWorld>>, String> {
    let mut worlds = Vec::new();
    let mut memory = Vec::new();
    for structure in structures {
        let world = structure.try_build(scene, &BuildConfig::default());
        let world = world.map_err(|error| format!("`{}`: {error}", structure.name))?;
        let report = world.build_report();
        let index = (report.objects.bytes + report.meshes.bytes) as f64 / 1e6;
        let triangles = report.triangle_bytes as f64 / 1e6;
        memory.push(format!("{} {index:.1} + {triangles:.1}", structure.name));
        worlds.push(world);
    }
    println!("Megabytes of index + triangles: {}.\n", memory.join(", "));
    Ok(worlds)
}

/// Builds in interleaved rounds, and prints the medians.
pub(crate) fn measure(
    structures: &[&Structure],
    scene: &Scene,
    rounds: usize,
) -> Result<(), String> {
    let pools = [pool(1)?, pool(0)?];
    let mut times = vec![[vec![], vec![]]; structures.len()];
    let mut stages = vec![[vec![], vec![]]; structures.len()];
    for round in 0..rounds {
        for place in 0..structures.len() {
            let index = (place + round) % structures.len();
            for (threads, pool) in pools.iter().enumerate() {
                let start = Instant::now();
                let world =
                    pool.install(|| structures[index].build(scene, &BuildConfig::default()));
                times[index][threads].push(start.elapsed().as_secs_f64());
                stages[index][threads].push(world.build_report().stages);
            }
        }
    }
    println!("| build | 1 thread, s | {} threads, s |", pools[1].current_num_threads());
    println!("|---|--:|--:|");
    for ((structure, [one, all]), stages) in structures.iter().zip(&times).zip(&stages) {
        let [one, all] = [one, all].map(|times| median(times).unwrap_or(f64::NAN));
        println!("| {} | {one:.3} | {all:.3} |", structure.name);
        let names = stages[0].first().into_iter().flat_map(BuildStages::iter);
        for (name, _) in names {
            let [one, all] = [0, 1].map(|threads| median_of(name, &stages[threads]));
            println!("| {}: {name} | {one:.3} | {all:.3} |", structure.name);
        }
    }
    println!();
    Ok(())
}

/// The median of a stage's seconds.
fn median_of(stage: &str, rounds: &[BuildStages]) -> f64 {
    let seconds = |stages: &BuildStages| {
        stages.iter().filter(|(name, _)| *name == stage).map(|(_, time)| time.as_secs_f64()).sum()
    };
    median(&rounds.iter().map(seconds).collect::<Vec<f64>>()).unwrap_or(f64::NAN)
}

fn pool(threads: usize) -> Result<ThreadPool, String> {
    ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())
}
