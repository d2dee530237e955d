//! Record → JSON and back. A report can be made again from this file.
//!
//! The schema is described, field by field, in `docs/report-schema.md`.

mod pretty;

pub(super) use pretty::pretty;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::Report;
use crate::analysis::Analysis;
use crate::record::{Comparison, SCHEMA_VERSION};

/// Why text cannot be read as a record.
#[derive(Debug, Error)]
pub enum ReadError {
    /// It is not JSON, a field is missing, or a field has the wrong type.
    #[error("not a record of a comparison: {0}")]
    Malformed(#[from] serde_json::Error),
    /// It has a schema version that this version of srt does not read.
    #[error(
        "the record has schema version {found}; this version of srt reads versions \
         {OLDEST_VERSION} to {SCHEMA_VERSION}"
    )]
    Version {
        /// The version in the record.
        found: u64,
    },
}

/// The oldest schema version that is read.
const OLDEST_VERSION: u64 = 1;

/// A record with its analysis, for programs that read the file.
#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    comparison: &'a Comparison,
    derived: &'a Analysis,
}

/// Writes a record and its analysis, with a line end.
pub(super) fn write(report: &Report<'_>) -> Result<String, serde_json::Error> {
    let document = Document { comparison: report.comparison, derived: &report.analysis };
    let compact = serde_json::to_string(&document)?;
    Ok(pretty(&compact) + "\n")
}

/// Reads a record. Unknown fields are ignored, and `derived` among them. In records of version 1, structures that were
/// slow traced single rays, evenly spread; their ratios are those of their times per ray.
///
/// # Errors
/// If the text is not a record, or one of another version.
pub fn read(text: &str) -> Result<Comparison, ReadError> {
    #[derive(Deserialize)]
    struct Version {
        schema_version: u64,
    }
    let found = serde_json::from_str::<Version>(text)?.schema_version;
    if !(OLDEST_VERSION..=u64::from(SCHEMA_VERSION)).contains(&found) {
        return Err(ReadError::Version { found });
    }
    Ok(serde_json::from_str(text)?)
}
