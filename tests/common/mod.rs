//! From scenes to pictures, as the tests need it.
#![allow(dead_code, reason = "each test uses its part of this")]

#[cfg(any(feature = "libraries", feature = "tinybvh"))]
pub(crate) mod peers;

use std::fs;
use std::path::{Path, PathBuf};

use srt::accel::BuildConfig;
use srt::assets::load_meshes;
use srt::image_io::Picture;
use srt::render::{Image, Settings, Silent, View, render};
use srt::scene::{Scene, structure_named};
use srt::scene_file::{ParseOptions, parse, render_diagnostics};

/// A file or folder of the project.
pub(crate) fn in_project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// All scenes in `scenes/`, in the order of their names.
pub(crate) fn scene_paths() -> Vec<PathBuf> {
    let mut paths = files_in("scenes", "sce");
    paths.sort();
    assert!(!paths.is_empty(), "no scenes");
    paths
}

/// The files with an extension in a folder of the project.
pub(crate) fn files_in(folder: &str, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(in_project(folder)).expect("the folder can be read");
    let paths = entries.map(|entry| entry.expect("the entry can be read").path());
    paths.filter(|path| path.extension().is_some_and(|e| e == extension)).collect()
}

/// The name of a file without its extension.
pub(crate) fn stem(path: &Path) -> String {
    path.file_stem().expect("a file has a name").to_string_lossy().into_owned()
}

/// A scene from its file.
pub(crate) fn load(path: &Path) -> Scene {
    load_frame(path, 0)
}

/// A frame of a scene from its file.
pub(crate) fn load_frame(path: &Path, frame: u32) -> Scene {
    let text = fs::read_to_string(path).expect("the scene can be read");
    let folder = path.parent().expect("a file is in a folder");
    compiled_frame(&text, &path.to_string_lossy(), folder, frame)
}

/// A scene from its text, the first line left out.
pub(crate) fn scene(text: &str) -> Scene {
    compiled(&format!("sce1.0\n{text}"), "test.sce", Path::new("."))
}

/// A scene from its whole text, of which the meshes are in a folder.
pub(crate) fn compiled(text: &str, name: &str, folder: &Path) -> Scene {
    compiled_frame(text, name, folder, 0)
}

fn compiled_frame(text: &str, name: &str, folder: &Path, frame: u32) -> Scene {
    let parsed = parse(text, &ParseOptions { frame, ..ParseOptions::default() })
        .unwrap_or_else(|d| panic!("{}", render_diagnostics(&d, text, name, false)));
    let meshes = load_meshes(&parsed.description.meshes, folder).expect("the meshes load");
    Scene::new(&parsed.description, meshes).expect("the scene compiles")
}

/// What a structure renders.
pub(crate) fn rendered(scene: &Scene, structure: &str, settings: &Settings) -> Image {
    let structure = structure_named(structure).expect("the structure exists");
    let world = structure.build(scene, &BuildConfig::default());
    render(scene, world.as_ref(), settings, &Silent).image
}

/// The picture of a scene, rendered with `bvh`.
pub(crate) fn picture(scene: &Scene, settings: &Settings) -> Picture {
    match rendered(scene, "bvh", settings) {
        Image::Color(picture) => picture,
        Image::Scalar { .. } => panic!("not a picture: {:?}", settings.view),
    }
}

/// A view of a scene in colours.
pub(crate) fn picture_of(scene: &Scene, view: View) -> Picture {
    picture(scene, &Settings { view, ..Settings::of_scene(scene) })
}

/// The depths of a scene, row by row from the top left.
pub(crate) fn depths(scene: &Scene) -> Vec<f32> {
    let settings = Settings { view: View::Depth, ..Settings::of_scene(scene) };
    match rendered(scene, "bvh", &settings) {
        Image::Scalar { values, .. } => values,
        Image::Color(_) => panic!("depths are no picture"),
    }
}

/// Runs something on a number of threads.
pub(crate) fn on_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("threads start").install(run)
}
