//! Ctrl-C: the first asks the work to stop, the second ends the process at once.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::exit::Exit;
use super::output::abandon_and_exit;

/// Tells whether the work shall stop.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interrupt {
    asked: Arc<AtomicBool>,
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
        // The flag guards no other memory.
        self.asked.load(Ordering::Relaxed)
    }

    /// Asks the work to stop; tells whether that had been asked before.
    fn ask(&self) -> bool {
        self.asked.swap(true, Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_time_is_told_from_the_first() {
        let interrupt = Interrupt::default();
        assert!(!interrupt.is_asked());
        assert!(!interrupt.ask());
        assert!(interrupt.is_asked());
        assert!(interrupt.clone().ask());
    }
}
