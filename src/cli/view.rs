//! `srt view`: a page on which a scene is looked at. The layer `live` looks, `serve` has the page; this file loads the
//! scene, prints the address, and loads the scene again whenever it was saved.

use std::path::PathBuf;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use super::exit::{CommandResult, Exit, Failure};
use super::load::{Described, LoadError, SceneFile};
use super::output::print;
use super::source;
use super::source::folder_of;
use super::structures::Structures;
use super::terminal::print_message;
use super::view_args::ViewArguments;
use super::watch::WatchedFiles;
use super::work::Work;
use crate::assets::generate::Recipe;
use crate::description::MeshReference;
use crate::live::{Show, Studio};
use crate::scene::Structure;
use crate::serve::Site;

/// Between two looks at the files is this time, and so many times that which a look takes.
const BETWEEN_LOOKS: Duration = Duration::from_millis(120);
const TIMES_LOOKING: u32 = 50;

/// The most pixels of a picture that is looked at: browsers draw no larger ones.
const MOST_PIXELS: u64 = 1 << 25;

/// Serves the page until a signal ends the process.
pub(super) fn run(arguments: ViewArguments, structures: &Structures) -> CommandResult {
    let ViewArguments { scene, port, listen, work, lenient, quiet } = arguments;
    if source::is_stdin(&scene) {
        return Err(Failure::new(
            "a view reads its scene again when it is saved, and standard input can be read only once: name a file",
        ));
    }
    if work.crop.is_some() {
        return Err(Failure::new("a view is of the whole picture: leave --crop out"));
    }
    let work = Work::new(scene, work, lenient, quiet)?;
    let pool = work.pool()?;
    let mut files = WatchedFiles::default();
    let start = SystemTime::now();
    files.set([work.scene.clone()], start);
    let Some(described) = work.describe(&pool) else { return Ok(Exit::Trouble) };
    files.set(files_of(&work, &described.description.meshes), start);
    let show = show(&work, described)?;
    let site = Site::listen(listen, port)
        .map_err(|error| Failure::new(format_args!("{error}; --port 0 takes a free port")))?;
    let studio = Studio::new(show, choice(&work, structures), work.build.clone(), pool);
    print(&format!("{}\n", site.url()))?;
    if !quiet {
        print_message(format_args!(
            "open the address in a browser to look at {}; Ctrl-C ends it",
            source::quoted(&work.scene)
        ));
        if listen.is_unspecified() {
            print_message(
                "on other machines, the address of this one stands in place of the first part",
            );
        }
    }
    let watched = Arc::clone(&studio);
    let watcher = thread::Builder::new().name("watcher".to_owned());
    watcher.spawn(move || follow(&watched, &work, files)).map_err(Failure::new)?;
    site.serve(studio).map_err(Failure::new)?;
    Ok(Exit::Fine)
}

/// What a scene is looked at as.
fn show(work: &Work, described: Described) -> Result<Show, Failure> {
    let Described { loaded, description, .. } = described;
    let settings = work.settings(&loaded.scene, false)?;
    let pixels = settings.region().pixels();
    if pixels > MOST_PIXELS {
        return Err(Failure::new(format_args!(
            "{}x{} pixels are too many to look at: {MOST_PIXELS} is the most; give fewer by --size",
            settings.width, settings.height
        )));
    }
    Ok(Show {
        name: source::name(&work.scene),
        scene: loaded.scene,
        camera: description.camera,
        settings,
        warnings: loaded.warnings,
    })
}

/// All structures, the chosen one first.
fn choice(work: &Work, structures: &Structures) -> Vec<Structure> {
    let others = structures.all().iter().filter(|other| other.name != work.structure.name);
    std::iter::once(&work.structure).chain(others).copied().collect()
}

/// The scene's file and those of its meshes.
fn files_of(work: &Work, meshes: &[MeshReference]) -> Vec<PathBuf> {
    let folder = folder_of(&work.scene);
    let in_files = meshes.iter().filter(|mesh| Recipe::parse(&mesh.name).is_none());
    let paths = in_files.map(|mesh| folder.join(&mesh.name));
    std::iter::once(work.scene.clone()).chain(paths).collect()
}

/// Loads the scene again whenever a file of it was saved, as long as somebody looks.
fn follow(studio: &Studio, work: &Work, mut files: WatchedFiles) {
    loop {
        studio.wait_for_lookers();
        let start = Instant::now();
        let have_changed = files.have_changed();
        let took = start.elapsed();
        let read_since = SystemTime::now();
        if have_changed && let Some(meshes) = reload(studio, work) {
            files.set(files_of(work, &meshes), read_since);
        }
        thread::sleep(BETWEEN_LOOKS.max(TIMES_LOOKING * took));
    }
}

/// Loads the scene and shows it, or says what is wrong with it. The meshes that it names, if it can be read.
fn reload(studio: &Studio, work: &Work) -> Option<Vec<MeshReference>> {
    match studio
        .on_threads(|| SceneFile::read(&work.scene, work.lenient)?.without_colors().usual_frame())
    {
        Ok(described) => {
            let meshes = described.description.meshes.clone();
            match show(work, described) {
                Ok(show) => studio.replace(show),
                Err(failure) => studio.explain(&format!("error: {failure}")),
            }
            Some(meshes)
        }
        Err(error) => {
            let summary = format!("error: {error}");
            match error {
                LoadError::Invalid { text, meshes, .. } => {
                    studio.explain(&format!("{text}\n\n{summary}"));
                    Some(meshes)
                }
                LoadError::Source(_) => {
                    studio.explain(&summary);
                    None
                }
            }
        }
    }
}
