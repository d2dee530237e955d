//! What has arrived for a session's thread.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use super::CommandError;
use super::command::Numbered;

/// More commands than this are not kept waiting.
const MOST_WAITING: usize = 10_000;

/// Commands, and whether the session ends.
#[derive(Default)]
pub(super) struct Inbox {
    contents: Mutex<Contents>,
    filled: Condvar,
    /// How many times something arrived: what a renderer asks for between slices of rays.
    arrivals: AtomicU64,
}

#[derive(Default)]
struct Contents {
    commands: VecDeque<Numbered>,
    /// The studio has another scene, or an error.
    has_news: bool,
    closed: bool,
}

impl Contents {
    fn is_empty(&mut self) -> bool {
        self.commands.is_empty() && !self.has_news && !self.closed
    }
}

/// What was in an inbox.
pub(super) struct Mail {
    /// In their order.
    pub(super) commands: VecDeque<Numbered>,
    /// Whether the session is over.
    pub(super) closed: bool,
    /// How many times something had arrived.
    pub(super) arrivals: u64,
}

impl Inbox {
    /// Puts a command in.
    pub(super) fn put(&self, command: Numbered) -> Result<(), CommandError> {
        let mut contents = self.lock();
        if contents.commands.len() >= MOST_WAITING {
            return Err(CommandError::TooMany);
        }
        contents.commands.push_back(command);
        self.announce();
        Ok(())
    }

    /// Says that the studio has something new.
    pub(super) fn put_news(&self) {
        let mut contents = self.lock();
        contents.has_news = true;
        self.announce();
    }

    /// Says that the session is over.
    pub(super) fn close(&self) {
        let mut contents = self.lock();
        contents.closed = true;
        self.announce();
    }

    /// Takes all that is there; waits for something if there is no other work.
    pub(super) fn take(&self, has_work: bool) -> Mail {
        let mut contents = self.lock();
        if !has_work {
            let waited = self.filled.wait_while(contents, Contents::is_empty);
            contents = waited.unwrap_or_else(PoisonError::into_inner);
        }
        contents.has_news = false;
        Mail {
            commands: std::mem::take(&mut contents.commands),
            closed: contents.closed,
            arrivals: self.arrivals.load(Ordering::Relaxed),
        }
    }

    /// Waits for a time, or until something is there.
    pub(super) fn rest(&self, time: Duration) {
        drop(self.filled.wait_timeout_while(self.lock(), time, Contents::is_empty));
    }

    /// How many times something has arrived. Changes only after what arrived is there.
    pub(super) fn arrivals(&self) -> u64 {
        self.arrivals.load(Ordering::Relaxed)
    }

    /// Whether the session is over.
    pub(super) fn is_closed(&self) -> bool {
        self.lock().closed
    }

    /// Called with the lock held, so that whoever takes what arrived sees that it has.
    fn announce(&self) {
        self.arrivals.fetch_add(1, Ordering::Relaxed);
        self.filled.notify_all();
    }

    fn lock(&self) -> MutexGuard<'_, Contents> {
        self.contents.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
