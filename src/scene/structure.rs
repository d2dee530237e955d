//! A structure by name, with all that can be done with it.

use std::any::TypeId;
use std::io::{self, Read, Write};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use crate::accel::{
    Accel, BuildConfig, BuildOptions, Exhaustive, Indexed, LoadError, OptionError, OptionInfo,
    Portable, Tracer, Update,
};
use crate::assets::expect_memory;
use crate::conformance::{self, FirstDifference, Limits, Summary};
use crate::shapes::TriangleMesh;

use super::foreign::{ForeignTracer, ForeignWorld};
use super::structures::structure_named;
use super::{BuildError, ReadError, SaveError, Scene, TracedWorld, World};

/// A structure by name, with the options that were chosen for it.
#[derive(Clone, Copy, Debug)]
pub struct Structure {
    /// What `--accel` and reports call it: with its options, if it has any, as
    /// `bvh8:builder=ploc,leaf=4`.
    pub name: &'static str,
    /// One line about it.
    pub summary: &'static str,
    /// Where it is from: papers, or the address of a library; empty where that is not told.
    pub source: &'static str,
    /// Whether it is another program's, compared for its speed: its hits are close to those of the
    /// others, not equal, and it counts nothing.
    pub peer: bool,
    /// Whether a comparison leaves it out where no structure is named.
    pub on_request: bool,
    /// Its name without options.
    base_name: &'static str,
    /// The options that it offers: those of the structure over the triangles, then those of the one
    /// over the objects.
    offered: [&'static [OptionInfo]; 2],
    /// Those that were chosen.
    options: &'static BuildOptions,
    /// The bytes that a build takes for each triangle of a mesh, and for each object.
    build_bytes: [u64; 2],
    /// In which ways the structure over the objects can follow, and that over the triangles.
    updates: [&'static [Update]; 2],
    build: BuildFunction,
    loaded: LoadedFunction,
    /// What structures that give equal hits can do beside; none for peers.
    equal: Option<EqualHits>,
    /// How it is saved, if it can be.
    saved: Option<Saved>,
}

/// How a structure is saved and read again.
#[derive(Clone, Copy, Debug)]
struct Saved {
    write: fn(&Scene, &BuildConfig, &mut dyn Write) -> io::Result<()>,
    read: ReadFunction,
}

/// What can be done with a structure that gives equal hits.
#[derive(Clone, Copy, Debug)]
struct EqualHits {
    index: fn(TriangleMesh<'_>, &BuildConfig) -> Box<dyn Tracer>,
    check: fn(&BuildOptions, &Limits<'_>) -> Result<Summary, FirstDifference>,
}

/// The bytes of a triangle as it is traced: an eighth of a pack.
const PACKED_TRIANGLE: u64 = 40;

/// The bytes of an object in the list that is searched.
const LISTED_OBJECT: u64 = 60;

const NO_OPTIONS: &BuildOptions = &BuildOptions::NONE;

type ReadFunction = fn(&Scene, &mut dyn Read, u64) -> Result<Box<dyn TracedWorld>, ReadError>;

type LoadedFunction = fn() -> Result<Option<String>, BuildError>;

type BuildFunction = fn(&Scene, &BuildConfig) -> Result<Box<dyn TracedWorld>, BuildError>;

impl Structure {
    /// A structure that indexes the objects by `O` and the triangles of each mesh by `T`.
    #[must_use]
    pub const fn new<O: Accel + 'static, T: Accel + 'static>(
        name: &'static str,
        summary: &'static str,
    ) -> Self {
        Self {
            offered: [T::OPTIONS, O::OPTIONS],
            build_bytes: [PACKED_TRIANGLE + T::BUILD_BYTES, LISTED_OBJECT + O::BUILD_BYTES],
            updates: [O::UPDATES, T::UPDATES],
            equal: Some(EqualHits {
                index: |mesh, config| Box::new(Indexed::<_, T>::build(mesh, config)),
                check: check::<O, T>,
            }),
            ..Self::named(name, summary, |scene, config| {
                Ok(Box::new(World::<O, T>::build(scene, config)))
            })
        }
    }

    /// The same as [`new`](Self::new), of a structure that can be saved.
    #[must_use]
    pub const fn portable<O: Portable + 'static, T: Portable + 'static>(
        name: &'static str,
        summary: &'static str,
    ) -> Self {
        let saved = Saved {
            write: |scene, config, out| World::<O, T>::build(scene, config).write(out),
            read: |scene, input, size| Ok(Box::new(World::<O, T>::read(scene, input, size)?)),
        };
        Self { saved: Some(saved), ..Self::new::<O, T>(name, summary) }
    }

    /// Another program's library, as a peer.
    #[must_use]
    pub const fn foreign<F: ForeignTracer + 'static>(
        name: &'static str,
        summary: &'static str,
    ) -> Self {
        Self {
            peer: true,
            on_request: true,
            offered: [F::OPTIONS, &[]],
            build_bytes: [F::BUILD_BYTES, 0],
            loaded: || F::loaded().map_err(|error| BuildError::Library { text: error.to_string() }),
            ..Self::named(name, summary, |scene, config| {
                Ok(Box::new(ForeignWorld::<F>::build(scene, config)?))
            })
        }
    }

    /// What can be built, and nothing else of it.
    const fn named(name: &'static str, summary: &'static str, build: BuildFunction) -> Self {
        Self {
            name,
            summary,
            source: "",
            peer: false,
            on_request: false,
            base_name: name,
            offered: [&[]; 2],
            options: NO_OPTIONS,
            build_bytes: [0; 2],
            updates: [&[]; 2],
            build,
            loaded: || Ok(None),
            equal: None,
            saved: None,
        }
    }

    /// The same, with where it is from: [`source`](Self::source).
    #[must_use]
    pub const fn with_source(self, source: &'static str) -> Self {
        Self { source, ..self }
    }

    /// The same, left out of comparisons that do not name it.
    #[must_use]
    pub const fn on_request(self) -> Self {
        Self { on_request: true, ..self }
    }

    /// Its name without options.
    #[must_use]
    pub fn base_name(&self) -> &'static str {
        self.base_name
    }

    /// Of a peer whose library is loaded as the program runs, the name and the version of what there is; nothing of
    /// what is part of the program.
    ///
    /// # Errors
    /// If there is none, with where it was looked for.
    pub fn loaded(&self) -> Result<Option<String>, BuildError> {
        (self.loaded)()
    }

    /// Whether it can follow a scene that moves in some way ([`TracedWorld::refit`]).
    #[must_use]
    pub fn can_follow(&self, update: Update) -> bool {
        self.updates.iter().all(|offered| offered.contains(&update))
    }

    /// The options that it offers, each name once.
    pub fn offered_options(&self) -> impl Iterator<Item = &'static OptionInfo> + Clone + use<> {
        let [of_triangles, of_objects] = self.offered;
        let is_new = move |info: &&OptionInfo| of_triangles.iter().all(|own| own.name != info.name);
        of_triangles.iter().chain(of_objects.iter().filter(is_new))
    }

    /// The structure with options, from text as `builder=ploc,leaf=4`, in place of those that it had.
    ///
    /// Its name is then one with its options in the order in which it offers them, and is kept for as
    /// long as the program runs.
    ///
    /// ```
    /// use srt::scene::structure_named;
    ///
    /// let bvh8 = structure_named("bvh8").unwrap();
    /// let four = bvh8.with_options("leaf=4,builder=ploc").unwrap();
    /// assert_eq!((four.name, four.base_name()), ("bvh8:builder=ploc,leaf=4", "bvh8"));
    /// ```
    ///
    /// # Errors
    /// If an option, or its value, is unknown, or is given twice.
    pub fn with_options(&self, text: &str) -> Result<Self, OptionError> {
        let options = BuildOptions::read(self.offered_options(), text)?;
        let Chosen { name, options } = kept(format!("{}:{options}", self.base_name), options);
        Ok(Self { name, options, ..*self })
    }

    /// Builds it over a scene. Options of the structure count more than those of `config`.
    ///
    /// # Errors
    /// If a peer does not know what the scene is made of, or if the build takes more memory than there
    /// is, by an estimate. The structures of this crate, and those of [`new`](Self::new), take every
    /// scene that there is memory for.
    pub fn try_build(
        &self,
        scene: &Scene,
        config: &BuildConfig,
    ) -> Result<Box<dyn TracedWorld>, BuildError> {
        expect_memory(self.bytes_to_build(scene))?;
        (self.build)(scene, &self.config(config))
    }

    /// What a build takes, roughly.
    fn bytes_to_build(&self, scene: &Scene) -> u64 {
        let [of_triangle, of_object] = self.build_bytes;
        let triangles: usize = scene.meshes().iter().map(|mesh| mesh.triangles.len()).sum();
        of_triangle * triangles as u64 + of_object * scene.objects.len() as u64
    }

    /// Builds it over a scene that it is known to take.
    ///
    /// # Panics
    /// If it does not: see [`try_build`](Self::try_build).
    #[must_use]
    pub fn build(&self, scene: &Scene, config: &BuildConfig) -> Box<dyn TracedWorld> {
        self.try_build(scene, config).unwrap_or_else(|error| panic!("`{}`: {error}", self.name))
    }

    /// Whether it can be saved once it is built: [`save`](Self::save).
    #[must_use]
    pub fn can_be_saved(&self) -> bool {
        self.saved.is_some()
    }

    /// Builds it over a scene and writes it, without the scene.
    ///
    /// # Errors
    /// As of [`try_build`](Self::try_build), if it cannot be saved, or if it cannot be written.
    pub fn save(
        &self,
        scene: &Scene,
        config: &BuildConfig,
        out: &mut dyn Write,
    ) -> Result<(), SaveError> {
        let saved = self.saved.ok_or(SaveError::NotPortable { structure: self.name })?;
        expect_memory(self.bytes_to_build(scene)).map_err(BuildError::from)?;
        Ok((saved.write)(scene, &self.config(config), out)?)
    }

    /// Reads what [`save`](Self::save) has written for the same scene, and nothing behind it. `size` is how many bytes
    /// there are at most.
    ///
    /// The bytes need not be trusted: what is read gives the hits of the scene.
    ///
    /// # Errors
    /// If it cannot be read, was damaged, or is not over this scene.
    pub fn load(
        &self,
        scene: &Scene,
        input: &mut dyn Read,
        size: u64,
    ) -> Result<Box<dyn TracedWorld>, ReadError> {
        let invalid = |what: String| ReadError::of_objects(LoadError::invalid(what));
        let saved = self.saved.ok_or_else(|| invalid(format!("`{}` is never saved", self.name)))?;
        let triangles: usize = scene.meshes().iter().map(|mesh| mesh.triangles.len()).sum();
        let bytes = PACKED_TRIANGLE * triangles as u64 + LISTED_OBJECT * scene.objects.len() as u64;
        expect_memory(bytes).map_err(|shortage| invalid(shortage.to_string()))?;
        (saved.read)(scene, input, size)
    }

    /// Builds it over the triangles of one mesh, without a scene; hits name object 0. `None` for a
    /// peer.
    #[must_use]
    pub fn index(&self, mesh: TriangleMesh<'_>, config: &BuildConfig) -> Option<Box<dyn Tracer>> {
        self.equal.map(|equal| (equal.index)(mesh, &self.config(config)))
    }

    /// Checks that it gives equal hits, as it is built with its options: see [`conformance`]. `None`
    /// for a peer, which need not.
    #[must_use]
    pub fn check(&self, limits: &Limits<'_>) -> Option<Result<Summary, FirstDifference>> {
        self.equal.map(|equal| (equal.check)(self.options, limits))
    }

    /// Whether the program has it, and nobody is trying it out: whether the table has its name.
    #[must_use]
    pub fn is_of_library(&self) -> bool {
        structure_named(self.base_name).is_some()
    }

    fn config(&self, config: &BuildConfig) -> BuildConfig {
        BuildConfig { options: self.options.or(&config.options), ..*config }
    }
}

/// Checks a structure over triangles in packs, and the one over objects as over triangles that are
/// tested one by one, in half of the time each. No structure at all is what the others are compared with.
fn check<O: Accel + 'static, T: Accel + 'static>(
    options: &BuildOptions,
    limits: &Limits<'_>,
) -> Result<Summary, FirstDifference> {
    if TypeId::of::<O>() == TypeId::of::<Exhaustive>() {
        return conformance::check_with::<T>(options, limits);
    }
    let start = Instant::now();
    let half = Limits { time: limits.time.map(|time| time / 2), ..*limits };
    let of_triangles = conformance::check_with::<T>(options, &half)?;
    let left = limits.time.map(|time| time.saturating_sub(start.elapsed()));
    let rest = Limits { time: left, ..*limits };
    Ok(of_triangles.plus(conformance::check_one_by_one::<O>(options, &rest)?))
}

/// What was chosen for a structure, and the name of the two.
struct Chosen {
    name: String,
    options: BuildOptions,
}

/// Keeps a choice for the rest of the program, once, so that a structure is as small and its name as
/// lasting as one of the table.
fn kept(name: String, options: BuildOptions) -> &'static Chosen {
    static ALL: Mutex<Vec<&Chosen>> = Mutex::new(Vec::new());
    let mut all = ALL.lock().unwrap_or_else(PoisonError::into_inner);
    let found = all.iter().find(|other| other.name == name && other.options == options).copied();
    found.unwrap_or_else(|| {
        let new: &'static Chosen = Box::leak(Box::new(Chosen { name, options }));
        all.push(new);
        new
    })
}
