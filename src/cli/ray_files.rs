//! Files of rays: those that a comparison is given, and those that it leaves.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::exit::Failure;
use super::output::{Output, make_folder};
use crate::assets::read_file;
use crate::compare::{SceneInput, wrong_answers};
use crate::ray_file::{EXTENSION, RayFile};
use crate::record::RayClass;
use crate::sealed::hexadecimal;

/// Reads a file of rays.
pub(super) fn read(path: &Path) -> Result<RayFile, Failure> {
    let trouble = |why: &dyn std::fmt::Display| {
        Failure::new(format_args!("cannot read the rays `{}`: {why}", path.display()))
    };
    let bytes = read_file(path).map_err(|error| trouble(&error))?;
    RayFile::decode(&bytes).map_err(|error| trouble(&error))
}

/// Reads the rays of scenes, a file for each in their order, by the scenes' names. Rays for another geometry are
/// refused, and so are answers that are not those of this program, and files without rays of the classes that are
/// wanted; all classes are, if none is named.
pub(super) fn read_for(
    paths: &[PathBuf],
    scenes: &[SceneInput],
    wanted: &[RayClass],
) -> Result<BTreeMap<String, RayFile>, Failure> {
    if !paths.is_empty() && paths.len() != scenes.len() {
        return Err(Failure::new(format_args!(
            "--rays takes a file for each scene, in their order: there are {} and {} scenes",
            paths.len(),
            scenes.len()
        )));
    }
    let one = |(path, scene): (&PathBuf, &SceneInput)| {
        let file = read(path)?;
        expect_rays(path, &file, wanted)?;
        check(path, &file, scene)?;
        Ok((scene.name.clone(), file))
    };
    paths.iter().zip(scenes).map(one).collect()
}

fn expect_rays(path: &Path, file: &RayFile, wanted: &[RayClass]) -> Result<(), Failure> {
    let path = path.display();
    let classes = || file.classes.iter().filter(|own| !own.rays.is_empty()).map(|own| own.class);
    if classes().next().is_none() {
        return Err(Failure::new(format_args!("the rays `{path}`: it has none to measure")));
    }
    if wanted.is_empty() || classes().any(|class| wanted.contains(&class)) {
        return Ok(());
    }
    let names = |classes: &[RayClass], last: &str| {
        let names: Vec<&str> = classes.iter().map(|class| class.name()).collect();
        names.join(last)
    };
    Err(Failure::new(format_args!(
        "the rays `{path}`: it has no {} rays; it has: {}",
        names(wanted, " or "),
        names(&classes().collect::<Vec<_>>(), ", "),
    )))
}

fn check(path: &Path, file: &RayFile, input: &SceneInput) -> Result<(), Failure> {
    let (path, scene) = (path.display(), &input.path);
    let own = input.scene.geometry_hash();
    if file.geometry != own {
        return Err(Failure::new(format_args!(
            "the rays `{path}` are not for the geometry of `{scene}`: that has SHA-256 {}, theirs {}",
            hexadecimal(&own),
            hexadecimal(&file.geometry)
        )));
    }
    match wrong_answers(&input.scene, file).map_err(Failure::new)? {
        Some(wrong) => Err(Failure::new(format_args!("the rays `{path}`: {wrong}"))),
        None => Ok(()),
    }
}

/// The folder into which the rays of scenes are written as they are recorded.
pub(super) struct RayFolder {
    path: PathBuf,
    /// The first failure of a write.
    failure: Mutex<Option<Failure>>,
}

impl RayFolder {
    /// Makes the folder, unless it exists, and checks that the files of these scenes can be written.
    pub(super) fn prepare(path: &Path, scenes: &[SceneInput]) -> Result<Self, Failure> {
        if path.is_file() {
            return Err(Failure::new(format_args!(
                "`{}` is a file, and --save-rays takes a folder, for a file of each scene",
                path.display()
            )));
        }
        make_folder(path)?;
        let folder = Self { path: path.to_owned(), failure: Mutex::default() };
        for scene in scenes {
            Output::prepare(&folder.file(&scene.name))?;
        }
        Ok(folder)
    }

    fn file(&self, scene: &str) -> PathBuf {
        self.path.join(format!("{scene}.{EXTENSION}"))
    }

    /// Writes the rays of a scene. A failure is kept, so that the comparison goes on.
    pub(super) fn write(&self, scene: &str, rays: &RayFile) {
        let written = || {
            let output = Output::prepare(&self.file(scene))?;
            output.write(|to| to.write_all(&rays.encode()))
        };
        if let Err(error) = written() {
            let mut failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner);
            failure.get_or_insert_with(|| error.into());
        }
    }

    /// How the writes went.
    pub(super) fn finish(self) -> Result<(), Failure> {
        self.failure.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
    }
}
