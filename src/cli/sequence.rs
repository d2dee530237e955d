//! `srt SCENE frames/####.png --frames 0..60`: a picture for each frame, each whole or not there.

use std::path::PathBuf;

use super::exit::{CommandResult, Exit, Failure};
use super::frames::{FrameNames, FrameRange, names_of_pictures};
use super::interrupt::Interrupt;
use super::load::{SceneFile, print_load_error};
use super::options::RenderOptions;
use super::output::make_folder;
use super::picture::PictureTarget;
use super::render::{begin, conclude, trace};
use super::render_args::{PictureArguments, RenderArguments};
use super::structures::Structures;
use super::terminal::print_message;

/// What becomes of the frames.
struct Sequence<'a> {
    frames: FrameRange,
    /// Where each goes; none where all go to standard output, one after the other.
    names: Option<FrameNames>,
    typed: PictureArguments,
    /// Those of this program.
    structures: &'a Structures,
}

/// Renders one frame after the other. The scene's file is read once, and its meshes are loaded once.
pub(super) fn run(
    mut arguments: RenderArguments,
    frames: FrameRange,
    structures: &Structures,
    interrupt: &Interrupt,
) -> CommandResult {
    let typed = arguments.picture.clone();
    let output = arguments.output.take().ok_or_else(|| Failure::new("no output was named"))?;
    let names = if output.as_os_str() == "-" { None } else { Some(names_of_pictures(&output)?) };
    let sequence = Sequence { frames, names, typed, structures };
    let first = sequence.path_of(frames.first);
    if let Some(folder) = first.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        make_folder(folder)?;
    }
    let mut options = RenderOptions::new(RenderArguments { output: Some(first), ..arguments })?;
    sequence.render(&mut options, interrupt)
}

impl Sequence<'_> {
    fn path_of(&self, frame: u32) -> PathBuf {
        self.names.as_ref().map_or_else(|| PathBuf::from("-"), |names| names.of_frame(frame))
    }

    fn render(&self, options: &mut RenderOptions, interrupt: &Interrupt) -> CommandResult {
        let pool = options.work.pool()?;
        let mut file = match SceneFile::read(&options.work.scene, options.work.lenient) {
            Ok(file) => file,
            Err(error) => {
                print_load_error(&error);
                return Ok(Exit::Trouble);
            }
        };
        let mut warned = String::new();
        for frame in self.frames.numbers() {
            options.work.frame = frame;
            options.picture = PictureTarget::new(&self.path_of(frame), &self.typed)?;
            options.work.refuse_to_replace_the_scene(&options.picture.output)?;
            let loaded = match pool.install(|| file.frame(frame)) {
                Ok(loaded) => loaded,
                Err(error) => {
                    print_load_error(&error);
                    print_message(self.what_is_written(frame));
                    return Ok(Exit::Trouble);
                }
            };
            // What is warned of in one frame usually is in all.
            if !options.work.quiet && !loaded.warnings.is_empty() && loaded.warnings != warned {
                print_message(&loaded.warnings);
            }
            warned.clone_from(&loaded.warnings);
            options.work.adopt(&loaded, self.structures)?;
            let options = &*options;
            let traced = || {
                let (begun, settings) = begin(options, loaded)?;
                let (build, outcome) = trace(&begun, &settings, options, interrupt)?;
                Ok::<_, Failure>((settings, build, outcome))
            };
            let (settings, build, outcome) = pool.install(traced)?;
            conclude(&settings, options, &build, outcome, interrupt)?;
        }
        Ok(Exit::Fine)
    }

    /// What is there when a frame is not.
    fn what_is_written(&self, frame: u32) -> String {
        match frame - self.frames.first {
            0 => format!("frame {frame} is wrong: nothing was written"),
            written => format!("frame {frame} is wrong: the {written} before it are written"),
        }
    }
}
