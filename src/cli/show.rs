//! `srt show`: a structure over a scene as a page of pictures, level by level. The layer `show` draws them.

use std::io::IsTerminal;

use super::exit::{CommandResult, Exit, Failure};
use super::inputs::{refuse_to_replace, refuse_to_replace_a_mesh};
use super::output::Output;
use super::show_args::ShowArguments;
use super::source;
use super::structures::Structures;
use super::terminal::print_message;
use super::work::{Overrides, Typed, Work, build_config, check_region, threads};
use crate::render::{Sampling, Settings, Silent, View};
use crate::scene::Scene;
use crate::show::{Facts, SlideOptions, page, slides};

/// The width of pictures, unless another is asked for.
const WIDTH: u32 = 720;

/// Renders the pictures and writes the page.
pub(super) fn run(arguments: ShowArguments, structures: &Structures) -> CommandResult {
    let output = Output::prepare(&arguments.output)?;
    if output.is_stdout() && std::io::stdout().is_terminal() {
        return Err(Failure::new(
            "a page does not print well on a terminal: redirect standard output, or name a file",
        ));
    }
    refuse_to_replace(&output, "the page", "the scene", &arguments.scene)?;
    let levels = arguments.levels;
    let mut work = work(arguments)?;
    let pool = work.pool()?;
    let Some(loaded) = work.load(&pool) else { return Ok(Exit::Trouble) };
    refuse_to_replace_a_mesh(&output, "the page", &loaded)?;
    work.adopt(&loaded, structures)?;
    let scene = &loaded.scene;
    let settings = settings(&work, scene)?;
    // Checked by the view of cells: a structure without them has nothing to show.
    let world = pool.install(|| work.build(scene, loaded.built.as_ref()))?;
    let slides =
        pool.install(|| slides(scene, &*world, &settings, SlideOptions { levels }, &Silent));
    let build = world.build_report();
    let facts = Facts {
        structure: work.structure.name,
        summary: work.structure.summary,
        scene: &source::name(&work.scene),
        objects: scene.objects.len() as u64,
        build: &build,
    };
    let text = page(&facts, &slides).map_err(Failure::new)?;
    output.write(|to| to.write_all(text.as_bytes()))?;
    if !work.quiet {
        let shown = slides.iter().filter(|slide| slide.level.is_some()).count();
        let levels = if shown == 1 { "level" } else { "levels" };
        print_message(format_args!(
            "{shown} {levels} of {}, {} KB",
            facts.structure,
            text.len() / 1000
        ));
    }
    Ok(Exit::Fine)
}

/// What was typed, once it was validated.
fn work(typed: ShowArguments) -> Result<Work, Failure> {
    let threads = threads(typed.threads)?;
    if let Some(size) = typed.size {
        check_region(size.width, size.height, None)?;
    }
    Ok(Work {
        typed: Typed {
            frame: typed.frame.is_some(),
            structure: true,
            quality: typed.build.is_some(),
        },
        scene: typed.scene,
        frame: typed.frame.unwrap_or(0),
        structure: typed.accel,
        build: build_config(typed.build.unwrap_or_default()),
        threads,
        overrides: Overrides { size: typed.size, aa: typed.aa, max_recursion: None },
        sampling: Sampling::default(),
        light_samples: 1,
        seed: 0,
        crop: None,
        view: View::Cells,
        lenient: typed.lenient,
        quiet: typed.quiet,
    })
}

/// The settings of all pictures.
fn settings(work: &Work, scene: &Scene) -> Result<Settings, Failure> {
    let mut settings = work.settings(scene, false)?;
    if work.overrides.size.is_none() {
        let height = u64::from(WIDTH) * u64::from(settings.height) / u64::from(settings.width);
        (settings.width, settings.height) = (WIDTH, height.clamp(1, 4 * u64::from(WIDTH)) as u32);
    }
    Ok(settings)
}
