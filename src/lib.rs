//! Ray tracing acceleration structures that return the same hits, bit for bit, and a ray tracer
//! that compares them.
//!
//! A structure finds what a ray hits among triangles, or among primitives of your own. There are
//! eleven, behind one interface, from a bounding ball to a tree of eight children whose kernels trace
//! packets of rays with AVX-512, AVX2 or portable code. Whatever the structure, the number of
//! threads or the instruction set, a ray has the same hit, to the last bit.
//!
//! ```
//! use srt::accel::{BuildConfig, Bvh8, ClosestHit, Indexed};
//! use srt::glam::Vec3;
//! use srt::math::{Hit, Ray};
//! use srt::shapes::TriangleMesh;
//!
//! let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
//! let mesh = TriangleMesh::new(&positions, &[[0, 1, 2]]);
//! let bvh: Indexed<_, Bvh8> = Indexed::build(mesh, &BuildConfig::default());
//!
//! let rays = [0.2, 0.7].map(|x| Ray::new(Vec3::new(x, 0.5, 3.0), Vec3::NEG_Z));
//! let mut hits = [Hit::MISS; 2];
//! bvh.answer(&ClosestHit, &rays, &mut hits);
//! assert_eq!((hits[0].t, hits[0].prim), (3.0, 0));
//! assert!(!hits[1].is_hit());
//! ```
//!
//! The [`guide`] shows single rays, any-hit queries, primitives of your own, threads and memory.
//! Any other [`Accel`](accel::Accel) can take the place of `Bvh8`, one of your own included;
//! [`conformance::check`] finds out whether that keeps the contract.
//!
//! # Modules
//!
//! | module | contents |
//! |---|---|
//! | [`accel`] | the structures and their interfaces |
//! | [`shapes`] | triangles and other primitives, with their formulas |
//! | [`math`] | rays, hits, boxes, transforms |
//! | [`counters`] | counts of the boxes and primitives that rays are tested against |
//! | [`conformance`] | meshes and rays that find out whether a structure returns equal hits |
//! | [`simd`] | lanes of floats and instruction sets, for kernels and formulas over many rays at once |
//!
//! # Features
//!
//! * `program`, on by default: the command `srt` and all that it is made of, as described
//!   [below](#the-program). With `default-features = false`, the crate is the modules above and
//!   seven direct dependencies.
//! * `embree`: Intel's Embree 3 and 4 beside this crate's structures. They trace whole scenes, so it turns
//!   `program` on; their libraries are loaded as they are asked for.
//! * `libraries`: obvhs, parry3d and bvh as they are shipped, beside this crate's structures, and the trees of the
//!   latter two in them.
//! * `tinybvh`: tinybvh beside this crate's structures. A build needs a C++ compiler.
//!
//! # The program
//!
//! With the feature `program` the crate also reads scenes, renders them, and measures structures on
//! their rays.
#![cfg_attr(
    feature = "program",
    doc = "\
From scenes to pictures it is [`scene_file::parse`], [`assets::load_meshes`], [`scene::Scene::new`],
[`scene::Structure::build`] and [`render::render`]. [`compare`] measures structures, [`report`] writes
what it found, [`live`] and [`serve`] are the page of `srt view`, [`show`] draws structures level by level, and
[`cli::run_with`] gives a structure of your own the whole command line.

The layers, and which of them may use which, are described in `ARCHITECTURE.md`; a test holds every
`crate::` path to that table."
)]
#![cfg_attr(docsrs, feature(doc_cfg))]

pub mod accel;
pub mod conformance;
pub mod counters;
pub mod math;
mod parallel;
pub mod shapes;
pub mod simd;

#[cfg(feature = "program")]
pub mod analysis;
#[cfg(feature = "program")]
pub mod assets;
#[cfg(feature = "program")]
pub mod built_file;
#[cfg(feature = "program")]
pub mod cli;
#[cfg(feature = "program")]
pub mod compare;
#[cfg(feature = "program")]
pub mod description;
#[cfg(feature = "embree")]
pub mod embree;
#[cfg(feature = "program")]
pub mod film;
#[cfg(feature = "program")]
pub mod image_io;
#[cfg(feature = "program")]
pub mod live;
#[cfg(feature = "program")]
pub mod pack;
#[cfg(feature = "program")]
mod page;
#[cfg(feature = "program")]
pub mod part_file;
#[cfg(feature = "program")]
pub mod ray_file;
#[cfg(feature = "program")]
pub mod record;
#[cfg(feature = "program")]
pub mod render;
#[cfg(feature = "program")]
pub mod report;
#[cfg(feature = "program")]
pub mod scatter;
#[cfg(feature = "program")]
pub mod scene;
#[cfg(feature = "program")]
pub mod scene_file;
#[cfg(feature = "program")]
mod sealed;
#[cfg(feature = "program")]
pub mod serve;
#[cfg(feature = "program")]
pub mod show;
#[cfg(feature = "tinybvh")]
pub mod tinybvh;

#[cfg(any(doc, doctest))]
#[doc = include_str!("../docs/library.md")]
pub mod guide {}

/// The vectors of all interfaces here, in the version that they are made with.
pub use glam;

/// The Rust in the pages of this project, compiled as documentation tests so that it stays true.
#[cfg(doctest)]
mod pages {
    #[cfg(feature = "program")]
    #[doc = include_str!("../CONTRIBUTING.md")]
    struct Contributing;

    #[cfg(feature = "program")]
    #[doc = include_str!("../docs/your-structure.md")]
    struct YourStructure;

    #[doc = include_str!("../README.md")]
    struct Readme;
}
