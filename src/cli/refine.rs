//! A rendering in passes: the picture gets better until all samples are there, or time is up, or little noise is left,
//! or a signal ends it; and what there is is saved to go on from.

use std::time::{Duration, Instant};

use super::checkpoint::CheckpointFile;
use super::exit::Failure;
use super::interrupt::Interrupt;
use super::load::Loaded;
use super::origin::origin;
use super::picture::PictureTarget;
use super::progress::Progress;
use super::terminal::print_message;
use crate::film::{Coverage, Film, doubling_passes, even_passes};
use crate::part_file::Origin;
use crate::render::{Image, Kept, Observer, RenderStats, Renderer, Rendering, Settings, View};

/// Between two pictures on the way there is at least this time.
const BETWEEN_PICTURES: Duration = Duration::from_secs(1);

/// And so many times that which the last one took to write: pictures take a small share of the time.
const TIMES_WRITING: u32 = 20;

/// The noise of fewer samples a pixel than this is too uncertain to stop at.
const SAMPLES_FOR_NOISE: f64 = 4.0;

/// How a picture is refined.
#[derive(Debug)]
pub(crate) struct Refinement {
    /// Whether it is written on the way, and after a signal.
    pub(crate) progressive: bool,
    /// After which time of rendering to stop.
    pub(crate) time: Option<Duration>,
    /// With how much noise to stop.
    pub(crate) noise: Option<f64>,
    /// Where what there is is saved.
    pub(crate) checkpoint: Option<CheckpointFile>,
}

/// Why a rendering stopped before all samples were there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StoppedBy {
    /// A signal that asked for it.
    Signal,
    /// `--time`.
    Time,
    /// `--noise`.
    Noise,
}

impl StoppedBy {
    /// The name in figures.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Signal => "signal",
            Self::Time => "time",
            Self::Noise => "noise",
        }
    }
}

/// A rendering, and what became of it.
#[derive(Debug)]
pub(crate) struct Outcome {
    /// What was rendered.
    pub(crate) rendering: Rendering,
    /// Why it is not all, if it is not.
    pub(crate) stopped_by: Option<StoppedBy>,
    /// The noise that is left, where it is known.
    pub(crate) noise: Option<f64>,
    /// Why the last checkpoint could not be written.
    pub(crate) not_saved: Option<Failure>,
}

/// A refinement before its first pass: what was rendered earlier, and what it states to be of.
pub(crate) struct Begun {
    film: Film,
    /// Where there is a checkpoint.
    origin: Option<Origin>,
}

impl Refinement {
    /// Begins, or goes on with a checkpoint.
    pub(crate) fn begin(
        &self,
        loaded: &Loaded,
        settings: &Settings,
        quiet: bool,
    ) -> Result<Begun, Failure> {
        let film = Film::with_moments(settings.region(), settings.film_samples());
        let origin = self.checkpoint.as_ref().map(|_| origin(loaded, settings));
        if let (Some(checkpoint), Some(origin)) = (&self.checkpoint, &origin) {
            let resumed = checkpoint.restore(origin, &film)?;
            if resumed && !quiet {
                let Coverage { samples, all_samples, .. } = film.coverage();
                let share = super::progress::share(samples, all_samples);
                let path = checkpoint.path().display();
                print_message(format_args!("going on from `{path}`: {share} is rendered"));
            }
        }
        Ok(Begun { film, origin })
    }

    /// Renders what is missing, until a reason to stop. Pictures on the way go to `target`.
    pub(crate) fn run(
        &self,
        begun: &Begun,
        renderer: &Renderer<'_>,
        settings: &Settings,
        target: &PictureTarget,
        (quiet, interrupt): (bool, &Interrupt),
    ) -> Result<Outcome, Failure> {
        let start = Instant::now();
        let film = &begun.film;
        let coverage = film.coverage();
        let progress = Progress::start(coverage.all_samples, quiet, interrupt.clone());
        progress.advance(coverage.samples);
        let deadline = self.time.and_then(|time| start.checked_add(time));
        let watch = Watch { progress: &progress, deadline };
        let pictures = Pictures { target, view: settings.view };
        let passes = || interrupt.cancellable(|| self.passes(film, renderer, &watch, &pictures));
        let passed = match (&self.checkpoint, &begun.origin) {
            (Some(checkpoint), Some(origin)) => checkpoint.keeping(origin, film, passes),
            _ => passes(),
        };
        drop(progress);
        // Whatever ended them: what is rendered is saved.
        let not_saved = match (&self.checkpoint, &begun.origin) {
            (Some(checkpoint), Some(origin)) => checkpoint.save(origin, film).err(),
            _ => None,
        };
        let (mut stats, stopped_by) = passed?;
        let coverage = film.coverage();
        let image = Image::of(film, settings.view);
        stats.time = start.elapsed();
        let complete = coverage.is_complete();
        Ok(Outcome {
            rendering: Rendering {
                image,
                complete,
                pixels: coverage.pixels,
                samples: coverage.samples,
                stats,
            },
            stopped_by: stopped_by.filter(|_| !complete),
            noise: film.noise(),
            not_saved: not_saved.map(Failure::from),
        })
    }

    /// Says what there is to do about a picture that is not what was asked for.
    pub(crate) fn say_what_is_left(
        &self,
        stopped_by: Option<StoppedBy>,
        noise: Option<f64>,
        settings: &Settings,
        is_written: bool,
    ) {
        if let (Some(most), None) = (self.noise, stopped_by) {
            let samples = settings.film_samples();
            match noise {
                Some(noise) if noise > most => print_message(format_args!(
                    "the noise is {noise:.2e} with all {samples} samples a pixel, more than {most}: give more \
                     by --aa"
                )),
                None => print_message(
                    "the noise of one sample a pixel is not known: give more by --aa, such as --aa 4",
                ),
                Some(_) => {}
            }
        }
        if let (Some(checkpoint), Some(_)) = (&self.checkpoint, stopped_by) {
            let path = checkpoint.path().display();
            let picture = if is_written { "" } else { "; no picture was written" };
            print_message(format_args!(
                "`{path}` has what is rendered: --resume goes on with it{picture}"
            ));
        }
    }

    /// The passes, and why they ended early.
    fn passes(
        &self,
        film: &Film,
        renderer: &Renderer<'_>,
        watch: &Watch<'_>,
        pictures: &Pictures<'_>,
    ) -> Result<(RenderStats, Option<StoppedBy>), Failure> {
        let passes = if self.progressive { doubling_passes } else { even_passes };
        let mut stats = RenderStats::default();
        let mut next_picture = Instant::now();
        for pass in passes(film.samples()) {
            let pieces = film.missing(pass.end);
            if pieces.is_empty() {
                continue;
            }
            stats.merge(&renderer.render(&pieces, Kept::Samples, watch, &|part| {
                let samples = part.piece.area.pixels() * part.piece.samples.len() as u64;
                let taken = film.take(part);
                debug_assert_eq!(taken, Ok(()), "the pieces are the film's own");
                watch.progress.advance(samples);
            }));
            if watch.cancelled() {
                let by_signal = watch.progress.cancelled();
                let why = if by_signal { StoppedBy::Signal } else { StoppedBy::Time };
                return Ok((stats, Some(why)));
            }
            let coverage = film.coverage();
            if coverage.is_complete() {
                break;
            }
            let is_enough = |noise| self.noise.is_some_and(|most| noise <= most);
            let is_certain = coverage.samples_per_pixel() >= SAMPLES_FOR_NOISE;
            if is_certain && film.noise().is_some_and(is_enough) {
                return Ok((stats, Some(StoppedBy::Noise)));
            }
            if self.progressive && Instant::now() >= next_picture {
                let written = pictures.write(film)?;
                next_picture = Instant::now() + BETWEEN_PICTURES.max(TIMES_WRITING * written);
            }
        }
        Ok((stats, None))
    }
}

/// The picture on the way.
struct Pictures<'a> {
    target: &'a PictureTarget,
    view: View,
}

impl Pictures<'_> {
    /// Writes the picture so far, if it goes to a file; how long that took.
    fn write(&self, film: &Film) -> Result<Duration, Failure> {
        let start = Instant::now();
        if self.target.output.file().is_some() {
            self.target.write(Image::of(film, self.view), self.view)?;
        }
        Ok(start.elapsed())
    }
}

/// Watches passes: counts rays, and stops them at a signal or when time is up.
struct Watch<'a> {
    progress: &'a Progress,
    deadline: Option<Instant>,
}

impl Observer for Watch<'_> {
    fn tile_done(&self, _: u64, rays: u64) {
        self.progress.tile_done(0, rays);
    }

    fn cancelled(&self) -> bool {
        let is_late = || self.deadline.is_some_and(|deadline| Instant::now() >= deadline);
        self.progress.cancelled() || is_late()
    }
}
