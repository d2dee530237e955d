//! The tables of a report, independent of the form that shows them.
//!
//! Markdown and HTML draw the same tables, so they show the same numbers. Nothing here writes Markdown or HTML.

mod baseline;
mod conformance;
mod growth;
mod overall;
mod rounds;
mod run;
mod sampling;
mod scene;
mod stages;

pub(super) use baseline::baseline_table;
pub(super) use conformance::conformance_table;
pub(super) use growth::{growth_tables, size_tables};
pub(super) use overall::{overall_table, proof_matrix};
pub(super) use rounds::round_table;
pub(super) use run::facts;
pub(super) use sampling::sampling_tables;
pub(super) use scene::{
    agreement, compared_without_difference, hardware_table, picture_table, proof_table, ray_table,
    rays_in_words, structure_name, structure_table,
};
pub(super) use stages::stage_table;

use super::numbers::{self, NOTHING};
use crate::record::Estimate;

/// A table with a title.
#[derive(Clone, Debug)]
pub struct Table {
    /// The title.
    pub title: String,
    /// How to read it; may be empty.
    pub note: String,
    /// The columns.
    pub columns: Vec<Column>,
    /// The rows, each with a cell for each column.
    pub rows: Vec<Vec<Cell>>,
}

/// A column's heading, and whether its cells are numbers.
#[derive(Clone, Debug)]
pub struct Column {
    /// The heading.
    pub head: String,
    /// Whether the cells are numbers, which are aligned to the right.
    pub numeric: bool,
}

/// The content of a cell.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The text or number.
    pub text: String,
    /// The 95 % interval of the number.
    pub spread: Option<String>,
}

impl Table {
    /// A table without rows. Columns whose heading starts with `#` hold numbers.
    #[must_use]
    pub fn new(title: impl Into<String>, note: impl Into<String>, heads: &[&str]) -> Self {
        let column = |head: &&str| {
            let number = head.strip_prefix('#');
            Column { head: number.unwrap_or(head).to_owned(), numeric: number.is_some() }
        };
        let columns = heads.iter().map(column).collect();
        Self { title: title.into(), note: note.into(), columns, rows: Vec::new() }
    }
}

/// What is shown in place of a number whose interval supports no statement.
const TOO_WIDE: &str = "too wide";

/// The interval of a measurement, or what is shown in its place where there were too few rounds or passes for one.
fn spread_or_dash(spread: Option<String>) -> Option<String> {
    spread.or_else(|| Some(NOTHING.to_owned()))
}

impl Cell {
    /// A text, or a number that has its digits already.
    #[must_use]
    pub fn text(text: impl Into<String>) -> Self {
        Self { text: text.into(), spread: None }
    }

    fn nothing() -> Self {
        Self::text(NOTHING)
    }

    /// A value as text, or a dash.
    fn of<T>(value: Option<T>, show: impl FnOnce(T) -> String) -> Self {
        value.map_or_else(Self::nothing, |value| Self::text(show(value)))
    }

    /// Value and interval of a number without a unit.
    fn estimate(estimate: Option<Estimate>) -> Self {
        estimate.map_or_else(Self::nothing, |estimate| Self {
            text: numbers::value(estimate),
            spread: spread_or_dash(numbers::spread(estimate)),
        })
    }

    /// The same of a number that structures are compared by: where its interval is too wide for that, the cell says so.
    pub(in crate::report) fn compared(estimate: Option<Estimate>) -> Self {
        let own = Self::estimate(estimate);
        match estimate {
            Some(wide) if wide.interval.is_some() && !wide.supports_a_statement() => {
                Self { text: TOO_WIDE.to_owned(), ..own }
            }
            _ => own,
        }
    }

    /// The same of a number that may be interpolated between measurements, and has no interval then.
    fn interpolated_or_measured(estimate: Option<Estimate>) -> Self {
        estimate.map_or_else(Self::nothing, |estimate| Self {
            text: numbers::value(estimate),
            spread: numbers::spread(estimate),
        })
    }

    /// Value and interval of a time in nanoseconds.
    fn time(estimate: Option<Estimate>) -> Self {
        estimate.map_or_else(Self::nothing, |estimate| {
            let (text, spread) = numbers::time_estimate(estimate);
            Self { text, spread: spread_or_dash(spread) }
        })
    }
}
