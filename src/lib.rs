//! srt: a ray tracer whose acceleration structure is a plug-in.
//!
//! The same scene renders to the same picture, bit for bit, whatever the structure, the number of
//! threads or the instruction set; what differs is the speed, and that is what srt measures.
//!
//! The layers, from the file to the picture, and which of them may use which, are described in
//! `ARCHITECTURE.md`; a test holds every `use crate::…` line to that table.

pub mod accel;
pub mod assets;
pub mod cli;
pub mod compare;
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

/// The Rust in the pages of this project, compiled as documentation tests so that it stays true.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../CONTRIBUTING.md")]
    struct Contributing;
}
