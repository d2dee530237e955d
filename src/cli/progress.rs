//! The progress bar of a rendering: percent, million rays a second, time left. Shown on a terminal only.

use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use super::interrupt::Interrupt;
use super::summary::ray_rate;
use super::terminal::print_message;
use crate::render::Observer;

/// How often the bar is drawn anew, so that time passes on it even between tiles.
const TICK: Duration = Duration::from_millis(200);

/// What is done when the process ends within a rendering.
pub(crate) type LastWords = Box<dyn Fn() + Send>;

/// Watches a rendering: shows how much of it is done, and cancels it.
pub(crate) struct Progress {
    bar: ProgressBar,
    rays: Arc<AtomicU64>,
    interrupt: Interrupt,
}

impl Progress {
    /// Begins at no pixel, or no sample of a pixel, of so many. Nothing is shown if `quiet` or if standard error is no
    /// terminal.
    pub(crate) fn start(pixels: u64, quiet: bool, interrupt: Interrupt) -> Self {
        let rays = Arc::new(AtomicU64::new(0));
        let bar = ProgressBar::with_draw_target(Some(pixels), ProgressDrawTarget::hidden());
        if !quiet && std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            bar.set_style(style(Arc::clone(&rays)));
            bar.enable_steady_tick(TICK);
        }
        Self { bar, rays, interrupt }
    }

    /// So many more are rendered.
    pub(crate) fn advance(&self, rendered: u64) {
        self.bar.inc(rendered);
    }

    /// What is done when the process ends within the rendering: clears the bar, and says how far it came, and where to
    /// read more about that.
    pub(crate) fn last_words(&self, hint: &'static str) -> LastWords {
        self.at_end(move |share| {
            format!("interrupted: {share} rendered; nothing was written{hint}")
        })
    }

    /// The same within one frame of several.
    pub(crate) fn last_words_of_frame(&self, frame: u32) -> LastWords {
        self.at_end(move |share| {
            format!(
                "interrupted: {share} of frame {frame} rendered; it was not written, those before it are whole"
            )
        })
    }

    fn at_end(&self, words: impl Fn(String) -> String + Send + 'static) -> LastWords {
        let bar = self.bar.clone();
        Box::new(move || {
            // Clearing the bar also brings it to its end.
            let share = share(bar.position(), bar.length().unwrap_or(0));
            bar.finish_and_clear();
            print_message(words(share));
        })
    }
}

/// The share of a picture in pixels, in words: `37 %`. Rounded down, so that a part is never 100 %.
pub(crate) fn share(done: u64, all: u64) -> String {
    let percent = (u128::from(done) * 100).checked_div(u128::from(all));
    format!("{} %", percent.unwrap_or(0))
}

impl Observer for Progress {
    fn tile_done(&self, pixels: u64, rays: u64) {
        self.rays.fetch_add(rays, Ordering::Relaxed);
        self.bar.inc(pixels);
    }

    fn cancelled(&self) -> bool {
        self.interrupt.is_requested()
    }
}

impl Drop for Progress {
    /// Leaves the terminal as it was.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

fn style(rays: Arc<AtomicU64>) -> ProgressStyle {
    let rate = move |state: &ProgressState, to: &mut dyn Write| {
        let speed = ray_rate(rays.load(Ordering::Relaxed), state.elapsed().as_secs_f64());
        // Nothing can be done about a terminal that takes no text.
        let _ = to.write_str(&speed);
    };
    ProgressStyle::with_template("{bar:32} {percent:>3} %  {rate}  {eta} left")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .with_key("rate", rate)
        .progress_chars("█▉▊▋▌▍▎▏ ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_add_up() {
        let progress = Progress::start(100, true, Interrupt::default());
        progress.tile_done(30, 1_000);
        progress.tile_done(70, 500);
        assert_eq!(progress.bar.position(), 100);
        assert_eq!(progress.rays.load(Ordering::Relaxed), 1_500);
        assert!(!progress.cancelled());
    }

    #[test]
    fn a_part_is_less_than_the_whole() {
        assert_eq!(share(0, 0), "0 %");
        assert_eq!(share(999, 1_000), "99 %");
        assert_eq!(share(1_000, 1_000), "100 %");
    }

    #[test]
    fn the_template_is_valid() {
        let template = "{bar:32} {percent:>3} %  {rate}  {eta} left";
        assert!(ProgressStyle::with_template(template).is_ok());
    }
}
