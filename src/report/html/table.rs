//! A table as HTML, in a box of its own that scrolls where the page is too narrow.

use maud::{Markup, html};

use crate::report::tables::{Cell, Column, Table};

/// Draws a table; without lines, nothing.
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
pub(super) fn bare(table: &Table) -> Markup {
    let mut last: Option<&str> = None;
    html! {
        div class="scroll" tabindex="0" {
            table {
                thead { tr { @for column in &table.columns { th scope="col" class=[class(column)] { (column.head) } } } }
                tbody {
                    @for row in &table.rows {
                        @let group = row.first().map(|cell| cell.text.as_str());
                        tr class=[(group != last && last.is_some()).then_some("new")] {
                            @for (cell, column) in row.iter().zip(&table.columns) { (cell_markup(cell, column)) }
                        }
                        @let () = last = group;
                    }
                }
            }
        }
    }
}

fn cell_markup(cell: &Cell, column: &Column) -> Markup {
    html! {
        td class=[class(column)] {
            (cell.text)
            @if let Some(spread) = &cell.spread { span class="spread" { (spread) } }
        }
    }
}

fn class(column: &Column) -> Option<&'static str> {
    column.numeric.then_some("number")
}
