//! The folder of a report: checked before the work, filled after it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::exit::Failure;
use super::inputs::is_same_file;
use super::output::{Output, claim_folder, make_folder};
use crate::assets::read_file;
use crate::compare::{self, ComparisonResult, Plan, heatmap_name, picture_name};
use crate::image_io::{Format, Picture, encode};
use crate::record::{Comparison, SceneRecord};
use crate::report::{Report, read_json};

/// The bytes of pictures by the names of their files.
pub(super) type PictureFiles = BTreeMap<String, Vec<u8>>;

/// The files that every report has.
const FILES: [&str; 4] = ["report.json", "report.csv", "report.md", "report.html"];

/// A folder in which files can be written.
#[derive(Debug)]
pub(super) struct ResultFolder {
    path: PathBuf,
    /// The record of the report that was here before.
    older: Option<Comparison>,
}

impl ResultFolder {
    /// Makes a folder, unless it exists, and checks that the files of a report can be written in it.
    pub(super) fn prepare(path: &Path) -> Result<Self, Failure> {
        if path.is_file() {
            return Err(Failure::new(format_args!(
                "`{}` is a file, and a report is a folder of files: give --out another name",
                path.display()
            )));
        }
        make_folder(path)?;
        Self::checked(path.to_owned())
    }

    /// Makes a new folder of this name within `parent`, with a number behind it if there is one already.
    pub(super) fn claim(parent: &Path, name: &str) -> Result<Self, Failure> {
        Self::checked(claim_folder(parent, name)?)
    }

    /// A new folder of the same name with another word behind it.
    pub(super) fn beside(&self, word: &str) -> Result<Self, Failure> {
        // `.` and `..` are no names.
        let path = fs::canonicalize(&self.path).map_err(|error| {
            let path = self.path.display();
            Failure::new(format_args!("cannot find the folder `{path}`: {error}"))
        })?;
        let name = path.file_name().unwrap_or("report".as_ref()).to_string_lossy();
        let parent = self.path.parent().filter(|_| self.path.file_name().is_some());
        let parent = parent.or(path.parent()).unwrap_or(&path);
        Self::claim(parent, &format!("{name}-{word}"))
    }

    /// Whether there is a report in it.
    pub(super) fn has_report(&self) -> bool {
        FILES.iter().any(|name| self.path.join(name).exists())
    }

    /// A folder that exists, if the files of a report can be written in it.
    fn checked(path: PathBuf) -> Result<Self, Failure> {
        for name in FILES {
            Output::prepare(&path.join(name))?;
        }
        let older = read_record(&path.join("report.json")).ok();
        Ok(Self { path, older })
    }

    /// Where it is.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a report in all its forms, and its pictures.
    pub(super) fn write(
        &self,
        report: &Report<'_>,
        pictures: &PictureFiles,
    ) -> Result<(), Failure> {
        let stale = self.stale(report.comparison());
        for (name, bytes) in pictures {
            self.write_file(name, bytes)?;
        }
        let json = report.json().map_err(Failure::new)?;
        self.write_file("report.json", json.as_bytes())?;
        self.write_file("report.csv", report.csv().as_bytes())?;
        if let Some(text) = report.sampling_csv() {
            self.write_file("sampling.csv", text.as_bytes())?;
        }
        self.write_file("report.md", report.markdown().as_bytes())?;
        self.write_file("report.html", report.html(pictures).as_bytes())?;
        // Last, so that nothing is lost where something cannot be written. What cannot be removed
        // stays.
        for name in stale {
            let _ = fs::remove_file(self.path.join(name));
        }
        Ok(())
    }

    /// Writes what is done of a comparison: its record and its pictures, without the forms for readers.
    pub(super) fn write_so_far(&self, so_far: &ComparisonResult) -> Result<(), Failure> {
        for (name, bytes) in encoded(&so_far.pictures)? {
            self.write_file(&name, &bytes)?;
        }
        let json = Report::new(&so_far.comparison).json().map_err(Failure::new)?;
        self.write_file("report.json", json.as_bytes())
    }

    /// The record here, if there is one and it is of this plan.
    pub(super) fn resumable(&self, plan: &Plan) -> Result<Option<Comparison>, Failure> {
        let path = self.path.join("report.json");
        if !path.exists() {
            return Ok(None);
        }
        let record = read_record(&path)?;
        compare::expect_same(&record.run, &compare::describe(plan), without_resume).map_err(
            |error| {
                Failure::new(format_args!(
                    "cannot go on with `{}`: {error}; leave --resume out to begin anew",
                    path.display()
                ))
            },
        )?;
        Ok(Some(record))
    }

    /// The files of the older report in this folder which the new one does not replace: they would be
    /// taken for its own. A record may come from anywhere, so only names that this program gives.
    fn stale(&self, comparison: &Comparison) -> Vec<String> {
        let Some(old) = &self.older else { return Vec::new() };
        let new = picture_names(comparison);
        // Some file systems do not distinguish upper and lower case.
        let is_new = |name: &String| new.iter().any(|new| new.eq_ignore_ascii_case(name));
        let given = given_names(old);
        let mut stale = picture_names(old);
        stale.retain(|name| given.contains(name) && !is_new(name));
        if old.sampling.is_some() && comparison.sampling.is_none() {
            stale.push("sampling.csv".to_owned());
        }
        stale
    }

    fn write_file(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let output = Output::prepare(&self.path.join(name))?;
        output.write(|to| to.write_all(bytes)).map_err(Failure::from)
    }
}

/// Refuses a folder in which the report would replace the baseline that it is compared with.
pub(super) fn refuse_to_replace_the_baseline(
    folder: &Path,
    baseline: &Path,
) -> Result<(), Failure> {
    for name in FILES {
        if is_same_file(&folder.join(name), baseline) {
            return Err(Failure::new(format_args!(
                "the report would replace the baseline `{}`: give --out another folder than `{}`",
                baseline.display(),
                folder.display()
            )));
        }
    }
    Ok(())
}

/// A command without what may differ where it is gone on with.
fn without_resume(command: &str) -> String {
    let differs = |word: &&str| !["--resume", "--quiet", "-q"].contains(word);
    command.split(' ').filter(differs).collect::<Vec<_>>().join(" ")
}

/// Pictures as files.
pub(super) fn encoded(pictures: &[(String, Picture)]) -> Result<PictureFiles, Failure> {
    let png = |(name, picture): &(String, _)| {
        encode(picture, Format::Png).map(|bytes| (name.clone(), bytes)).map_err(Failure::new)
    };
    pictures.iter().map(png).collect()
}

/// The pictures that a record names, as far as a folder has them: a report lists those that are missing.
pub(super) fn pictures_in(comparison: &Comparison, folder: &Path) -> PictureFiles {
    let read = |name: String| Some((name.clone(), fs::read(folder.join(&name)).ok()?));
    picture_names(comparison).into_iter().filter_map(read).collect()
}

/// The files of all pictures that a record names.
///
/// A record may come from anywhere: a name that leads out of its folder, or deeper, is left out.
fn picture_names(comparison: &Comparison) -> Vec<String> {
    let heatmaps = |scene: &SceneRecord| {
        let all = scene.structures.iter().filter_map(|own| own.heatmap.clone());
        scene.picture.clone().into_iter().chain(all).collect::<Vec<_>>()
    };
    let is_plain = |name: &String| Path::new(name).file_name() == Some(name.as_ref());
    let files = comparison.scenes.iter().flat_map(heatmaps).map(|picture| picture.file);
    files.filter(is_plain).collect()
}

/// The names that a comparison gives the pictures of a record's scenes and structures.
fn given_names(comparison: &Comparison) -> Vec<String> {
    let of_scene = |scene: &SceneRecord| {
        let heatmaps = scene.structures.iter().map(|own| heatmap_name(&scene.name, &own.name));
        std::iter::once(picture_name(&scene.name)).chain(heatmaps).collect::<Vec<_>>()
    };
    comparison.scenes.iter().flat_map(of_scene).collect()
}

/// Reads a record from its file.
pub(super) fn read_record(path: &Path) -> Result<Comparison, Failure> {
    let trouble = |why: &dyn std::fmt::Display| {
        Failure::new(format_args!("cannot read the record `{}`: {why}", path.display()))
    };
    let bytes = read_file(path).map_err(|error| trouble(&error))?;
    let text = String::from_utf8(bytes).map_err(|_| trouble(&"it is not text"))?;
    read_json(&text).map_err(|error| trouble(&error))
}
