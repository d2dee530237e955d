//! Turns: those who wait get theirs in the order in which they came, which a `Mutex` does not promise.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// A place for one at a time.
#[derive(Default)]
pub(super) struct Turns {
    numbers: Mutex<Numbers>,
    next: Condvar,
}

#[derive(Default)]
struct Numbers {
    /// The next who comes gets this.
    free: u64,
    /// Who has the turn.
    current: u64,
}

/// A turn; ends when it is dropped.
pub(super) struct Turn<'a>(&'a Turns);

impl Turns {
    /// Waits for a turn.
    pub(super) fn wait(&self) -> Turn<'_> {
        let mut numbers = self.lock();
        let own = numbers.free;
        numbers.free += 1;
        while numbers.current != own {
            numbers = self.next.wait(numbers).unwrap_or_else(PoisonError::into_inner);
        }
        Turn(self)
    }

    fn lock(&self) -> MutexGuard<'_, Numbers> {
        self.numbers.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        self.0.lock().current += 1;
        self.0.next.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;

    #[test]
    fn one_at_a_time_and_everyone_gets_a_turn() {
        let (turns, within, total) = (Turns::default(), AtomicU32::new(0), AtomicU32::new(0));
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..50 {
                        let _turn = turns.wait();
                        assert_eq!(within.fetch_add(1, Ordering::SeqCst), 0);
                        total.fetch_add(1, Ordering::SeqCst);
                        within.fetch_sub(1, Ordering::SeqCst);
                    }
                });
            }
        });
        assert_eq!(total.into_inner(), 200);
    }
}
