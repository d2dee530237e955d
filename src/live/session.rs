//! One who looks: commands in, the newest picture out.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use std::thread;

use super::command::Numbered;
use super::inbox::Inbox;
use super::update::{Pixels, Report, encode};
use super::worker::Worker;
use super::{CommandError, Studio, StudioError};

/// Someone who looks at the scene of a studio. Its thread ends when it is dropped.
pub struct Session {
    inbox: Arc<Inbox>,
    outbox: Arc<Outbox>,
    greeting: String,
}

/// What one has seen already.
#[derive(Debug, Default)]
pub struct Seen {
    serial: u64,
    pictures: Vec<u64>,
}

/// The newest of a session.
pub(super) struct Outbox {
    newest: Mutex<Newest>,
    changed: Box<dyn Fn() + Send + Sync>,
}

#[derive(Default)]
struct Newest {
    /// Counts what was put in.
    serial: u64,
    report: Option<Report>,
    pictures: Vec<Arc<Pixels>>,
}

impl Session {
    /// Starts the thread.
    pub(super) fn begin(
        studio: &Arc<Studio>,
        changed: Box<dyn Fn() + Send + Sync>,
    ) -> Result<(Self, Weak<Inbox>), StudioError> {
        let inbox: Arc<Inbox> = Arc::default();
        let outbox = Arc::new(Outbox { newest: Mutex::default(), changed });
        let greeting = super::greeting::text(studio);
        let worker = Worker::new(Arc::clone(studio), Arc::clone(&inbox), Arc::clone(&outbox));
        thread::Builder::new().name("session".to_owned()).spawn(move || worker.run())?;
        let weak = Arc::downgrade(&inbox);
        Ok((Self { inbox, outbox, greeting }, weak))
    }

    /// What there is to choose from, as JSON: to be sent first.
    #[must_use]
    pub fn greeting(&self) -> &str {
        &self.greeting
    }

    /// Carries out a command, given as JSON, as soon as the thread can.
    ///
    /// # Errors
    /// If it is no command.
    pub fn tell(&self, command: &str) -> Result<(), CommandError> {
        self.inbox.put(Numbered::read(command)?)
    }

    /// What there is to see that was not seen; `None` if that is nothing.
    ///
    /// Four bytes, the low one first, are the length of the JSON behind them; what follows are the pixels of the
    /// structures in their order, four bytes each, of as many bytes as the JSON says: none where they were seen.
    #[must_use]
    pub fn update(&self, seen: &mut Seen) -> Option<Vec<u8>> {
        let newest = self.outbox.lock();
        let report = newest.report.as_ref().filter(|_| newest.serial > seen.serial)?;
        let update = encode(report, &newest.pictures, &seen.pictures);
        seen.serial = newest.serial;
        seen.pictures = newest.pictures.iter().map(|picture| picture.serial).collect();
        Some(update)
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.inbox.close();
    }
}

impl Outbox {
    /// Puts the newest in, in place of what was there.
    pub(super) fn put(&self, report: Report, pictures: Vec<Arc<Pixels>>) {
        let mut newest = self.lock();
        newest.serial += 1;
        newest.report = Some(report);
        newest.pictures = pictures;
        drop(newest);
        (self.changed)();
    }

    fn lock(&self) -> MutexGuard<'_, Newest> {
        self.newest.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
