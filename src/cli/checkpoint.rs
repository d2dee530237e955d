//! The file of `--checkpoint`: what is rendered of a picture, saved whole or not at all, to go on from.

use std::path::{Path, PathBuf};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

use super::exit::Failure;
use super::inputs::refuse_to_replace_a_mesh;
use super::load::Loaded;
use super::output::{Output, OutputError};
use super::picture::PictureTarget;
use super::terminal::print_warning;
use super::work::Work;
use crate::assets::read_file;
use crate::film::Film;
use crate::part_file::{Kind, Origin, PartFile};

/// The place of a checkpoint, and how it is used.
#[derive(Debug)]
pub(crate) struct CheckpointFile {
    /// As typed.
    path: PathBuf,
    output: Output,
    interval: Duration,
    resume: bool,
}

impl CheckpointFile {
    /// Checks the place. A checkpoint that is there already is not replaced unless it is gone on with.
    pub(crate) fn new(
        path: PathBuf,
        interval: Duration,
        resume: bool,
        work: &Work,
        picture: &PictureTarget,
    ) -> Result<Self, Failure> {
        work.refuse_what_differs("--checkpoint")?;
        let named = path.display();
        let refuse = |why: &str| Failure::new(format_args!("--checkpoint `{named}`: {why}"));
        let output = Output::prepare(&path)?;
        if output.file().is_none() {
            return Err(refuse("it is no file, and only a file can be replaced whole"));
        }
        work.refuse_to_replace_the_scene(&output)?;
        if output.file() == picture.output.file() {
            return Err(refuse("it is the file of the picture: give it a name of its own"));
        }
        if !resume && path.exists() {
            return Err(refuse(
                "it is there already: go on with it by --resume, or delete it to begin anew",
            ));
        }
        Ok(Self { path, output, interval, resume })
    }

    /// Refuses to replace a mesh of the scene.
    pub(crate) fn refuse_to_replace_a_mesh(&self, loaded: &Loaded) -> Result<(), Failure> {
        refuse_to_replace_a_mesh(&self.output, "the checkpoint", loaded)
    }

    /// As it was typed.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Brings the film to where the file says that the same picture was left, if there is a file. Whether there is one.
    pub(crate) fn restore(&self, origin: &Origin, film: &Film) -> Result<bool, Failure> {
        if !self.resume || !self.path.exists() {
            return Ok(false);
        }
        let refuse = |why: &dyn std::fmt::Display| {
            Failure::new(format_args!("cannot resume from `{}`: {why}", self.path.display()))
        };
        let bytes = read_file(&self.path).map_err(|error| refuse(&error))?;
        let file = PartFile::decode(&bytes).map_err(|error| refuse(&error))?;
        drop(bytes);
        if let Some(difference) = origin.difference(&file.origin) {
            return Err(refuse(&format_args!("it is of another picture: it has {difference}")));
        }
        if let Kind::Part { share, .. } = file.kind {
            return Err(refuse(&format_args!(
                "it is part {share} of a picture: `srt assemble` puts parts together"
            )));
        }
        for part in file.parts {
            film.take(part).map_err(|error| refuse(&error))?;
        }
        Ok(true)
    }

    /// Writes what the film has.
    pub(crate) fn save(&self, origin: &Origin, film: &Film) -> Result<(), OutputError> {
        let parts = film.parts();
        let file = PartFile { origin: origin.clone(), kind: Kind::Checkpoint, parts };
        self.output.write_once_more(|to| file.write(to))
    }

    /// Does work, and saves what the film has at each interval meanwhile, from a thread of its own. A save that fails
    /// is warned of, once, and the work goes on.
    pub(crate) fn keeping<T>(&self, origin: &Origin, film: &Film, work: impl FnOnce() -> T) -> T {
        let end = End::default();
        std::thread::scope(|scope| {
            // Dropped when the work ends, however it ends: the thread is waited for.
            let _ended = EndAtDrop(&end);
            scope.spawn(|| self.keep(origin, film, &end));
            work()
        })
    }

    fn keep(&self, origin: &Origin, film: &Film, end: &End) {
        let mut saved = film.coverage();
        let mut warned = false;
        while !end.comes_within(self.interval) {
            let now = film.coverage();
            if now == saved {
                continue;
            }
            match self.save(origin, film) {
                Ok(()) => saved = now,
                Err(error) if !warned => {
                    print_warning(format_args!("{error}; the rendering goes on without it"));
                    warned = true;
                }
                Err(_) => {}
            }
        }
    }
}

/// The end of some work, that a thread waits for.
#[derive(Default)]
struct End {
    is_there: Mutex<bool>,
    came: Condvar,
}

impl End {
    /// Waits for the end, at most so long; whether it is there.
    fn comes_within(&self, time: Duration) -> bool {
        let is_there = self.is_there.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.came.wait_timeout_while(is_there, time, |is_there| !*is_there);
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }
}

struct EndAtDrop<'a>(&'a End);

impl Drop for EndAtDrop<'_> {
    fn drop(&mut self) {
        *self.0.is_there.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.0.came.notify_all();
    }
}
