//! Ctrl-C: ends the process at once and leaves no unfinished file; but where work is under way that
//! can stop by itself, the first asks it to, and only the second ends the process.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::exit::Exit;
use super::output::abandon_and_exit;

/// Tells whether the work shall stop.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interrupt {
    flags: Arc<Flags>,
}

/// They guard no other memory, so their order does not matter to anything else.
#[derive(Debug, Default)]
struct Flags {
    asked: AtomicBool,
    heeded: AtomicBool,
}

impl Interrupt {
    /// Takes Ctrl-C over from the system, which would end the process. Once a process.
    pub(crate) fn install() -> Result<Self, ctrlc::Error> {
        let interrupt = Self::default();
        let handler = interrupt.clone();
        ctrlc::set_handler(move || {
            if handler.ask() {
                abandon_and_exit(Exit::Interrupted as i32);
            }
        })?;
        Ok(interrupt)
    }

    /// Whether the work shall stop.
    pub(crate) fn is_asked(&self) -> bool {
        self.flags.asked.load(Ordering::Relaxed)
    }

    /// Runs work that looks at [`is_asked`](Self::is_asked) often, and stops by itself.
    pub(crate) fn heeded_by<T>(&self, work: impl FnOnce() -> T) -> T {
        self.flags.heeded.store(true, Ordering::Relaxed);
        let result = work();
        self.flags.heeded.store(false, Ordering::Relaxed);
        result
    }

    /// Asks the work to stop; tells whether nothing will, or did not when it was asked before.
    fn ask(&self) -> bool {
        let again = self.flags.asked.swap(true, Ordering::Relaxed);
        again || !self.flags.heeded.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_time_is_told_from_the_first() {
        let interrupt = Interrupt::default();
        interrupt.heeded_by(|| {
            assert!(!interrupt.is_asked());
            assert!(!interrupt.ask());
            assert!(interrupt.is_asked());
            assert!(interrupt.clone().ask());
        });
    }

    #[test]
    fn where_nothing_heeds_it_the_first_time_is_enough() {
        let interrupt = Interrupt::default();
        interrupt.heeded_by(|| {});
        assert!(interrupt.ask());
    }
}
