//! What is rendered, and by what, once it was validated: as far as possible before the scene is read. Nothing here is
//! optional that a rendering needs.

use std::io::Read;
use std::path::PathBuf;
use std::thread::available_parallelism;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::exit::Failure;
use super::inputs::refuse_to_replace;
use super::load::{Described, LoadError, Loaded, SavedStructure, SceneFile, print_load_error};
use super::output::Output;
use super::source;
use super::structures::Structures;
use super::terminal::print_message;
use super::values::Size;
use super::work_args::{USUAL_STRUCTURE, WorkArguments};
use crate::accel::{BuildConfig, Quality};
use crate::built_file::BuiltFileError;
use crate::film::Crop;
use crate::render::{Sampling, Settings, View};
use crate::scene::{ReadError, STRUCTURES, Scene, Structure, TracedWorld, structure_named};

/// A scene, how it is rendered, and by what; what is absent is taken from the scene.
#[derive(Debug)]
pub(crate) struct Work {
    /// The scene's file.
    pub(crate) scene: PathBuf,
    /// The frame, of a scene that moves.
    pub(crate) frame: u32,
    /// The structure that is traced.
    pub(crate) structure: Structure,
    /// How it is built.
    pub(crate) build: BuildConfig,
    /// Which of these were typed; a built scene has its own.
    pub(crate) typed: Typed,
    /// Threads that build and render.
    pub(crate) threads: usize,
    /// What replaces the options of the scene.
    pub(crate) overrides: Overrides,
    /// How the samples of lights are made.
    pub(crate) sampling: Sampling,
    /// The root of the number of samples of each area light.
    pub(crate) light_samples: u32,
    /// Where the random numbers start.
    pub(crate) seed: u64,
    /// The part to render, if not all.
    pub(crate) crop: Option<Crop>,
    /// What the pixels show.
    pub(crate) view: View,
    /// Whether unknown commands are warnings.
    pub(crate) lenient: bool,
    /// Whether progress, warnings and the last line are left out.
    pub(crate) quiet: bool,
}

/// Which options were typed that a built scene has too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Typed {
    pub(crate) frame: bool,
    pub(crate) structure: bool,
    pub(crate) quality: bool,
}

/// Options that a scene has too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Overrides {
    /// Instead of `nx` and `ny`.
    pub(crate) size: Option<Size>,
    /// Instead of `aasample`.
    pub(crate) aa: Option<u32>,
    /// Instead of `max_recursion`.
    pub(crate) max_recursion: Option<u32>,
}

impl Work {
    /// Validates what was typed.
    pub(crate) fn new(
        scene: PathBuf,
        typed: WorkArguments,
        lenient: bool,
        quiet: bool,
    ) -> Result<Self, Failure> {
        match (typed.size, typed.crop) {
            (Some(size), crop) => check_region(size.width, size.height, crop)?,
            (None, Some(crop)) => check_pixels(crop)?,
            (None, None) => {}
        }
        Ok(Self {
            typed: Typed {
                frame: typed.frame.is_some(),
                structure: typed.accel.is_some(),
                quality: typed.build.is_some(),
            },
            frame: typed.frame.unwrap_or(0),
            structure: typed.accel.unwrap_or(usual_structure()),
            build: build_config(typed.build.unwrap_or_default()),
            threads: threads(typed.threads)?,
            overrides: Overrides {
                size: typed.size,
                aa: typed.aa,
                max_recursion: typed.max_recursion,
            },
            sampling: typed.sampling,
            light_samples: typed.light_samples,
            seed: typed.seed,
            crop: typed.crop,
            view: typed.view,
            lenient,
            quiet,
            scene,
        })
    }

    /// The settings of the renderer: what was typed, and the scene's options where nothing was. `count` is whether
    /// tests are to be counted, which peers do not.
    pub(crate) fn settings(&self, scene: &Scene, count: bool) -> Result<Settings, Failure> {
        let of_scene = Settings::of_scene(scene);
        let size = self.overrides.size;
        let settings = Settings {
            width: size.map_or(of_scene.width, |size| size.width),
            height: size.map_or(of_scene.height, |size| size.height),
            crop: self.crop,
            aa: self.overrides.aa.unwrap_or(of_scene.aa),
            light_samples: self.light_samples,
            sampling: self.sampling,
            max_recursion: self.overrides.max_recursion.unwrap_or(of_scene.max_recursion),
            seed: self.seed,
            view: self.view,
            count: count && !self.structure.peer,
        };
        let name = self.structure.name;
        match self.view {
            View::Heatmap if self.structure.peer => {
                let what = format_args!("`{name}` counts no tests: it has no heatmap");
                return Err(Failure::new(what));
            }
            View::Cells if self.structure.peer => {
                let what =
                    format_args!("`{name}` is another program's: it does not show its cells");
                return Err(Failure::new(what));
            }
            _ => {}
        }
        check_region(settings.width, settings.height, settings.crop)?;
        check_samples(&settings)?;
        Ok(settings)
    }

    /// Takes structure, quality and frame from a built scene, where it is one and none were typed.
    ///
    /// # Errors
    /// If others were typed, or if this program has no such structure.
    pub(crate) fn adopt(
        &mut self,
        loaded: &Loaded,
        structures: &Structures,
    ) -> Result<(), Failure> {
        self.frame = loaded.frame;
        let Some(built) = &loaded.built else { return Ok(()) };
        let SavedStructure { structure, quality, .. } = built;
        let file = source::quoted(&built.path);
        if self.structure.name != structure {
            if self.typed.structure {
                return Err(Failure::new(format_args!(
                    "{file} was built with `{structure}`, not with `{}`: leave --accel out, or build it again with it",
                    self.structure.name
                )));
            }
            self.structure = structures.find(structure).map_err(|_| {
                Failure::new(format_args!(
                    "{file} was built with `{}`, which this program does not have",
                    structure.escape_debug()
                ))
            })?;
        }
        let found = Quality::ALL.into_iter().find(|one| one.name() == quality);
        if self.typed.quality && found != Some(self.build.quality) {
            return Err(Failure::new(format_args!(
                "{file} was built with --build {}, not with {}: leave --build out, or build it again with it",
                quality.escape_debug(),
                self.build.quality.name()
            )));
        }
        self.build = build_config(found.unwrap_or_default());
        Ok(())
    }

    /// Builds the structure, or reads the one that was built already, on the threads of the current pool.
    pub(crate) fn build(
        &self,
        scene: &Scene,
        built: Option<&SavedStructure>,
    ) -> Result<Box<dyn TracedWorld>, Failure> {
        let name = self.structure.name;
        let world = match built {
            Some(built) => self.read(scene, built)?,
            None => self
                .structure
                .try_build(scene, &self.build)
                .map_err(|error| Failure::new(format_args!("`{name}`: {error}")))?,
        };
        if self.view == View::Cells && scene.objects.is_empty() {
            return Err(Failure::new(format_args!(
                "`{name}` has no cells over this scene: the scene has no primitives; add an object, as `ball 1 0 0 0`"
            )));
        }
        if self.view == View::Cells && world.regions().is_empty() {
            return Err(Failure::new(format_args!(
                "`{name}` has no cells over this scene: it tests every primitive; choose another structure"
            )));
        }
        Ok(world)
    }

    fn read(&self, scene: &Scene, built: &SavedStructure) -> Result<Box<dyn TracedWorld>, Failure> {
        let mut bytes = built.bytes.clone();
        let size = bytes.size();
        let of_part =
            |ReadError { mesh, source }| BuiltFileError::part(structure_over(mesh), source);
        let read = self.structure.load(scene, &mut bytes, size).map_err(of_part);
        let read = read.and_then(|world| match bytes.read(&mut [0]) {
            Ok(0) => Ok(world),
            Ok(_) => Err(BuiltFileError::Longer),
            Err(error) => Err(BuiltFileError::part("the end", error.into())),
        });
        read.map_err(|error| {
            let file = source::quoted(&built.path);
            Failure::new(format_args!("cannot read the built scene {file}: {error}"))
        })
    }

    /// What would differ from machine to machine cannot be put together or gone on with: `option` says what asks.
    pub(crate) fn refuse_what_differs(&self, option: &str) -> Result<(), Failure> {
        if self.view.shows_structure() {
            let view = self.view.name();
            let what = if self.view == View::Heatmap {
                "what a structure tested"
            } else {
                "the structure"
            };
            return Err(Failure::new(format_args!(
                "{option} is for what is the same whatever the structure, and --view {view} shows {what}: \
                 leave one of them out"
            )));
        }
        if self.structure.peer {
            return Err(Failure::new(format_args!(
                "{option} is for structures whose hits are equal to the bit, and those of `{}` are its own: \
                 choose another --accel",
                self.structure.name
            )));
        }
        Ok(())
    }

    /// The threads that build and render.
    pub(crate) fn pool(&self) -> Result<ThreadPool, Failure> {
        pool_of(self.threads)
    }

    /// Loads the scene and prints its warnings; or prints why there is none.
    pub(crate) fn load(&self, pool: &ThreadPool) -> Option<Loaded> {
        let load = || self.file().and_then(|(mut file, frame)| file.frame(frame));
        let loaded = pool.install(load).map_err(|error| print_load_error(&error)).ok()?;
        self.warn(&loaded);
        Some(loaded)
    }

    /// The same, with the scene as written.
    pub(crate) fn describe(&self, pool: &ThreadPool) -> Option<Described> {
        let describe = || self.file().and_then(|(mut file, frame)| file.described(frame));
        let described = pool.install(describe).map_err(|error| print_load_error(&error)).ok()?;
        self.warn(&described.loaded);
        Some(described)
    }

    /// The scene's file, and the frame that is wanted of it.
    fn file(&self) -> Result<(SceneFile, u32), LoadError> {
        let file = SceneFile::read(&self.scene, self.lenient)?;
        let own = file.built_frame().filter(|_| !self.typed.frame);
        Ok((file, own.unwrap_or(self.frame)))
    }

    fn warn(&self, loaded: &Loaded) {
        if !self.quiet && !loaded.warnings.is_empty() {
            print_message(&loaded.warnings);
        }
    }

    /// Refuses an output that would replace the scene.
    pub(crate) fn refuse_to_replace_the_scene(&self, output: &Output) -> Result<(), Failure> {
        refuse_to_replace(output, "the output", "the scene", &self.scene)
    }
}

/// So many threads.
pub(super) fn pool_of(threads: usize) -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| Failure::new(format_args!("cannot start {threads} threads: {error}")))
}

/// A crop must lie within the picture, whose size may be known only from the scene, and what is
/// rendered must fit into memory.
pub(crate) fn check_region(width: u32, height: u32, crop: Option<Crop>) -> Result<(), Failure> {
    let Some(crop) = crop else {
        return check_pixels(Crop { x0: 0, y0: 0, x1: width, y1: height });
    };
    if crop.is_within(width, height) {
        return check_pixels(crop);
    }
    Err(Failure::new(format_args!(
        "the crop {crop} does not lie within the picture of {width}x{height} pixels"
    )))
}

fn check_pixels(region: Crop) -> Result<(), Failure> {
    if region.pixels() <= Settings::MAX_PIXELS {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "{}x{} pixels are too many to render at once: {} is the most; render parts with --crop",
        region.width(),
        region.height(),
        Settings::MAX_PIXELS,
    )))
}

/// More threads than this for each processor only wait for each other: with hundreds of them, a
/// build of milliseconds takes seconds.
const MOST_THREADS_A_PROCESSOR: usize = 4;

/// As many threads as were typed, or one a processor.
pub(crate) fn threads(typed: Option<u16>) -> Result<usize, Failure> {
    let processors = available_parallelism().map_or(1, std::num::NonZero::get);
    let (threads, most) =
        (typed.map_or(processors, usize::from), MOST_THREADS_A_PROCESSOR * processors);
    if threads <= most {
        return Ok(threads);
    }
    let are =
        if processors == 1 { "1 processor is" } else { &format!("{processors} processors are") };
    Err(Failure::new(format_args!(
        "{threads} threads are too many: {are} available, and --threads may be {most} at most"
    )))
}

/// The samples of a pixel and of a light are made together, so they are limited together.
fn check_samples(settings: &Settings) -> Result<(), Failure> {
    let (aa, light, most) = (settings.aa.max(1), settings.light_samples, Settings::MAX_LIGHT_SIDE);
    if aa.saturating_mul(light) <= most {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "{aa} × {aa} samples a pixel with {light} × {light} of each light are too many: \
         --aa times --light-samples may be {most} at most"
    )))
}

/// The structure that is traced where none is named.
pub(super) fn usual_structure() -> Structure {
    *structure_named(USUAL_STRUCTURE).unwrap_or(&STRUCTURES[0])
}

fn structure_over(mesh: Option<usize>) -> String {
    mesh.map_or_else(
        || "the structure over the objects".to_owned(),
        |mesh| format!("the structure over mesh {}", mesh + 1),
    )
}

pub(crate) fn build_config(quality: Quality) -> BuildConfig {
    BuildConfig { quality, ..BuildConfig::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_may_be_some_times_the_processors() {
        let processors = threads(None).unwrap();
        let most = 4 * processors;
        assert_eq!(threads(Some(most as u16)).unwrap(), most);
        let message = threads(Some(most as u16 + 1)).unwrap_err().to_string();
        assert!(message.contains(&format!("{processors} processor")), "{message}");
        assert!(message.contains(&format!("{most} at most")), "{message}");
    }
}
