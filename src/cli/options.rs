//! What was typed → what was validated: the options of a rendering, checked as far as possible before
//! the scene is read. Nothing here is optional that the rendering needs.

use super::checkpoint::CheckpointFile;
use super::exit::Failure;
use super::frames::{FrameRange, path_of_picture};
use super::inputs::refuse_to_replace_a_mesh;
use super::load::Loaded;
use super::output::Output;
use super::picture::PictureTarget;
use super::refine::Refinement;
use super::render_args::{RenderArguments, StatsForm};
use super::work::Work;
use crate::render::{Settings, View};
use crate::scene::Scene;

/// All options of a rendering.
#[derive(Debug)]
pub(crate) struct RenderOptions {
    /// What is rendered, and by what.
    pub(crate) work: Work,
    /// Where the picture goes, and how.
    pub(crate) picture: PictureTarget,
    /// How it is refined, if it is not rendered in one go.
    pub(crate) refinement: Option<Refinement>,
    /// Which frames are rendered, if not one alone.
    pub(crate) frames: Option<FrameRange>,
    /// Whether an interrupted rendering is written.
    pub(crate) keep_partial: bool,
    /// Which figures are printed, and to which stream.
    pub(crate) stats: Option<Stats>,
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
    /// Validates what was typed, and checks the places of the picture and of the checkpoint.
    pub(crate) fn new(typed: RenderArguments) -> Result<Self, Failure> {
        let scene = typed.scene.ok_or_else(|| Failure::new("no scene was named"))?;
        let output = typed.output.ok_or_else(|| Failure::new("no output was named"))?;
        let output = match typed.frames {
            Some(_) => output,
            None => path_of_picture(output, typed.work.frame)?,
        };
        let work = Work::new(scene, typed.work, typed.lenient, typed.quiet)?;
        let picture = PictureTarget::new(&output, &typed.picture)?;
        work.refuse_to_replace_the_scene(&picture.output)?;
        picture.check_tone(work.view)?;
        let checkpoint = typed.checkpoint.map(|path| {
            CheckpointFile::new(path, typed.checkpoint_interval, typed.resume, &work, &picture)
        });
        let refinement = Refinement {
            progressive: typed.progressive || typed.time.is_some() || typed.noise.is_some(),
            time: typed.time,
            noise: typed.noise,
            checkpoint: checkpoint.transpose()?,
        };
        let refines = refinement.progressive || refinement.checkpoint.is_some();
        if refinement.progressive && work.view == View::Heatmap {
            return Err(Failure::new(
                "--view heatmap shows what all rays of a pixel tested: it cannot be refined in passes",
            ));
        }
        if typed.noise.is_some() && work.view != View::Color {
            return Err(Failure::new(format_args!(
                "--noise is for the light of a picture, and --view {} has none: leave --noise out",
                work.view.name(),
            )));
        }
        Ok(Self {
            stats: typed.stats.map(|form| stats(form, &picture.output)),
            frames: typed.frames,
            refinement: refines.then_some(refinement),
            keep_partial: typed.keep_partial,
            picture,
            work,
        })
    }

    /// Refuses a picture or a checkpoint that would replace a mesh of the scene.
    pub(crate) fn refuse_to_replace_a_mesh(&self, loaded: &Loaded) -> Result<(), Failure> {
        let checkpoint = self.refinement.as_ref().and_then(|own| own.checkpoint.as_ref());
        refuse_to_replace_a_mesh(&self.picture.output, "the output", loaded)?;
        checkpoint.map_or(Ok(()), |checkpoint| checkpoint.refuse_to_replace_a_mesh(loaded))
    }

    /// The settings of the renderer: what was typed, and the scene's options where nothing was.
    pub(crate) fn settings(&self, scene: &Scene) -> Result<Settings, Failure> {
        self.work.settings(scene, self.stats.is_some())
    }
}

fn stats(form: StatsForm, output: &Output) -> Stats {
    match form {
        StatsForm::Table => Stats::Table,
        StatsForm::Json => Stats::Json { to_stderr: output.is_stdout() },
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use clap::Parser;

    use super::super::args::Arguments;
    use super::*;
    use crate::accel::BuildConfig;
    use crate::render::Sampling;

    fn options(typed: &[&str]) -> Result<RenderOptions, Failure> {
        let arguments = ["srt", "a.sce", "/dev/null"].iter().chain(typed);
        RenderOptions::new(Arguments::try_parse_from(arguments).unwrap().render)
    }

    #[test]
    #[cfg(unix)]
    fn defaults() {
        let options = options(&[]).unwrap();
        assert_eq!(options.work.structure.name, "bvh8");
        assert_eq!(options.work.build, BuildConfig::default());
        assert!(options.work.threads >= 1);
        assert_eq!(options.work.light_samples, 1);
        assert_eq!(options.work.view, View::Color);
        assert_eq!(options.work.sampling, Sampling::default());
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
