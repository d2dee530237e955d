//! A table as HTML, in a box that scrolls if the page is too narrow.

use maud::{Markup, html};

use crate::report::tables::{Cell, Column, Table};

/// Characters up to which a text stays in one line.
const SHORT: usize = 24;

/// Draws a table; nothing without rows.
pub(super) fn table(table: &Table) -> Markup {
    html! {
        @if !table.rows.is_empty() {
            h3 { (table.title) }
            @if !table.note.is_empty() { p class="note" { (table.note) } }
            (bare(table))
        }
    }
}

/// The table without its heading.
pub(in crate::report) fn bare(table: &Table) -> Markup {
    let groups: Vec<&str> =
        table.rows.iter().filter_map(|row| Some(row.first()?.text.as_str())).collect();
    let repeats = |i: usize| i > 0 && groups.get(i) == groups.get(i - 1);
    let grouped = (0..groups.len()).any(repeats);
    html! {
        div class="scroll" tabindex="0" {
            table {
                thead { tr { @for column in &table.columns { th scope="col" class=[class(column)] { (&column.head) } } } }
                tbody {
                    @for (i, row) in table.rows.iter().enumerate() {
                        tr class=[row_class(grouped, repeats(i))] {
                            @for (cell, column) in row.iter().zip(&table.columns) { (cell_markup(cell, column)) }
                        }
                    }
                }
            }
        }
    }
}

/// Rows with the same first cell are a group; in all but its first row that cell is faint.
fn row_class(grouped: bool, repeats: bool) -> Option<&'static str> {
    grouped.then_some(if repeats { "again" } else { "new" })
}

fn cell_markup(cell: &Cell, column: &Column) -> Markup {
    let is_short = cell.text.chars().count() <= SHORT;
    html! {
        td class=[class(column).or(is_short.then_some("short"))] {
            (cell.text)
            @if let Some(spread) = &cell.spread { span class="spread" { (spread) } }
        }
    }
}

fn class(column: &Column) -> Option<&'static str> {
    column.numeric.then_some("number")
}
