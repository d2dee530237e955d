//! The default command: a scene → a picture. The work is `render`'s; this file loads the scene,
//! shows progress, writes, and tells what it took.

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::exit::{Exit, Failure, Outcome};
use super::figures::Report;
use super::interrupt::Interrupt;
use super::load::{LoadError, Loaded, load};
use super::options::{RenderOptions, Stats};
use super::output::{OutputError, print};
use super::progress::Progress;
use super::render_args::RenderArguments;
use super::terminal::{tell, tell_error};
use super::{sight, summary};
use crate::image_io::encode;
use crate::render::{Rendering, Settings, render};
use crate::scene::{BuildError, BuildReport, Scene};

/// Renders; a rendering that Ctrl-C ended is written only if the options say so.
pub(super) fn run(arguments: RenderArguments, interrupt: &Interrupt) -> Outcome {
    let options = RenderOptions::new(arguments)?;
    let pool = pool(options.threads)?;
    let scene = match pool.install(|| load(&options.scene, options.lenient)) {
        Ok(Loaded { scene, warnings, .. }) => {
            if !options.quiet && !warnings.is_empty() {
                tell(warnings);
            }
            scene
        }
        Err(error) => return Ok(refuse(&error)),
    };
    let settings = options.settings(&scene)?;
    let traced = pool.install(|| trace(&scene, &settings, &options, interrupt));
    let refused = |error| Failure::new(format_args!("`{}`: {error}", options.structure.name));
    let (build, rendering) = traced.map_err(refused)?;
    conclude(&settings, options, build, rendering)
}

fn pool(threads: usize) -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| Failure::new(format_args!("cannot start {threads} threads: {error}")))
}

/// Tells why there is no scene.
fn refuse(error: &LoadError) -> Exit {
    if let LoadError::Invalid { text, .. } = error {
        tell(format_args!("{text}\n"));
    }
    tell_error(error);
    Exit::Trouble
}

/// Builds and renders, on the threads of the current pool.
fn trace(
    scene: &Scene,
    settings: &Settings,
    options: &RenderOptions,
    interrupt: &Interrupt,
) -> Result<(BuildReport, Rendering), BuildError> {
    let world = options.structure.try_build(scene, &options.build)?;
    let progress = Progress::start(settings.region().pixels(), options.quiet, interrupt.clone());
    let rendering = interrupt.heeded_by(|| render(scene, &*world, settings, &progress));
    Ok((world.build_report(), rendering))
}

/// Writes the picture and tells what it took.
fn conclude(
    settings: &Settings,
    options: RenderOptions,
    build: BuildReport,
    rendering: Rendering,
) -> Outcome {
    if !rendering.complete && !options.keep_partial {
        tell("interrupted; nothing was written (see --keep-partial)");
        return Ok(Exit::Interrupted);
    }
    let mut report = Report::new(&options, settings, build, &rendering);
    let (picture, scale) = sight::picture(rendering.image, settings.view, options.format);
    report.scale = scale;
    let bytes = encode(&picture, options.format).map_err(Failure::new)?;
    options.output.write(|to| to.write_all(&bytes))?;
    if let Some(stats) = options.stats {
        print_stats(&report, stats)?;
    }
    if !options.quiet {
        if let Some(scale) = scale {
            tell(sight::legend(settings.view, scale));
        }
        tell(summary::line(&report));
    }
    Ok(if report.partial { Exit::Interrupted } else { Exit::Fine })
}

fn print_stats(report: &Report, stats: Stats) -> Result<(), Failure> {
    let json = || report.to_json().map_err(Failure::new);
    match stats {
        Stats::Table => tell(summary::table(report)),
        Stats::Json { to_stderr: true } => tell(json()?.trim_end()),
        Stats::Json { to_stderr: false } => match print(&json()?) {
            // The picture is written; whoever wanted figures has seen enough.
            Ok(()) | Err(OutputError::BrokenPipe) => {}
            Err(error) => return Err(error.into()),
        },
    }
    Ok(())
}
