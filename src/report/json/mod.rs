//! Record → JSON and back. All other reports are made from this one.
//!
//! The schema is described, field by field, in `docs/report-schema.md`.

mod pretty;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::record::derived::Derived;
use crate::record::{Comparison, SCHEMA_VERSION};

/// Why text is not a record.
#[derive(Debug, Error)]
pub enum ReadError {
    /// It is no JSON, or lacks a field, or a field has the wrong type.
    #[error("not a record of a comparison: {0}")]
    Malformed(#[from] serde_json::Error),
    /// It was written by a version of srt that this one does not understand.
    #[error(
        "the record has schema version {found}; this version of srt reads version {SCHEMA_VERSION}"
    )]
    Version {
        /// The version that the record says.
        found: u64,
    },
}

/// A record with the figures that follow from it, which readers other than srt may want.
#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    comparison: &'a Comparison,
    derived: Derived,
}

/// Writes a record: human-readable JSON with a line end.
///
/// Beside the record's own fields there is `derived`: medians, intervals and ratios, for programs
/// that read the file. [`read`] computes them anew.
///
/// # Errors
/// None that a record can cause.
pub fn write(comparison: &Comparison) -> Result<String, serde_json::Error> {
    let derived = Derived::of(comparison);
    let compact = serde_json::to_string(&Document { comparison, derived })?;
    Ok(pretty::pretty(&compact) + "\n")
}

/// Reads a record. Fields that are not known are left out.
///
/// # Errors
/// If the text is not a record, or one of another version.
pub fn read(text: &str) -> Result<Comparison, ReadError> {
    #[derive(Deserialize)]
    struct Version {
        schema_version: u64,
    }
    let found = serde_json::from_str::<Version>(text)?.schema_version;
    if found != u64::from(SCHEMA_VERSION) {
        return Err(ReadError::Version { found });
    }
    Ok(serde_json::from_str(text)?)
}
