//! Ctrl-C: ends the process at once and leaves no unfinished file. During work that can be cancelled,
//! the first Ctrl-C cancels it, and only the second ends the process.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::exit::Exit;
use super::output::abandon_and_exit;

/// Whether Ctrl-C was pressed, for work that can be cancelled.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interrupt {
    flags: Arc<Flags>,
}

/// They guard no other memory, so their order does not matter to anything else.
#[derive(Debug, Default)]
struct Flags {
    /// Ctrl-C was pressed.
    requested: AtomicBool,
    /// Work is under way that stops by itself when it is requested.
    cancellable: AtomicBool,
}

impl Interrupt {
    /// Takes Ctrl-C over from the system, which would end the process. Once a process.
    pub(crate) fn install() -> Result<Self, ctrlc::Error> {
        let interrupt = Self::default();
        let handler = interrupt.clone();
        ctrlc::set_handler(move || {
            if handler.request() {
                abandon_and_exit(Exit::Interrupted as i32);
            }
        })?;
        Ok(interrupt)
    }

    /// Whether work shall stop.
    pub(crate) fn is_requested(&self) -> bool {
        self.flags.requested.load(Ordering::Relaxed)
    }

    /// Runs work that looks at [`is_requested`](Self::is_requested) often, and stops by itself.
    pub(crate) fn cancellable<T>(&self, work: impl FnOnce() -> T) -> T {
        self.flags.cancellable.store(true, Ordering::Relaxed);
        let result = work();
        self.flags.cancellable.store(false, Ordering::Relaxed);
        result
    }

    /// Requests that work stops. Whether the process is to end at once: there is no such work, or it
    /// was requested before.
    fn request(&self) -> bool {
        let again = self.flags.requested.swap(true, Ordering::Relaxed);
        again || !self.flags.cancellable.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_request_ends_what_the_first_cancels() {
        let interrupt = Interrupt::default();
        interrupt.cancellable(|| {
            assert!(!interrupt.is_requested());
            assert!(!interrupt.request());
            assert!(interrupt.is_requested());
            assert!(interrupt.clone().request());
        });
    }

    #[test]
    fn without_cancellable_work_the_first_request_ends_the_process() {
        let interrupt = Interrupt::default();
        interrupt.cancellable(|| {});
        assert!(interrupt.request());
    }
}
