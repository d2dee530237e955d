//! The signals that ask a process to end: Ctrl-C, and what schedulers, `timeout` and closed terminals send.
//! They end it at once and leave no unfinished file. During work that can be cancelled, the first one
//! cancels it, and only the second ends the process.

use std::io;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use super::exit::Exit;
use super::output::abandon_and_exit;

/// Whether the process was asked to end, for work that can be cancelled.
#[derive(Clone, Default)]
pub(crate) struct Interrupt {
    shared: Arc<Shared>,
}

/// The atomics guard no other memory, so their order does not matter to anything else.
#[derive(Default)]
struct Shared {
    /// The number of the signal; 0 as long as there was none.
    signal: AtomicU8,
    /// Work is under way that stops by itself when it is requested.
    cancellable: AtomicBool,
    /// What to say when the process ends within the work that is under way.
    last_words: Mutex<Option<Box<dyn Fn() + Send>>>,
}

impl Interrupt {
    /// Takes the signals over from the system, which would end the process. Once a process.
    pub(crate) fn install() -> io::Result<Self> {
        let interrupt = Self::default();
        let handler = interrupt.clone();
        listen(move |signal| handler.receive(signal))?;
        Ok(interrupt)
    }

    /// Whether work that can be cancelled shall stop. Never true of other work, which the process ends
    /// with.
    pub(crate) fn is_requested(&self) -> bool {
        let received = self.shared.signal.load(Ordering::Relaxed) != 0;
        received && self.shared.cancellable.load(Ordering::Relaxed)
    }

    /// How the command ends if it was stopped: by the signal that was received.
    pub(crate) fn exit(&self) -> Exit {
        Exit::Interrupted(self.shared.signal.load(Ordering::Relaxed))
    }

    /// Runs work that looks at [`is_requested`](Self::is_requested) often, and stops by itself.
    pub(crate) fn cancellable<T>(&self, work: impl FnOnce() -> T) -> T {
        self.shared.cancellable.store(true, Ordering::Relaxed);
        let result = work();
        self.shared.cancellable.store(false, Ordering::Relaxed);
        result
    }

    /// Runs work; if the process ends meanwhile, `last_words` says how far it came.
    pub(crate) fn with_last_words<T>(
        &self,
        last_words: impl Fn() + Send + 'static,
        work: impl FnOnce() -> T,
    ) -> T {
        self.set_last_words(Some(Box::new(last_words)));
        let result = work();
        self.set_last_words(None);
        result
    }

    fn set_last_words(&self, words: Option<Box<dyn Fn() + Send>>) {
        *self.shared.last_words.lock().unwrap_or_else(PoisonError::into_inner) = words;
    }

    /// What a signal does.
    fn receive(&self, signal: u8) {
        if self.request(signal) {
            // The lock is held until the end: what comes after the work would make the words untrue.
            let words = self.shared.last_words.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(speak) = &*words {
                speak();
            }
            abandon_and_exit(self.exit().code().into());
        }
    }

    /// Requests that work stops. Whether the process is to end at once: there is no such work, or it
    /// was requested before.
    fn request(&self, signal: u8) -> bool {
        let again = self.shared.signal.swap(signal, Ordering::Relaxed) != 0;
        again || !self.shared.cancellable.load(Ordering::Relaxed)
    }
}

/// Calls `receive` with the number of each signal that would end the process, on a thread of its own.
#[cfg(unix)]
fn listen(receive: impl Fn(u8) + Send + 'static) -> io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXFSZ};

    let ignored = ignored_signals();
    let wanted = [SIGINT, SIGTERM, SIGHUP, SIGQUIT];
    let heard = wanted.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
    // A file that grows beyond the limit of files is an error of the write, not the end of the process.
    signal_hook::flag::register(SIGXFSZ, Arc::default())?;
    let mut signals = signal_hook::iterator::Signals::new(heard)?;
    let listener = std::thread::Builder::new().name("signals".to_owned());
    listener.spawn(move || {
        for signal in signals.forever() {
            receive(u8::try_from(signal).unwrap_or(u8::MAX));
        }
    })?;
    Ok(())
}

/// The signals that were ignored when the process began, as `nohup` and a shell's background jobs begin
/// it: bit n − 1 stands for signal n. They stay ignored. Only Linux tells without unsafe code; elsewhere
/// none counts as ignored.
#[cfg(unix)]
fn ignored_signals() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
}

/// Calls `receive` with the number of SIGINT when the process is asked to end.
#[cfg(not(unix))]
fn listen(receive: impl Fn(u8) + Send + 'static) -> io::Result<()> {
    /// The one that stands for all where there are no signals.
    const SIGINT: u8 = 2;
    ctrlc::set_handler(move || receive(SIGINT)).map_err(io::Error::other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_request_ends_what_the_first_cancels() {
        let interrupt = Interrupt::default();
        interrupt.cancellable(|| {
            assert!(!interrupt.is_requested());
            assert!(!interrupt.request(15));
            assert!(interrupt.is_requested());
            assert_eq!(interrupt.exit().code(), 143);
            assert!(interrupt.clone().request(2));
            assert_eq!(interrupt.exit().code(), 130);
        });
    }

    #[test]
    fn without_cancellable_work_the_first_request_ends_the_process() {
        let interrupt = Interrupt::default();
        interrupt.cancellable(|| {});
        assert!(interrupt.request(2));
    }

    #[test]
    fn last_words_are_those_of_the_work_under_way() {
        let interrupt = Interrupt::default();
        let has_words = || interrupt.shared.last_words.lock().unwrap().is_some();
        assert!(interrupt.with_last_words(|| {}, has_words));
        assert!(!has_words());
    }
}
