//! Builds: what they occupy, and how long they take.

use rayon::{ThreadPool, ThreadPoolBuilder};
use srt::accel::{BuildConfig, BuildStages};
use srt::analysis::statistics::median;
use srt::compare::measure::{fixed_rounds, timed};
use srt::report::{Cell, Table, markdown_table};
use srt::scene::{Scene, Structure, TracedWorld};

/// Builds all structures, on all threads, and prints what they occupy.
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

/// A build: its seconds, and its stages.
type Build = (f64, BuildStages);

/// Builds in interleaved rounds on one thread and on all, and prints the medians.
pub(crate) fn measure(
    structures: &[&Structure],
    scene: &Scene,
    rounds: usize,
) -> Result<(), String> {
    let pools = [pool(1)?, pool(0)?];
    // Task 2i is the i-th structure on one thread, task 2i + 1 on all.
    let builds = fixed_rounds(2 * structures.len(), rounds, |task| {
        let build = || structures[task / 2].build(scene, &BuildConfig::default());
        let (world, round) = pools[task % 2].install(|| timed(build));
        (round.wall_ns as f64 / 1e9, world.build_report().stages)
    });
    let all_threads = format!("#{} threads, s", pools[1].current_num_threads());
    let mut table = Table::new("", "", &["build", "#1 thread, s", &all_threads]);
    for (structure, builds) in structures.iter().zip(builds.chunks(2)) {
        let name = structure.name;
        table.rows.push(row(name.to_owned(), builds, |build| build.0));
        let stages = builds[0].first().into_iter().flat_map(|(_, stages)| stages.iter());
        table.rows.extend(stages.map(|(stage, _)| {
            row(format!("{name}: {stage}"), builds, |build| seconds_of(stage, &build.1))
        }));
    }
    println!("{}", markdown_table(&table));
    Ok(())
}

/// A line with the medians of some time, on one thread and on all.
fn row(name: String, builds: &[Vec<Build>], seconds: impl Fn(&Build) -> f64) -> Vec<Cell> {
    let median = |builds: &Vec<Build>| {
        let seconds: Vec<f64> = builds.iter().map(&seconds).collect();
        Cell::text(format!("{:.3}", median(&seconds).unwrap_or(f64::NAN)))
    };
    std::iter::once(Cell::text(name)).chain(builds.iter().map(median)).collect()
}

/// The seconds of a stage.
fn seconds_of(stage: &str, stages: &BuildStages) -> f64 {
    let own = stages.iter().filter(|(name, _)| *name == stage);
    own.map(|(_, time)| time.as_secs_f64()).sum()
}

fn pool(threads: usize) -> Result<ThreadPool, String> {
    ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())
}
