//! The default command: a scene → a picture. The layer `render` does the work; this file loads the
//! scene, shows progress, writes the picture, and prints the figures.

use std::path::Path;

use clap::CommandFactory;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::args::Arguments;
use super::clipping::ClippingWarning;
use super::exit::{CommandResult, Exit, Failure};
use super::figures::Figures;
use super::interrupt::Interrupt;
use super::load::{Loaded, load, print_load_error};
use super::near::nearest;
use super::options::{RenderOptions, Stats};
use super::output::{OutputError, print};
use super::progress::Progress;
use super::render_args::RenderArguments;
use super::terminal::{print_message, print_warning};
use super::{image, summary};
use crate::image_io::encode;
use crate::render::{Rendering, Settings, View, render};
use crate::scene::{BuildError, BuildReport, Scene};

/// Renders; a rendering that a signal ended is written only with `--keep-partial`.
pub(super) fn run(arguments: RenderArguments, interrupt: &Interrupt) -> CommandResult {
    if let Some(failure) = no_such_name(arguments.scene.as_deref()) {
        return Err(failure);
    }
    let options = RenderOptions::new(arguments)?;
    let pool = pool(options.threads)?;
    let scene = match pool.install(|| load(&options.scene, options.lenient)) {
        Ok(Loaded { scene, warnings, .. }) => {
            if !options.quiet && !warnings.is_empty() {
                print_message(warnings);
            }
            scene
        }
        Err(error) => {
            print_load_error(&error);
            return Ok(Exit::Trouble);
        }
    };
    let settings = options.settings(&scene)?;
    let traced = pool.install(|| trace(&scene, &settings, &options, interrupt));
    let refused = |error| Failure::new(format_args!("`{}`: {error}", options.structure.name));
    let (build, rendering) = traced.map_err(refused)?;
    conclude(&settings, options, build, rendering, interrupt)
}

/// What to say of a scene that is a single word and no file: it was probably meant to be a subcommand.
fn no_such_name(scene: Option<&Path>) -> Option<Failure> {
    let scene = scene?;
    let typed = scene.to_str()?;
    let is_word = typed.starts_with(|c: char| c.is_ascii_alphabetic())
        && typed.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
    if !is_word || typed.len() > 40 || scene.exists() {
        return None;
    }
    let command = Arguments::command();
    // A subcommand behind options of rendering is taken for a scene.
    if command.find_subcommand(typed).is_some() {
        return None;
    }
    let hint = match nearest(typed, command.get_subcommands().map(clap::Command::get_name)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "`srt SCENE OUTPUT` renders, `srt help` lists the subcommands".to_owned(),
    };
    Some(Failure::new(format_args!("there is no scene and no subcommand `{typed}`; {hint}")))
}

fn pool(threads: usize) -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| Failure::new(format_args!("cannot start {threads} threads: {error}")))
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
    let render = || render(scene, &*world, settings, &progress);
    // What will not be written is not worth waiting for: the process ends at once.
    let rendering = interrupt.with_last_words(progress.last_words(), || {
        if options.keep_partial { interrupt.cancellable(render) } else { render() }
    });
    Ok((world.build_report(), rendering))
}

/// Writes the picture, and prints the figures.
fn conclude(
    settings: &Settings,
    options: RenderOptions,
    build: BuildReport,
    rendering: Rendering,
    interrupt: &Interrupt,
) -> CommandResult {
    let figures = Figures::new(&options, settings, &build, &rendering);
    let (mut picture, scale) = image::picture(rendering.image, settings.view, options.format);
    let figures = figures.with_scale(scale);
    let is_light = settings.view == View::Color && !options.quiet;
    let clipping = ClippingWarning::of(&picture, options.tone, options.format).filter(|_| is_light);
    options.tone.apply(&mut picture);
    let bytes = encode(&picture, options.format).map_err(Failure::new)?;
    options.output.write(|to| to.write_all(&bytes))?;
    if let Some(stats) = options.stats {
        print_stats(&figures, stats)?;
    }
    if !options.quiet {
        if let Some(clipping) = clipping {
            print_warning(clipping);
        }
        if let Some(scale) = scale {
            print_message(image::legend(settings.view, scale));
        }
        print_message(summary::line(&figures));
    }
    Ok(if figures.partial { interrupt.exit() } else { Exit::Fine })
}

fn print_stats(figures: &Figures, stats: Stats) -> Result<(), Failure> {
    let json = || figures.to_json().map_err(Failure::new);
    match stats {
        Stats::Table => print_message(summary::table(figures)),
        Stats::Json { to_stderr: true } => print_message(json()?.trim_end()),
        Stats::Json { to_stderr: false } => match print(&json()?) {
            // The picture is written; the reader of the figures has seen enough.
            Ok(()) | Err(OutputError::BrokenPipe) => {}
            Err(error) => return Err(error.into()),
        },
    }
    Ok(())
}
