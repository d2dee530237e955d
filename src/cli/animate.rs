//! `srt animate`: a scene that moves and structures that follow it → a table of what that costs. The layer `compare`
//! measures, the layer `report` writes.

use std::path::Path;
use std::thread::available_parallelism;

use super::animate_args::AnimateArguments;
use super::compare_progress::CompareProgress;
use super::exit::{CommandResult, Exit, Failure};
use super::interrupt::Interrupt;
use super::load::{LoadError, SceneFile, print_load_error};
use super::output::{Output, make_folder, print};
use super::source;
use super::terminal::{print_error, print_message};
use crate::compare::{self, MeasuredMotion, MotionError, MotionPlan, measure_motion, offers};
use crate::record::{FramePicture, Motion};
use crate::report::MotionReport;
use crate::scene::{Scene, Structure};

/// The most pictures in the page.
const PICTURES: u32 = 24;

/// Measures the sequence, prints the table and writes the files.
pub(super) fn run(arguments: &AnimateArguments, interrupt: &Interrupt) -> CommandResult {
    let plan = plan(arguments)?;
    let files = arguments.out.as_deref().map(Files::prepare).transpose()?;
    if !arguments.quiet {
        compare::disturbances().iter().for_each(print_message);
    }
    let mut file = match SceneFile::read(&arguments.scene, arguments.lenient) {
        Ok(file) => file,
        Err(error) => return Ok(wrong_scene(&error)),
    };
    let mut warned = arguments.quiet;
    let scene_of = |frame| {
        let loaded = file.frame(frame)?;
        if !std::mem::replace(&mut warned, true) && !loaded.warnings.is_empty() {
            print_message(&loaded.warnings);
        }
        Ok::<Scene, LoadError>(loaded.scene)
    };
    let progress = CompareProgress::start(arguments.quiet, interrupt.clone(), None, None);
    let measured = interrupt.cancellable(|| measure_motion(&plan, scene_of, &progress));
    drop(progress);
    let MeasuredMotion { mut motion, pictures } = match measured {
        Ok(measured) => measured,
        Err(MotionError::Frame { why, frame }) => {
            let exit = wrong_scene(&why);
            print_message(format_args!("in frame {frame}"));
            return Ok(exit);
        }
        Err(error) => return Err(Failure::new(error)),
    };
    motion.scene = source::name(&arguments.scene);
    motion.run.command = std::env::args().collect::<Vec<_>>().join(" ");
    motion.run.date = jiff::Zoned::now().strftime("%Y-%m-%dT%H:%M:%S%:z").to_string();
    conclude(arguments, (&motion, &pictures), files, interrupt)
}

fn wrong_scene(error: &LoadError) -> Exit {
    print_load_error(error);
    Exit::Trouble
}

/// Prints the table, and writes the files.
fn conclude(
    arguments: &AnimateArguments,
    (motion, pictures): (&Motion, &[FramePicture]),
    files: Option<Files>,
    interrupt: &Interrupt,
) -> CommandResult {
    let report = MotionReport::new(motion);
    if let Some(files) = files {
        files.write(&report, pictures)?;
    }
    if !arguments.quiet {
        print(&report.terminal().replace(['\u{a0}', '\u{202f}'], " "))?;
    }
    if !report.holds() {
        print_error("answers differ: see the table");
        return Ok(Exit::Negative);
    }
    Ok(if motion.run.partial { interrupt.exit() } else { Exit::Fine })
}

/// What was typed, once it was validated.
fn plan(arguments: &AnimateArguments) -> Result<MotionPlan, Failure> {
    let (structures, strategies) = (arguments.structures(), arguments.strategies());
    if let Some(peer) = structures.iter().find(|structure| structure.peer) {
        return Err(Failure::new(format_args!(
            "`{}` is another program's: its answers need not be equal, and it is not kept ready for frames; choose \
             another --accel",
            peer.name
        )));
    }
    let frames = arguments.frames;
    if frames.first == frames.last {
        return Err(Failure::new(format_args!(
            "--frames {frames} is one frame, for which all is built: name a later one as the last, as in {}..{}",
            frames.first,
            frames.first + 9,
        )));
    }
    let offered = |own: &Structure| strategies.iter().any(|&strategy| offers(own, strategy));
    if !structures.iter().any(offered) {
        return Err(Failure::new(
            "none of these structures can follow in these ways: add `rebuild` to --strategies",
        ));
    }
    if !arguments.quiet {
        for own in structures.iter().filter(|own| !offered(own)) {
            let ways: Vec<&str> = strategies.iter().map(|strategy| strategy.name()).collect();
            print_message(format_args!(
                "note: {} offers none of: {}; it is left out",
                own.name,
                ways.join(", ")
            ));
        }
    }
    let processors = available_parallelism().map_or(1, std::num::NonZero::get);
    Ok(MotionPlan {
        structures,
        strategies,
        frames: [frames.first, frames.last],
        threads: arguments.threads.map_or(processors, usize::from),
        rounds: arguments.rounds,
        rays_per_class: arguments.rays as usize,
        size: [arguments.size.width, arguments.size.height],
        pictures: if arguments.out.is_some() { PICTURES } else { 0 },
    })
}

/// The files of a report.
struct Files([Output; 4]);

impl Files {
    /// Makes the folder, and checks that the files can be written.
    fn prepare(folder: &Path) -> Result<Self, Failure> {
        make_folder(folder)?;
        let file = |name: &str| Output::prepare(&folder.join(name));
        Ok(Self([
            file("motion.json")?,
            file("motion.md")?,
            file("motion.csv")?,
            file("motion.html")?,
        ]))
    }

    fn write(self, report: &MotionReport<'_>, pictures: &[FramePicture]) -> Result<(), Failure> {
        let json = report.json().map_err(Failure::new)?;
        let texts = [json, report.markdown(), report.csv(), report.html(pictures)];
        for (file, text) in self.0.into_iter().zip(texts) {
            file.write(|to| to.write_all(text.as_bytes()))?;
        }
        Ok(())
    }
}
