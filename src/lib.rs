//! srt: a ray tracer whose acceleration structure is a plug-in.
//!
//! The same scene renders to the same picture, bit for bit, whatever the structure, the number of
//! threads or the instruction set; what differs is the speed, and that is what srt measures.
//!
//! # Rays into a mesh of one's own
//!
//! No scene is needed: [`Indexed`](accel::Indexed) puts triangles and a structure together, and
//! [`Tracer`](accel::Tracer) takes slices of rays.
//!
//! ```
//! use srt::accel::{BuildConfig, Bvh8, Indexed, Tracer};
//! use srt::glam::Vec3;
//! use srt::math::{Hit, Ray};
//! use srt::shapes::TriangleSet;
//!
//! let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
//! let triangles = TriangleSet::new(&positions, &[[0, 1, 2]]);
//! let bvh: Indexed<_, Bvh8> = Indexed::build(triangles, &BuildConfig::default());
//!
//! let rays = [0.2, 0.7].map(|x| Ray::new(Vec3::new(x, 0.5, 3.0), Vec3::NEG_Z));
//! let mut hits = [Hit::MISS; 2];
//! bvh.intersect(&rays, &mut hits, None);
//! assert_eq!((hits[0].t, hits[0].prim), (3.0, 0));
//! assert!(!hits[1].is_hit());
//! ```
//!
//! Any [`Accel`](accel::Accel) stands in for `Bvh8`, and gives the same hits. How to bring one of
//! one's own is told at [`compare`]; [`conformance::check`] tells whether it keeps the contract, and
//! [`cli::run_with`] gives it the whole command line. From scenes to pictures it is
//! [`scene_file::parse`], [`assets::load_meshes`], [`scene::Scene::new`],
//! [`scene::Structure::build`] and [`render::render`].
//!
//! # Layers
//!
//! The layers, from the file to the picture, and which of them may use which, are described in
//! `ARCHITECTURE.md`; a test holds every `use crate::…` line to that table.

pub mod accel;
pub mod analysis;
pub mod assets;
pub mod cli;
pub mod compare;
pub mod conformance;
pub mod counters;
pub mod description;
#[cfg(feature = "embree")]
pub mod embree;
pub mod image_io;
pub mod math;
pub mod record;
pub mod render;
pub mod report;
pub mod scene;
pub mod scene_file;
pub mod shapes;
pub mod simd;

/// The vectors of all interfaces here, in the version that they are made with.
pub use glam;

/// The Rust in the pages of this project, compiled as documentation tests so that it stays true.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../CONTRIBUTING.md")]
    struct Contributing;

    #[doc = include_str!("../README.md")]
    struct Readme;
}
