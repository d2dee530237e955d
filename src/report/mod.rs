//! Record → bytes: JSON, CSV, Markdown, HTML and text for a terminal.
//!
//! Everything is made from a [`Comparison`](crate::record::Comparison) alone, so an old record
//! gives the same report again. Knows no files and traces no rays: who calls decides where bytes
//! go. All forms take their figures from [`Derived`](crate::record::derived::Derived) and round
//! them in one place, so they say the same numbers.
//!
//! ```
//! use srt::record::{Comparison, Run};
//! use srt::report::{html, json, verdict};
//!
//! let comparison = Comparison::new(Run::default(), "none");
//! assert_eq!(verdict(&comparison), "nothing was traced; no pictures were compared.");
//! let text = json::write(&comparison)?;
//! assert_eq!(json::read(&text)?, comparison);
//! assert!(html::write(&comparison, &html::Pictures::new()).starts_with("<!DOCTYPE html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod csv;
pub mod html;
pub mod json;
mod limits;
pub mod markdown;
pub(crate) mod numbers;
mod plot;
mod sampling_verdict;
mod tables;
pub mod terminal;
mod verdict;

pub use tables::{Cell, Column, Table};
pub use verdict::verdict;
