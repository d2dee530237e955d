//! Record → bytes: JSON, CSV, Markdown, HTML and text for a terminal.
//!
//! A [`Report`] is made from a [`Comparison`] alone, so an old record gives the same report again. It computes the
//! [`Analysis`] of the record once and writes every form from it. All forms round numbers in one place, so they print
//! the same ones. Nothing here traces a ray or opens a file: the caller decides where the bytes go.
//!
//! ```
//! use srt::record::{Comparison, Run};
//! use srt::report::{Pictures, Report, read_json};
//!
//! let comparison = Comparison::new(Run::default(), "none");
//! let report = Report::new(&comparison);
//! assert_eq!(report.verdict(), "nothing was traced; no results were compared.");
//! assert_eq!(read_json(&report.json()?)?, comparison);
//! assert!(report.html(&Pictures::new()).starts_with("<!DOCTYPE html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod csv;
mod figures;
mod html;
mod json;
mod limits;
mod markdown;
mod motion;
pub(crate) mod numbers;
mod plot;
mod sampling_verdict;
mod tables;
mod terminal;
mod verdict;

use std::collections::BTreeMap;

use crate::analysis::Analysis;
use crate::record::Comparison;
use plot::Looks;

pub use json::{ReadError, read as read_json};
pub use markdown::table_lines as markdown_table;
pub use motion::MotionReport;
pub use tables::{Cell, Column, Table};
pub(crate) use terminal::table_lines as terminal_table;

/// The bytes of the picture files that a record names, by these names.
pub type Pictures = BTreeMap<String, Vec<u8>>;

/// A record and its analysis, ready to be written in every form.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    comparison: &'a Comparison,
    analysis: Analysis,
}

impl<'a> Report<'a> {
    /// Analyses a record.
    #[must_use]
    pub fn new(comparison: &'a Comparison) -> Self {
        Self { comparison, analysis: Analysis::of(comparison) }
    }

    /// The record.
    #[must_use]
    pub fn comparison(&self) -> &'a Comparison {
        self.comparison
    }

    /// The comparison in one sentence: which structure is how many times as fast as which other, on which rays, with
    /// which interval, and whether the pictures are equal.
    ///
    /// It is the best supported finding over all scenes ([`Finding`](crate::analysis::Finding)); without scenes, how
    /// cost grows. If results differ it states only that, because times of unequal work cannot be compared.
    #[must_use]
    pub fn verdict(&self) -> String {
        verdict::verdict(self)
    }

    /// Human-readable JSON: the record's own fields and, in `derived`, its analysis for other programs. [`read_json`]
    /// computes that anew.
    ///
    /// # Errors
    /// None that a record can cause.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        json::write(self)
    }

    /// A CSV table with a line for each scene, structure and class of rays.
    #[must_use]
    pub fn csv(&self) -> String {
        csv::write(self)
    }

    /// A CSV table of the chapter on sampling; `None` without that chapter.
    #[must_use]
    pub fn sampling_csv(&self) -> Option<String> {
        csv::write_sampling(self)
    }

    /// A Markdown page. Pictures are linked as the files that the record names.
    #[must_use]
    pub fn markdown(&self) -> String {
        markdown::write(self)
    }

    /// A self-contained HTML page. A picture that is not among `pictures` is reported as missing.
    #[must_use]
    pub fn html(&self, pictures: &Pictures) -> String {
        html::write(self, pictures)
    }

    /// The plots of the page as SVG files, with names for them that end in `.svg`: for papers and slides. They follow
    /// light and dark, and name nothing outside.
    #[must_use]
    pub fn plots(&self) -> Vec<(String, String)> {
        let plots = figures::all(self).into_iter();
        plots.map(|(name, plot)| (format!("{name}.svg"), plot.file())).collect()
    }

    /// The looks of all structures of its scenes and sweeps.
    fn looks(&self) -> Looks {
        let scenes = self.comparison.scenes.iter().flat_map(|scene| &scene.structures);
        let points = self.comparison.sweeps.iter().flat_map(|sweep| &sweep.points);
        let names = scenes.map(|own| own.name.as_str());
        Looks::of(names.chain(points.map(|point| point.structure.as_str())))
    }

    /// Text for a terminal: a table for each scene, then the verdicts.
    #[must_use]
    pub fn terminal(&self) -> String {
        terminal::write(self)
    }

    /// Text for a terminal: what changed against the baseline; `None` if the record has none.
    #[must_use]
    pub fn terminal_changes(&self) -> Option<String> {
        self.comparison.baseline.as_ref().map(terminal::write_changes)
    }
}
