//! The folder of a report: found fit before the work, filled after it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::exit::Failure;
use super::output::Output;
use crate::record::Comparison;
use crate::report::{csv, html, json, markdown};

/// The bytes of pictures by the names of their files.
pub(super) type PictureFiles = BTreeMap<String, Vec<u8>>;

/// The files that every report has.
const FILES: [&str; 4] = ["report.json", "report.csv", "report.md", "report.html"];

/// A folder that takes files.
#[derive(Debug)]
pub(super) struct ResultFolder {
    path: PathBuf,
}

impl ResultFolder {
    /// Makes a folder, unless it is there, and tries whether it takes the files of a report.
    pub(super) fn prepare(path: &Path) -> Result<Self, Failure> {
        fs::create_dir_all(path).map_err(|error| {
            Failure::new(format_args!("cannot make the folder `{}`: {error}", path.display()))
        })?;
        for name in FILES {
            Output::prepare(&path.join(name))?;
        }
        Ok(Self { path: path.to_owned() })
    }

    /// Where it is.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a report in all its forms, and its pictures.
    pub(super) fn write(
        &self,
        comparison: &Comparison,
        pictures: &PictureFiles,
    ) -> Result<(), Failure> {
        for (name, bytes) in pictures {
            self.write_file(name, bytes)?;
        }
        let json = json::write(comparison).map_err(Failure::new)?;
        self.write_file("report.json", json.as_bytes())?;
        self.write_file("report.csv", csv::write(comparison).as_bytes())?;
        if let Some(text) = csv::write_sampling(comparison) {
            self.write_file("sampling.csv", text.as_bytes())?;
        }
        self.write_file("report.md", markdown::write(comparison).as_bytes())?;
        self.write_file("report.html", html::write(comparison, pictures).as_bytes())
    }

    fn write_file(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let output = Output::prepare(&self.path.join(name))?;
        output.write(|to| to.write_all(bytes)).map_err(Failure::from)
    }
}

/// Reads a record from its file.
pub(super) fn read_record(path: &Path) -> Result<Comparison, Failure> {
    let trouble = |why: &dyn std::fmt::Display| {
        Failure::new(format_args!("cannot read the record `{}`: {why}", path.display()))
    };
    let text = fs::read_to_string(path).map_err(|error| trouble(&error))?;
    json::read(&text).map_err(|error| trouble(&error))
}
