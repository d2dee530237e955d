//! The progress of a comparison: what is being done, and the time left for the whole plan.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::interrupt::Interrupt;
use super::ray_files::RayFolder;
use super::result_folder::ResultFolder;
use super::terminal::print_message;
use crate::compare::{ComparisonResult, Observer};
use crate::ray_file::RayFile;

/// Steps of the bar.
const STEPS: u64 = 1_000;

/// How often the bar is drawn anew.
const TICK: Duration = Duration::from_millis(250);

const TEMPLATE: &str = "{bar:24} {percent:>3} %  {eta} left  {msg}";

/// Watches a comparison: shows what is being done, saves what is done and the rays that it is to leave, and cancels it.
pub(super) struct CompareProgress<'a> {
    bar: ProgressBar,
    interrupt: Interrupt,
    rays: Option<&'a RayFolder>,
    /// Where what is done is saved.
    folder: Option<&'a ResultFolder>,
}

impl<'a> CompareProgress<'a> {
    /// Nothing is shown if `quiet` or if standard error is no terminal.
    pub(super) fn start(
        quiet: bool,
        interrupt: Interrupt,
        rays: Option<&'a RayFolder>,
        folder: Option<&'a ResultFolder>,
    ) -> Self {
        let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::hidden());
        if !quiet && std::io::stderr().is_terminal() {
            let style = ProgressStyle::with_template(TEMPLATE)
                .unwrap_or_else(|_| ProgressStyle::default_bar());
            bar.set_draw_target(ProgressDrawTarget::stderr());
            bar.set_style(style.progress_chars("█▉▊▋▌▍▎▏ "));
            bar.enable_steady_tick(TICK);
        }
        Self { bar, interrupt, rays, folder }
    }
}

impl Observer for CompareProgress<'_> {
    fn begins(&self, what: &str) {
        self.bar.set_message(what.to_owned());
    }

    fn advanced(&self, share: f64) {
        self.bar.set_position((share * STEPS as f64) as u64);
    }

    fn cancelled(&self) -> bool {
        self.interrupt.is_requested()
    }

    fn part_done(&self, so_far: &ComparisonResult) {
        // The disk may have room again until the report is written, which fails if not.
        let Some(folder) = self.folder else { return };
        if let Err(error) = folder.write_so_far(so_far) {
            let warning = format!("warning: what is done could not be saved: {error}");
            self.bar.suspend(|| print_message(warning));
        }
    }

    fn rays_recorded(&self, scene: &str, rays: &RayFile) {
        if let Some(folder) = self.rays {
            folder.write(scene, rays);
        }
    }
}

impl Drop for CompareProgress<'_> {
    /// Leaves the terminal as it was.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
