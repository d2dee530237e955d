//! The default command: a scene → a picture. The layer `render` does the work; this file loads the
//! scene, shows progress, writes the picture, and prints the figures.

use std::path::Path;

use clap::CommandFactory;

use super::args::Arguments;
use super::exit::{CommandResult, Exit, Failure};
use super::figures::Figures;
use super::interrupt::Interrupt;
use super::load::{Loaded, SavedStructure};
use super::near::nearest;
use super::options::{RenderOptions, Stats};
use super::output::{OutputError, print};
use super::progress::Progress;
use super::refine::{Begun, Outcome, Refinement, StoppedBy};
use super::render_args::RenderArguments;
use super::sequence;
use super::structures::Structures;
use super::summary;
use super::terminal::print_message;
use crate::render::{Renderer, Settings, render};
use crate::scene::{BuildReport, Scene};

/// Renders; a rendering that a signal ended is written only with `--keep-partial` or `--progressive`.
pub(super) fn run(
    arguments: RenderArguments,
    structures: &Structures,
    interrupt: &Interrupt,
) -> CommandResult {
    if let Some(failure) = no_such_name(arguments.scene.as_deref()) {
        return Err(failure);
    }
    if let Some(frames) = arguments.frames {
        return sequence::run(arguments, frames, structures, interrupt);
    }
    let mut options = RenderOptions::new(arguments)?;
    let pool = options.work.pool()?;
    let Some(loaded) = options.work.load(&pool) else { return Ok(Exit::Trouble) };
    options.work.adopt(&loaded, structures)?;
    let (begun, settings) = pool.install(|| begin(&options, loaded))?;
    let traced = || trace(&begun, &settings, &options, interrupt);
    let (build, outcome) = pool.install(traced)?;
    conclude(&settings, &options, &build, outcome, interrupt)
}

/// What is needed of a scene that was loaded, as it is rendered.
pub(super) struct Begin {
    scene: Scene,
    built: Option<SavedStructure>,
    /// The state of a refinement, if it is refined.
    refined: Option<Begun>,
}

/// Keeps what is needed of a scene that was loaded; the rest of it is dropped.
pub(super) fn begin(options: &RenderOptions, loaded: Loaded) -> Result<(Begin, Settings), Failure> {
    options.refuse_to_replace_a_mesh(&loaded)?;
    let settings = options.settings(&loaded.scene)?;
    let begin = |refinement: &Refinement| refinement.begin(&loaded, &settings, options.work.quiet);
    let refined = options.refinement.as_ref().map(begin).transpose()?;
    Ok((Begin { scene: loaded.scene, built: loaded.built, refined }, settings))
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

/// Builds and renders, on the threads of the current pool.
pub(super) fn trace(
    begin: &Begin,
    settings: &Settings,
    options: &RenderOptions,
    interrupt: &Interrupt,
) -> Result<(BuildReport, Outcome), Failure> {
    let Begin { scene, built, refined } = begin;
    let world = options.work.build(scene, built.as_ref())?;
    let quiet = options.work.quiet;
    if let (Some(refinement), Some(begun)) = (&options.refinement, refined) {
        let renderer = Renderer::new(scene, &*world, settings);
        let watched = (quiet, interrupt);
        let outcome = refinement.run(begun, &renderer, settings, &options.picture, watched)?;
        return Ok((world.build_report(), outcome));
    }
    let progress = Progress::start(settings.region().pixels(), quiet, interrupt.clone());
    let render = || render(scene, &*world, settings, &progress);
    // What will not be written is not worth waiting for: the process ends at once.
    let words = match options.frames {
        Some(_) => progress.last_words_of_frame(options.work.frame),
        None => progress.last_words(" (see --keep-partial)"),
    };
    let rendering = interrupt.with_last_words(words, || {
        if options.keep_partial { interrupt.cancellable(render) } else { render() }
    });
    let stopped_by = (!rendering.complete).then_some(StoppedBy::Signal);
    Ok((world.build_report(), Outcome { rendering, stopped_by, noise: None, not_saved: None }))
}

/// Writes the picture, and prints the figures.
pub(super) fn conclude(
    settings: &Settings,
    options: &RenderOptions,
    build: &BuildReport,
    outcome: Outcome,
    interrupt: &Interrupt,
) -> CommandResult {
    let figures = Figures::new(options, settings, build, &outcome);
    let Outcome { rendering, stopped_by, noise, not_saved } = outcome;
    let refinement = options.refinement.as_ref();
    let is_kept = options.keep_partial || refinement.is_none_or(|own| own.progressive);
    let remarks = if is_kept || stopped_by.is_none() {
        Some(options.picture.write(rendering.image, settings.view)?)
    } else {
        None
    };
    let figures = figures.with_scale(remarks.as_ref().and_then(|remarks| remarks.scale));
    if let Some(stats) = options.stats {
        print_stats(&figures, stats)?;
    }
    if !options.work.quiet {
        if let Some(remarks) = &remarks {
            remarks.print();
        }
        let line = summary::line(&figures);
        match options.frames {
            Some(_) => print_message(format_args!("frame {}: {line}", figures.frame)),
            None => print_message(line),
        }
        if let Some(refinement) = refinement {
            refinement.say_what_is_left(stopped_by, noise, settings, remarks.is_some());
        }
    }
    if let Some(failure) = not_saved {
        return Err(failure);
    }
    Ok(if stopped_by == Some(StoppedBy::Signal) { interrupt.exit() } else { Exit::Fine })
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
