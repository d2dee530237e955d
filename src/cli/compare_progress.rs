//! The progress of a comparison: what is being done, and the time left for the whole plan.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::interrupt::Interrupt;
use crate::compare::Observer;

/// Steps of the bar.
const STEPS: u64 = 1_000;

/// How often the bar is drawn anew.
const TICK: Duration = Duration::from_millis(250);

const TEMPLATE: &str = "{bar:24} {percent:>3} %  {eta} left  {msg}";

/// Watches a comparison: shows what is being done, and cancels it.
pub(super) struct CompareProgress {
    bar: ProgressBar,
    interrupt: Interrupt,
}

impl CompareProgress {
    /// Nothing is shown if `quiet` or if standard error is no terminal.
    pub(super) fn start(quiet: bool, interrupt: Interrupt) -> Self {
        let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::hidden());
        if !quiet && std::io::stderr().is_terminal() {
            let style = ProgressStyle::with_template(TEMPLATE)
                .unwrap_or_else(|_| ProgressStyle::default_bar());
            bar.set_draw_target(ProgressDrawTarget::stderr());
            bar.set_style(style.progress_chars("█▉▊▋▌▍▎▏ "));
            bar.enable_steady_tick(TICK);
        }
        Self { bar, interrupt }
    }
}

impl Observer for CompareProgress {
    fn begins(&self, what: &str) {
        self.bar.set_message(what.to_owned());
    }

    fn advanced(&self, share: f64) {
        self.bar.set_position((share * STEPS as f64) as u64);
    }

    fn cancelled(&self) -> bool {
        self.interrupt.is_requested()
    }
}

impl Drop for CompareProgress {
    /// Leaves the terminal as it was.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
