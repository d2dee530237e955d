//! What was typed → what was validated: the options of a rendering, checked as far as possible before
//! the scene is read. Nothing here is optional that the rendering needs.

use std::fs;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;

use super::exit::Failure;
use super::output::{Output, prepare_picture};
use super::render_args::{RenderArguments, StatsForm};
use super::values::Size;
use crate::accel::{BuildConfig, Quality};
use crate::image_io::{Format, Tone};
use crate::render::{Crop, Sampling, Settings, View};
use crate::scene::{Scene, Structure};

/// All options of a rendering; what is absent is taken from the scene.
#[derive(Debug)]
pub(crate) struct RenderOptions {
    /// The scene's file.
    pub(crate) scene: PathBuf,
    /// Where the picture goes.
    pub(crate) output: Output,
    /// In which format.
    pub(crate) format: Format,
    /// The structure that is traced.
    pub(crate) structure: Structure,
    /// How it is built.
    pub(crate) build: BuildConfig,
    /// Threads that build and render.
    pub(crate) threads: usize,
    /// What replaces the options of the scene.
    pub(crate) overrides: Overrides,
    /// How the samples of lights are made.
    pub(crate) sampling: Sampling,
    /// The root of the number of samples of each area light.
    pub(crate) light_samples: u32,
    /// Where the random numbers start.
    pub(crate) seed: u64,
    /// The part to render, if not all.
    pub(crate) crop: Option<Crop>,
    /// What the pixels show.
    pub(crate) view: View,
    /// How its light is fitted into bytes.
    pub(crate) tone: Tone,
    /// Whether unknown commands are warnings.
    pub(crate) lenient: bool,
    /// Whether an interrupted rendering is written.
    pub(crate) keep_partial: bool,
    /// Which figures are printed, and to which stream.
    pub(crate) stats: Option<Stats>,
    /// Whether progress, warnings and the last line are left out.
    pub(crate) quiet: bool,
}

/// Options that a scene has too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Overrides {
    /// Instead of `nx` and `ny`.
    pub(crate) size: Option<Size>,
    /// Instead of `aasample`.
    pub(crate) aa: Option<u32>,
    /// Instead of `max_recursion`.
    pub(crate) max_recursion: Option<u32>,
}

/// The form of `--stats`, and the stream that it goes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stats {
    /// The table, on standard error.
    Table,
    /// JSON on standard output, or on standard error where the picture goes to standard output.
    Json {
        /// Which of the two.
        to_stderr: bool,
    },
}

impl RenderOptions {
    /// Validates what was typed, and checks the place of the picture.
    pub(crate) fn new(typed: RenderArguments) -> Result<Self, Failure> {
        let scene = typed.scene.ok_or_else(|| Failure::new("no scene was named"))?;
        let output = typed.output.ok_or_else(|| Failure::new("no output was named"))?;
        match (typed.size, typed.crop) {
            (Some(size), crop) => check_region(size.width, size.height, crop)?,
            (None, Some(crop)) => check_pixels(crop)?,
            (None, None) => {}
        }
        let (output, format) = prepare_picture(&output, typed.format)?;
        refuse_same_file(&scene, &output)?;
        let tone = Tone { exposure: typed.exposure, curve: typed.tone_curve };
        check_tone(tone, typed.view, format)?;
        Ok(Self {
            structure: typed.accel,
            build: build_config(typed.build),
            threads: threads(typed.threads)?,
            overrides: Overrides {
                size: typed.size,
                aa: typed.aa,
                max_recursion: typed.max_recursion,
            },
            sampling: typed.sampling,
            light_samples: typed.light_samples,
            seed: typed.seed,
            crop: typed.crop,
            view: typed.view,
            tone,
            lenient: typed.lenient,
            keep_partial: typed.keep_partial,
            stats: typed.stats.map(|form| stats(form, &output)),
            quiet: typed.quiet,
            scene,
            output,
            format,
        })
    }

    /// The settings of the renderer: what was typed, and the scene's options where nothing was.
    pub(crate) fn settings(&self, scene: &Scene) -> Result<Settings, Failure> {
        let of_scene = Settings::of_scene(scene);
        let size = self.overrides.size;
        let settings = Settings {
            width: size.map_or(of_scene.width, |size| size.width),
            height: size.map_or(of_scene.height, |size| size.height),
            crop: self.crop,
            aa: self.overrides.aa.unwrap_or(of_scene.aa),
            light_samples: self.light_samples,
            sampling: self.sampling,
            max_recursion: self.overrides.max_recursion.unwrap_or(of_scene.max_recursion),
            seed: self.seed,
            view: self.view,
            count: self.stats.is_some() && !self.structure.peer,
        };
        if self.view == View::Heatmap && self.structure.peer {
            let name = self.structure.name;
            return Err(Failure::new(format_args!("`{name}` counts no tests: it has no heatmap")));
        }
        check_region(settings.width, settings.height, settings.crop)?;
        check_samples(&settings)?;
        Ok(settings)
    }
}

/// A crop must lie within the picture, whose size may be known only from the scene, and what is
/// rendered must fit into memory.
fn check_region(width: u32, height: u32, crop: Option<Crop>) -> Result<(), Failure> {
    let Some(crop) = crop else {
        return check_pixels(Crop { x0: 0, y0: 0, x1: width, y1: height });
    };
    if crop.is_within(width, height) {
        return check_pixels(crop);
    }
    Err(Failure::new(format_args!(
        "the crop {crop} does not lie within the picture of {width}x{height} pixels"
    )))
}

fn check_pixels(region: Crop) -> Result<(), Failure> {
    if region.pixels() <= Settings::MAX_PIXELS {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "{}x{} pixels are too many to render at once: {} is the most; render parts with --crop",
        region.width(),
        region.height(),
        Settings::MAX_PIXELS,
    )))
}

/// Exposure and tone curve are for the light of the scene, and for formats that cannot hold all of it.
fn check_tone(tone: Tone, view: View, format: Format) -> Result<(), Failure> {
    if tone.is_neutral() {
        return Ok(());
    }
    if view != View::Color {
        return Err(Failure::new(format_args!(
            "--exposure and --tone-curve change the light of a picture, and --view {} shows none: \
             leave them out",
            view.name(),
        )));
    }
    if format.is_linear() {
        return Err(Failure::new(format_args!(
            "--exposure and --tone-curve are for .tga, .png and .ppm: .{format} holds the light as it \
             is, and what shows it chooses the exposure",
        )));
    }
    Ok(())
}

/// More threads than this for each processor only wait for each other: with hundreds of them, a
/// build of milliseconds takes seconds.
const MOST_THREADS_A_PROCESSOR: usize = 4;

/// As many threads as were typed, or one a processor.
fn threads(typed: Option<u16>) -> Result<usize, Failure> {
    let processors = available_parallelism().map_or(1, std::num::NonZero::get);
    let (threads, most) =
        (typed.map_or(processors, usize::from), MOST_THREADS_A_PROCESSOR * processors);
    if threads <= most {
        return Ok(threads);
    }
    let are =
        if processors == 1 { "1 processor is" } else { &format!("{processors} processors are") };
    Err(Failure::new(format_args!(
        "{threads} threads are too many: {are} available, and --threads may be {most} at most"
    )))
}

/// The samples of a pixel and of a light are made together, so they are limited together.
fn check_samples(settings: &Settings) -> Result<(), Failure> {
    let (aa, light, most) = (settings.aa.max(1), settings.light_samples, Settings::MAX_LIGHT_SIDE);
    if aa.saturating_mul(light) <= most {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "{aa} × {aa} samples a pixel with {light} × {light} of each light are too many: \
         --aa times --light-samples may be {most} at most"
    )))
}

/// A typing error (`srt scene.sce scene.sce --format png`) must not destroy the scene.
fn refuse_same_file(scene: &Path, output: &Output) -> Result<(), Failure> {
    let real = |path: &Path| fs::canonicalize(path).ok();
    let same = output.file().and_then(real).is_some_and(|file| real(scene) == Some(file));
    if same {
        return Err(Failure::new(format_args!(
            "the output would replace the scene `{}`",
            scene.display()
        )));
    }
    Ok(())
}

fn build_config(quality: Quality) -> BuildConfig {
    BuildConfig { quality, ..BuildConfig::default() }
}

fn stats(form: StatsForm, output: &Output) -> Stats {
    match form {
        StatsForm::Table => Stats::Table,
        StatsForm::Json => Stats::Json { to_stderr: output.is_stdout() },
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::super::args::Arguments;
    use super::*;

    fn options(typed: &[&str]) -> Result<RenderOptions, Failure> {
        let arguments = ["srt", "a.sce", "/dev/null"].iter().chain(typed);
        RenderOptions::new(Arguments::try_parse_from(arguments).unwrap().render)
    }

    #[test]
    #[cfg(unix)]
    fn defaults() {
        let options = options(&[]).unwrap();
        assert_eq!(options.structure.name, "bvh8");
        assert_eq!(options.build, BuildConfig::default());
        assert!(options.threads >= 1);
        assert_eq!(options.light_samples, 1);
        assert_eq!(options.view, View::Color);
        assert_eq!(options.sampling, Sampling::default());
        assert_eq!(options.stats, None);
    }

    #[test]
    #[cfg(unix)]
    fn figures_go_where_the_picture_does_not() {
        assert_eq!(options(&["--stats"]).unwrap().stats, Some(Stats::Table));
        let json = options(&["--stats=json"]).unwrap().stats;
        assert_eq!(json, Some(Stats::Json { to_stderr: false }));
        let to_pipe = stats(StatsForm::Json, &Output::stdout());
        assert_eq!(to_pipe, Stats::Json { to_stderr: true });
    }

    #[test]
    #[cfg(unix)]
    fn a_tone_is_for_light_in_bytes() {
        let refusal = |typed: &[&str]| options(typed).unwrap_err().to_string();
        assert!(options(&["--exposure", "-1.5", "--tone-curve", "filmic"]).is_ok());
        assert!(options(&["--exposure", "0", "--tone-curve", "none", "--format", "exr"]).is_ok());
        let floats = refusal(&["--exposure", "1", "--format", "exr"]);
        assert!(floats.contains(".exr holds the light as it is"), "{floats}");
        assert!(
            refusal(&["--tone-curve", "filmic", "--format", "hdr"]).contains(".tga, .png and .ppm")
        );
        let view = refusal(&["--exposure", "1", "--view", "depth"]);
        assert!(view.contains("--view depth shows none"), "{view}");
    }

    #[test]
    #[cfg(unix)]
    fn a_crop_outside_is_refused() {
        let message = options(&["--size", "10x10", "--crop", "0,0,11,10"]).unwrap_err();
        assert!(message.to_string().contains("0,0,11,10"), "{message}");
        assert!(options(&["--size", "10x10", "--crop", "0,0,10,10"]).is_ok());
    }

    #[test]
    #[cfg(unix)]
    fn more_pixels_than_fit_into_memory_are_refused() {
        let message = options(&["--size", "65535x65535"]).unwrap_err().to_string();
        assert!(message.contains("65535x65535") && message.contains("268435456"), "{message}");
        assert!(options(&["--crop", "0,0,16384,16385"]).is_err());
        assert!(options(&["--size", "16384x16384"]).is_ok());
        // What counts is what is rendered.
        assert!(options(&["--size", "65535x65535", "--crop", "60000,0,60100,100"]).is_ok());
    }

    #[test]
    fn threads_may_be_some_times_the_processors() {
        let processors = threads(None).unwrap();
        let most = 4 * processors;
        assert_eq!(threads(Some(most as u16)).unwrap(), most);
        let message = threads(Some(most as u16 + 1)).unwrap_err().to_string();
        assert!(message.contains(&format!("{processors} processor")), "{message}");
        assert!(message.contains(&format!("{most} at most")), "{message}");
    }

    #[test]
    fn the_scene_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("a.sce");
        fs::write(&scene, "sce1.0").unwrap();
        let scene = scene.to_str().unwrap();
        let typed = ["srt", scene, scene, "--format", "png"];
        let arguments = Arguments::try_parse_from(typed).unwrap().render;
        assert!(RenderOptions::new(arguments).unwrap_err().to_string().contains("replace"));
    }
}
